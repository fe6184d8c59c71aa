// SPDX-License-Identifier: MIT
// The largest ball inside a solid that touches a point of its surface: a ball too large shrinks until nothing is in it.
#include "body/inner_ball.h"

#include "body/body_tolerance.h"
#include "carve/nearest_facet.h"
#include "solid/solid_data.h"

namespace firma {

namespace {

struct NearPoint {
    double distance;  ///< metres, at most `reach`
    Vec3 at;
};

/// A ball of at most this radius that touches at a point: as it shrinks until nothing is in it.
/// @param slop     metres: what is no farther within it counts as outside
/// @param nearest  (centre, reach) -> NearPoint: of what may not be in it
/// @return its radius, and how near to its centre something is; nothing where it has no room
template <class Nearest>
std::optional<Sphere> shrunk_ball(const SurfacePoint& at, double radius, double smallest, double slop,
                                  const Nearest& nearest) {
    constexpr int kSteps = 24;
    for (int step = 0; step < kSteps; ++step) {
        const Vec3 centre = at.at - at.normal * radius;
        const NearPoint touch = nearest(centre, radius * (1 + kSearchRounding));
        if (touch.distance >= radius * (1 - kBallSlop) - slop)
            return Sphere{centre, touch.distance < radius ? touch.distance : radius};
        // The ball through the nearest point that still touches at `at`: |at - p|^2 = 2 r n.(at - p).
        const Vec3 to = at.at - touch.at;
        const double along = dot(to, at.normal);
        if (!(along > 0)) return std::nullopt;
        const double next = dot(to, to) / (2 * along);
        if (!(next < radius) || next < smallest) return std::nullopt;
        radius = next;
    }
    return std::nullopt;
}

}  // namespace

std::optional<Sphere> inner_ball(const Solid& solid, const PointCloud& samples, const SurfacePoint& at, double reach) {
    const Node* root = solid.data().faces.root.get();
    const double smallest = kSmallestBall * reach;
    const auto by_samples = [&](const Vec3& centre, double) {
        const PointCloud::Nearest nearest = samples.nearest(centre);
        return NearPoint{nearest.distance, nearest.at};
    };
    const auto by_facets = [&](const Vec3& centre, double within) {
        const std::optional<NearestFacet> nearest = nearest_facet(root, centre, within);
        return nearest ? NearPoint{length(centre - nearest->at), nearest->at} : NearPoint{within, centre};
    };
    const std::optional<Sphere> about = shrunk_ball(at, reach, smallest, kSampleRounding * reach, by_samples);
    const double at_most = about ? length(at.at - about->centre) : reach;
    std::optional<Sphere> ball = shrunk_ball(at, at_most, smallest, 0, by_facets);
    if (!ball) return std::nullopt;
    ball->radius -= kDistanceRounding;
    if (!(ball->radius > smallest)) return std::nullopt;
    // A triangle of a facet that rounding bent may look the other way: its ball lies outside.
    if (locate(solid, ball->centre) != Where::kSolid) return std::nullopt;
    return ball;
}

Sphere grown_ball(const Solid& solid, const PointCloud& samples, double reach, Sphere ball) {
    constexpr int kMaxMoves = 40;
    const Node* root = solid.data().faces.root.get();
    double step = ball.radius / 2;
    for (int move = 0; move < kMaxMoves && step > ball.radius / 256; ++move) {
        Sphere best = ball;
        // A step of half the radius or less stays inside the ball, and so in the solid.
        for (int axis = 0; axis < 3; ++axis)
            for (const double sign : {-1.0, 1.0}) {
                Vec3 centre = ball.centre;
                centre[axis] += sign * step;
                const double at_most = samples.nearest(centre).distance + kSampleRounding * reach;
                if (!(at_most > best.radius)) continue;
                const std::optional<NearestFacet> nearest =
                    nearest_facet(root, centre, at_most * (1 + kSearchRounding));
                const double radius = nearest ? length(centre - nearest->at) - kDistanceRounding : 0;
                if (radius > best.radius) best = {centre, radius};
            }
        if (best.radius > ball.radius)
            ball = best;
        else
            step /= 2;
    }
    return ball;
}

}  // namespace firma
