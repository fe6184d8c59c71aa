// SPDX-License-Identifier: MIT
// The volume of brushes joined, exactly: convex bodies as lists of polygons with rational corners.
#include "tests/reference/brush_oracle.h"

#include <algorithm>
#include <array>
#include <utility>

namespace firma::reference {
namespace {

using Corner = std::array<Rational, 3>;
using Polygon = std::vector<Corner>;
using Body = std::vector<Polygon>;

/// What lies in front is outside.
struct HalfSpace {
    std::array<boost::multiprecision::cpp_int, 3> normal;
    boost::multiprecision::cpp_int offset;

    Rational at(const Corner& p) const {
        return Rational(normal[0]) * p[0] + Rational(normal[1]) * p[1] + Rational(normal[2]) * p[2] + Rational(offset);
    }
};

HalfSpace half_space(const BrushSide& side) {
    std::int64_t p[3][3];
    for (int k = 0; k < 3; ++k)
        for (int axis = 0; axis < 3; ++axis) p[k][axis] = side.points[k][axis] / kSurfacePerInput;
    HalfSpace made;
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        made.normal[std::size_t(axis)] = boost::multiprecision::cpp_int(p[1][u] - p[0][u]) * (p[2][v] - p[0][v]) -
                                         boost::multiprecision::cpp_int(p[1][v] - p[0][v]) * (p[2][u] - p[0][u]);
        made.offset -= made.normal[std::size_t(axis)] * p[0][axis];
    }
    return made;
}

Body cube(std::int64_t half) {
    Body body;
    for (int axis = 0; axis < 3; ++axis)
        for (const std::int64_t at : {-half, half}) {
            Polygon polygon(4);
            constexpr int kSigns[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
            for (std::size_t k = 0; k < 4; ++k) {
                polygon[k][std::size_t(axis)] = at;
                polygon[k][std::size_t((axis + 1) % 3)] = kSigns[k][0] * half;
                polygon[k][std::size_t((axis + 2) % 3)] = kSigns[k][1] * half;
            }
            body.push_back(polygon);
        }
    return body;
}

Rational area_sign(const Corner& a, const Corner& b, const Corner& c, std::size_t u, std::size_t v) {
    return (b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u]);
}

/// The hull of points in a plane that is not parallel to the axis looked along.
Polygon hull(Polygon points, std::size_t axis) {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    const auto less = [&](const Corner& a, const Corner& b) { return a[u] != b[u] ? a[u] < b[u] : a[v] < b[v]; };
    std::sort(points.begin(), points.end(), less);
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 3) return {};
    Polygon around;
    for (int pass = 0; pass < 2; ++pass) {
        const std::size_t start = around.size();
        for (const Corner& point : points) {
            while (around.size() >= start + 2 && area_sign(around[around.size() - 2], around.back(), point, u, v) <= 0)
                around.pop_back();
            around.push_back(point);
        }
        around.pop_back();
        std::reverse(points.begin(), points.end());
    }
    return around.size() < 3 ? Polygon{} : around;
}

/// The part of a body on one side: behind the plane, or in front of it.
Body clip(const Body& body, const HalfSpace& by, bool keep_front) {
    Body kept;
    Polygon on_plane;
    bool any = false, any_off = false;
    for (const Polygon& polygon : body) {
        std::vector<Rational> at;
        for (const Corner& corner : polygon) at.push_back(keep_front ? -by.at(corner) : by.at(corner));
        Polygon part;
        for (std::size_t k = 0; k < polygon.size(); ++k) {
            const std::size_t next = (k + 1) % polygon.size();
            if (at[k] <= 0) part.push_back(polygon[k]);
            if (at[k] == 0) on_plane.push_back(polygon[k]);
            any = any || at[k] < 0;
            any_off = any_off || at[k] > 0;
            if (at[k] * at[next] >= 0) continue;
            const Rational share = at[k] / (at[k] - at[next]);
            Corner crossing;
            for (std::size_t axis = 0; axis < 3; ++axis)
                crossing[axis] = polygon[k][axis] + share * (polygon[next][axis] - polygon[k][axis]);
            part.push_back(crossing);
            on_plane.push_back(crossing);
        }
        if (part.size() >= 3) kept.push_back(std::move(part));
    }
    if (!any) return {};
    if (!any_off) return body;  // a face that lies in the plane is there already
    std::size_t axis = 0;
    while (by.normal[axis] == 0) ++axis;
    if (Polygon cap = hull(std::move(on_plane), axis); !cap.empty()) kept.push_back(std::move(cap));
    return kept;
}

Rational volume_of(const Body& body) {
    if (body.empty()) return 0;
    const Corner& o = body[0][0];
    Rational six = 0;
    for (const Polygon& polygon : body)
        for (std::size_t k = 2; k < polygon.size(); ++k) {
            Corner a, b, c;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                a[axis] = polygon[0][axis] - o[axis];
                b[axis] = polygon[k - 1][axis] - o[axis];
                c[axis] = polygon[k][axis] - o[axis];
            }
            const Rational cone = a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                                  a[2] * (b[0] * c[1] - b[1] * c[0]);
            six += abs(cone);
        }
    return six / 6;
}

std::vector<std::vector<HalfSpace>> solids_of(const BrushLevel& level) {
    std::vector<std::vector<HalfSpace>> solids;
    for (const Brush& brush : level.brushes) {
        if (brush.kind != BrushKind::kSolid && brush.kind != BrushKind::kSky) continue;
        std::vector<HalfSpace>& sides = solids.emplace_back();
        for (std::uint32_t k = 0; k < brush.side_count; ++k)
            sides.push_back(half_space(level.sides[brush.first_side + k]));
    }
    return solids;
}

}  // namespace

Rational joined_volume(const BrushLevel& level) {
    const std::vector<std::vector<HalfSpace>> solids = solids_of(level);
    Rational sum = 0;
    for (std::size_t one = 0; one < solids.size(); ++one) {
        Body body = cube(std::int64_t(1) << 26);
        for (const HalfSpace& side : solids[one]) body = clip(body, side, false);
        std::vector<Body> parts;
        if (!body.empty()) parts.push_back(std::move(body));
        for (std::size_t other = 0; other < one && !parts.empty(); ++other) {
            std::vector<Body> left;
            for (const Body& part : parts) {
                std::vector<Body> outside;
                Body rest = part;
                for (const HalfSpace& side : solids[other]) {
                    if (Body front = clip(rest, side, true); !front.empty()) outside.push_back(std::move(front));
                    rest = clip(rest, side, false);
                    if (rest.empty()) break;
                }
                if (rest.empty())  // the two have nothing in common
                    left.push_back(part);
                else
                    for (Body& body_outside : outside) left.push_back(std::move(body_outside));
            }
            parts = std::move(left);
        }
        for (const Body& part : parts) sum += volume_of(part);
    }
    return sum;
}

int side_of_brushes(const BrushLevel& level, const Rational (&point)[3]) {
    const Corner p{point[0], point[1], point[2]};
    int best = -1;
    for (const std::vector<HalfSpace>& sides : solids_of(level)) {
        int inside = 1;
        for (const HalfSpace& side : sides) {
            const Rational at = side.at(p);
            inside = std::min(inside, at > 0 ? -1 : at < 0 ? 1 : 0);
        }
        best = std::max(best, inside);
    }
    return best;
}

}  // namespace firma::reference
