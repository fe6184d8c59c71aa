// SPDX-License-Identifier: MIT
// Whether a point lies in a placed cutter: along an axis in double, where that is sure, else along exact lines.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "base/sort.h"
#include "carve/cutter_solid.h"
#include "carve/exact_ray.h"
#include "carve/gather.h"
#include "carve/side_of_solid.h"
#include "geometry/exact_point.h"
#include "geometry/rounding.h"

namespace firma {
namespace {

/// A direction that rises less along an axis may, exactly, fall.
constexpr double kLevel = 0x1p-40;

/// The part of a ray that lies beyond the point in the cutter's box.
GridBox way_out(const GridBox& box, const ExactPoint& from, const Vec3& direction) {
    GridBox way;
    way.add(from.rounded());
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] > -kLevel) way.high[axis] = std::max(way.high[axis], box.high[axis]);
        if (direction[axis] < kLevel) way.low[axis] = std::min(way.low[axis], box.low[axis]);
    }
    return way;
}

void append_edges(const CutterSolid& cutter, std::uint32_t t, std::vector<ExactRay::Edge>& edges) {
    const auto& corners = cutter.triangle(t);
    for (int k = 0; k < 3; ++k) {
        const CutterSolid::Edge& edge = cutter.edges[cutter.edge_of(t, k)];
        edges.push_back({&cutter.points[corners[std::size_t(k)]],
                         &cutter.points[corners[std::size_t(k < 2 ? k + 1 : 0)]], &cutter.across(edge, t).plane});
    }
}

/// Where a ray along an axis meets a triangle, in double, with what the sums may be off by.
class AxisRay {
public:
    /// @param forward  along the axis, or against it
    AxisRay(const ExactPoint& from, int axis, bool forward)
        : from_(from), axis_(axis), u_((axis + 1) % 3), v_((axis + 2) % 3), forward_(forward) {}

    GridBox way(const GridBox& box) const {
        GridBox way;
        way.add(from_.rounded());
        (forward_ ? way.high : way.low)[axis_] = (forward_ ? box.high : box.low)[axis_];
        return grown(way, 1);
    }
    ExactRay::Crossing meet(const CutterSolid& cutter, std::uint32_t t) const {
        bool left = false, right = false, near = false;
        const CutterTriangle& corners = cutter.triangle(t);
        for (std::size_t k = 0; k < 3; ++k) {
            const int turn = turn_of(cutter.points[corners[k]].approximate(),
                                     cutter.points[corners[k < 2 ? k + 1 : 0]].approximate());
            left |= turn > 0;
            right |= turn < 0;
            near |= turn == 0;
        }
        if (left && right) return ExactRay::Crossing::kNone;
        if (near) return ExactRay::Crossing::kUnsure;
        const int side = exact_side(cutter.planes[t]->plane, from_);
        if (side == 0) return ExactRay::Crossing::kOn;
        return (side > 0) == (left != forward_) ? ExactRay::Crossing::kCrosses : ExactRay::Crossing::kNone;
    }

private:
    /// Whether an edge passes the ray on its left, 1, or on its right, seen against the axis; 0: too near to tell.
    int turn_of(const Vec3& a, const Vec3& b) const {
        const Vec3& p = from_.approximate();
        const double a_u = a[u_] - p[u_], a_v = a[v_] - p[v_], b_u = b[u_] - p[u_], b_v = b[v_] - p[v_];
        const double one = a_u * b_v, other = a_v * b_u;
        // Each difference is off by two approximations and a rounding, each product and their difference by one more.
        const double error =
            4 * kApproximation * (std::fabs(a_u) + std::fabs(a_v) + std::fabs(b_u) + std::fabs(b_v) + 1) +
            rounding(8) * (std::fabs(one) + std::fabs(other));
        return one - other > error ? 1 : one - other < -error ? -1 : 0;
    }

    const ExactPoint& from_;
    const int axis_, u_, v_;
    const bool forward_;
};

/// side_of_cutter() of a mesh along the axes, the shortest way out first; 0: too near to edges to tell.
int side_along_axes(const CutterSolid& cutter, const ExactPoint& point, bool& on_surface) {
    const GridPoint& p = point.rounded();
    for (int axis = 0; axis < 3; ++axis)
        if (p[axis] < cutter.box.low[axis] - 1 || p[axis] > cutter.box.high[axis] + 1) return -1;
    struct Way {
        std::int64_t length;
        int axis;
        bool forward;
    };
    std::array<Way, 3> ways;
    for (int axis = 0; axis < 3; ++axis) {
        const std::int64_t up = std::int64_t(cutter.box.high[axis]) - p[axis];
        const std::int64_t down = std::int64_t(p[axis]) - cutter.box.low[axis];
        ways[std::size_t(axis)] = {std::min(up, down), axis, up <= down};
    }
    sort_range(std::span<Way>(ways),
               [](const Way& a, const Way& b) { return a.length != b.length ? a.length < b.length : a.axis < b.axis; });
    for (const Way& way : ways) {
        const AxisRay ray(point, way.axis, way.forward);
        CrossingCount crossings;
        cutter.tree.for_each_meeting(ray.way(cutter.box),
                                     [&](std::uint32_t t) { return !crossings.add(ray.meet(cutter, t)); });
        on_surface = crossings.begins_on_one();
        if (on_surface) return 0;
        if (crossings.sure()) return crossings.odd() ? 1 : -1;
    }
    return 0;
}

}  // namespace

int side_of_cutter(const CutterSolid& cutter, const ExactPoint& point) {
    if (!cutter.turned) {
        bool on_surface = false;
        const int side = side_along_axes(cutter, point, on_surface);
        if (side != 0 || on_surface) return side;
    }
    std::vector<ExactRay::Edge> edges;
    std::vector<std::uint32_t> asked(cutter.turned ? cutter.turned->boundary.faces.size() : 0, ~0u);
    for (int way = 0; way < ExactRay::kWays; ++way) {
        const ExactRay ray(point, way);
        CrossingCount crossings;
        const auto meet = [&](const Plane& plane) { return !crossings.add(ray.meet(plane, edges, INFINITY)); };
        // The point lies within a step of its rounded one; a Solid's facets lie near its faces.
        const std::int32_t steps = cutter.turned ? 1 + kFacetReach : 1;
        cutter.tree.for_each_meeting(grown(way_out(cutter.box, point, ray.direction()), steps), [&](std::uint32_t t) {
            edges.clear();
            if (!cutter.turned) {
                append_edges(cutter, t, edges);
                return meet(cutter.planes[t]->plane);
            }
            const SolidPatch& boundary = cutter.turned->boundary;
            const std::uint32_t face = cutter.turned->face_of[t];
            if (asked[face] == std::uint32_t(way)) return false;
            asked[face] = std::uint32_t(way);
            append_edges(boundary, boundary.faces[face], edges);
            return meet(boundary.faces[face].plane->plane);
        });
        if (crossings.begins_on_one()) return 0;
        if (crossings.sure()) return crossings.odd() ? 1 : -1;
    }
    return 0;
}

}  // namespace firma
