// SPDX-License-Identifier: MIT
// What a touch on the way does to the velocities of those who touch.
#pragma once

#include "body/mover.h"

namespace firma {

struct TouchTerms {
    double restitution = 0, friction = 0;
    double bounce_speed = 0;  ///< metres a second along the normal: what meets slower does not bounce
    Vec3 surface{};           ///< metres a second, of what is met, where that is no mover
};

/// Newton's restitution, and Coulomb's friction, of no more than brings sliding to an end. Of both together no more
/// than leaves the energy as it was, as what is met sees it.
/// @param other   null: the world
/// @param normal  unit, toward `mover`
/// @return whether they were coming nearer at all; else nothing changes
bool respond(Mover& mover, Mover* other, const Vec3& point, const Vec3& normal, const TouchTerms& terms);

}  // namespace firma
