// SPDX-License-Identifier: MIT
// Finds which planes are one and the same, seen from either side, and makes each exact.
#include "brush/bsp_planes.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace firma {
namespace {

constexpr std::uint32_t kNoNumber = ~0u;

// The file's numbers, turned so that a plane and its negative are equal.
struct TurnedPlane {
    FloatPlane plane;
    bool flipped = false;

    explicit TurnedPlane(const FloatPlane& from) : plane(from) {
        int axis = 0;
        while (axis < 2 && from.normal[axis] == 0) ++axis;
        flipped = from.normal[axis] < 0;
        if (flipped) plane = {-from.normal, -from.distance};
        for (int k = 0; k < 3; ++k) plane.normal[k] += 0.0;  // no negative zeros
        plane.distance += 0.0;
    }
    auto key() const { return std::tuple(plane.normal.x, plane.normal.y, plane.normal.z, plane.distance); }
};

// A side's face, by what it lies on.
struct FamilyFace {
    std::uint32_t family = 0;
    std::uint32_t side = 0;
};

class PlaneMaker {
public:
    PlaneMaker(const BspFile& file, const BspBrushes& brushes, double scale)
        : file_(file), brushes_(brushes), scale_(scale) {}

    std::optional<Error> make() {
        find_families();
        std::vector<FamilyFace> faces;
        for (std::uint32_t k = 0; k < brushes_.sides.size(); ++k) {
            const BspSide& side = brushes_.sides[k];
            if (side.bounds) faces.push_back({family_[side.plane], k});
        }
        // The largest face first, of equals the first in the file: fit_plane() begins with its corners.
        std::sort(faces.begin(), faces.end(), [&](const FamilyFace& a, const FamilyFace& b) {
            const double area_a = brushes_.sides[a.side].area, area_b = brushes_.sides[b.side].area;
            return std::tuple(a.family, -area_a, a.side) < std::tuple(b.family, -area_b, b.side);
        });
        for (std::size_t begin = 0, end = 0; begin < faces.size(); begin = end) {
            while (end < faces.size() && faces[end].family == faces[begin].family) ++end;
            if (auto error = fit(std::span(faces).subspan(begin, end - begin))) return error;
        }
        for (std::uint32_t k = 0; k < turned_.size(); ++k) {
            out.of_plane.push_back(fitted_[family_[k]]);
            if (out.of_plane.back() && turned_[k].flipped)
                std::swap(out.of_plane[k]->points[1], out.of_plane[k]->points[2]);
        }
        return std::nullopt;
    }

    ExactPlanes out;

private:
    void find_families() {
        for (const FloatPlane& plane : brushes_.planes) turned_.emplace_back(plane);
        std::vector<std::uint32_t> order(turned_.size());
        std::iota(order.begin(), order.end(), 0u);
        std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
            return std::tuple_cat(turned_[a].key(), std::tuple(a)) < std::tuple_cat(turned_[b].key(), std::tuple(b));
        });
        family_.assign(turned_.size(), kNoNumber);
        std::uint32_t families = 0;
        for (std::size_t k = 0; k < order.size(); ++k) {
            families += k == 0 || turned_[order[k]].key() != turned_[order[k - 1]].key();
            family_[order[k]] = families - 1;
        }
        fitted_.resize(families);
    }

    std::optional<Error> fit(std::span<const FamilyFace> faces) {
        const BspSide& first = brushes_.sides[faces[0].side];
        const FloatPlane& plane = turned_[first.plane].plane;
        std::optional<FittedPlane>& fitted = fitted_[faces[0].family];
        if (const auto axis = axis_of(plane)) {
            fitted = fit_axial_plane(plane, *axis, scale_);
        } else {
            std::vector<Vec3> corners;
            for (const FamilyFace& face : faces) {
                const BspSide& side = brushes_.sides[face.side];
                const auto own = std::span(brushes_.corners).subspan(side.first_corner, side.corner_count);
                corners.insert(corners.end(), own.begin(), own.end());
            }
            fitted = fit_plane(plane, corners, scale_);
            if (!fitted) fitted = fit_bare_plane(plane, scale_);
        }
        if (!fitted) {
            return file_.fault(ErrorCode::kOutOfRange, BspLump::kPlanes, first.plane,
                               "a brush's plane lies outside the world");
        }
        ++out.counts[std::size_t(fitted->kind)];
        return std::nullopt;
    }

    const BspFile& file_;
    const BspBrushes& brushes_;
    double scale_;
    std::vector<TurnedPlane> turned_;                 // by plane
    std::vector<std::uint32_t> family_;               // by plane
    std::vector<std::optional<FittedPlane>> fitted_;  // by family
};

}  // namespace

Result<ExactPlanes> make_exact_planes(const BspFile& file, const BspBrushes& brushes, double scale) {
    PlaneMaker maker(file, brushes, scale);
    if (auto error = maker.make()) return *std::move(error);
    return std::move(maker.out);
}

}  // namespace firma
