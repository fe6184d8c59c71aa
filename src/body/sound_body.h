// SPDX-License-Identifier: MIT
// Whether a step can work with what a body says of itself.
#pragma once

#include "body/mover.h"
#include "firma/bodies.h"

namespace firma {

/// Its numbers are finite and below 2^200, its friction and resistance to rolling are not negative, its restitution is
/// within 0 to 1. Others are left where they are: nothing is done with them, and nothing meets them.
bool is_sound(const Body& body);

/// Whether numbers so large came together that what a step made of it is none.
bool is_sound(const Mover& mover);

/// The same of what is kept of a contact.
bool is_sound(const BodyContact& contact);

}  // namespace firma
