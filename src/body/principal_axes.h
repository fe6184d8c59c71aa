// SPDX-License-Identifier: MIT
// The axes about which a body turns without wobbling.
#pragma once

#include <array>

#include "firma/turn.h"

namespace firma {

struct PrincipalAxes {
    Vec3 moments;                     ///< largest first
    Quaternion rotation{0, 0, 0, 1};  ///< turns the axes of the coordinates to them
};

/// @param tensor  symmetric, a row each, finite
/// Source: C. G. J. Jacobi, 1846: turns about one axis at a time until what is beside the diagonal is nothing.
PrincipalAxes principal_axes(const std::array<Vec3, 3>& tensor);

}  // namespace firma
