// SPDX-License-Identifier: MIT
// The largest ball inside a solid that touches a point of its surface: a ball too large shrinks until nothing is in it.
#include "body/inner_ball.h"

#include "body/body_tolerance.h"
#include "carve/nearest_facet.h"
#include "solid/solid_data.h"

namespace firma {

constexpr double kRoundedBy = 0x1p-30;  // metres: what distances are rounded by is far below

std::optional<Sphere> inner_ball(const Solid& solid, const SurfacePoint& at, double reach) {
    constexpr int kSteps = 24;
    const Node* root = solid.data().faces.root.get();
    double radius = reach;
    for (int step = 0; step < kSteps; ++step) {
        const Vec3 centre = at.at - at.normal * radius;
        const std::optional<NearestFacet> nearest = nearest_facet(root, centre, radius * (1 + kSearchRounding));
        const double distance = nearest ? length(centre - nearest->at) : radius;
        if (distance >= radius * (1 - kBallSlop)) {
            const double kept = (distance < radius ? distance : radius) - kRoundedBy;
            if (!(kept > kSmallestBall * reach)) return std::nullopt;
            return Sphere{centre, kept};
        }
        // The ball through the nearest point that still touches at `at`: |at - p|^2 = 2 r n.(at - p).
        const Vec3 to = at.at - nearest->at;
        const double along = dot(to, at.normal);
        if (!(along > 0)) return std::nullopt;
        const double next = dot(to, to) / (2 * along);
        if (!(next < radius) || next < kSmallestBall * reach) return std::nullopt;
        radius = next;
    }
    return std::nullopt;
}

Sphere grown_ball(const Solid& solid, Sphere ball) {
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
                const std::optional<NearestFacet> nearest = nearest_facet(root, centre, ball.radius * 4);
                const double radius = nearest ? length(centre - nearest->at) - kRoundedBy : 0;
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
