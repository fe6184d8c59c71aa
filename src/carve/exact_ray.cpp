// SPDX-License-Identifier: MIT
// A ray from an exact point.
#include "carve/exact_ray.h"

#include <cmath>
#include <utility>

namespace firma {
namespace {

/// Normals of planes through a point of the grid: no two of a row are parallel, few planes of levels are like them.
constexpr std::int64_t kNormals[6][3][3] = {
    {{13, 5, -3}, {-4, 11, 7}, {2, -9, 17}},   {{7, -16, 5}, {9, 4, -19}, {-11, 3, 8}},
    {{3, 8, 23}, {21, -2, 5}, {-6, 25, 4}},    {{-15, 7, 9}, {8, 19, -5}, {4, 6, 21}},
    {{27, -4, 11}, {5, 14, -9}, {-3, 10, 31}}, {{6, 29, -7}, {-17, 3, 12}, {10, -5, 33}},
};

}  // namespace

ExactRay::ExactRay(const ExactPoint& from, int way) : from_(from) {
    const int row = way / 2;
    sign_ = way % 2 == 0 ? 1 : -1;
    if (from.on_grid()) {
        const InputPoint p = from.grid();
        for (std::size_t k = 0; k < 3; ++k) {
            Int128 offset = 0;
            for (int axis = 0; axis < 3; ++axis) offset -= Int128(kNormals[row][k][axis]) * p[axis];
            own_[k] = plane_of_numbers(kNormals[row][k], offset);
            planes_[k] = &own_[k];
        }
    } else {
        // Each two of the three, in both orders.
        constexpr int kOrders[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {1, 0, 2}, {2, 1, 0}, {0, 2, 1}};
        for (std::size_t k = 0; k < 3; ++k) planes_[k] = from.plane(kOrders[row][k]);
    }
    const Vec3 along = cross(planes_[0]->unit_normal(), planes_[1]->unit_normal());
    direction_ = along * (double(sign_) / length(along));
}

/// Whether both planes may pass between the corners, by the filter of exact_side() at the box's farthest ones.
bool ExactRay::may_meet(const Vec3& low, const Vec3& high) const {
    for (int k = 0; k < 2; ++k) {
        const Plane& plane = *planes_[k];
        const Vec3 n = plane.direction();
        Vec3 back = low, front = high;
        for (int axis = 0; axis < 3; ++axis)
            if (n[axis] < 0) std::swap(back[axis], front[axis]);
        const double error = kSideError * plane.size;
        if (dot(n, front) + plane.d < -error || dot(n, back) + plane.d > error) return false;
    }
    return true;
}

ExactRay::Crossing ExactRay::meet(const Plane& face, std::span<const Edge> loops, double until) const {
    const Plane &p = *planes_[0], &q = *planes_[1];
    bool passes = false;
    int first = 0;
    for (const Edge& edge : loops) {
        const int side = exact_side(p, *edge.from);
        if (first == 0) first = side;
        passes |= side == 0 || side != first;
    }
    if (!passes) return Crossing::kNone;
    if (exact_turn(p, q, face) == 0) return exact_side(face, from_) == 0 ? Crossing::kUnsure : Crossing::kNone;
    if (!meet_in_world(p, q, face)) return Crossing::kNone;
    const ExactPoint at(p, q, face);
    const int order = exact_side(face, from_) == 0 ? 0 : sign_ * exact_order(p, q, from_, *planes_[2], at);
    if (order < 0) return Crossing::kNone;
    if (order > 0 && dot(at.approximate() - from_.approximate(), direction_) > until) return Crossing::kNone;
    const int inside = encloses(face, loops, at);
    if (order == 0) return inside == 0 ? Crossing::kNone : Crossing::kOn;
    return inside < 0 ? Crossing::kUnsure : inside > 0 ? Crossing::kCrosses : Crossing::kNone;
}

/// By the edges that the first plane crosses, beyond the point along the line in which it meets the face. What lies on
/// the plane counts as behind it.
int ExactRay::encloses(const Plane& face, std::span<const Edge> loops, const ExactPoint& point) const {
    const Plane &p = *planes_[0], &q = *planes_[1];
    bool inside = false;
    for (const Edge& edge : loops) {
        const int a = exact_side(p, *edge.from), b = exact_side(p, *edge.to);
        if (a == 0 || b == 0) {
            const int at_a = a == 0 ? exact_order(face, p, point, q, *edge.from) : 2;
            const int at_b = b == 0 ? exact_order(face, p, point, q, *edge.to) : 2;
            if (at_a == 0 || at_b == 0 || at_a * at_b == -1) return -1;
        }
        if ((a > 0) == (b > 0)) continue;
        const int beyond = exact_order(face, p, point, q, ExactPoint(face, p, *edge.across));
        if (beyond == 0) return -1;
        if (beyond > 0) inside = !inside;
    }
    return inside;
}

}  // namespace firma
