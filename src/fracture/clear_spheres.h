// SPDX-License-Identifier: MIT
// Spheres of a body that begins where the world may reach into it.
#pragma once

#include <cstdint>

#include "firma/cutter.h"
#include "firma/sphere_set.h"
#include "firma/world.h"

namespace firma {

/// What is left of spheres clear of the world: smaller, or fewer. None where the centre of mass is in its solid: the
/// body is buried then, and would hang in the ground from what sticks out.
/// @param pose    of their frame
/// @param centre  of mass, in it
SphereSet clear_spheres(const World& world, const SphereSet& spheres, const Vec3& centre, const Pose& pose,
                        std::uint32_t mask);

}  // namespace firma
