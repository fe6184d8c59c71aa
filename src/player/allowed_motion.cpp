// SPDX-License-Identifier: MIT
// A projection onto the cone between planes, by all its faces and edges.
#include "player/allowed_motion.h"

namespace firma {
namespace {

/// Rounding, a share of a motion: what leads into a plane by so little leads along it. Far above what a projection is
/// off by, and so small that the contact offset outlasts any path.
constexpr double kAlongPlane = 1e-10;
/// Rounding, the sine of an angle: the line of two planes nearer than that is not known.
constexpr double kParallel = 1e-7;

}  // namespace

bool AllowedMotion::holds(const Vec3& normal) const {
    for (std::size_t k = 0; k < count_; ++k)
        if (max_abs(normals_[k] - normal) < kAlongPlane) return true;
    return false;
}

void AllowedMotion::add(const Vec3& normal) {
    if (count_ < kMaxPlanes && !holds(normal)) normals_[count_++] = normal;
}

bool AllowedMotion::allows(const Vec3& motion) const {
    const double least = -kAlongPlane * length(motion);
    for (std::size_t k = 0; k < count_; ++k)
        if (dot(normals_[k], motion) < least) return false;
    return true;
}

// The part of `wanted` in one plane that it leads into, where allowed, is the nearest: the conditions of Karush, Kuhn
// and Tucker hold. Else the nearest lies on a line of two planes, or is zero: it is the projection onto that line, and
// as |wanted - d|^2 = |wanted|^2 - |d|^2 the longest that is allowed.
Vec3 AllowedMotion::nearest(const Vec3& wanted) const {
    if (allows(wanted)) return wanted;
    for (std::size_t i = 0; i < count_; ++i) {
        const double into = dot(normals_[i], wanted);
        const Vec3 along = wanted - normals_[i] * into;
        if (into < 0 && allows(along)) return along;
    }
    Vec3 best;
    for (std::size_t i = 0; i < count_; ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const Vec3 line = cross(normals_[i], normals_[j]);
            const double size = dot(line, line);
            if (!(size > kParallel * kParallel)) continue;
            const Vec3 along = line * (dot(line, wanted) / size);
            if (dot(along, along) > dot(best, best) && allows(along)) best = along;
        }
    return best;
}

}  // namespace firma
