// SPDX-License-Identifier: MIT
// The exact solid of a world: is it sound, how large is it, is it the same? And what of a level can become one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "firma/hit.h"
#include "firma/vec.h"
#include "firma/world.h"

namespace firma {

/// What does not hold of a solid's exact boundary, and where.
struct SolidFault {
    std::string what;
    FaceId face;  ///< one facet of the exact face; not valid() when no face is at fault alone
    Vec3 at;      ///< metres: a corner or an edge's end that shows it
};

/// The first thing that does not hold of the solid's boundary, or nothing. All faces with Face::solid are looked at:
/// loops close, an outer one first, the right way around, then holes; every edge is used twice, once each way; vertices
/// lie exactly on the planes of their faces and edges; the facets of each face cover it, and all facets together are
/// closed. Says nothing about where the boundary crosses itself. See check_world() for facets one by one.
std::optional<SolidFault> check_solid(const World& world);

struct SolidMeasures {
    /// Of the exact solid, cubic metres; where rock reaches to infinity, minus the volume of its air.
    double volume = 0;
    /// Of the exact solid's boundary, square metres.
    double area = 0;
    /// As `volume`, but of what casts meet: corners rounded to the surface grid.
    double facet_volume = 0;
    std::size_t faces = 0;   ///< exact ones
    std::size_t facets = 0;  ///< of these
};

/// Measures all faces with Face::solid. Each number is rounded once or twice, from sums of 100 bits and more.
SolidMeasures measure_solid(const World& world);

/// A hash of the exact solid: planes, materials and loops of rounded corners. Equal for equal solids, however they came
/// about: disjoint edits in any order give the same. Ids, sources, blocks and which faces edits have touched do not
/// count. The same on every machine.
std::uint64_t hash_solid(const World& world);

/// Why a piece of a level's surface cannot be carved.
enum class SolidNoteKind : std::uint8_t {
    kOpenEdge,    ///< an edge that is not used equally often each way
    kFoldedEdge,  ///< faces around an edge lie on each other, or do not alternate
    kTwoSided,    ///< a two-sided face
    kOffGrid,     ///< a vertex off the input grid
    kCrossing,    ///< it crosses or touches itself, or another closed piece
    kWrongWay,    ///< turned the wrong way for where it lies: a solid in a solid, or a hollow in the air
};

/// A piece of a level's surface, joined by edges, that is castable only, and what shows why.
struct SolidNote {
    SolidNoteKind what = SolidNoteKind::kOpenEdge;
    std::size_t faces = 0;     ///< in the piece, as the level has them
    std::uint32_t source = 0;  ///< index in the file of a face that shows it
    std::uint32_t other = 0;   ///< kCrossing: of the face that it crosses or touches
    Vec3 at;                   ///< metres: a corner of that face; for edges, where it starts
    Vec3 to;                   ///< where the edge ends, for edges; else as `at`
};

struct LevelSolidity {
    std::size_t solid_faces = 0;   ///< of Level::faces
    bool rock_outside = false;     ///< what no face separates from infinity is solid
    std::vector<SolidNote> notes;  ///< one for each piece that is castable only
};

/// What of a level make_world() can make carvable, and why not the rest. Closed pieces can, exactly as snapped: each
/// edge used equally often each way, no crossing, no touching but for common edges and vertices, one-sided faces.
/// @param level  one that make_world() refuses has no solid face and no note
LevelSolidity level_solidity(const Level& level);

}  // namespace firma
