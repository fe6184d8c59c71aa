// SPDX-License-Identifier: MIT
// From a level of brushes to a World: brushes joined into one solid, the air divided into rooms.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "firma/brush_level.h"
#include "firma/export.h"
#include "firma/world.h"

namespace firma {

/// What did not become what its author meant.
struct BrushNote {
    enum class What : std::uint8_t {
        kNotJoined,   ///< a brush of solid: castable only, or nothing at all where it has no volume
        kNoVolume,    ///< a brush whose planes leave no volume, or do not close it: met by nothing
        kIdlePortal,  ///< a portal with one room on both sides, wherever it is in the air (the air goes around it), or
                      ///< of which nothing is in the air that no portal before it takes
    };
    What what = What::kNotJoined;
    std::uint32_t brush = 0;  ///< index into BrushLevel::brushes
    std::string reason;       ///< a clause: "it has more than 1024 planes"
};

/// An entity that does not do what its author meant.
struct EntityNote {
    std::uint32_t entity = 0;  ///< index into BrushLevel::entities
    std::string reason;        ///< a clause: "it stands in the solid"
};

/// What joining a level came to.
struct BrushWorldReport {
    std::vector<BrushNote> notes;          ///< by what, then brush
    std::vector<EntityNote> entity_notes;  ///< entities `firma_room` that name no room, by entity
    std::size_t solid_brushes = 0;         ///< joined
    std::size_t solid_faces = 0;           ///< exact faces of the solid
    std::size_t planes_moved = 0;  ///< by about half a millimetre at most, as faces were too thin for the surface grid
    std::size_t lost_shells = 0;   ///< closed surfaces whose room no ray told: rooms of their own
};

/// Joins the brushes exactly: of faces that lie against each other, or in another brush, nothing is left; of faces of
/// two brushes in one plane that look the same way, and overlap, that of the brush that comes first stays; neighbours
/// in one plane with one material and one texture projection become one face where that is convex. The air is divided
/// by the portals into rooms, the last of which is the exterior; pockets that nothing leads to are rooms of their own.
/// What is no solid (glass, clips, liquids, patches) is castable, with its mask, in the room that it lies in. Rooms
/// have the names of point entities `firma_room` in them, portals the `targetname` of the entity that their brush
/// belongs to.
///
/// What is painted with the sky refuses cuts (its materials' hardness is 1, but for materials that the options' rules
/// name): a hole in it would look into the void.
///
/// A face's source is the index of its brush's side; that of a surface counts on from there.
///
/// @param report  filled, when given
/// @return kTooLarge for a level of 2^20 brush sides or more; kInvalid, with brush and side, for one that does not hold
///         together (see BrushLevel), and for a skin that is no length; kMalformed where no face is left that a cast
///         could meet, with what was left out
FIRMA_EXPORT Result<World> make_world(const BrushLevel& level, const WorldOptions& options = {},
                                      BrushWorldReport* report = nullptr);

}  // namespace firma
