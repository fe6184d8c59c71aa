// SPDX-License-Identifier: MIT
// Cuts a large square down to a brush's face.
#include "brush/winding.h"

#include <cmath>
#include <utility>

namespace firma {
namespace {

double height(const FloatPlane& plane, const Vec3& p) {
    return dot(plane.normal, p) - plane.distance;
}

// A square on the plane, around the point nearest to the origin.
std::vector<Vec3> square_on(const FloatPlane& plane, double reach) {
    const Vec3& n = plane.normal;
    int smallest = 0;
    for (int axis = 1; axis < 3; ++axis)
        if (std::fabs(n[axis]) < std::fabs(n[smallest])) smallest = axis;
    Vec3 axis;
    axis[smallest] = 1;
    Vec3 u = cross(n, axis);
    u = u * (reach / length(u));
    Vec3 v = cross(n, u);
    v = v * (reach / length(v));
    const Vec3 foot = n * (plane.distance / dot(n, n));
    return {foot - u - v, foot + u - v, foot + u + v, foot - u + v};
}

void clip_behind(std::vector<Vec3>& corners, std::vector<Vec3>& scratch, const FloatPlane& plane) {
    scratch.clear();
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const Vec3 &a = corners[k], &b = corners[k + 1 < corners.size() ? k + 1 : 0];
        const double ha = height(plane, a), hb = height(plane, b);
        if (ha <= 0) scratch.push_back(a);
        if ((ha < 0 && hb > 0) || (ha > 0 && hb < 0)) {
            // From the inner end, so that neighbours who share the edge come to the same point.
            const Vec3 &in = ha < 0 ? a : b, &out = ha < 0 ? b : a;
            const double hin = ha < 0 ? ha : hb, hout = ha < 0 ? hb : ha;
            scratch.push_back(in + (out - in) * (hin / (hin - hout)));
        }
    }
    std::swap(corners, scratch);
}

}  // namespace

std::optional<FloatPlane> float_plane(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 normal = cross(b - a, c - a);
    const double size = length(normal);
    if (!(size > 0) || !is_finite(size)) return std::nullopt;
    FloatPlane plane;
    plane.normal = normal * (1 / size);
    plane.distance = dot(plane.normal, a);
    return plane;
}

std::vector<Vec3> winding(std::span<const FloatPlane> planes, std::size_t which, double reach) {
    std::vector<Vec3> corners = square_on(planes[which], reach), scratch;
    for (std::size_t k = 0; k < planes.size() && !corners.empty(); ++k) {
        if (k == which) continue;
        const bool same = planes[k].normal == planes[which].normal && planes[k].distance == planes[which].distance;
        if (!same) clip_behind(corners, scratch, planes[k]);
    }
    return corners;
}

void merge_corners(std::vector<Vec3>& corners, double distance) {
    std::vector<Vec3> kept;
    for (const Vec3& corner : corners)
        if (kept.empty() || length(corner - kept.back()) > distance) kept.push_back(corner);
    while (kept.size() > 1 && length(kept.back() - kept.front()) <= distance) kept.pop_back();
    corners = std::move(kept);
}

double area(std::span<const Vec3> corners) {
    Vec3 twice;
    for (std::size_t k = 2; k < corners.size(); ++k) {
        twice = twice + cross(corners[k - 1] - corners[0], corners[k] - corners[0]);
    }
    return 0.5 * length(twice);
}

}  // namespace firma
