// SPDX-License-Identifier: MIT
// Pieces of a world that a cut leaves loose: what they are as bodies, and what holds a piece where it is.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "firma/cutter.h"
#include "firma/export.h"
#include "firma/mass.h"
#include "firma/result.h"
#include "firma/solid.h"
#include "firma/vec.h"
#include "firma/world.h"

namespace firma {

/// How much of a body is of one matter.
struct MatterVolume {
    std::uint32_t matter = 0;  ///< index into MatterTable::matters of the world that the body was part of
    double volume = 0;         ///< cubic metres
    friend bool operator==(const MatterVolume&, const MatterVolume&) = default;
};

/// A piece that came loose and left the world, with its exact faces: their sources and materials are those that they
/// had in the world; of what the cut made, those of the world after it, which names all of them.
struct Chunk {
    /// In a frame of its own: the world's grid moved by whole steps of 1/4096 m to the middle of the piece. It is cut,
    /// asked and drawn like any solid.
    Solid solid;
    /// Where that frame's origin lay in the world, metres: a point of the frame lay at `origin` + point.
    Vec3 origin;
    /// In its frame: by the densities of the matters that it is made of, or by one density (ChunkOptions::density).
    MassProperties mass;
    /// What it is made of, as matter_at() says it of each place: ascending, each matter once. Volumes add up to that of
    /// `mass` but for rounding.
    std::vector<MatterVolume> matters;
};

/// How a cut looks for loose pieces: see CarveOptions::chunks.
struct ChunkOptions {
    /// Pieces of less, cubic metres, leave the world too, but are only counted: CarveReport::crumbs.
    double min_volume = 0.001;
    /// Kilograms a cubic metre, of all that a chunk is made of; 0: of each matter its own (Matter::density). Where
    /// several are near a chunk their pieces are cut out of it, exactly, each at the cost of a small subtract().
    double density = 0;
};

/// What holds a piece of a world's solid. A piece with one face that holds stays where it is, as does whatever reaches
/// around air instead of enclosing anything: rock around rooms, the walls of hollows.
struct AnchorRules {
    /// What hangs free now stays by intent, a lamp or a floating platform, and so do its parts; the outer side of a
    /// hull around rooms among it. Of a level that stands free as a whole (a piece of ground without rock around it)
    /// nothing ever comes loose like this: say false, and name what holds it up.
    bool hanging = true;
    /// Faces of these materials hold. Names that the world does not have hold nothing.
    std::vector<std::string> materials{};
    /// Faces that come from these of the level's file hold; of a level of brushes, from these sides.
    std::vector<std::uint32_t> sources{};
    /// Solid that reaches into one of these boxes (metres) is held: see anchor_volumes(). One that is empty or not
    /// finite holds nothing.
    std::vector<Box> volumes{};
};

/// The same world with what holds its pieces said anew: of the same version, as with_rules(). Edits and files keep it,
/// no hash sees it. A cut that looks for loose pieces in a world of which nothing is said takes AnchorRules{} for it,
/// at this cost: say it when the level is read.
/// With AnchorRules::hanging costs all faces, in time and in memory.
[[nodiscard]] FIRMA_EXPORT World with_anchors(const World& world, const AnchorRules& rules = {});

/// The bodies that a solid is made of: what faces that share edges enclose, each with its hollows. Ids, sources and
/// materials stay. A body in a hollow of another is one of its own. Where rock reaches to infinity the first one is
/// that.
/// @return in order of the lowest id of their faces, but for the rock; the solid itself where it is one; none for none
/// Costs all faces, and a search among the bodies for each hollow.
[[nodiscard]] FIRMA_EXPORT std::vector<Solid> connected_pieces(const Solid& solid);

/// A body where it came to rest, ready for fill().
struct RestingSolid {
    Cutter cutter;             ///< fill(world, cutter, pose) makes it ground
    Pose pose;                 ///< where the cutter goes
    double volume_change = 0;  ///< cubic metres that snapping added; negative where it took some
    int mended = 0;            ///< triangles that were taken out, as snapping made them cross others
};

/// A solid as a cutter at a pose, for what has fallen to become ground. By one of the 24 turns of the axes and at scale
/// 1 it is placed exactly (cutter_from_solid()). At any other pose each corner of its facets is turned, scaled and
/// snapped to the grid of 1/4096 m. Triangles that lose their area there go; of those that cross or touch others the
/// thinnest go, and their neighbours take over: by a turned edge, else by merging two corners of a short one. Where
/// that is not enough it is all done again at up to 15 other places, less than half a step away along each axis.
/// @param name  for messages
/// @return errors of cutter_from_solid(), and of a pose that is not finite or leads out of the world; kInvalid where
///         triangles cross or touch each other still, with a place: it stays a body then
/// Costs its facets, and testing those near each other against each other, again for each time that some are mended.
[[nodiscard]] FIRMA_EXPORT Result<RestingSolid> resting_solid(const Solid& solid, const Pose& pose,
                                                              std::string name = "");

}  // namespace firma
