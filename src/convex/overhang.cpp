// SPDX-License-Identifier: MIT
// How far a hull stands out from a solid: distances change by no more than one goes, so one point speaks for a box.
#include "convex/overhang.h"

#include <algorithm>
#include <cmath>

namespace firma {
namespace {

/// Metres: rounded corners, and distances in double.
constexpr double kHullRounding = 4e-6;
/// Boxes looked at, at most; and the smallest, as a share of what is allowed.
constexpr int kMaxBoxes = 100000;
constexpr double kSmallestBox = 1.0 / 32;

double square(const Vec3& v) {
    return dot(v, v);
}

double square_to_segment(const Vec3& from, const Vec3& a, const Vec3& b) {
    const Vec3 along = b - a, to = from - a;
    const double length_square = square(along);
    const double share = length_square > 0 ? std::clamp(dot(to, along) / length_square, 0.0, 1.0) : 0;
    return square(to - along * share);
}

double square_to_box(const Vec3& from, const Box& box) {
    Vec3 gap;
    for (int axis = 0; axis < 3; ++axis)
        gap[axis] = std::max({box.low[axis] - from[axis], from[axis] - box.high[axis], 0.0});
    return square(gap);
}

/// Above zero outside, metres from the nearest plane that says so.
double outside_hull(const GridHull& hull, const Vec3& point) {
    double most = -INFINITY;
    for (const GridHull::Triangle& triangle : hull.triangles)
        most = std::max(most, dot(triangle.normal, point) - triangle.offset);
    return most;
}

}  // namespace

SidesDistance::SidesDistance(const ConvexSpace& space, const SolidSides& solid) {
    constexpr double kStep = 1 / kInputSteps;
    for (std::uint32_t first = 0, end; first < solid.size(); first = end) {
        end = first + 1;
        while (end < solid.size() && solid.sides[end].plane == solid.sides[first].plane) ++end;
        Face face;
        const Plane& plane = space.plane(solid.sides[first].plane);
        face.normal = plane.unit_normal();
        face.offset = -plane.d * kStep / length(plane.direction());
        const FlatView view = plane.front_view();
        face.u = view.u();
        face.v = view.v();
        face.first = std::uint32_t(segments_.size());
        for (std::uint32_t k = first; k < end; ++k) {
            const FaceSide& side = solid.sides[k];
            segments_.push_back(
                {space.point(side.from).approximate() * kStep, space.point(side.to).approximate() * kStep});
            face.box.add(segments_.back().from);
        }
        face.end = std::uint32_t(segments_.size());
        faces_.push_back(face);
    }
}

/// Each side is judged the same way by both faces that have it: so no point falls between two.
bool SidesDistance::within(const Face& face, const Vec3& at, int u, int v) const {
    bool inside = false;
    for (std::uint32_t k = face.first; k < face.end; ++k) {
        Vec3 a = segments_[k].from, b = segments_[k].to;
        if ((a[v] <= at[v]) == (b[v] <= at[v])) continue;
        if (a[v] > b[v]) std::swap(a, b);
        inside ^= (b[u] - a[u]) * (at[v] - a[v]) > (at[u] - a[u]) * (b[v] - a[v]);
    }
    return inside;
}

double SidesDistance::distance(const Face& face, const Vec3& from) const {
    const double above = dot(face.normal, from) - face.offset;
    if (within(face, from - face.normal * above, face.u, face.v)) return std::fabs(above);
    double least = INFINITY;
    for (std::uint32_t k = face.first; k < face.end; ++k)
        least = std::min(least, square_to_segment(from, segments_[k].from, segments_[k].to));
    return std::sqrt(least);
}

double SidesDistance::distance(const Vec3& from, double reach) const {
    double least = reach;
    for (const Face& face : faces_)
        if (std::fabs(dot(face.normal, from) - face.offset) < least && square_to_box(from, face.box) < least * least)
            least = std::min(least, distance(face, from));
    return least;
}

bool SidesDistance::contains(const Vec3& point) const {
    bool inside = false;
    for (const Face& face : faces_) {
        if (face.normal.z == 0 || face.box.high.z < point.z) continue;
        if (!within(face, point, 0, 1)) continue;
        const double above = dot(face.normal, point) - face.offset;
        inside ^= (above < 0) == (face.normal.z > 0);
    }
    return inside;
}

std::optional<double> overhang_within(const SidesDistance& solid, const GridHull& hull, double most) {
    const double allowed = most - kHullRounding;
    if (!(allowed > 0) || hull.triangles.empty()) return std::nullopt;
    const auto stands_out = [&](const Vec3& point) {
        return solid.distance(point, 2 * most) > allowed && !solid.contains(point);
    };
    Box around;
    for (const GridPoint& point : hull.points) around.add(to_metres(point));
    // Where it stands out far that shows in the middle of a triangle, mostly.
    for (const GridHull::Triangle& triangle : hull.triangles) {
        Vec3 middle;
        for (const std::uint32_t corner : triangle.corner) middle += to_metres(hull.points[corner]) * (1.0 / 3);
        if (stands_out(middle)) return std::nullopt;
    }
    struct Cell {
        Vec3 middle, half;
    };
    std::vector<Cell> cells{{(around.low + around.high) * 0.5, (around.high - around.low) * 0.5}};
    double bound = 0;
    for (int looked_at = 0; !cells.empty(); ++looked_at) {
        if (looked_at == kMaxBoxes) return std::nullopt;
        const Cell cell = cells.back();
        cells.pop_back();
        const double radius = length(cell.half), out = outside_hull(hull, cell.middle);
        if (out > radius) continue;
        const double distance = solid.distance(cell.middle, radius + 2 * most);
        const bool inside = solid.contains(cell.middle);
        // From inside, one has to go that far to be outside.
        const double here = inside ? std::max(radius - distance, 0.0) : radius + distance;
        if (here <= allowed) {
            bound = std::max(bound, here);
            continue;
        }
        if ((!inside && out <= 0 && distance > allowed) || radius < most * kSmallestBox) return std::nullopt;
        int axis = 0;
        for (int other = 1; other < 3; ++other)
            if (cell.half[other] > cell.half[axis]) axis = other;
        for (const double sign : {-0.5, 0.5}) {
            Cell part = cell;
            part.half[axis] *= 0.5;
            part.middle[axis] += sign * cell.half[axis];
            cells.push_back(part);
        }
    }
    return bound + kHullRounding;
}

}  // namespace firma
