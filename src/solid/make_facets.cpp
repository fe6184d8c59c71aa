// SPDX-License-Identifier: MIT
// Makes the facets that casts meet from a face of the exact solid.
#include "solid/make_facets.h"

#include <array>
#include <cmath>

#include "geometry/convex_loop.h"
#include "geometry/polygon_shape.h"

namespace firma {
namespace {

void write_one(std::size_t count, Facets& facets) {
    facets.corners.clear();
    for (std::uint32_t k = 0; k < count; ++k) facets.corners.push_back(k);
    facets.first.assign({0, std::uint32_t(count)});
}

bool usable_loops(std::size_t count, std::span<const std::uint32_t> loop_ends) {
    std::uint32_t begin = 0;
    for (const std::uint32_t end : loop_ends) {
        if (end > count || end < begin || end - begin < 3) return false;
        begin = end;
    }
    return begin == count && count > 0;
}

}  // namespace

bool FacetMaker::make(std::span<const GridPoint> points, std::span<const std::uint32_t> loop_ends, FlatView view,
                      Facets& facets) {
    if (!usable_loops(points.size(), loop_ends)) return false;
    flat_.clear();
    for (const GridPoint& point : points) flat_.push_back(project(point, view));
    if (points.size() == 3) {
        write_one(3, facets);
        return turn(flat_[0], flat_[1], flat_[2]) > 0;
    }
    if (points.size() == 4) return make_quad(points, facets);
    if (loop_ends.size() == 1 && convex()) {
        if (points.size() <= kMaxCorners && planar(points)) {
            write_one(points.size(), facets);
            return true;
        }
    } else if (!checker_.simple(flat_, loop_ends)) {
        return false;
    }
    if (!triangulator_.make(points, flat_, loop_ends, triangles_)) return false;
    merger_.merge(points, flat_, triangles_, facets);
    return true;
}

void FacetMaker::make_folded(std::span<const GridPoint> points, std::span<const Vec3> exact,
                             std::span<const std::uint32_t> loop_ends, FlatView view, Facets& facets) {
    constexpr double kFine = 0x1p24;  // of an input step: what exact corners are known to
    flat_.clear();
    for (const Vec3& p : exact)
        flat_.push_back({std::int64_t(std::floor(p[view.u()] * kFine)), std::int64_t(std::floor(p[view.v()] * kFine))});
    triangulator_.make_any(points, flat_, loop_ends, triangles_);
    facets.corners.clear();
    facets.first.assign(1, 0);
    const auto& corners = triangles_.corners;
    const auto has_sides = [&](std::size_t k) {
        const GridPoint &a = points[corners[k]], &b = points[corners[k + 1]], &c = points[corners[k + 2]];
        return a != b && b != c && c != a;
    };
    for (std::size_t k = 0; k < corners.size(); k += 3) {
        // With a side of no length the other two cancel; but a face is found by its facets.
        if (!has_sides(k) && !(k + 3 == corners.size() && facets.corners.empty())) continue;
        for (std::size_t c = k; c < k + 3; ++c) facets.corners.push_back(corners[c]);
        facets.first.push_back(std::uint32_t(facets.corners.size()));
    }
}

/// Two triangles with area and a common diagonal lie on either side of it: nothing else needs checking.
bool FacetMaker::make_quad(std::span<const GridPoint> points, Facets& facets) const {
    std::array<Int128, 4> turns;
    for (std::size_t k = 0; k < 4; ++k) turns[k] = turn(flat_[(k + 3) % 4], flat_[k], flat_[(k + 1) % 4]);
    const bool from_0 = turns[1] > 0 && turns[3] > 0, from_1 = turns[0] > 0 && turns[2] > 0;
    if (!from_0 && !from_1) return false;
    if (turns[0] >= 0 && turns[1] >= 0 && turns[2] >= 0 && turns[3] >= 0 &&
        coplanar(points[0], points[1], points[2], points[3])) {
        write_one(4, facets);
        return true;
    }
    const bool shorter_from_0 = square_distance(points[0], points[2]) <= square_distance(points[1], points[3]);
    if (from_0 && (!from_1 || shorter_from_0))
        facets.corners.assign({0, 1, 2, 0, 2, 3});
    else
        facets.corners.assign({1, 2, 3, 1, 3, 0});
    facets.first.assign({0, 3, 6});
    return true;
}

bool FacetMaker::convex() const {
    return convex_loop<Int128>(flat_.size(), [&](std::size_t k) -> const FlatPoint& { return flat_[k]; });
}

/// Whether all corners of a convex loop are of one plane.
bool FacetMaker::planar(std::span<const GridPoint> points) const {
    const std::size_t count = points.size();
    std::size_t k = 2;  // the first two corners and this one have area
    while (k + 1 < count && turn(flat_[0], flat_[1], flat_[k]) == 0) ++k;
    for (std::size_t other = 2; other < count; ++other)
        if (other != k && !coplanar(points[0], points[1], points[k], points[other])) return false;
    return true;
}

}  // namespace firma
