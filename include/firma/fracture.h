// SPDX-License-Identifier: MIT
// A solid broken into pieces, exactly: by planes, one after the other, as its matter breaks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "firma/export.h"
#include "firma/mass.h"
#include "firma/matter.h"
#include "firma/result.h"
#include "firma/solid.h"
#include "firma/turn.h"
#include "firma/vec.h"

namespace firma {

class World;
struct Chunk;

/// How cracks run.
enum class CrackStyle : std::uint8_t {
    kLumps,   ///< across the longest way through each piece, crooked: concrete, rock; long splinters where one size
              ///< is larger than the others
    kBricks,  ///< rows along z, divided along x, every other row half a brick on; thick walls divided along y
    kShards,  ///< away from the point of impact, around z, and across these: glass
};

/// What pieces look like. Sizes are along the axes of the solid that the pattern finds, or is given: z is the way
/// through a slab, x the long way, of bricks z is up.
struct FracturePattern {
    CrackStyle style = CrackStyle::kLumps;
    /// Metres, above zero: of a piece at the point of impact; of kBricks, of a brick. Of kShards x is how far apart
    /// cracks around the impact are, y how wide a shard is.
    Vec3 size{0.3, 0.3, 0.3};
    /// By how much of itself a piece is larger a metre from the point of impact, >= 0.
    double growth = 1;
    /// 0 to 1: how far from the middle and how slanted cracks are; of bricks by this share of a brick's size.
    double crooked = 0.5;
    /// The pattern's axes in the solid's frame; nothing: found, see fracture_axes().
    std::optional<Quaternion> axes{};
    /// A corner of a brick of an even row; nothing: the low corner of the solid along the pattern's axes.
    std::optional<Vec3> brick_corner{};
};

/// How a matter breaks, by its name and Matter::fracture: brick in bricks, wood in splinters along the grain, what is a
/// pane in shards, "concrete" in slabs that keep their thickness; all else in lumps. The same every time.
[[nodiscard]] FIRMA_EXPORT FracturePattern fracture_pattern(const Matter& matter);

/// The axes that a pattern finds in a solid without rock outside: z across its largest flat sides, y across the largest
/// of those that are across z, x along both: of a slab z is the way through it, of a beam x is its length. Of kBricks z
/// is the one of these three that is nearest to the frame's z, y the one of the others with more area across it.
/// @return no turn for a solid without faces
/// Costs its facets, sorted.
[[nodiscard]] FIRMA_EXPORT Quaternion fracture_axes(const Solid& solid, CrackStyle style = CrackStyle::kLumps);

struct FractureOptions {
    /// Where it was hit, in the solid's frame, metres: pieces are smallest there. Nothing: they are of one size, and
    /// kShards spread from the middle.
    std::optional<Vec3> impact{};
    std::size_t max_pieces = 32;  ///< 1 to kMaxPieces: cracks end when there are so many; what falls apart there may
                                  ///< make more of them
    /// Cubic metres: a piece of less is not divided.
    double min_volume = 0.001;
    double density = 2400;       ///< kilograms a cubic metre, for FracturePiece::mass
    std::uint64_t seed = 1;      ///< of crooked cracks
    std::uint32_t material = 0;  ///< of the faces along cracks: see crack_material()
};

/// More are refused.
inline constexpr std::size_t kMaxPieces = 4096;

struct FracturePiece {
    Solid solid;          ///< in the frame of the whole; one body (connected_pieces())
    MassProperties mass;  ///< by FractureOptions::density
};

struct Fracture {
    /// In an order that is the same everywhere. One piece, the whole, where nothing divided it.
    std::vector<FracturePiece> pieces;
    std::size_t cracks = 0;   ///< planes that divided something
    std::size_t refused = 0;  ///< that could not be cut: what they would have divided stayed whole
    Error refusal;            ///< of the first of these
};

/// Breaks a solid into pieces that fill it.
///
/// The pieces are cut by one plane after another: what a plane divides becomes two solids, each with that plane, bit
/// for bit. So no piece crosses another, together they are the whole (unite() of all of them is same_solid() as it),
/// and their exact volumes add up to its volume. The planes are those of three points of the input grid. Faces keep
/// ids, sources and materials as in subtract(); those along cracks are of `material`, and come from edit `edits() + 1`
/// and later of that piece. What casts meet of a piece are facets, rounded as in any solid, by at most 3.3 um: a corner
/// that two pieces share is rounded to one point in both.
///
/// @param solid  a chunk, a piece, a mesh that make_solid() read: closed, without rock outside
/// @return kInvalid for a solid without faces or with rock outside, and for a pattern or options that are not finite or
///         out of range, naming it; kOutOfRange where it lies within six of its radii of the world's rim; what
///         subtract() says where not one plane could be cut and one was to be. The solid stays what it was.
/// The same bits on every machine. Costs two subtract() a crack, each of all faces of what it divides; the facets of
/// each piece, and mass_properties() of it. Source: for cracks that end at older cracks, as those of concrete and glass
/// do, S. Bohn et al., Hierarchical crack pattern as formed by successive domain divisions, 2005.
[[nodiscard]] FIRMA_EXPORT Result<Fracture> fracture(const Solid& solid, const FracturePattern& pattern,
                                                     const FractureOptions& options = {});

/// The matter that a chunk has most of.
/// @return 0 where it has none
[[nodiscard]] FIRMA_EXPORT std::uint32_t main_matter(const Chunk& chunk);

/// The number of the material that cracks in a matter have (Matter::inside) in a world.
/// @param matter  index into MatterTable::matters
/// @return nothing where no material of the world has that name: no cut has left it yet
/// Goes through the names.
[[nodiscard]] FIRMA_EXPORT std::optional<std::uint32_t> crack_material(const World& world, std::uint32_t matter);

}  // namespace firma
