// SPDX-License-Identifier: MIT
// What placed cutters leave of polygons that bound nothing: an arrangement of all. A polygon is divided where cutters'
// surfaces meet it, and each cell lies in a cutter or does not, by a point within it. Cutters are not divided by each
// other.
#include "carve/trim_polygons.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/sort.h"
#include "carve/side_of_solid.h"
#include "geometry/exact_plane.h"
#include "geometry/surface_plane.h"
#include "solid/append_faces.h"

namespace firma {
namespace {

constexpr std::size_t kTrimUnitsAStep = 32;
constexpr std::size_t kMostTrimPlanes = (1u << 21) - 4096;  // see arrange/point_table.cpp; a step adds fewer than that
/// Input steps: what of a polygon is thinner everywhere goes only where it lies as deep in the cutter, as rounding
/// makes such slivers at its surface. Four surface steps.
constexpr double kThinCell = 4.0 / kSurfacePerInput;

/// @param middle  input steps
bool may_hold(const CutterSolid& cutter, const Vec3& middle) {
    constexpr double kBeside =
        64;  // surface steps: more than a Solid's facets lie beside its faces, and what is rounded
    static_assert(kBeside > kFacetReach + 2);
    for (int axis = 0; axis < 3; ++axis) {
        const double at = middle[axis] * kSurfacePerInput;
        if (at < double(cutter.box.low[axis]) - kBeside || at > double(cutter.box.high[axis]) + kBeside) return false;
    }
    return true;
}

/// Along the normal of a polygon, with numbers too large for a plane.
FlatView view_of(std::span<const GridPoint> corners) {
    Vec3 normal;
    for (std::size_t k = 2; k < corners.size(); ++k)
        normal = normal + cross(to_metres(corners[k - 1]) - to_metres(corners[0]),
                                to_metres(corners[k]) - to_metres(corners[0]));
    int axis = 0;
    for (int k = 1; k < 3; ++k)
        if (std::fabs(normal[k]) > std::fabs(normal[axis])) axis = k;
    return {axis, normal[axis] < 0};
}

/// Where a side passes a place along an axis, rounded: the same whichever way it runs.
GridPoint point_at(GridPoint a, GridPoint b, int axis, std::int32_t at) {
    if (b < a) std::swap(a, b);
    const Int128 whole = Int128(b[axis]) - a[axis], part = Int128(at) - a[axis];
    GridPoint p;
    for (int k = 0; k < 3; ++k) {
        const double share = double((Int128(b[k]) - a[k]) * part) / double(whole);
        p[k] = std::int32_t(a[k] + std::int64_t(std::floor(share + 0.5)));
    }
    p[axis] = at;
    return p;
}

}  // namespace

PolygonTrimmer::PolygonTrimmer(std::vector<FacetPlace> facets, std::vector<Trim> trims, std::uint64_t max_pairs)
    : facets_(std::move(facets)),
      trims_(std::move(trims)),
      first_cutter_(facets_.size() + 1, 0),
      budget_(max_pairs),
      fate_(facets_.size(), Fate::kStays),
      loses_(facets_.size(), 0) {
    for (const Trim& trim : trims_)
        for (const std::uint32_t facet : trim.facets) ++first_cutter_[facet + 1];
    std::partial_sum(first_cutter_.begin(), first_cutter_.end(), first_cutter_.begin());
    cutters_.resize(first_cutter_.back());
    std::vector<std::uint32_t> next = first_cutter_;
    for (std::uint32_t k = 0; k < trims_.size(); ++k)
        for (const std::uint32_t facet : trims_[k].facets) cutters_[next[facet]++] = k;
}

PolygonTrimmer::End PolygonTrimmer::step() {
    WorkSlice slice(kTrimUnitsAStep);
    switch (phase_) {
        case Phase::kPolygons:
            if (!go_on(next_, facets_.size(), slice, [&](std::uint32_t facet) { add_facet(facet); }))
                return End::kGoesOn;
            if (facet_of_.empty()) return finish();
            first_face_.push_back(std::uint32_t(facet_of_.size()));
            phase_ = Phase::kCutters;
            return End::kGoesOn;
        case Phase::kCutters:
            return add_cutters(slice);
        case Phase::kPairs:
            return meet_next();
        case Phase::kSpans:
            if (spans_.finish(slice)) phase_ = Phase::kLines;
            return End::kGoesOn;
        case Phase::kLines:
            if (lines_.divide(slice)) phase_ = Phase::kCells;
            return End::kGoesOn;
        case Phase::kCells: {
            const PhaseEnd end = cells_.step(slice, facet_of_.size());
            if (end == PhaseEnd::kBroken) return End::kBroken;
            if (end == PhaseEnd::kDone) phase_ = Phase::kPlaces;
            return End::kGoesOn;
        }
        case Phase::kPlaces:
            break;
    }
    constexpr std::size_t kUnitsAPolygon = kTrimUnitsAStep / 4;
    return go_on(next_, facet_of_.size(), slice,
                 [&](std::uint32_t face) {
                     place_cells(face);
                     slice.take(kUnitsAPolygon);
                 })
               ? finish()
               : End::kGoesOn;
}

/// Of `made_`. Of what rounding folded, triangles without area or turned over cover nothing.
template <class Function>
void PolygonTrimmer::for_each_facet(std::span<const GridPoint> points, FlatView view, const Function& function) const {
    for (std::size_t k = 0; k < made_.count(); ++k) {
        std::vector<GridPoint> corners;
        for (std::uint32_t c = made_.first[k]; c < made_.first[k + 1]; ++c) corners.push_back(points[made_.corners[c]]);
        if (corners.size() > 3 ||
            turn(project(corners[0], view), project(corners[1], view), project(corners[2], view)) > 0)
            function(corners);
    }
}

void PolygonTrimmer::add_facet(std::uint32_t facet) {
    first_face_.push_back(std::uint32_t(facet_of_.size()));
    const FaceRecord& record = facets_[facet].record();
    std::vector<GridPoint> corners;
    for (std::uint32_t k = 0; k < record.corner_count; ++k) corners.push_back(facets_[facet].block->corner(record, k));
    add_polygon(facet, corners);
}

void PolygonTrimmer::add_polygon(std::uint32_t facet, const std::vector<GridPoint>& corners) {
    const Plane plane = surface_plane(corners);
    if (!plane.valid()) return divide(facet, corners);
    const PlaneId id = overlay_.tables.planes.add(plane);
    sides_.clear();
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const GridPoint &a = corners[k], &b = corners[k + 1 < corners.size() ? k + 1 : 0];
        OverlayEdge edge{point(a), point(b), {id, overlay_.tables.planes.add(surface_edge_plane(a, b, plane))}};
        sides_.push_back({overlay_.add_edge(edge), false});
    }
    const std::uint32_t ends[] = {std::uint32_t(sides_.size())};
    overlay_.add_face(id, 0, sides_, ends);
    facet_of_.push_back(facet);
}

