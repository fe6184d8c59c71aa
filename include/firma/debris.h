// SPDX-License-Identifier: MIT
// Debris: bodies that know their solids, so that they break, lie about for a while, and become ground again. Plain
// arrays beside the Bodies: a snapshot of a game is a World and copies of its Bodies and its Debris.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "firma/blast.h"
#include "firma/bodies.h"
#include "firma/carve.h"
#include "firma/chunk.h"
#include "firma/export.h"
#include "firma/fracture.h"
#include "firma/result.h"
#include "firma/solid.h"
#include "firma/world.h"

namespace firma {

/// What a body is made of.
struct DebrisPiece {
    Solid solid;                ///< in the frame of the body's shape: drawn at pose_of()
    std::uint32_t use = 0;      ///< of the body (BodyId::use)
    std::uint32_t matter = 0;   ///< index into MatterTable::matters of the world that it came from: what it is most of
    Vec3 origin;                ///< metres: where its frame's origin lay in that world (Chunk::origin)
    std::uint32_t broken = 0;   ///< how often what it was part of broke since it left the world
    double age = 0;             ///< seconds, since it is a body of its own
    double asleep_for = 0;      ///< seconds
    bool never_ground = false;  ///< it was to become ground, and could not
    bool of_part = false;       ///< it came off a part of the level: no place of the level's says what it is made of
};

/// By slot of the bodies. Slots of bodies without a solid hold a piece without faces, or are not there.
struct Debris {
    std::vector<DebrisPiece> slots;

