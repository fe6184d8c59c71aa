// SPDX-License-Identifier: MIT
// A solid in two along a plane of its faces, exactly, and joined again where that resolved nothing.
#pragma once

#include <vector>

#include "convex/sides.h"

namespace firma {

/// What two halves are closed by: the same polygons, seen from both sides.
struct SidesSplit {
    FaceSides front, back;  ///< closed, settled
    FaceSides cap;          ///< that of the half behind, in the plane; that in front has them the other way around
    /// Of cap sides: whether a reflex edge of the whole lies there, which the plane resolves.
    std::vector<bool> resolves;
};

/// @param plane  of the solid's faces, either way
/// @return false where the halves do not close: the solid crosses itself
bool split_sides(ConvexSpace& space, const SolidSides& solid, PlaneId plane, SidesSplit& split);

/// The parts that a plane leaves of a solid. Where it goes through what is convex anyway, front and back are one part
/// still; each is connected, as parts_of_sides() says.
/// @return false likewise; one part where the plane resolved nothing
bool divide_solid(ConvexSpace& space, const SolidSides& solid, PlaneId plane, std::vector<FaceSides>& parts);

}  // namespace firma