std::uint32_t PolygonTrimmer::point(const GridPoint& p) {
    if (on_input_grid(p)) return overlay_.tables.points.add(to_input(p));
    PlaneId planes[3];
    for (int axis = 0; axis < 3; ++axis) planes[axis] = overlay_.tables.planes.add(surface_axis_plane(axis, p[axis]));
    return overlay_.tables.points.add(planes[0], planes[1], planes[2]);
}

/// In the middle of its longest extent. Parts clear of all cutters stay as they are; others may be divided again.
void PolygonTrimmer::divide(std::uint32_t facet, const std::vector<GridPoint>& corners) {
    GridBox box;
    for (const GridPoint& corner : corners) box.add(corner);
    const auto cutters = cutters_of(facet);
    if (std::none_of(cutters.begin(), cutters.end(),
                     [&](std::uint32_t k) { return boxes_meet(box, trims_[k].cutter->box); })) {
        add_left(facet, corners);
        return;
    }
    const int axis = box.longest_axis();
    const auto at = std::int32_t((std::int64_t(box.low[axis]) + box.high[axis]) / 2);
    const FlatView view = view_of(corners);
    for (const int way : {1, -1}) {
        std::vector<GridPoint> half;
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const GridPoint &a = corners[k], &b = corners[k + 1 < corners.size() ? k + 1 : 0];
            const std::int64_t from = way * (std::int64_t(a[axis]) - at), to = way * (std::int64_t(b[axis]) - at);
            if (from >= 0) half.push_back(a);
            if ((from < 0 && to > 0) || (from > 0 && to < 0)) half.push_back(point_at(a, b, axis, at));
        }
        half.erase(std::unique(half.begin(), half.end()), half.end());
        if (half.size() > 1 && half.front() == half.back()) half.pop_back();
        if (half.size() < 3) continue;
        const std::uint32_t ends[] = {std::uint32_t(half.size())};
        if (!facet_maker_.make(half, ends, view, made_)) {
            exact_.clear();
            for (const GridPoint& p : half) exact_.push_back(to_metres(p) * double(kInputSteps));
            facet_maker_.make_folded(half, exact_, ends, view, made_);
        }
        std::vector<std::vector<GridPoint>> parts;
        for_each_facet(half, view, [&](const std::vector<GridPoint>& part) { parts.push_back(part); });
        for (const std::vector<GridPoint>& part : parts) add_polygon(facet, part);
    }
}

