// SPDX-License-Identifier: MIT
// The convex hull of a few points, point by point, with exact signs.
//
// A point outside sees some triangles strictly from their front; those are replaced by triangles from the border of
// what it sees. Triangles in one plane are seen alike, as signs are exact; so the border is a single loop, and no new
// triangle is flat.
#include "cast/hull_shape.h"

#include <cmath>
#include <string>

#include "cast/sizes_of.h"
#include "geometry/rounding.h"

namespace firma {
namespace {

using HullCorners = std::array<std::uint8_t, 3>;

/// Sign of (b - a) x (c - a) . (p - a).
int side_of_corners(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
    const Vec3 ab = b - a, ac = c - a, ap = p - a;
    const double estimate = dot(cross(ab, ac), ap);
    if (std::fabs(estimate) > rounding(64) * 6 * max_abs(ab) * max_abs(ac) * max_abs(ap)) return estimate > 0 ? 1 : -1;
    return exact_triple_sign(difference_as_sum(p, a), difference_as_sum(b, a), difference_as_sum(c, a));
}

bool on_one_line(const Vec3& a, const Vec3& b, const Vec3& c) {
    for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}})
        if (exact_triple_sign(as_sum(axis), difference_as_sum(b, a), difference_as_sum(c, a)) != 0) return false;
    return true;
}

class HullOfPoints {
public:
    explicit HullOfPoints(std::span<const Vec3> points) : points_(points) {}

    /// @return whether there are four points that are not in one plane
    bool run() {
        if (!begin()) return false;
        for (std::size_t p = 0; p < points_.size(); ++p) add(std::uint8_t(p));
        return true;
    }
    const std::vector<HullCorners>& triangles() const { return triangles_; }

private:
    bool begin() {
        const std::size_t count = points_.size();
        std::size_t b = 1, c = 1, d = 1;
        while (b < count && points_[b] == points_[0]) ++b;
        while (b < count && c < count && on_one_line(points_[0], points_[b], points_[c])) ++c;
        if (b >= count || c >= count) return false;
        int side = 0;
        for (; d < count; ++d)
            if ((side = side_of_corners(points_[0], points_[b], points_[c], points_[d])) != 0) break;
        if (side == 0) return false;
        if (side > 0) std::swap(b, c);
        const auto o = std::uint8_t(0), x = std::uint8_t(b), y = std::uint8_t(c), z = std::uint8_t(d);
        triangles_ = {{o, x, y}, {o, z, x}, {x, z, y}, {y, z, o}};
        return true;
    }

    void add(std::uint8_t p) {
        std::vector<HullCorners> kept;
        bool border[kMaxHullCorners][kMaxHullCorners] = {};  // directed edges of what is seen
        bool any = false;
        for (const HullCorners& t : triangles_) {
            if (side_of_corners(points_[t[0]], points_[t[1]], points_[t[2]], points_[p]) <= 0) {
                kept.push_back(t);
                continue;
            }
            any = true;
            for (std::size_t k = 0; k < 3; ++k) border[t[k]][t[(k + 1) % 3]] = true;
        }
        if (!any) return;
        for (std::size_t a = 0; a < points_.size(); ++a)
            for (std::size_t b = 0; b < points_.size(); ++b)
                if (border[a][b] && !border[b][a]) kept.push_back({std::uint8_t(a), std::uint8_t(b), p});
        triangles_ = std::move(kept);
    }

    std::span<const Vec3> points_;
    std::vector<HullCorners> triangles_;
};

void keep_used_corners(std::span<const Vec3> points, const std::vector<HullCorners>& triangles, HullShape& shape) {
    std::array<int, kMaxHullCorners> place;
    place.fill(-1);
    for (HullCorners t : triangles) {
        for (std::uint8_t& corner : t) {
            int& at = place[corner];
            if (at < 0) {
                at = int(shape.corners.size());
                shape.corners.push_back(points[corner]);
                const double far = length(points[corner]) * (1 + rounding(8));
                if (far > shape.reach) shape.reach = far;
            }
            corner = std::uint8_t(at);
        }
        const Vec3 b = shape.corners[t[1]] - shape.corners[t[0]], c = shape.corners[t[2]] - shape.corners[t[0]];
        const Vec3 normal = cross(b, c), error = sizes_of_cross(b, c) * rounding(5);
        shape.triangles.push_back({t, normal, error, error + sizes_of(normal) * rounding(4)});
    }
}

void put_box_around(HullShape& shape) {
    Vec3 low = shape.corners[0], high = low;
    for (const Vec3& corner : shape.corners)
        for (int axis = 0; axis < 3; ++axis) {
            if (corner[axis] < low[axis]) low[axis] = corner[axis];
            if (corner[axis] > high[axis]) high[axis] = corner[axis];
            if (std::fabs(corner[axis]) > shape.sizes[axis]) shape.sizes[axis] = std::fabs(corner[axis]);
        }
    shape.extent.axes = 3;
    for (int axis = 0; axis < 3; ++axis) {
        shape.extent.middle[axis] = low[axis] * 0.5 + high[axis] * 0.5;
        shape.extent.axis[std::size_t(axis)][axis] = high[axis] * 0.5 - low[axis] * 0.5;
    }
    shape.extent.radius = rounding(16) * shape.reach;
}

void find_edges(HullShape& shape) {
    std::array<std::array<std::uint8_t, kMaxHullCorners>, kMaxHullCorners> left{};
    for (std::size_t t = 0; t < shape.triangles.size(); ++t) {
        const HullCorners& corner = shape.triangles[t].corner;
        for (std::size_t k = 0; k < 3; ++k) left[corner[k]][corner[(k + 1) % 3]] = std::uint8_t(t);
    }
    for (std::size_t t = 0; t < shape.triangles.size(); ++t) {
        const HullCorners& corner = shape.triangles[t].corner;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint8_t a = corner[k], b = corner[(k + 1) % 3];
            if (a < b) shape.edges.push_back({a, b, std::uint8_t(t), left[b][a], shape.corners[b] - shape.corners[a]});
        }
    }
}

}  // namespace

Result<HullShape> shape_of_hull(std::span<const Vec3> points) {
    if (points.size() > kMaxHullCorners)
        return Error{ErrorCode::kTooLarge, "hull", std::to_string(points.size()) + " corners; at most 64 are allowed"};
    std::vector<Vec3> usable(points.begin(), points.end());
    for (std::size_t k = 0; k < usable.size(); ++k) {
        if (!is_finite(usable[k]) || max_abs(usable[k]) > kLargestNumber / 2)
            return Error{ErrorCode::kOutOfRange, "hull corner " + std::to_string(k), "not finite, or beyond 2^199"};
        for (int axis = 0; axis < 3; ++axis)
            if (std::fabs(usable[k][axis]) < kSmallestNumber) usable[k][axis] = 0;
    }
    HullOfPoints hull(usable);
    if (!hull.run()) return Error{ErrorCode::kInvalid, "hull", "all corners lie in one plane"};
    HullShape shape;
    keep_used_corners(usable, hull.triangles(), shape);
    find_edges(shape);
    put_box_around(shape);
    return shape;
}

}  // namespace firma
