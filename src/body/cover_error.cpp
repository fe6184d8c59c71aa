// SPDX-License-Identifier: MIT
// How far a surface is from the nearest sphere: branch and bound over triangles.
#include "body/cover_error.h"

#include "base/sort.h"
#include "body/body_tolerance.h"
#include "body/point_order.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace firma {
namespace {

/// Halvings in all: what keeps hostile shapes from taking for ever.
constexpr std::size_t kMaxHalvings = 200'000;

struct Piece {
    double bound;  ///< no point of it is farther
    SurfaceTriangle corners;
    std::uint32_t of;
    friend bool operator<(const Piece& a, const Piece& b) {
        if (a.bound != b.bound) return a.bound < b.bound;
        if (a.of != b.of) return a.of > b.of;
        // Halves may be as far as each other: whatever a queue is made of, it is the same one that is next.
        for (std::size_t k = 0; k < 3; ++k)
            if (!(a.corners[k] == b.corners[k])) return comes_before(a.corners[k], b.corners[k]);
        return false;
    }
};

struct FarPoint {
    double gap = -INFINITY;  ///< from the nearest sphere
    Vec3 at;
};

double gap_at(const Vec3& at, std::span<const Sphere> spheres) {
    double least = INFINITY;
    for (const Sphere& sphere : spheres) {
        const double gap = length(at - sphere.centre) - sphere.radius;
        least = gap < least ? gap : least;
    }
    return least;
}

/// The farthest points of several triangles, none within `apart` of another.
std::vector<Vec3> apart_from_each_other(std::vector<FarPoint> points, double apart) {
    constexpr std::size_t kMost = 48;
    sort_range(points, [](const FarPoint& a, const FarPoint& b) {
        return a.gap != b.gap ? a.gap > b.gap : comes_before(a.at, b.at);
    });
    std::vector<Vec3> kept;
    for (const FarPoint& point : points) {
        if (kept.size() == kMost) break;
        const auto is_near = [&](const Vec3& other) { return length(other - point.at) < apart; };
        if (std::none_of(kept.begin(), kept.end(), is_near)) kept.push_back(point.at);
    }
    return kept;
}

}  // namespace

CoverError cover_error(std::span<const SurfaceTriangle> triangles, std::span<const Sphere> spheres, double allowed,
                       double tolerance) {
    std::priority_queue<Piece> pieces;
    double known = -INFINITY;
    std::vector<FarPoint> farthest(triangles.size());
    const auto add = [&](const SurfaceTriangle& corners, std::uint32_t of) {
        const Vec3 middle = (corners[0] + corners[1] + corners[2]) * (1.0 / 3);
        double reach = 0;
        for (const Vec3& corner : corners) reach = std::max(reach, length(corner - middle));
        const double here = gap_at(middle, spheres);
        if (here > farthest[of].gap) farthest[of] = {here, middle};
        // Distance changes by no more than one goes.
        const double bound = here + reach + kDistanceRounding;
        known = std::max(known, here);
        if (bound > known + tolerance) pieces.push({bound, corners, of});
    };
    for (std::size_t k = 0; k < triangles.size(); ++k) add(triangles[k], std::uint32_t(k));
    for (std::size_t halvings = 0; !pieces.empty() && halvings < kMaxHalvings; ++halvings) {
        const Piece piece = pieces.top();
        if (piece.bound <= known + tolerance) break;
        pieces.pop();
        std::size_t longest = 0;
        double size = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const double side = length(piece.corners[(k + 1) % 3] - piece.corners[k]);
            if (side > size) size = side, longest = k;
        }
        const Vec3 a = piece.corners[longest], b = piece.corners[(longest + 1) % 3],
                   c = piece.corners[(longest + 2) % 3];
        const Vec3 half = (a + b) * 0.5;
        add({a, half, c}, piece.of);
        add({half, b, c}, piece.of);
    }
    CoverError error;
    error.at_most = known + tolerance;
    if (!pieces.empty()) error.at_most = std::max(pieces.top().bound, error.at_most);
    std::erase_if(farthest, [&](const FarPoint& point) { return point.gap <= allowed; });
    error.too_far = apart_from_each_other(std::move(farthest), allowed / 2);
    return error;
}

}  // namespace firma