PolygonTrimmer::End PolygonTrimmer::add_cutters(WorkSlice& slice) {
    const bool is_whole = add_cutter(slice);
    if (overlay_.tables.planes.size() >= kMostTrimPlanes) return End::kTooLarge;
    if (!is_whole) return End::kGoesOn;
    if (faces_of_.size() < trims_.size()) return End::kGoesOn;
    spans_.start();
    next_ = 0;
    start_pairs();
    phase_ = Phase::kPairs;
    return End::kGoesOn;
}

/// The next one.
/// @return whether all of it is done
bool PolygonTrimmer::add_cutter(WorkSlice& slice) {
    const CutterSolid& cutter = *trims_[faces_of_.size()].cutter;
    if (cutter.turned) {
        const auto first = std::uint32_t(overlay_.faces.size());
        if (!solid_) {
            solid_ = std::make_unique<PatchAdder>(cutter.turned->boundary, 1, overlay_);
            first_of_solid_ = first;
        }
        if (!solid_->add(slice)) return false;
        faces_of_.emplace_back();
        for (const std::uint32_t face : cutter.turned->face_of) faces_of_.back().push_back(first_of_solid_ + face);
        solid_.reset();
    } else {
        if (!mesh_) mesh_ = std::make_unique<MeshAdder>(cutter, 1, overlay_);
        if (!mesh_->add(slice)) return false;
        faces_of_.push_back(mesh_->face_of());
        mesh_.reset();
    }
    return true;
}

/// Of the cutter at hand with the facets that it may take of.
void PolygonTrimmer::start_pairs() {
    std::vector<std::uint32_t> faces;
    for (const std::uint32_t facet : trims_[next_].facets)
        for (std::uint32_t face = first_face_[facet]; face < first_face_[facet + 1]; ++face) faces.push_back(face);
    pairs_.start(*trims_[next_].cutter, overlay_, std::move(faces_of_[next_]), std::move(faces));
}

PolygonTrimmer::End PolygonTrimmer::meet_next() {
    const bool goes_on = pairs_.step(spans_, budget_);
    if (budget_.spent()) return End::kPairs;
    if (goes_on) return End::kGoesOn;
    if (++next_ < trims_.size()) {
        start_pairs();
    } else {
        next_ = 0;
        phase_ = Phase::kSpans;
    }
    return End::kGoesOn;
}

