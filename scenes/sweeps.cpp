// SPDX-License-Identifier: MIT
// Sweeps along a path.
#include "scenes/sweeps.h"

#include <cmath>

#include "base/assert.h"
#include "firma/mesh.h"

namespace firma::scenes {
namespace {

constexpr double kRadius = 0.0625, kLength = 0.03125;  // of a block whose edge is 1
constexpr int kSides = 16;

struct Shape {
    std::vector<Vec3> vertices;
    std::vector<CutterTriangle> triangles;
};

/// Sine and cosine of k sixteenths of a turn.
struct Turn {
    double cosine[kSides], sine[kSides];

    Turn() {
        const double root = std::sqrt(2.0);
        const double quarter[5] = {1, std::sqrt(2 + root) / 2, root / 2, std::sqrt(2 - root) / 2, 0};
        for (int k = 0; k < kSides; ++k) {
            const int within = k % 4;
            const double c = quarter[within], s = quarter[4 - within];
            const int quadrant = k / 4;
            cosine[k] = quadrant == 0 ? c : quadrant == 1 ? -s : quadrant == 2 ? -c : s;
            sine[k] = quadrant == 0 ? s : quadrant == 1 ? c : quadrant == 2 ? -s : -c;
        }
    }
};

struct Ring {
    double radius, height;
};

/// Rings around z from the lowest to the highest, closed by a point below and one above.
Shape turned(const std::vector<Ring>& rings, double lowest, double highest) {
    const Turn turn;
    Shape shape;
    for (const Ring& ring : rings)
        for (int k = 0; k < kSides; ++k)
            shape.vertices.push_back({ring.radius * turn.cosine[k], ring.radius * turn.sine[k], ring.height});
    const auto low = std::uint32_t(shape.vertices.size()), high = low + 1;
    shape.vertices.push_back({0, 0, lowest});
    shape.vertices.push_back({0, 0, highest});
    for (std::uint32_t k = 0; k < kSides; ++k) {
        const std::uint32_t next = (k + 1) % kSides, top = low - kSides;
        shape.triangles.push_back({low, next, k});
        for (std::uint32_t ring = 0; ring + kSides < low; ring += kSides) {
            shape.triangles.push_back({ring + k, ring + next, ring + kSides + next});
            shape.triangles.push_back({ring + k, ring + kSides + next, ring + kSides + k});
        }
        shape.triangles.push_back({top + k, top + next, high});
    }
    return shape;
}

Shape box(const Vec3& half) {
    Shape shape;
    for (int k = 0; k < 8; ++k)
        shape.vertices.push_back({k & 1 ? half.x : -half.x, k & 2 ? half.y : -half.y, k & 4 ? half.z : -half.z});
    shape.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                       {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return shape;
}

Shape shape_of(SweepTool tool) {
    const double half = kLength / 2;
    if (tool == SweepTool::kBox) return box({kRadius, kRadius / 2, half});
    if (tool == SweepTool::kCylinder) return turned({{kRadius, -half}, {kRadius, half}}, -half, half);
    const Turn turn;
    std::vector<Ring> rings;
    for (int k = -3; k <= 3; ++k) {
        const int size = k < 0 ? -k : k;
        const double radius = kRadius * turn.cosine[size], rise = kRadius * turn.sine[size];
        if (k <= 0) rings.push_back({radius, -half - rise});
        if (k >= 0) rings.push_back({radius, half + rise});
    }
    return turned(rings, -half - kRadius, half + kRadius);
}

/// From z to a direction, which is not against it.
Quaternion toward(const Vec3& direction) {
    return {-direction.y, direction.x, 0, direction.z + std::sqrt(dot(direction, direction))};
}

Vec3 blend(const Vec3& a, const Vec3& b, double t) {
    return a + (b - a) * t;
}

/// A place and a direction on the curve, t from 0 to 1: three pieces of degree 3.
void along_curve(double t, Vec3& place, Vec3& direction) {
    static constexpr Vec3 kControl[10] = {{-0.5625, -0.4375, -0.25}, {-0.25, -0.5, 0.25},     {0.125, -0.375, 0.375},
                                          {0.3125, -0.125, 0.25},    {0.5, 0.125, 0.125},     {0.375, 0.4375, -0.1875},
                                          {0.0625, 0.375, -0.0625},  {-0.25, 0.3125, 0.0625}, {-0.375, 0.0625, 0.25},
                                          {-0.0625, 0, 0.5625}};
    const int piece = t < 1.0 / 3 ? 0 : t < 2.0 / 3 ? 1 : 2;
    const double u = t * 3 - piece;
    const Vec3* p = kControl + 3 * piece;
    const Vec3 ab = blend(p[0], p[1], u), bc = blend(p[1], p[2], u), cd = blend(p[2], p[3], u);
    const Vec3 abc = blend(ab, bc, u), bcd = blend(bc, cd, u);
    place = blend(abc, bcd, u);
    direction = bcd - abc;
}

Pose pose_at(std::size_t k, double scale) {
    constexpr std::size_t kFirst = 24, kStraight = 40;
    Vec3 place, direction;
    if (k < kFirst) {
        place = {-0.375 + kLength * double(k), -0.375, 0.46875};
        direction = {1, 0, 0};
    } else if (k < kStraight) {
        place = {0.375, -0.375 + kLength * double(k - kFirst), 0.46875};
        direction = {0, 1, 0};
    } else {
        along_curve(double(k - kStraight) / double(kSweepCuts - kStraight - 1), place, direction);
    }
    return {place * scale, toward(direction), scale};
}

}  // namespace

std::string_view name_of(SweepTool tool) {
    return tool == SweepTool::kCapsule ? "capsules" : tool == SweepTool::kCylinder ? "cylinders" : "boxes";
}

Sweep make_sweep(SweepTool tool, int exponent) {
    FIRMA_ASSERT(exponent >= 0 && exponent <= kLargestSweep, "a scale from 2^0 to 2^13");
    const double scale = std::ldexp(1.0, exponent);
    const Shape block = box({scale / 2, scale / 2, scale / 2});
    std::vector<std::uint32_t> corners;
    for (const CutterTriangle& triangle : block.triangles)
        corners.insert(corners.end(), triangle.begin(), triangle.end());
    Sweep sweep;
    Mesh mesh;
    mesh.vertices = block.vertices;
    mesh.corners = corners;
    sweep.block = level_from_mesh(mesh, "block").value();
    const Shape shape = shape_of(tool);
    sweep.tool = make_cutter(shape.vertices, shape.triangles, std::string(name_of(tool))).value();
    for (std::size_t k = 0; k < kSweepCuts; ++k) sweep.poses.push_back(pose_at(k, scale));
    return sweep;
}

}  // namespace firma::scenes
