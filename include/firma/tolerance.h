// SPDX-License-Identifier: MIT
// Slop: the physical distances that Firma accepts, all in one place, carried by the World.
#pragma once

namespace firma {

/// Distances in metres. Nothing in a cast depends on them but `safe_fraction`.
struct Tolerance {
    /// How far from a surface a mover stops, measured along the contact normal.
    double skin = 0.001;
};

}  // namespace firma
