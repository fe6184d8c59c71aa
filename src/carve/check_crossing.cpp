// SPDX-License-Identifier: MIT
// First whether the surface is a star around its middle, which nearly every crater is; then pair by pair.
#include "carve/check_crossing.h"

#include <vector>

#include "index/box_tree.h"

namespace firma {
namespace {

/// A direction out of the middle, or a vertex seen from it: 27 bits each.
struct Ray {
    std::int64_t x = 0, y = 0, z = 0;
};

Ray cross_product(const Ray& a, const Ray& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The dot product of one with 55 bits and one with 27.
int dot_sign(const Ray& a, const Ray& b) {
    const Int128 sum = Int128(a.x) * b.x + Int128(a.y) * b.y + Int128(a.z) * b.z;
    return sum > 0 ? 1 : sum < 0 ? -1 : 0;
}

InputPoint middle_of(const std::vector<InputPoint>& vertices) {
    InputPoint middle;
    for (int axis = 0; axis < 3; ++axis) {
        std::int64_t sum = 0;
        for (const InputPoint& v : vertices) sum += v[axis];
        middle[axis] = std::int32_t(sum / std::int64_t(vertices.size()));
    }
    return middle;
}

/// What a look at the surface from the middle, along one direction, tells.
enum class Look : std::uint8_t {
    kStar,     ///< every triangle faces away, one covers the direction
    kNoStar,   ///< some triangle does not face away, or not exactly one covers the direction
    kUnclear,  ///< the direction passes through an edge
};

Look look_along(const Ray& direction, const std::vector<Ray>& rays, const std::vector<CutterTriangle>& triangles) {
    int covering = 0;
    bool clear = true;
    for (const auto& [ia, ib, ic] : triangles) {
        const Ray &a = rays[ia], &b = rays[ib], &c = rays[ic];
        const Ray ab = cross_product(a, b);
        if (dot_sign(ab, c) <= 0) return Look::kNoStar;
        const int at_ab = dot_sign(ab, direction);
        if (at_ab < 0) continue;
        const int at_bc = dot_sign(cross_product(b, c), direction);
        if (at_bc < 0) continue;
        const int at_ca = dot_sign(cross_product(c, a), direction);
        if (at_ca < 0) continue;
        ++covering;
        clear &= at_ab > 0 && at_bc > 0 && at_ca > 0;
    }
    return !clear ? Look::kUnclear : covering == 1 ? Look::kStar : Look::kNoStar;
}

/// Edges are not likely to be seen in these.
constexpr Ray kDirections[] = {{30011, 41011, 52009}, {-50021, 20011, 37013}, {7001, -61001, 23003}};

}  // namespace

// Look at the surface from the middle. Suppose every triangle faces away, strictly (its volume with the middle is
// positive), and some direction that passes through no edge meets exactly one. Then:
//  - Directions meet each part of a closed surface equally often, counted with the sign of facing; as all signs are
//    positive, every direction that passes through no edge meets exactly one triangle. So the cones of two triangles
//    share no inner direction.
//  - Across an edge the neighbour continues on the other side, as both face away. The two cover all directions around
//  an
//    inner point of the edge, so that no third triangle is seen there, not even with its boundary.
//  - Around a vertex the triangles of one fan follow each other and close up: likewise nothing else is seen there.
// Whatever two triangles share is seen in one direction, so it can only be their common edge or vertex.
bool is_star_shaped(const PlacedCutter& placed) {
    if (placed.vertices.empty()) return false;
    const InputPoint middle = middle_of(placed.vertices);
    std::vector<Ray> rays;
    rays.reserve(placed.vertices.size());
    for (const InputPoint& v : placed.vertices) rays.push_back({v.x - middle.x, v.y - middle.y, v.z - middle.z});
    for (const Ray& direction : kDirections) {
        const Look look = look_along(direction, rays, placed.triangles);
        if (look != Look::kUnclear) return look == Look::kStar;
    }
    return false;
}

std::vector<GridBox> triangle_boxes(const PlacedCutter& placed) {
    std::vector<GridBox> boxes(placed.triangles.size());
    for (std::size_t t = 0; t < boxes.size(); ++t)
        for (const std::uint32_t corner : placed.triangles[t]) boxes[t].add(to_surface(placed.vertices[corner]));
    return boxes;
}

std::optional<Crossing> find_crossing_pair(const PlacedCutter& placed, PairBudget* budget) {
    const BoxTree tree(triangle_boxes(placed));
    std::vector<MeshPolygon> polygons;
    polygons.reserve(placed.triangles.size());
    for (std::uint32_t t = 0; t < placed.triangles.size(); ++t) polygons.push_back(polygon_of(placed, t));
    Crossing crossing;
    // In the order of the tree, so that one search finds in the cache what the last one looked at.
    for (const BoxTree::Item& item : tree.items()) {
        const std::uint32_t t = item.number;
        const bool found = tree.for_each_meeting(item.box, [&](std::uint32_t u) {
            if (u <= t) return false;
            if (budget && !budget->take()) return true;
            if (!polygons_cross(placed.vertices, polygons[t], polygons[u])) return false;
            crossing = {t, u};
            return true;
        });
        if (budget && budget->spent()) return std::nullopt;
        if (found) return crossing;
    }
    return std::nullopt;
}

}  // namespace firma
