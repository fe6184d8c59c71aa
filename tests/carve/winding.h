// SPDX-License-Identifier: MIT
// Whether a point lies in a placed cutter, by solid angles: slow and surely right, away from its surface.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "carve/place_cutter.h"
#include "firma/cutter.h"

namespace firma::test {

/// How often the surface of a mesh goes around a point: by solid angles.
inline double winding_around(std::span<const Vec3> vertices, std::span<const CutterTriangle> triangles,
                             const Vec3& point) {
    double sum = 0;
    for (const CutterTriangle& triangle : triangles) {
        std::array<Vec3, 3> to;
        for (std::size_t k = 0; k < 3; ++k) {
            to[k] = vertices[triangle[k]] - point;
            to[k] = to[k] * (1 / length(to[k]));
        }
        const double volume = dot(to[0], cross(to[1], to[2]));
        sum += 2 * std::atan2(volume, 1 + dot(to[0], to[1]) + dot(to[1], to[2]) + dot(to[2], to[0]));
    }
    return sum / (4 * std::numbers::pi);
}

/// Of a pose that does not turn, before it is snapped.
inline double winding(const Cutter& cutter, const Pose& pose, const Vec3& point) {
    std::vector<Vec3> vertices;
    for (const Vec3& vertex : cutter.vertices()) vertices.push_back(vertex * pose.scale + pose.position);
    return winding_around(vertices, cutter.triangles(), point);
}

/// As a cut places it.
class PlacedWinding {
public:
    PlacedWinding(const Cutter& cutter, const Pose& pose) : PlacedWinding(place_cutter(cutter, pose).value()) {}
    explicit PlacedWinding(const PlacedCutter& placed) {
        for (const InputPoint& p : placed.vertices) vertices_.push_back(to_metres(to_surface(p)));
        triangles_ = placed.triangles;
    }
    bool holds(const Vec3& point) const { return winding_around(vertices_, triangles_, point) > 0.5; }
    /// Whether it is so for all that is near, too.
    bool is_clear(const Vec3& point, double reach) const {
        const bool here = holds(point);
        for (int axis = 0; axis < 3; ++axis)
            for (const double step : {-reach, reach}) {
                Vec3 beside = point;
                beside[axis] += step;
                if (holds(beside) != here) return false;
            }
        return true;
    }

private:
    std::vector<Vec3> vertices_;
    std::vector<CutterTriangle> triangles_;
};

}  // namespace firma::test
