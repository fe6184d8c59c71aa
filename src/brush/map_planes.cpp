// SPDX-License-Identifier: MIT
// Chooses points of the grid for the sides of a .map.
#include "brush/map_planes.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "brush/fit_plane.h"
#include "brush/plane_families.h"
#include "brush/winding.h"
#include "geometry/grid_orient.h"

namespace firma {
namespace {

constexpr std::uint32_t kNoSide = ~0u;

class MapPlaneMaker {
public:
    MapPlaneMaker(const MapFile& file, double scale) : file_(file), scale_(scale) {}

    MapPlanes make(const std::vector<bool>& wants_area) {
        for (const MapSide& side : file_.sides) snap_points(side);
        for (std::size_t k = 0; k < file_.brushes.size(); ++k) cut_faces(file_.brushes[k], wants_area[k]);
        if (!turned_.empty()) fit_turned();
        fit_bare();
        return std::move(out_);
    }

private:
    // A side that is not on the grid, with its face.
    struct Turned {
        std::uint32_t side = 0;
        std::vector<Vec3> corners;  // units
    };
    // What the sides of one plane share.
    struct Shared {
        std::uint32_t exact_side = kNoSide;  // one that is on the grid
        std::vector<Vec3> corners;
        std::optional<FittedPlane> fitted;
    };

    void snap_points(const MapSide& side) {
        MapPlane& made = out_.of_side.emplace_back();
        if (side.plane) return take_plane(*side.plane, made);
        // Quake's points run clockwise seen from outside.
        const Vec3 points[3] = {side.points[0], side.points[2], side.points[1]};
        bool exact = true;
        for (int k = 0; k < 3; ++k) {
            made.points[k] = *snap(points[k] * scale_);
            exact = exact && to_metres(made.points[k]) == points[k] * scale_;
        }
        made.valid = !on_one_line(to_input(made.points[0]), to_input(made.points[1]), to_input(made.points[2]));
        exact_.push_back(exact);
        planes_.push_back(float_plane(points[0], points[1], points[2]));
    }

    // A side that has no points: an axial plane's are at once on the grid, those of others come from their faces.
    void take_plane(const FloatPlane& plane, MapPlane& made) {
        const auto axis = axis_of(plane);
        const auto fitted = axis ? fit_axial_plane(plane, *axis, scale_) : std::nullopt;
        if (fitted) take(*fitted, made);
        exact_.push_back(fitted.has_value());
        planes_.push_back(plane);
    }

    static void take(const FittedPlane& fitted, MapPlane& made) {
        std::copy(std::begin(fitted.points), std::end(fitted.points), std::begin(made.points));
        made.valid = true;
        made.shift = fitted.shift;
    }

    // What has neither points nor a face: it touches its brush at most, but a brush of planes that look inward must not
    // become one without them.
    void fit_bare() {
        for (std::uint32_t k = 0; k < file_.sides.size(); ++k) {
            if (!file_.sides[k].plane || out_.of_side[k].valid) continue;
            if (const auto fitted = fit_bare_plane(*file_.sides[k].plane, scale_)) {
                take(*fitted, out_.of_side[k]);
                out_.of_side[k].shift = 0;  // no corner of a face is off it
            }
        }
    }

    // Of brushes that have a side off the grid, and of those whose areas are wanted.
    void cut_faces(const MapBrush& brush, bool wants_area) {
        std::vector<FloatPlane> planes;
        std::vector<std::uint32_t> sides;
        bool all_exact = true;
        for (std::uint32_t k = brush.first_side; k < brush.first_side + brush.side_count; ++k) {
            if (!planes_[k] || (exact_[k] && !out_.of_side[k].valid)) continue;
            planes.push_back(*planes_[k]);
            sides.push_back(k);
            all_exact = all_exact && exact_[k];
        }
        if (all_exact && !wants_area) return;
        pairs_ += planes.size() * planes.size();
        if (pairs_ > kMostSidePairs) {
            out_.complete = false;
            return;
        }
        for (std::size_t k = 0; k < sides.size(); ++k) {
            std::vector<Vec3> corners = winding(planes, k, 2 * kWorldRim / scale_);
            out_.of_side[sides[k]].area = area(corners);
            merge_corners(corners, kSameCorner);
            std::erase_if(corners, [&](const Vec3& c) { return max_abs(c) * scale_ > kWorldRim; });  // without an end
            if (!exact_[sides[k]] && !corners.empty()) turned_.push_back({sides[k], std::move(corners)});
        }
    }

    void fit_turned() {
        std::vector<Shared> shared;
        for (std::uint32_t k = 0; k < file_.sides.size(); ++k) {
            if (!exact_[k] || !out_.of_side[k].valid) continue;
            Vec3 points[3];
            for (int c = 0; c < 3; ++c) points[c] = to_metres(out_.of_side[k].points[c]) * (1 / scale_);
            if (families_.find(*planes_[k], points)) continue;
            families_.add(*planes_[k]);
            shared.emplace_back().exact_side = k;
        }
        std::vector<PlaneFamilies::Match> matches;
        for (const Turned& turned : turned_) {
            const FloatPlane& plane = *planes_[turned.side];
            auto match = families_.find(plane, turned.corners);
            if (!match) {
                match = {families_.add(plane), false};
                shared.emplace_back();
            }
            std::vector<Vec3>& corners = shared[match->family].corners;
            corners.insert(corners.end(), turned.corners.begin(), turned.corners.end());
            matches.push_back(*match);
        }
        for (std::uint32_t k = 0; k < shared.size(); ++k) {
            if (shared[k].exact_side == kNoSide) {
                shared[k].fitted = fit_plane(families_.plane(k), shared[k].corners, scale_);
            }
        }
        for (std::size_t k = 0; k < turned_.size(); ++k)
            place(turned_[k], shared[matches[k].family], matches[k].flipped);
    }

    void place(const Turned& turned, const Shared& shared, bool flipped) {
        MapPlane& made = out_.of_side[turned.side];
        if (shared.exact_side != kNoSide || shared.fitted) {
            const GridPoint(&points)[3] =
                shared.fitted ? shared.fitted->points : out_.of_side[shared.exact_side].points;
            std::copy(std::begin(points), std::end(points), std::begin(made.points));
            if (flipped) std::swap(made.points[1], made.points[2]);
            made.valid = true;
        }
        if (!made.valid) return;
        const auto plane = float_plane(to_metres(made.points[0]), to_metres(made.points[1]), to_metres(made.points[2]));
        for (const Vec3& corner : turned.corners) {
            made.shift = std::max(made.shift, std::fabs(dot(plane->normal, corner * scale_) - plane->distance));
        }
    }

    const MapFile& file_;
    double scale_;
    MapPlanes out_;
    std::vector<bool> exact_;                        // by side: its points lie on the grid
    std::vector<std::optional<FloatPlane>> planes_;  // by side, in units
    std::vector<Turned> turned_;
    PlaneFamilies families_;
    std::uint64_t pairs_ = 0;
};

}  // namespace

MapPlanes make_map_planes(const MapFile& file, double scale, const std::vector<bool>& wants_area) {
    return MapPlaneMaker(file, scale).make(wants_area);
}

}  // namespace firma
