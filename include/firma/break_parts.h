// SPDX-License-Identifier: MIT
// Parts of a level that break: func_breakable, func_explosive, a door that is carved in two. What a part bears is kept
// beside it by the game; what breaks off becomes debris, and the part goes. docs/moving.md says which keys count.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "firma/blast.h"
#include "firma/bodies.h"
#include "firma/brush_parts.h"
#include "firma/carve.h"
#include "firma/debris.h"
#include "firma/export.h"
#include "firma/moving_parts.h"
#include "firma/vec.h"
#include "firma/world.h"

namespace firma {

/// What a part bears, and what is left of that. A plain value.
struct Breakable {
    double health = 0;       ///< what is left, by its author's measure; not above 0: nothing hurts it
    double whole = 0;        ///< cubic metres of its solid before anything was taken of it
    double max_taken = 0.5;  ///< of `whole`: what has lost a larger share breaks; 1: carving alone breaks it never
    /// Of all of it, in place of what its textures say: index into MatterTable::matters.
    std::optional<std::uint32_t> matter{};
    double damage = 0;    ///< of the explosion that it makes, by its author's measure: BrushPart::damage
    bool broken = false;  ///< once, and for ever
};

/// Of a part that an entity makes: its health, and the matter that it names, where the part's world has one of that
/// name ("metal" is steel, "stone" rock; the numbers of `material` are Half-Life's). Costs its faces.
[[nodiscard]] FIRMA_EXPORT Breakable breakable_of(const BrushPart& part);

/// Takes from its health.
/// @return whether this breaks it: call break_part(). False for one that is broken, that nothing hurts, and for a
///         damage that is not finite or not above 0
FIRMA_EXPORT bool hurt_part(Breakable& breakable, double damage);

/// The share of a blast that a part feels, for hurt_part(): blast_share() at the point of its faces that is nearest to
/// the blast; 0 where the level stands before that point.
/// @param fraction  of the part's motion
/// Never allocates. Costs closest() of the part, and a ray.
[[nodiscard]] FIRMA_EXPORT double blast_felt(const World& level, const MovingPart& part, const Blast& blast,
                                             double fraction = 0);

struct BreakOptions {
    double fraction = 0;  ///< of the part's motion, where it breaks
    /// That its motion takes from fraction 0 to 1: pieces go on as it went there. 0: they begin at rest.
    double seconds = 0;
    std::optional<Vec3> impact{};  ///< in the world, metres: pieces are smallest there
    /// Opened as well: those that it closed when it was whole. With a hole in it it covers none (portals_closed_by()).
    std::vector<PortalId> portals{};
    bool unbroken = false;        ///< it falls as it is: a body for each of its connected_pieces()
    std::size_t max_pieces = 12;  ///< of each of these, at most; where they become dust: FractureOptions
    double min_volume = 0.001;
    std::uint64_t seed = 1;
    std::size_t max_spheres = 12;  ///< as ShatterOptions::max_spheres; brought within its range
};

/// What a part broke into.
struct BrokenPart {
    std::vector<BodyId> pieces;
    std::size_t unfit = 0;         ///< of its solid's pieces, that could not be bodies: lost
    std::size_t dust = 0;          ///< see Shattered
    double dust_mass = 0;          ///< kilograms
    std::vector<PortalId> opened;  ///< those that it closed, ascending
    World level;                   ///< with these open; the same one where there are none
};

/// Breaks a part: its pieces become debris where it stands, and it goes. It keeps its place in Scene::parts, without a
/// face: nothing meets it any more, what slept on it wakes in the next step. The portals that it closes where its
/// motion begins (portals_closed_by()) are opened, and those of BreakOptions::portals.
///
/// Pieces are of the part's matters, by the part's world, or by `breakable`; they weigh as if all were of the matter
/// that most of its surface is of. Their spheres keep clear of the level.
/// @param breakable  becomes broken; may be null
/// @return no pieces for a part without solid; for one whose motion cannot be used all is as it was
/// The same on every machine. Costs shatter() of each piece of its solid.
FIRMA_EXPORT BrokenPart break_part(const World& level, MovingPart& part, Breakable* breakable, Bodies& bodies,
                                   Debris& debris, const BreakOptions& options = {});

/// What holds the pieces of a part that is cut.
enum class PartHold : std::uint8_t {
    kLevel,    ///< faces of the level that they touch, within PartCutOptions::touch; of a part that nothing held
               ///< before the cut, as kLargest
    kLargest,  ///< whatever moves the part: it goes on with the largest piece
};

struct PartCutOptions {
    /// Of the cut. Its `chunks` say what is too small for a body.
    CarveOptions carve{.material = {}, .chunks = ChunkOptions{}};
    PartHold hold = PartHold::kLevel;
    double touch = 1.0 / 32;  ///< metres
    /// Where the part stands, and how it breaks if that is too much.
    BreakOptions pieces{};
};

/// What a cut did to a part.
struct PartCut {
    CarveStatus status = CarveStatus::kRefused;
    Error error;                ///< for kRefused
    CarveReport report;         ///< of the cut; what came loose counts as chunks
    std::vector<BodyId> loose;  ///< what the cut left that nothing holds: bodies, unbroken
    std::size_t unfit = 0;      ///< such pieces that could not be bodies: lost
    /// What was left of the part broke, as more than Breakable::max_taken was taken; or all of it fell, as nothing
    /// holds any of it.
    std::optional<BrokenPart> broken;
    /// Portals that the part closed before the cut, and that are open now, ascending: it has a hole there, or it broke.
    std::vector<PortalId> opened;
    World level;  ///< with these open; the same one where there are none
};

/// Carves a part where it stands (pose_in_part()). Where that leaves pieces that nothing holds, they leave the part
/// exactly, and become bodies; where too much was taken, the rest breaks. Portals that the part closed and covers no
/// longer are opened: it is asked at points of them not farther apart than an eighth of a metre.
/// @param pose       of the cutter, in the world
/// @param breakable  may be null: then nothing breaks, but pieces fall
/// @return kNothing and kRefused as carve(): then the part is as it was
/// The same on every machine. Costs carve(), connected_pieces() of what it leaves, and where some are loose the cut
/// again, with a look at the faces of the level near the part's.
FIRMA_EXPORT PartCut carve_part(const World& level, MovingPart& part, Breakable* breakable, const Cutter& cutter,
                                const Pose& pose, Bodies& bodies, Debris& debris, const PartCutOptions& options = {});

}  // namespace firma