    /// Null where that body is not there any more, or no debris.
    FIRMA_EXPORT DebrisPiece* find(const Bodies& bodies, BodyId id);
    FIRMA_EXPORT const DebrisPiece* find(const Bodies& bodies, BodyId id) const;
};

/// Adds a body and its solid.
/// @param body   its shape has to be valid()
/// @param piece  `use` is set
FIRMA_EXPORT BodyId add_debris(Bodies& bodies, Debris& debris, Body body, DebrisPiece piece);
/// A chunk as a body at rest where it came loose, of the matter that it has most of.
/// @return the errors of body_of(): nothing is added then
/// Costs body_of().
[[nodiscard]] FIRMA_EXPORT Result<BodyId> add_debris(Bodies& bodies, Debris& debris, const Chunk& chunk,
                                                     const FitOptions& fit = {});
/// Takes a body out with its solid. Does nothing for one that is not there.
FIRMA_EXPORT void remove_debris(Bodies& bodies, Debris& debris, BodyId id);

/// A hash of all that is in it, for machines that are to agree.
[[nodiscard]] FIRMA_EXPORT std::uint64_t hash_debris(const Debris& debris);

struct ShatterOptions {
    /// FractureOptions::impact is in the world here, metres; its density is the body's. Pieces of less than its
    /// min_volume become dust.
    FractureOptions fracture{};
    std::size_t max_spheres =
        12;  ///< of a piece, 1 to kMaxSpheres: found in less time than by fit_spheres(), less near
    /// The world that it lies in, of the level that it came from. Each piece is of the matter that the place was of
    /// where its centre was before it came loose, and as dense as that, in proportion. Spheres keep clear of what is
    /// solid: a body that rests lies a little in the ground, where it has no spheres, and so do its pieces. One whose
    /// centre of mass is in solid is buried, and becomes dust. Null: all are of the body's matter, and as dense, and
    /// their spheres may be in the ground.
    const World* world = nullptr;
    /// The part's own world, of one that came off a part: says what its pieces are of, in place of `world`.
    const World* part = nullptr;
};

/// What a body broke into.
struct Shattered {
    std::vector<BodyId> pieces;  ///< in place of the body; the body itself where nothing divided it
    std::size_t dust = 0;        ///< pieces too small to be bodies, or without room for a sphere, or buried: no bodies
    double dust_mass = 0;        ///< kilograms
    Vec3 dust_momentum;          ///< newton seconds, that went with them
    Vec3 dust_angular_momentum;  ///< newton metre seconds, about where the body's centre of mass was
    std::size_t cracks = 0;      ///< see Fracture
    std::size_t refused = 0;
};

/// Breaks a body: its pieces take its place, each where it was, as it moved there.
///
/// The pieces' masses are by their exact volumes (and the densities of ShatterOptions::world), and come to the body's.
/// They move as one rigid body that has its momentum and its angular momentum: so both are kept, to rounding, dust
/// included. Where their masses are where the body's mass was, that is its own velocity and spin. Friction and what
/// else the body says of itself is theirs too, its force by mass; its torque goes. They resist rolling more where their
/// spheres leave much of them out.
///
/// @return kInvalid for a body that is not there or is no debris, and for max_spheres out of range; the errors of
/// fracture(): then all is as it was
/// Costs fracture(), and some hundred searches for the nearest facet a piece.
[[nodiscard]] FIRMA_EXPORT Result<Shattered> shatter(Bodies& bodies, Debris& debris, BodyId id,
                                                     const FracturePattern& pattern,
                                                     const ShatterOptions& options = {});

/// How much debris a game keeps, and what becomes of the rest.
struct DebrisRules {
    std::size_t max_bodies = 256;
    std::size_t max_spheres = 4096;  ///< of all debris together
    double max_age = INFINITY;       ///< seconds: what is older goes, asleep or not
    double max_asleep = 20;          ///< seconds: what sleeps longer goes, or becomes ground
    bool to_ground = false;          ///< sleepers become part of the world instead of going
    std::size_t max_to_ground = 1;   ///< a call: each is an edit of the world
    double min_to_ground = 0.01;     ///< cubic metres: what is less goes
    /// Metres: nothing becomes ground where a sphere of another body is deeper in it. That body is pushed out.
    double max_overlap = 0.02;
    /// Spheres in the world that stay clear: players. Nothing becomes ground where one is in it.
    std::span<const Sphere> keep_clear{};
    /// CarveOptions::edit of the first fill of a call, those after it count on; 0: of each the one after the last.
    std::uint32_t first_edit = 0;
};

/// What became of debris.
struct DebrisReport {
    World world;  ///< after all that became ground
    std::vector<BodyId> removed;
    std::vector<BodyId> to_ground;
    std::vector<RestingSolid> fills;         ///< of each of these: fill() with it was the edit
    std::vector<CarveOptions> fill_options;  ///< and with these, for an edit log
    std::vector<CarveReport> edits;          ///< and its report
    std::size_t refused = 0;                 ///< that could not become ground, and stay bodies until they are too old
    std::size_t waiting = 0;                 ///< that wait, as a body or a player is in the way, or for another call
};

/// Lets debris age, and keeps it within rules. Call it once a frame, after step().
///
/// First what is too old goes. Then sleepers that lay long enough go or become ground, the smallest first: by
/// resting_solid() and fill(), with the inside of their matter (Matter::inside) as the material. Then, where there is
/// too much, the rest goes: sleepers before what is awake, of these the smallest first.
///
/// @param seconds  since the last call; nothing ages where that is negative or not finite
/// The same on every machine. Costs the bodies; a resting_solid() and a fill() for each that becomes ground.
[[nodiscard]] FIRMA_EXPORT DebrisReport tend_debris(const World& world, Bodies& bodies, Debris& debris, double seconds,
                                                    const DebrisRules& rules = {});

struct BlastOptions {
    /// Of the crater; nothing comes loose unless its `chunks` say so, as by default here.
    CarveOptions carve{.material = {}, .chunks = ChunkOptions{}};
    /// Metres around the blast: debris with a sphere in it that the blast sees breaks; what comes loose breaks too. 0:
    /// none does.
    double break_radius = 3;
    /// Pieces that a body breaks into at most, and where they become dust: FractureOptions.
    std::size_t max_pieces = 12;
    double min_volume = 0.001;
    /// What broke so often does not break again.
    std::uint32_t max_broken = 3;
    std::uint64_t seed = 1;
    std::size_t max_spheres = 12;  ///< as ShatterOptions::max_spheres, of chunks too; brought within its range
    PushOptions push{};
};

/// What a blast did.
struct BlastResult {
    CarveResult carve;           ///< its `world` is the one after the blast
    std::vector<BodyId> loose;   ///< bodies of what came loose, and of its pieces
    std::vector<BodyId> pieces;  ///< of debris that broke
    std::size_t broken = 0;      ///< bodies that broke, of both
    std::size_t unfit = 0;       ///< chunks that could not be bodies: lost
    std::size_t dust = 0;        ///< see Shattered
    double dust_mass = 0;        ///< kilograms
    PushReport push;
};

/// A blast in one call: carve() makes the crater; what comes loose becomes debris and breaks as its matter does;
/// debris near it that it sees breaks; then all bodies near it are pushed, by what is left of the world. Parts cover,
/// as exposure() says, and stay as they are: carve_part() cuts them.
/// @param crater, pose  as for carve(). A cutter that is not valid() carves nothing. Where the crater is refused all
///                      else happens: see BlastResult::carve
/// The same on every machine. Costs carve(), shatter() a body that breaks and blast_push().
[[nodiscard]] FIRMA_EXPORT BlastResult explode(const Scene& scene, Bodies& bodies, Debris& debris, const Blast& blast,
                                               const Cutter& crater, const Pose& pose,
                                               const BlastOptions& options = {});
/// In a world without parts.
[[nodiscard]] inline BlastResult explode(const World& world, Bodies& bodies, Debris& debris, const Blast& blast,
                                         const Cutter& crater, const Pose& pose, const BlastOptions& options = {}) {
    return explode(Scene{world}, bodies, debris, blast, crater, pose, options);
}

}  // namespace firma
