// SPDX-License-Identifier: MIT
// From a body to what a step works on, and back.
#include "body/mover.h"

#include "body/turn_between.h"

namespace firma {

Quaternion principal_rotation(const Body& body) {
    return normalised(compose(normalised(body.rotation), body.shape.axes()));
}

Mover make_mover(const Body& body, std::uint32_t slot) {
    Mover mover;
    mover.slot = slot;
    mover.shape = &body.shape.data();
    mover.start = mover.position = body.position;
    mover.start_rotation = mover.rotation = principal_rotation(body);
    mover.velocity = body.velocity;
    mover.spin = body.spin;
    mover.inverse_mass = 1 / mover.shape->mass;
    mover.turn_inertia();
    return mover;
}

double way_of(const Mover& mover) {
    const double turn = length(turn_between(mover.start_rotation, mover.rotation));
    return length(mover.position - mover.start) + turn * mover.shape->reach;
}

void put_back_mover(const Mover& mover, Body& body) {
    body.position = mover.position;
    body.rotation = normalised(compose(mover.rotation, turn_back(mover.shape->axes)));
    body.velocity = mover.velocity;
    body.spin = mover.spin;
}

}  // namespace firma
