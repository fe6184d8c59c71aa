// SPDX-License-Identifier: MIT
// What a fill does to polygons that stand in the air and divide it: they lose what lies in the cutter, and the faces
// that the fill makes are divided where they stand on them, so that each face bounds one air.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "carve/cut_view.h"
#include "solid/solid_face.h"

namespace firma {

/// A polygon in the air: part of a portal.
struct CutSheet {
    std::uint32_t portal = 0;
    std::uint32_t air[2] = {0, 0};  ///< in front of it, and behind
    Ref<const SolidPlane> plane;
    std::vector<SolidUse> uses;       ///< of all loops in a row
    std::vector<std::uint32_t> ends;  ///< of each loop; the outer one is first
};

/// How the outline of what is left of a sheet uses an edge: one by number (cut_view.h), or one as it was.
struct SheetSide {
    std::uint32_t edge = kAsItWas;
    bool reversed = false;
    SolidUse use;  ///< with kAsItWas
    static constexpr std::uint32_t kAsItWas = ~0u;
};

struct SheetRest {
    std::uint32_t sheet = 0;
    std::vector<SheetSide> sides;
    std::vector<std::uint32_t> ends;
};

/// The air that a face of a fill bounds.
struct FaceAir {
    std::uint32_t air = ~0u;  ///< ClippedSheets::kNoAir where neither a sheet nor a wall tells
    /// Then: a corner of the faces that hang together with it, the one farthest from the sheets' planes. All of them
    /// bound the air that it lies in.
    GridPoint place;
};

struct ClippedSheets {
    static constexpr std::uint32_t kNoAir = ~0u;
    Crossings crossings;  ///< those of the fill, and points that sheets make
    NewLoops loops;       ///< those of the fill, its own faces divided
    /// Of each of its faces; kNoAir, and no place, for pieces of old faces.
    std::vector<FaceAir> air;
    std::vector<std::uint8_t> changed;          ///< of each sheet: `rest` has what is left of it, if anything
    std::vector<SheetRest> rest;                ///< in order of sheets
    std::vector<Ref<const SolidPlane>> planes;  ///< that the new crossings and edges look at
};

/// @param sheets  near the cutter: those that are not meet neither it nor an edge that the fill divides
/// @param air_of  of the part of a face
/// @return nothing where it cannot be told: a sheet stands on no edge of a wall, or something is too thin
/// Costs pairs of sheets and new faces whose boxes meet.
std::optional<ClippedSheets> clip_sheets(const CutInput& in, const Crossings& crossings, const NewLoops& loops,
                                         const std::vector<CutSheet>& sheets,
                                         const std::function<std::uint32_t(std::uint32_t part)>& air_of);

}  // namespace firma
