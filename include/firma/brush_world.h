// SPDX-License-Identifier: MIT
// From a level of brushes to a World: brushes joined into one solid, the air divided into rooms; portals for levels
// whose author placed none; where a level leaks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "firma/brush_level.h"
#include "firma/export.h"
#include "firma/level.h"
#include "firma/result.h"
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
    std::size_t lost_shells =
        0;  ///< unclassified: closed surfaces of which no ray found out the room they are in; rooms of their own
};

/// Joins the brushes exactly: of faces that lie against each other, or in another brush, nothing is left; of faces of
/// two brushes in one plane that look the same way, and overlap, that of the brush that comes first stays; neighbours
/// in one plane with one material and one texture projection become one face where that is convex. The air is divided
/// by the portals into rooms, the last of which is the exterior; pockets that nothing leads to are rooms of their own.
/// What is no solid (glass, clips, liquids, patches) is castable, with its mask, in the room that it lies in. Rooms
/// have the names of point entities `firma_room` in them, portals the `targetname` of the entity that their brush
/// belongs to.
///
/// Each brush of the solid is a piece of a matter (firma/matter.h, docs/matter.md). One that is painted with the sky
/// may not be carved, but where CarveRules::hardness has an entry for its material: a hole in it would look into the
/// void.
///
/// A face's source is the index of its brush's side; that of a surface counts on from there.
///
/// @param report  filled, when given
/// @return kTooLarge for a level of 2^20 brush sides or more; kInvalid, with brush and side, for one that does not hold
///         together (see BrushLevel), and for a contact offset that is no length; kMalformed where no face is left that
///         a cast could meet, with what was left out
/// Time and memory grow with the sides of the brushes, and with the other brushes and portals that each of them meets.
[[nodiscard]] FIRMA_EXPORT Result<World> make_world(const BrushLevel& level, const WorldOptions& options = {},
                                                    BrushWorldReport* report = nullptr);

/// The world of a file by its ending: .obj, .map, .bsp (its brushes), or .firma, which has its own options: for that
/// the options are ignored. (read_gltf() reads glTF; read_level(), read_brush_level() tell more of a level than its
/// world.)
/// @return errors of the reader and of make_world(); kUnsupported for other endings
/// Costs what the reader and make_world() cost; of a .firma file what load_world() costs.
[[nodiscard]] FIRMA_EXPORT Result<World> read_world(const std::string& path, const WorldOptions& options = {},
                                                    const ReadOptions& read = {});

/// The volumes in which nothing falls: a box (metres) around each brush of the entities `firma_anchor`, for
/// AnchorRules::volumes of a world of this level. Brushes that are open, or without volume, have none. Costs the
/// level's brushes.
[[nodiscard]] FIRMA_EXPORT std::vector<Box> anchor_volumes(const BrushLevel& level);

struct DivideOptions {
    /// An opening divides two rooms when its area is less than so many times that of a square wall of the smaller one,
    /// were that a cube. 0: none does.
    double narrow = 0.4;
    double min_room_volume = 8;         ///< cubic metres of air
    std::size_t max_cells = 6'000'000;  ///< tested: 14 bytes each; where these are too few, small doors are missed
};

/// What dividing a level came to.
struct DivideReport {
    std::size_t cells = 0;    ///< tested; 0 where the level has no solid brush, or too many and too large ones
    std::size_t narrows = 0;  ///< sections of the air that were narrower than what lies beyond
    std::size_t untried = 0;  ///< of these, the widest of more than 20,000: what they would divide is left undivided
    std::size_t idle = 0;     ///< of these, chosen in vain: the air goes around by a way that the cells do not show
    std::size_t portals = 0;  ///< added
};

/// Adds portals where the air of the level narrows: rectangles square to an axis, each a brush of BrushKind::kPortal at
/// the end of `brushes`, of entity 0 and material 0, with its portal as its first side. Each divides two rooms in the
/// world that make_world() makes of the level; none is idle. All else stays as it is, the author's portals too: what
/// these leave undivided is divided further. (Sources of BrushLevel::surfaces count on from the sides that there are
/// then.)
///
/// The air is divided into cells, a sixteenth of a metre wide or more, as many as max_cells allow; a doorway at least
/// as deep as they are is found. What divides the cells is then put to the exact test. What lies outside of a closed
/// hull is not divided, if a player begins inside of it (entities `info_player...`).
///
/// @param report  filled, when given
/// @return the level with the portals, the same on every machine; as it was where nothing is narrow. kTooLarge and
///         kInvalid as of make_world(); kInvalid for an option that is no number or negative
/// Takes about as long as making the level's world, and a second or so for the cells: the brushes are joined once,
/// however many narrows are chosen in vain.
[[nodiscard]] FIRMA_EXPORT Result<BrushLevel> divide_rooms(const BrushLevel& level, const DivideOptions& options = {},
                                                           DivideReport* report = nullptr);

/// A way through the air from a point to beyond all faces, for an author to see where a level leaks.
///
/// @param from  metres, in the air
/// @param mask  faces that share a bit stop the way; kStopsSight: walls alone, as glass and clips close nothing
/// @return the points of a line, `from` first, the last one outside the world's bounds; each sees the next. Empty where
///         there is no way, or none wide enough to be found: ways narrower than an eighth of a metre may not be
/// Tests a lattice of points, ever finer, by a short cast to each neighbour; takes up to some seconds for a large
/// level. Where there is no way, or none but a narrow one, it goes through every lattice, up to 4 million points of
/// each, and takes memory for them.
[[nodiscard]] FIRMA_EXPORT std::vector<Vec3> find_leak(const World& world, const Vec3& from,
                                                       std::uint32_t mask = kStopsSight);

}  // namespace firma
