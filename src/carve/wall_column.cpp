// SPDX-License-Identifier: MIT
// What stands straight over a hole in a wall.
#include "carve/wall_column.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "base/sort.h"
#include "carve/check_crossing.h"
#include "carve/place_cutter.h"
#include "geometry/exact_plane.h"

namespace firma {
namespace {

constexpr double kUnderSquare = 8 / kInputSteps;
/// More, as a longer way is straighter once it is snapped.
constexpr double kUnderSlanted = 32 / kInputSteps;
constexpr int kBehindSlanted = 4;  ///< surface steps

int steepest_axis(const Vec3& normal) {
    int axis = 0;
    for (int k = 1; k < 3; ++k)
        if (std::fabs(normal[k]) > std::fabs(normal[axis])) axis = k;
    return axis;
}

Vec3 snapped(const Vec3& p) {
    Vec3 at;
    for (int axis = 0; axis < 3; ++axis) at[axis] = std::floor(p[axis] * kInputSteps + 0.5) / kInputSteps;
    return at;
}

/// Points by index; lower and upper ends of a prism.
struct ColumnPrism {
    std::vector<Vec3> base;  ///< on the input grid
    std::vector<CutterTriangle> triangles;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> sides;

    void add_polygon(std::span<const std::uint32_t> corners) {
        for (std::size_t k = 2; k < corners.size(); ++k)
            if (corners[0] != corners[k - 1] && corners[k - 1] != corners[k] && corners[k] != corners[0])
                triangles.push_back({corners[0], corners[k - 1], corners[k]});
    }
    /// The sides of triangles that have no other beside them.
    void find_sides() {
        for (const CutterTriangle& corners : triangles)
            for (std::size_t k = 0; k < 3; ++k) sides.emplace_back(corners[k], corners[(k + 1) % 3]);
        sort_range(sides);
        const auto all = sides;
        std::erase_if(sides, [&](const auto& side) {
            return std::binary_search(all.begin(), all.end(), std::pair(side.second, side.first));
        });
    }
    /// @return not valid() where it is no sound cutter in the world
    Cutter raise(const Vec3& under, const Vec3& over) const {
        const auto count = std::uint32_t(base.size());
        std::vector<Vec3> points;
        for (const Vec3& p : base) points.push_back(p + under);
        for (const Vec3& p : base) points.push_back(p + over);
        std::vector<CutterTriangle> mesh;
        for (const auto& [a, b, c] : triangles) {
            mesh.push_back({a, c, b});
            mesh.push_back({a + count, b + count, c + count});
        }
        for (const auto& [a, b] : sides) {
            mesh.push_back({a, b, b + count});
            mesh.push_back({a, b + count, a + count});
        }
        const Result<Cutter> cutter = make_cutter(points, mesh, "column");
        if (!cutter) return {};
        const Result<PlacedCutter> placed = place_cutter(cutter.value(), {});
        if (!placed || find_crossing(placed.value())) return {};
        return cutter.value();
    }
};

ColumnPrism prism_over(const FaceSet& polygons) {
    ColumnPrism prism;
    std::vector<Vec3> corners;
    const auto before = [](const Vec3& a, const Vec3& b) {
        return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
    };
    for (const FaceSet::Entry& face : polygons.faces)
        for (std::uint32_t k = 0; k < face.corner_count; ++k)
            corners.push_back(snapped(to_metres(polygons.corner(face, k))));
    prism.base = corners;
    sort_range(prism.base, before);
    prism.base.erase(std::unique(prism.base.begin(), prism.base.end()), prism.base.end());
    std::vector<std::uint32_t> loop;
    std::size_t next = 0;
    for (const FaceSet::Entry& face : polygons.faces) {
        loop.clear();
        for (std::uint32_t k = 0; k < face.corner_count; ++k) {
            const auto at = std::lower_bound(prism.base.begin(), prism.base.end(), corners[next++], before);
            loop.push_back(std::uint32_t(at - prism.base.begin()));
        }
        prism.add_polygon(loop);
    }
    prism.find_sides();
    return prism;
}

/// Over the hull of squares around the corners, two input steps wide.
ColumnPrism grown_prism(const FaceSet& polygons, const FaceSet::Entry& face, const Vec3& normal) {
    const int axis = steepest_axis(normal);
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const double way = normal[axis] < 0 ? -1 : 1;
    std::vector<Vec3> points;
    for (std::uint32_t k = 0; k < face.corner_count; ++k)
        for (const double right : {-1.0, 1.0})
            for (const double up : {-1.0, 1.0}) {
                Vec3 p = snapped(to_metres(polygons.corner(face, k)));
                p[u] += right / kInputSteps;
                p[v] += up / kInputSteps;
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
    std::vector<std::uint32_t> loop;
    for (std::uint32_t k = 0; k < prism.base.size(); ++k) loop.push_back(k);
    prism.add_polygon(loop);
    prism.find_sides();
    return prism;
}

void add_loop(FaceSet& set, std::span<const GridPoint> corners) {
    FaceSet::Entry face;
    face.id = {std::uint32_t(set.faces.size())};
    face.first_corner = std::uint32_t(set.corners.size());
    face.corner_count = std::uint32_t(corners.size());
    for (const GridPoint& corner : corners) {
        set.corners.push_back(std::uint32_t(set.vertices.size()));
        set.vertices.push_back(corner);
    }
    set.faces.push_back(face);
}

}  // namespace

WallPlane wall_plane(const Vec3& normal, const GridPoint& point) {
    WallPlane wall{normal, dot(normal, to_metres(point)), -1, 0};
    for (int axis = 0; axis < 3; ++axis) {
        if (std::fabs(normal[axis]) != 1) continue;
        wall.axis = axis;
        wall.level = point[axis];
    }
    return wall;
}

FaceSet section_of_box(const WallPlane& wall, const GridBox& box) {
    FaceSet set;
    const int axis = wall.axis >= 0 ? wall.axis : steepest_axis(wall.normal);
    if (wall.axis >= 0 && (wall.level < box.low[axis] || wall.level > box.high[axis])) return set;
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const bool turned = wall.normal[axis] < 0;
    GridPoint corners[4];
    double lowest = INFINITY, highest = -INFINITY;
    for (int k = 0; k < 4; ++k) {
        GridPoint& p = corners[turned ? 3 - k : k];
        p[u] = k == 1 || k == 2 ? box.high[u] : box.low[u];
        p[v] = k >= 2 ? box.high[v] : box.low[v];
        if (wall.axis >= 0) {
            p[axis] = wall.level;
            continue;
        }
        const Vec3 at = to_metres(p);
        const double level = (wall.offset - wall.normal[u] * at[u] - wall.normal[v] * at[v]) / wall.normal[axis];
        const double steps = std::floor(level * kSurfaceSteps + 0.5) + (turned ? kBehindSlanted : -kBehindSlanted);
        if (!(std::fabs(steps) < 0x7fffffc0)) return set;
        p[axis] = std::int32_t(steps);
        lowest = std::min(lowest, steps);
        highest = std::max(highest, steps);
    }
    if (wall.axis >= 0) {
        add_loop(set, corners);
        return set;
    }
    if (highest < box.low[axis] || lowest > box.high[axis]) return set;
    const GridPoint halves[2][3] = {{corners[0], corners[1], corners[2]}, {corners[0], corners[2], corners[3]}};
    for (const auto& half : halves) add_loop(set, half);
    return set;
}

std::vector<Cutter> columns_over(const FaceSet& polygons, const WallPlane& wall, double height) {
    const Vec3 under = snapped(wall.normal * -(wall.axis >= 0 ? kUnderSquare : kUnderSlanted));
    const Vec3 over = snapped(wall.normal * height);
    std::vector<Cutter> columns;
    if (const Cutter whole = prism_over(polygons).raise(under, over); whole.valid()) {
        columns.push_back(whole);
        return columns;
    }
    for (const FaceSet::Entry& face : polygons.faces)
        if (const Cutter part = grown_prism(polygons, face, wall.normal).raise(under, over); part.valid())
            columns.push_back(part);
    return columns;
}

}  // namespace firma
