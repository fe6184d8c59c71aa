// SPDX-License-Identifier: MIT
// A cutter without what may not be carved.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "firma/cutter.h"
#include "firma/result.h"
#include "firma/solid.h"
#include "firma/vec.h"
#include "geometry/grid_box.h"

namespace firma {

/// Something that may not be carved, near a cutter.
struct CutShield {
    Cutter cutter;  ///< its body, where it is
    std::string name;
};

/// A box as a cutter: widened to the input grid, and no larger than a metre beyond another one needs it.
/// @param around  surface steps
/// @return nothing where they share no volume
std::optional<Cutter> box_shield(const Box& box, const GridBox& around);

struct TrimmedCutter {
    std::size_t shields = 0;  ///< how many took something of it
    std::string first;        ///< the name of the first of these
    Solid solid;              ///< what is left, where it lies
};

/// A placed cutter minus the shields, one after the other, exactly.
/// @return the errors of unite() and subtract()
Result<TrimmedCutter> trim_cutter(const Cutter& cutter, const Pose& pose, std::span<const CutShield> shields);

/// Of each face of what is left, in order of ids: the triangle of the cutter that it is a part of; ~0 for one where it
/// was cut short.
std::vector<std::uint32_t> triangles_of_trimmed(const Solid& solid);

}  // namespace firma
