// SPDX-License-Identifier: MIT
// Meshes for the tests of cutters: boxes side by side in one mesh, and cutters placed by hand; what holds after any
// cut.
#pragma once

#include <gtest/gtest.h>

#include <initializer_list>
#include <optional>
#include <utility>
#include <vector>

#include "carve/cutter_topology.h"
#include "carve/place_cutter.h"
#include "firma/carve.h"
#include "firma/cutter.h"

namespace firma::test {

inline Pose pose_at(double x, double y, double z, double scale = 1) {
    Pose pose;
    pose.position = {x, y, z};
    pose.scale = scale;
    return pose;
}

struct TriangleMesh {
    std::vector<Vec3> vertices;
    std::vector<CutterTriangle> triangles;

    void add(const TriangleMesh& other) {
        const auto first = std::uint32_t(vertices.size());
        vertices.insert(vertices.end(), other.vertices.begin(), other.vertices.end());
        for (const auto& [a, b, c] : other.triangles) triangles.push_back({a + first, b + first, c + first});
    }
    void turn_over() {
        for (CutterTriangle& corners : triangles) std::swap(corners[1], corners[2]);
    }
    Result<Cutter> cutter() const { return make_cutter(vertices, triangles, "mesh"); }
};

inline TriangleMesh mesh_of(const Cutter& cutter) {
    return {{cutter.vertices().begin(), cutter.vertices().end()},
            {cutter.triangles().begin(), cutter.triangles().end()}};
}

/// Axis-aligned, from corner to corner.
inline TriangleMesh box_mesh(const Vec3& low, const Vec3& high) {
    TriangleMesh mesh = mesh_of(make_crater(CutterShape::kBox, 0));
    for (Vec3& v : mesh.vertices)
        for (int axis = 0; axis < 3; ++axis) v[axis] = v[axis] < 0 ? low[axis] : high[axis];
    return mesh;
}

/// Straight from the grid, unchecked.
inline PlacedCutter placed_by_hand(std::vector<InputPoint> vertices, std::vector<CutterTriangle> triangles) {
    PlacedCutter placed;
    placed.vertices = std::move(vertices);
    placed.triangles = std::move(triangles);
    return placed;
}

/// A ring around the z axis, wider than thick, of 2 * around * across triangles: no point inside sees it whole.
inline TriangleMesh ring_mesh(int around, int across) {
    TriangleMesh mesh;
    // Both circles by points of a square pushed out to the circle: no sine needed.
    const auto circle = [](int k, int count) {
        const double at = 4.0 * k / count, part = at - int(at);
        const Vec3 corner[5] = {{1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}, {1, 1, 0}};
        const Vec3 p = corner[int(at)] * (1 - part) + corner[int(at) + 1] * part;
        return p * (1 / length(p));
    };
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < across; ++j) {
            const Vec3 large = circle(i, around), small = circle(j, across);
            const double radius = 3 + small.x;
            mesh.vertices.push_back({large.x * radius, large.y * radius, small.y});
            const auto at = [&](int a, int b) { return std::uint32_t(a % around * across + b % across); };
            mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    return mesh;
}

/// What must hold of a world after any edit.
inline void expect_sound_world(const World& world) {
    const std::optional<WorldFault> fault = check_world(world);
    EXPECT_FALSE(fault) << fault->what << ", face " << fault->face.value;
    const auto solid = check_solid(world);
    EXPECT_FALSE(solid) << solid->what;
}

}  // namespace firma::test
