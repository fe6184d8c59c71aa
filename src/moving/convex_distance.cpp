// SPDX-License-Identifier: MIT
// How far two convex sets of corners are from each other, by simplices of their difference.
#include "moving/convex_distance.h"

#include <cmath>
#include <cstddef>

namespace firma {
namespace {

/// Rounding, metres: what is so near is taken for one point.
constexpr double kOnePoint = 1e-9;

/// A corner of the difference a - b, and the corner of a that it came from.
struct DifferenceCorner {
    Vec3 apart, of_a;
};

/// Up to four corners, and a point of their hull by its weights.
struct DifferenceSimplex {
    DifferenceCorner corner[4];
    double weight[4] = {1, 0, 0, 0};
    int count = 0;

    Vec3 apart() const {
        Vec3 sum;
        for (int k = 0; k < count; ++k) sum += corner[k].apart * weight[k];
        return sum;
    }
    Vec3 of_a() const {
        Vec3 sum;
        for (int k = 0; k < count; ++k) sum += corner[k].of_a * weight[k];
        return sum;
    }
};

/// Those corners that the nearest point to the origin needs.
struct NearestPart {
    double square = INFINITY;
    DifferenceSimplex part;

    void take(const DifferenceSimplex& other) {
        const Vec3 at = other.apart();
        const double distance = dot(at, at);
        if (!(distance < square)) return;
        square = distance;
        part = other;
    }
};

void look_at_corner(const DifferenceCorner& p, NearestPart& nearest) {
    DifferenceSimplex one;
    one.corner[0] = p;
    one.count = 1;
    nearest.take(one);
}

void look_at_edge(const DifferenceCorner& p, const DifferenceCorner& q, NearestPart& nearest) {
    const Vec3 edge = q.apart - p.apart;
    const double square = dot(edge, edge), along = -dot(p.apart, edge);
    if (!(along > 0) || !(along < square)) return;  // its ends are looked at by themselves
    DifferenceSimplex two;
    two.corner[0] = p;
    two.corner[1] = q;
    two.count = 2;
    two.weight[1] = along / square;
    two.weight[0] = 1 - two.weight[1];
    nearest.take(two);
}

/// The inside alone.
void look_at_triangle(const DifferenceCorner& p, const DifferenceCorner& q, const DifferenceCorner& r,
                      NearestPart& nearest) {
    const Vec3 normal = cross(q.apart - p.apart, r.apart - p.apart);
    const double square = dot(normal, normal);
    const double of_p = dot(cross(q.apart, r.apart), normal), of_q = dot(cross(r.apart, p.apart), normal),
                 of_r = dot(cross(p.apart, q.apart), normal);
    if (!(of_p > 0) || !(of_q > 0) || !(of_r > 0) || !(square > 0)) return;
    DifferenceSimplex three;
    three.corner[0] = p;
    three.corner[1] = q;
    three.corner[2] = r;
    three.count = 3;
    const double sum = of_p + of_q + of_r;
    three.weight[0] = of_p / sum;
    three.weight[1] = of_q / sum;
    three.weight[2] = of_r / sum;
    nearest.take(three);
}

/// Whether the origin lies in a tetrahedron that has volume.
bool holds_origin(const DifferenceSimplex& s) {
    static constexpr int kSides[4][4] = {{0, 1, 2, 3}, {0, 1, 3, 2}, {0, 2, 3, 1}, {1, 2, 3, 0}};
    for (const auto& side : kSides) {
        const Vec3& p = s.corner[side[0]].apart;
        const Vec3 normal = cross(s.corner[side[1]].apart - p, s.corner[side[2]].apart - p);
        const double other = dot(normal, s.corner[side[3]].apart - p), origin = -dot(normal, p);
        if (other == 0 || (other > 0) != (origin > 0)) return false;
    }
    return true;
}

NearestPart nearest_part(const DifferenceSimplex& s) {
    NearestPart nearest;
    for (int i = 0; i < s.count; ++i) {
        look_at_corner(s.corner[i], nearest);
        for (int j = i + 1; j < s.count; ++j) {
            look_at_edge(s.corner[i], s.corner[j], nearest);
            for (int k = j + 1; k < s.count; ++k) look_at_triangle(s.corner[i], s.corner[j], s.corner[k], nearest);
        }
    }
    return nearest;
}

DifferenceCorner lowest_along(std::span<const Vec3> a, std::span<const Vec3> b, const Vec3& direction) {
    std::size_t low = 0, high = 0;
    double lowest = INFINITY, highest = -INFINITY;
    for (std::size_t k = 0; k < a.size(); ++k) {
        const double at = dot(a[k], direction);
        if (at < lowest) lowest = at, low = k;
    }
    for (std::size_t k = 0; k < b.size(); ++k) {
        const double at = dot(b[k], direction);
        if (at > highest) highest = at, high = k;
    }
    return {a[low] - b[high], a[low]};
}

}  // namespace

ConvexDistance convex_distance(std::span<const Vec3> a, std::span<const Vec3> b) {
    ConvexDistance found;
    found.at_least = -INFINITY;
    DifferenceSimplex simplex;
    simplex.corner[0] = {a[0] - b[0], a[0]};
    simplex.count = 1;
    double square = INFINITY;
    for (int round = 0; round < 128; ++round) {
        const Vec3 apart = simplex.apart();
        const double now = dot(apart, apart);
        if (now <= kOnePoint * kOnePoint) return {false, 0, 0, {}, simplex.of_a()};
        if (!(now < square)) break;  // rounding hinders
        square = now;
        found.distance = std::sqrt(now);
        found.point = simplex.of_a();
        const Vec3 direction = apart * (1 / found.distance);
        const DifferenceCorner next = lowest_along(a, b, direction);
        const double at_least = dot(next.apart, direction);
        if (at_least > found.at_least) {
            found.at_least = at_least;
            found.normal = direction;
        }
        if (found.distance - found.at_least <= kNearSlop) break;
        simplex.corner[simplex.count++] = next;
        if (simplex.count == 4 && holds_origin(simplex)) return {false, 0, 0, {}, simplex.of_a()};
        simplex = nearest_part(simplex).part;
    }
    found.apart = true;
    return found;
}

}  // namespace firma
