// SPDX-License-Identifier: MIT
// Spheres for the pieces of a fracture: within a frame, where fit_spheres() takes some milliseconds a piece.
#pragma once

#include <cstddef>

#include "firma/solid.h"
#include "firma/sphere_set.h"

namespace firma {

/// At most so many spheres inside a solid, each as safely inside as those of fit_spheres(), near most of its surface.
/// By fewer points and balls than there, and looked at once: how near is known of these points alone.
/// @param solid  closed, without rock outside
/// @return no spheres where there is no room for any; their error at the points
SphereFit piece_spheres(const Solid& solid, std::size_t max_spheres);

}  // namespace firma
