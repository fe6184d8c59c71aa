// SPDX-License-Identifier: MIT
// Impulses of one touch.
#include "body/touch_response.h"

#include <algorithm>
#include <cmath>

namespace firma {
namespace {

/// Two that touch in a point, the second one the world if null.
struct TouchingPair {
    Mover& mover;
    Mover* other;
    Vec3 from, from_other;  ///< from their centres to the point
    Vec3 surface;

    TouchingPair(Mover& one, Mover* two, const Vec3& point, const Vec3& moves)
        : mover(one),
          other(two),
          from(point - one.position),
          from_other(two ? point - two->position : Vec3{}),
          surface(moves) {}

    Vec3 speed() const {
        const Vec3 own = mover.velocity_at(from);
        return other ? own - other->velocity_at(from_other) : own - surface;
    }
    double yield(const Vec3& direction) const {
        return mover.yield(direction, from) + (other ? other->yield(direction, from_other) : 0);
    }
    void push(const Vec3& impulse) {
        mover.push(impulse, from);
        if (other) other->push(impulse * -1.0, from_other);
    }
};

}  // namespace

bool respond(Mover& mover, Mover* other, const Vec3& point, const Vec3& normal, const TouchTerms& terms) {
    TouchingPair pair(mover, other, point, terms.surface);
    const Vec3 speed = pair.speed();
    const double approach = dot(speed, normal);
    if (!(approach < 0)) return false;
    const double restitution = approach < -terms.bounce_speed ? terms.restitution : 0;
    const double pushed = -(1 + restitution) * approach / pair.yield(normal);
    Vec3 impulse = normal * pushed;
    pair.push(impulse);
    const Vec3 sliding = speed - normal * approach;
    if (const double slides = length(sliding); slides > 0) {
        const Vec3 along = sliding * (1 / slides);
        const double stops = std::max(dot(pair.speed(), along), 0.0) / pair.yield(along);
        const Vec3 rubs = along * -std::min(stops, terms.friction * pushed);
        impulse += rubs;
        pair.push(rubs);
    }
    // Of s times the impulse the energy changes by s J.v + s^2 J.(v' - v) / 2.
    const double taken = -dot(impulse, speed), given = dot(impulse, pair.speed() - speed) / 2;
    if (given > taken) pair.push(impulse * (taken / given - 1));
    return true;
}

}  // namespace firma
