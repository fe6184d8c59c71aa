// SPDX-License-Identifier: MIT
// A point of a face that lies within it.
#include "carve/point_within.h"

#include <algorithm>

#include "geometry/exact_plane.h"

namespace firma {
namespace {

/// Input steps: the middle of a triangle that is wider lies in it, however it is rounded (fine_plane()).
constexpr double kThinnest = 0x1p-10;

}  // namespace

std::optional<ExactPoint> WithinFinder::find(const Plane& plane, const std::vector<ExactPoint>& corners,
                                             std::span<const std::uint32_t> ends) {
    points_.clear();
    exact_.clear();
    for (const ExactPoint& corner : corners) {
        points_.push_back(corner.rounded());
        exact_.push_back(corner.approximate());
    }
    const FlatView view = plane.front_view();
    if (!facet_maker_.make(points_, ends, view, facets_))
        facet_maker_.make_folded(points_, exact_, ends, view, facets_);
    Vec3 middle{0, 0, 0};
    double thickest = 0;
    for (std::size_t k = 0; k < facets_.count(); ++k) {
        const std::span of_facet(facets_.corners.data() + facets_.first[k], facets_.first[k + 1] - facets_.first[k]);
        const auto corner = [&](std::size_t c) { return exact_[of_facet[c]]; };
        for (std::size_t c = 2; c < of_facet.size(); ++c) {
            const Vec3 a = corner(0), b = corner(c - 1), d = corner(c);
            const double area = length(cross(b - a, d - a));
            const double width = area / std::max({length(b - a), length(d - a), length(d - b), kThinnest});
            if (!(width > thickest)) continue;
            thickest = width;
            middle = (a + b + d) * (1.0 / 3);
        }
    }
    if (thickest < kThinnest) return std::nullopt;
    u_ = fine_plane(view.u(), middle[view.u()]);
    v_ = fine_plane(view.v(), middle[view.v()]);
    if (exact_turn(plane, u_, v_) == 0) return std::nullopt;
    return ExactPoint(plane, u_, v_);
}

}  // namespace firma