void PolygonTrimmer::place_cells(std::uint32_t face) {
    const CellSet& set = cells_.cells();
    const std::uint32_t first = set.first_of_face[face], end = set.first_of_face[face + 1];
    kept_.clear();
    for (std::uint32_t cell = first; cell < end; ++cell) kept_.push_back(!lies_in(set.cells[cell]));
    if (std::find(kept_.begin(), kept_.end(), 0) != kept_.end()) {
        loses_[facet_of_[face]] = 1;
        return write_cells(face);
    }
    points_.clear();
    for (const OverlaySide& side : overlay_.sides(overlay_.faces[face]))
        points_.push_back(overlay_.point(overlay_.from(side)).rounded());
    add_left(facet_of_[face], points_);
}

void PolygonTrimmer::find_facets(const Plane& plane, std::span<const PieceUse> uses,
                                 std::span<const std::uint32_t> ends) {
    points_.clear();
    exact_.clear();
    for (const PieceUse& use : uses) {
        const ExactPoint& corner = overlay_.point(start_of(use));
        points_.push_back(corner.rounded());
        exact_.push_back(corner.approximate());
    }
    if (!facet_maker_.make(points_, ends, plane.front_view(), made_))
        facet_maker_.make_folded(points_, exact_, ends, plane.front_view(), made_);
}

/// By a point within its widest triangle; on a cutter's surface by points in front of it and behind.
bool PolygonTrimmer::lies_in(const Cell& cell) {
    const Plane& plane = overlay_.plane(overlay_.faces[cell.face].plane);
    find_facets(plane, cells_.cells().uses(cell), cells_.cells().ends(cell));
    Vec3 middle;
    double widest = -1;
    for (std::size_t k = 0; k < made_.count(); ++k)
        for (std::uint32_t c = made_.first[k] + 2; c < made_.first[k + 1]; ++c) {
            const Vec3 &a = exact_[made_.corners[made_.first[k]]], &b = exact_[made_.corners[c - 1]],
                       &d = exact_[made_.corners[c]];
            const double width =
                length(cross(b - a, d - a)) / std::max({length(b - a), length(d - a), length(d - b), kThinCell});
            if (!(width > widest)) continue;
            widest = width;
            middle = (a + b + d) * (1.0 / 3);
        }
    if (widest < 0) return false;
    const FlatView view = plane.front_view();
    const Plane u = fine_plane(view.u(), middle[view.u()]), v = fine_plane(view.v(), middle[view.v()]);
    const auto holds = [&](const CutterSolid& cutter) {
        if (!may_hold(cutter, middle)) return false;
        const auto side = [&](const Plane& at) {
            return meet_in_world(at, u, v) ? side_of_cutter(cutter, ExactPoint(at, u, v)) : -1;
        };
        const int on = side(plane);
        return on > 0 || (on == 0 && side(plane_beside(plane, -1)) > 0);
    };
    const auto cutters = cutters_of(facet_of_[cell.face]);
    if (widest < kThinCell) return lies_deep(cutters, middle);
    return std::any_of(cutters.begin(), cutters.end(), [&](std::uint32_t k) { return holds(*trims_[k].cutter); });
}

/// Whether all around a point lies in some of the cutters.
bool PolygonTrimmer::lies_deep(std::span<const std::uint32_t> cutters, const Vec3& middle) const {
    for (int axis = 0; axis < 3; ++axis)
        for (const double step : {-kThinCell, kThinCell}) {
            Vec3 at = middle;
            at[axis] += step;
            const Plane x = fine_plane(0, at.x), y = fine_plane(1, at.y), z = fine_plane(2, at.z);
            if (!meet_in_world(x, y, z)) return false;
            const ExactPoint point(x, y, z);
            if (std::none_of(cutters.begin(), cutters.end(),
                             [&](std::uint32_t k) { return side_of_cutter(*trims_[k].cutter, point) > 0; }))
                return false;
        }
    return true;
}

