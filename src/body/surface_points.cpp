// SPDX-License-Identifier: MIT
// Points spread over a surface.
#include "body/surface_points.h"

#include "base/sort.h"
#include "body/point_order.h"

#include <algorithm>
#include <cmath>

#include "solid/block.h"
#include "solid/solid_data.h"

namespace firma {
namespace {

void add_points(const SurfaceTriangle& triangle, double spacing, std::vector<SurfacePoint>& points) {
    std::size_t longest = 0;
    double base = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double side = length(triangle[(k + 1) % 3] - triangle[k]);
        if (side > base) base = side, longest = k;
    }
    const Vec3 a = triangle[longest], b = triangle[(longest + 1) % 3], top = triangle[(longest + 2) % 3];
    const Vec3 twice = cross(b - a, top - a);
    const double size = length(twice);
    if (!(size > 0)) return;
    const Vec3 normal = twice * (1 / size);
    const auto rows = std::size_t(std::ceil(size / base / spacing));
    for (std::size_t row = 0; row < rows; ++row) {
        const double up = (double(row) + 0.5) / double(rows);
        const auto count = std::max<std::size_t>(1, std::size_t(std::ceil(base * (1 - up) / spacing)));
        const Vec3 left = a + (top - a) * up, right = b + (top - b) * up;
        for (std::size_t k = 0; k < count; ++k)
            points.push_back({left + (right - left) * ((double(k) + 0.5) / double(count)), normal});
    }
}

}  // namespace

std::vector<SurfaceTriangle> triangles_of(const Solid& solid) {
    std::vector<SurfaceTriangle> triangles;
    const Node* root = solid.data().faces.root.get();
    if (!root) return triangles;
    for_each_block(*root, [&](const Block& block) {
        for (const FaceRecord& face : block.faces) {
            const Vec3 first = to_metres(block.corner(face, 0));
            for (std::uint32_t k = 2; k < face.corner_count; ++k) {
                const SurfaceTriangle triangle{first, to_metres(block.corner(face, k - 1)),
                                               to_metres(block.corner(face, k))};
                if (area_of(triangle) > 0) triangles.push_back(triangle);
            }
        }
    });
    return triangles;
}

double area_of(const SurfaceTriangle& triangle) {
    return length(cross(triangle[1] - triangle[0], triangle[2] - triangle[0])) / 2;
}

std::vector<Vec3> corners_of(const std::vector<SurfaceTriangle>& triangles) {
    std::vector<Vec3> corners;
    for (const SurfaceTriangle& triangle : triangles) corners.insert(corners.end(), triangle.begin(), triangle.end());
    sort_range(corners, comes_before);
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    return corners;
}

std::vector<Vec3> side_points(const std::vector<SurfaceTriangle>& triangles, double spacing) {
    std::vector<Vec3> points;
    for (const SurfaceTriangle& triangle : triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 a = triangle[k], b = triangle[(k + 1) % 3], side = b - a;
            if (!comes_before(a, b)) continue;  // the neighbour has it the other way round
            const auto count = std::size_t(std::ceil(length(side) / spacing));
            for (std::size_t i = 0; i < count; ++i) points.push_back(a + side * ((double(i) + 0.5) / double(count)));
        }
    return points;
}

std::vector<SurfacePoint> surface_points(const std::vector<SurfaceTriangle>& triangles, double spacing) {
    std::vector<SurfacePoint> points;
    for (const SurfaceTriangle& triangle : triangles) add_points(triangle, spacing, points);
    return points;
}

}  // namespace firma
