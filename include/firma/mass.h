// SPDX-License-Identifier: MIT
// Mass, centre and inertia of a solid, for the simulation that moves it.
#pragma once

#include <array>

#include "firma/export.h"
#include "firma/solid.h"
#include "firma/vec.h"

namespace firma {

/// Of a body that is as dense everywhere.
struct MassProperties {
    double volume = 0;  ///< cubic metres
    double mass = 0;    ///< kilograms
    Vec3 centre;        ///< of mass, metres
    /// The tensor of inertia about the centre, kg m2, a row each: symmetric; its axes are those of the solid's grid.
    std::array<Vec3, 3> inertia{};
};

/// Integrates over the exact boundary, not over what casts meet. Each number is rounded a few times at its end, from
/// sums of some 100 bits about a point in the middle of the solid: also far from the origin all its digits are good.
/// @param density  kilograms a cubic metre
/// @return all 0 for a solid without faces, for one with rock outside, and for a density that is not finite or negative
/// Costs all faces, in time and in memory.
/// Source: for the idea, B. Mirtich, Fast and Accurate Computation of Polyhedral Mass Properties, 1996; here by cones
/// from one point over the faces instead of the divergence theorem three times.
[[nodiscard]] FIRMA_EXPORT MassProperties mass_properties(const Solid& solid, double density);

}  // namespace firma