/// Cells that stay side by side are one again, and what the cutter only touches divides nothing.
/// @return whether that changed anything; then `loops_` and `ends_` have all that stays
bool PolygonTrimmer::join_kept(std::uint32_t face) {
    const CellSet& set = cells_.cells();
    const std::uint32_t first = set.first_of_face[face];
    uses_.clear();
    for (std::size_t k = 0; k < kept_.size(); ++k)
        if (kept_[k]) {
            const auto uses = set.uses(set.cells[first + k]);
            uses_.insert(uses_.end(), uses.begin(), uses.end());
        }
    sort_range(uses_, [](const PieceUse& a, const PieceUse& b) {
        return a.piece != b.piece ? a.piece < b.piece : a.forward && !b.forward;
    });
    std::size_t left = 0;
    for (std::size_t k = 0; k < uses_.size(); ++k)
        if (k + 1 < uses_.size() && uses_[k + 1].piece == uses_[k].piece)
            ++k;
        else
            uses_[left++] = uses_[k];
    if (left == uses_.size()) return false;
    uses_.resize(left);
    flat_.start(overlay_.faces[face].plane);
    return flat_.trace(uses_, loops_, ends_) && flat_.group(loops_, ends_, outlines_);
}

void PolygonTrimmer::write_cells(std::uint32_t face) {
    const Plane& plane = overlay_.plane(overlay_.faces[face].plane);
    const CellSet& set = cells_.cells();
    if (join_kept(face)) {
        for (std::size_t k = 0; k < outlines_.outlines().size(); ++k) {
            std::vector<PieceUse> uses;
            std::vector<std::uint32_t> ends;
            append_loops<PieceUse>(loops_, ends_, outlines_.loops(k), 0, uses, ends);
            write(facet_of_[face], plane, uses, ends);
        }
        return;
    }
    for (std::uint32_t k = 0; k < kept_.size(); ++k) {
        const Cell& cell = set.cells[set.first_of_face[face] + k];
        if (kept_[k]) write(facet_of_[face], plane, set.uses(cell), set.ends(cell));
    }
}

void PolygonTrimmer::write(std::uint32_t facet, const Plane& plane, std::span<const PieceUse> uses,
                           std::span<const std::uint32_t> ends) {
    find_facets(plane, uses, ends);
    for_each_facet(points_, plane.front_view(),
                   [&](const std::vector<GridPoint>& corners) { add_left(facet, corners); });
}

void PolygonTrimmer::add_left(std::uint32_t facet, std::span<const GridPoint> corners) {
    left_.push_back({facet, std::uint32_t(left_corners_.size()), std::uint32_t(corners.size())});
    left_corners_.insert(left_corners_.end(), corners.begin(), corners.end());
}

PolygonTrimmer::End PolygonTrimmer::finish() {
    sort_range(left_,
               [](const Left& a, const Left& b) { return a.facet != b.facet ? a.facet < b.facet : a.first < b.first; });
    for (std::size_t facet = 0; facet < fate_.size(); ++facet)
        if (loses_[facet]) fate_[facet] = Fate::kGoes;
    for (const Left& left : left_)
        if (loses_[left.facet]) fate_[left.facet] = Fate::kTrimmed;
    return End::kDone;
}

void PolygonTrimmer::append_left(std::size_t facet, FaceSet& set) const {
    auto left = std::partition_point(left_.begin(), left_.end(), [&](const Left& it) { return it.facet < facet; });
    for (; left != left_.end() && left->facet == facet; ++left) {
        FaceSet::Entry entry = entry_of(*facets_[facet].block, facets_[facet].record());
        entry.id = {};
        entry.owner = nullptr;
        entry.first_corner = std::uint32_t(set.corners.size());
        entry.corner_count = left->count;
        for (std::uint32_t k = 0; k < left->count; ++k) {
            set.corners.push_back(std::uint32_t(set.vertices.size()));
            set.vertices.push_back(left_corners_[left->first + k]);
        }
        set.faces.push_back(entry);
    }
}

}  // namespace firma
