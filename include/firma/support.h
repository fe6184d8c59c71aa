// SPDX-License-Identifier: MIT
// What stands on faces or hangs at them: which faces hold an entity of a level, and which entities an edit took them
// from. Values beside the World, as bodies are; docs/support.md says what counts.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "firma/brush_level.h"
#include "firma/export.h"
#include "firma/hit.h"
#include "firma/level.h"
#include "firma/moving_parts.h"
#include "firma/result.h"
#include "firma/vec.h"
#include "firma/versions.h"
#include "firma/world.h"

namespace firma {

struct BrushParts;

/// What of a thing faces hold.
enum class SupportKind : std::uint8_t {
    kTouches,  ///< whatever faces its sides touch: parts, crates where they are placed
    kStands,   ///< it is put down first: straight down until it touches; then what is below it
    kHangs,    ///< whatever faces are as near as the nearest: lamps, signs
};

/// A flat side of a thing that faces may lie at.
struct SupportSide {
    std::vector<Vec3> corners;  ///< convex, counter-clockwise seen from outside, metres
    Vec3 normal;                ///< unit, out of the thing
    double depth = 0;           ///< metres behind it in which faces count as well: it may be sunk into what holds it
};

/// Something that faces may hold, where it is.
struct SupportedThing {
    std::uint32_t entity = 0;  ///< the caller's number for it: index into BrushLevel::entities
    SupportKind kind = SupportKind::kTouches;
    /// Metres. Its six sides count, each with half of the box behind it.
    Box box{};
    std::vector<SupportSide> sides;  ///< in place of the box's: support_sides() of a part
    /// Metres: kTouches, from a side to what holds it, at least the world's contact offset; kStands, how far down is
    /// looked; kHangs, how far around.
    double reach = 0;
    std::uint32_t mask = kStopsWalk;  ///< faces that share a bit hold
};

/// A face that holds something.
struct SupportFace {
    FaceRef face;
    std::uint64_t hash = 0;  ///< of the whole face: the same id may be another face's after an undo and another edit
    double area = 0;         ///< square metres of it that lie at the thing
    friend bool operator==(const SupportFace&, const SupportFace&) = default;
};

/// What holds a thing.
struct Support {
    SupportedThing thing;
    double lowered = 0;              ///< metres that a thing of kStands stands below where it was given
    double reach = 0;                ///< metres within which faces hold it: of kHangs as far as the nearest
    std::vector<SupportFace> faces;  ///< ascending by id
    double area = 0;                 ///< of all of them; 0: nothing holds it
};

/// All that something holds or held in a world. Plain data: a snapshot of a game is a World and a copy of it.
struct Supports {
    std::vector<Support> things;   ///< as given
    std::uint64_t world_hash = 0;  ///< hash_world() of the world that it is of
};

/// Finds what holds things. A face holds a thing where a part of it lies at a side, against it (at more than 120
/// degrees to the side's normal), not farther than Support::reach, and overlaps the side seen along its normal, by at
/// least a square millimetre. That reach is the world's contact offset, but as SupportedThing::reach says.
/// @return kInvalid, with the index of the thing, for a number that is not finite, a negative reach or depth, a box
///         that is empty where there are no sides, and a side of less than three corners or without normal
/// The same bits on every machine. Costs the faces near each thing, of kStands those below it as far as it reaches.
[[nodiscard]] FIRMA_EXPORT Result<Supports> find_supports(const World& world,
                                                          const std::vector<SupportedThing>& things);

enum class SupportLoss : std::uint8_t {
    kNone,  ///< as much holds it as before, or more: other faces in place of those that went
    kSome,
    kAll,  ///< nothing holds it any more
};

/// A thing that other faces hold than before, or none.
struct SupportChange {
    std::size_t thing = 0;  ///< index into Supports::things
    std::uint32_t entity = 0;
    SupportLoss loss = SupportLoss::kNone;
    std::vector<FaceRef> lost;     ///< of the world before, ascending by id
    double before = 0, after = 0;  ///< square metres that hold it
    bool buried = false;           ///< its middle is in solid now: it was filled in
};

/// What an edit did to things.
struct SupportDiff {
    std::vector<SupportChange> changes;  ///< by index of the thing
    Supports after;                      ///< of the world after
};

/// The things whose supporting faces went or came from one world to another, by an edit, a fill, an undo or a redo.
/// Each is searched where it stood or hung before: what would fall is not followed. A thing that nothing held is told,
/// with kNone, when something does again.
/// @param before  of the world before the change
/// @param diff    diff_worlds() from that world to `after`
/// Costs a look at each thing's box, and finding anew what holds those near what changed.
[[nodiscard]] FIRMA_EXPORT SupportDiff diff_supports(const Supports& before, const WorldDiff& diff, const World& after);
/// The same where the world before is not at hand: finds anew what holds each, unless hash_world() is the same.
[[nodiscard]] FIRMA_EXPORT SupportDiff diff_supports(const Supports& before, const World& after);

/// The sides of a part where it is at a fraction of its motion: of each face of its solid one.
/// @return none for a part whose motion cannot be used
/// Costs its faces.
[[nodiscard]] FIRMA_EXPORT std::vector<SupportSide> support_sides(const MovingPart& part, double fraction = 0);

/// The entities of a level of brushes that something may hold: its parts as they stand at time 0 (kTouches); what is
/// put down, and what hangs, by their classes, as docs/support.md lists them. Others, and those without an origin, are
/// left out. Ascending by entity.
/// @param parts  make_brush_parts() of the level
/// Costs the entities, and the faces of the parts.
[[nodiscard]] FIRMA_EXPORT std::vector<SupportedThing> supported_entities(const BrushLevel& level,
                                                                          const BrushParts& parts);

}  // namespace firma
