// SPDX-License-Identifier: MIT
// Solids with reflex edges, for tests of convex pieces.
#pragma once

#include <cmath>
#include <initializer_list>
#include <utility>
#include <vector>

#include "firma/chunk.h"
#include "firma/convex_pieces.h"
#include "firma/turn.h"
#include "scenes/rng.h"
#include "tests/carve/cutters.h"
#include "tests/solid/solid_levels.h"

namespace firma::test {

inline Solid solid_of_mesh(const TriangleMesh& mesh) {
    return unite(Solid(), mesh.cutter().value(), {}).solid;
}

inline Solid block(const Vec3& low, const Vec3& high) {
    return solid_of_mesh(box_mesh(low, high));
}

/// Boxes united.
inline Solid boxes(std::initializer_list<std::pair<Vec3, Vec3>> all) {
    Solid solid;
    for (const auto& [low, high] : all) {
        const SolidResult more = unite(solid, box_mesh(low, high).cutter().value(), {});
        if (more.done()) solid = more.solid;
    }
    return solid;
}

inline Solid without(const Solid& solid, const Cutter& cutter, const Pose& pose = {}) {
    const SolidResult less = subtract(solid, cutter, pose);
    return less.done() ? less.solid : solid;
}

inline Solid without_box(const Solid& solid, const Vec3& low, const Vec3& high) {
    return without(solid, box_mesh(low, high).cutter().value());
}

/// A hall of that shape in rock without end.
inline Solid turned_out(const Solid& solid) {
    return make_world(box_level(solid.bounds().low, solid.bounds().high, true)).value().solid();
}

/// A prism along z from 0 to `height` on an outline that the origin sees whole, counter-clockwise.
inline TriangleMesh prism_mesh(const std::vector<Vec3>& outline, double height) {
    TriangleMesh mesh;
    const auto count = std::uint32_t(outline.size());
    for (const Vec3& corner : outline) mesh.vertices.push_back({corner.x, corner.y, 0});
    for (const Vec3& corner : outline) mesh.vertices.push_back({corner.x, corner.y, height});
    mesh.vertices.push_back({0, 0, 0});
    mesh.vertices.push_back({0, 0, height});
    for (std::uint32_t k = 0; k < count; ++k) {
        const std::uint32_t next = (k + 1) % count;
        mesh.triangles.push_back({next, k, 2 * count});
        mesh.triangles.push_back({count + k, count + next, 2 * count + 1});
        mesh.triangles.push_back({k, next, count + next});
        mesh.triangles.push_back({k, count + next, count + k});
    }
    return mesh;
}

/// A wheel with teeth, 0.25 m thick; a hole through its middle where `bore` is above zero.
inline Solid gear(int teeth, double bore) {
    const auto around = [&](double radius, double part) {
        const double angle = 2 * 3.14159265358979 * part / teeth;
        return Vec3{radius * std::cos(angle), radius * std::sin(angle), 0};
    };
    std::vector<Vec3> outline, hole;
    for (int k = 0; k < teeth; ++k)
        for (const auto& [radius, part] : {std::pair{0.8, 0.0}, {1.0, 0.1}, {1.0, 0.4}, {0.8, 0.5}})
            outline.push_back(around(radius, k + part));
    for (int k = 0; k < teeth; ++k) hole.push_back(around(bore, k));
    const Solid wheel = solid_of_mesh(prism_mesh(outline, 0.25));
    if (!(bore > 0)) return wheel;
    TriangleMesh drill = prism_mesh(hole, 1);
    for (Vec3& vertex : drill.vertices) vertex.z -= 0.5;
    return without(wheel, drill.cutter().value());
}

/// Random rubble: a block from which wedges, boxes and rough balls have bitten, at any turn.
inline Solid random_rubble(std::uint64_t seed) {
    scenes::Rng rng(seed);
    const Vec3 half{rng.uniform(0.1, 0.6), rng.uniform(0.1, 0.6), rng.uniform(0.1, 0.6)};
    Solid solid = block(-half, half);
    const int bites = 1 + int(rng.below(3));
    for (int k = 0; k < bites; ++k) {
        const std::uint32_t kind = rng.below(8);
        const CutterShape shape = kind < 3 ? CutterShape::kWedge : kind < 6 ? CutterShape::kBox : CutterShape::kRocky;
        Pose pose;
        pose.rotation = random_turn(rng.next());
        pose.scale = rng.uniform(0.1, 0.4);
        for (int axis = 0; axis < 3; ++axis) pose.position[axis] = rng.uniform(-1.1, 1.1) * half[axis];
        solid = without(solid, make_crater(shape, rng.next()), pose);
    }
    return solid;
}

}  // namespace firma::test
