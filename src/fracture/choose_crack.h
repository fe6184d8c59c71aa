// SPDX-License-Identifier: MIT
// Where a piece breaks next, by the style of a pattern; and how badly it wants to.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "firma/fracture.h"

namespace firma {

/// A sector around the point of impact, seen along z: from one unit direction counter-clockwise to another, at most
/// half a circle; all of it where both are zero.
struct CrackSector {
    Vec3 from, to;
};

/// A piece, in the axes of the pattern, metres.
struct CrackCell {
    std::vector<Vec3> corners;
    Vec3 low, high;
    CrackSector sector;
};

struct CrackChoice {
    Vec3 point, normal;            ///< in the axes of the pattern; the normal is unit
    CrackSector in_front, behind;  ///< of the cells that it makes
};

/// What holds for all pieces of a solid.
struct CrackField {
    FracturePattern pattern;
    Vec3 impact;        ///< where cracks of shards meet, in the axes of the pattern
    bool hit = false;   ///< whether pieces are smaller near it
    Vec3 brick_corner;  ///< in the axes of the pattern
};

/// Sets `low` and `high`.
void measure_cell(CrackCell& cell);

/// How much larger a piece is than it should be, as a factor: what is below kWorthDividing stays.
double excess_of(const CrackField& field, const CrackCell& cell);
inline constexpr double kWorthDividing = 1.5;

/// @param seed  decides how crooked it is
/// @return nothing where a style has no crack for this piece
std::optional<CrackChoice> choose_crack(const CrackField& field, const CrackCell& cell, std::uint64_t seed);

}  // namespace firma
