// SPDX-License-Identifier: MIT
// Prisms on the input grid.
#include "carve/column_prism.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "base/sort.h"
#include "carve/check_crossing.h"
#include "carve/place_cutter.h"

namespace firma {
namespace {

using PrismSide = std::pair<std::uint32_t, std::uint32_t>;

/// Those of triangles that have no other beside them.
std::vector<PrismSide> sides_of(std::span<const CutterTriangle> triangles) {
    std::vector<PrismSide> sides;
    for (const CutterTriangle& corners : triangles)
        for (std::size_t k = 0; k < 3; ++k) sides.emplace_back(corners[k], corners[(k + 1) % 3]);
    sort_range(sides);
    const auto all = sides;
    std::erase_if(sides, [&](const PrismSide& side) {
        return std::binary_search(all.begin(), all.end(), PrismSide(side.second, side.first));
    });
    return sides;
}

}  // namespace

int steepest_axis(const Vec3& normal) {
    int axis = 0;
    for (int k = 1; k < 3; ++k)
        if (std::fabs(normal[k]) > std::fabs(normal[axis])) axis = k;
    return axis;
}

Vec3 to_input_grid(const Vec3& p) {
    Vec3 at;
    for (int axis = 0; axis < 3; ++axis) at[axis] = std::floor(p[axis] * kInputSteps + 0.5) / kInputSteps;
    return at;
}

Cutter ColumnPrism::raise(const Vec3& under, const Vec3& over) const {
    const auto count = std::uint32_t(base.size());
    std::vector<Vec3> points;
    for (const Vec3& p : base) points.push_back(p + under);
    for (const Vec3& p : base) points.push_back(p + over);
    std::vector<CutterTriangle> mesh;
    for (const auto& [a, b, c] : triangles) {
        mesh.push_back({a, c, b});
        mesh.push_back({a + count, b + count, c + count});
    }
    for (const auto& [a, b] : sides_of(triangles)) {
        mesh.push_back({a, b, b + count});
        mesh.push_back({a, b + count, a + count});
    }
    Result<Cutter> cutter = make_cutter(points, mesh, "column");
    if (!cutter) return {};
    const Result<PlacedCutter> placed = place_cutter(cutter.value(), {});
    if (!placed || find_crossing(placed.value())) return {};
    return std::move(cutter.value());
}

ColumnPrism grown_prism(std::span<const Vec3> corners, const Vec3& normal) {
    const int axis = steepest_axis(normal);
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const double way = normal[axis] < 0 ? -1 : 1;
    std::vector<Vec3> points;
    for (const Vec3& corner : corners)
        for (const double right : {-1.0, 1.0})
            for (const double up : {-1.0, 1.0}) {
                Vec3 p = to_input_grid(corner);
                p[u] += right * kInputStep;
                p[v] += up * kInputStep;
                points.push_back(p);
            }
    sort_range(points, [&](const Vec3& a, const Vec3& b) {
        return a[u] != b[u] ? a[u] < b[u] : a[v] != b[v] ? a[v] < b[v] : a[axis] < b[axis];
    });
    // Source: A. Andrew, Another Efficient Algorithm for Convex Hulls in Two Dimensions, 1979. Exact in double: whole
    // steps.
    const auto turns = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
        return way * ((b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u])) > 0;
    };
    ColumnPrism prism;
    for (int pass = 0; pass < 2; ++pass) {
        const std::size_t first = prism.base.size();
        for (const Vec3& p : points) {
            while (prism.base.size() >= first + 2 && !turns(prism.base[prism.base.size() - 2], prism.base.back(), p))
                prism.base.pop_back();
            prism.base.push_back(p);
        }
        prism.base.pop_back();
        std::reverse(points.begin(), points.end());
    }
    for (std::uint32_t k = 2; k < prism.base.size(); ++k) prism.triangles.push_back({0, k - 1, k});
    return prism;
}

}  // namespace firma
