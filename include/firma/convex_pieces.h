// SPDX-License-Identifier: MIT
// A solid as convex pieces, exactly, for programs that hand chunks to another engine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "firma/export.h"
#include "firma/mass.h"
#include "firma/result.h"
#include "firma/solid.h"
#include "firma/vec.h"

namespace firma {

struct ConvexOptions {
    std::size_t max_pieces = 256;  ///< 1 to kMaxConvexPieces: a solid of more is refused
    /// Metres. 0: each piece is convex. Above: what is convex but for less than this stays one piece, of which its
    /// hull is given: no point of the hull is farther than this from the piece. So no point of two hulls' overlap is
    /// farther than this from either piece.
    double max_concavity = 0;
    double density = 2400;  ///< kilograms a cubic metre, for ConvexBody::mass
};

/// More are refused.
inline constexpr std::size_t kMaxConvexPieces = 16384;

/// A face of a convex piece.
struct ConvexFace {
    Vec3 normal;        ///< unit, outward
    double offset = 0;  ///< metres: normal . p = offset on it
    /// Its corners, counter-clockwise seen from outside: ConvexBody::loops[first] to [first + count - 1], count >= 3.
    std::uint32_t first = 0, count = 0;
};

struct ConvexBody {
    /// Whether the piece is convex, exactly. If not, the corners and faces are those of its hull.
    bool exact = true;
    /// The piece, convex, in the frame of the whole, of one that is exact: two pieces that meet have one plane between
    /// them, bit for bit. Else without faces.
    Solid solid;
    /// Rounded to the surface grid, by at most 3.3 um, metres: a corner that pieces share is the same in each. The
    /// hull of these is what another engine makes of them.
    std::vector<Vec3> corners;
    /// Of an exact piece its exact planes; of a hull, triangles.
    std::vector<ConvexFace> faces;
    std::vector<std::uint32_t> loops;  ///< numbers of corners
    /// Of the piece, not of its hull: exact ones of all pieces add up to the whole's.
    MassProperties mass;
    double hull_volume = 0;  ///< cubic metres: of the hull of `corners`, exactly, but for its rounding
    /// Metres: no point of the hull is farther from the piece. 0 for an exact one, whose corners are rounded only.
    double overhang = 0;
};

struct ConvexPieces {
    /// In an order that is the same everywhere.
    std::vector<ConvexBody> pieces;
    std::size_t exact = 0;         ///< how many of them are
    std::size_t reflex_edges = 0;  ///< of the whole; 0: it is convex, or several that are
    std::size_t cuts = 0;          ///< planes that divided something
    std::size_t merged = 0;        ///< pairs of pieces that were one convex piece after all
};

/// Divides a solid into convex pieces that fill it.
///
/// What has reflex edges is divided by a plane through one of them, again and again: that of a face there, or one
/// through two such edges whose ends lie on the input grid; by the one that resolves most and makes fewest two. Where
/// it would cut what is convex there anyway, it does not; pieces that are convex together are merged, as long as there
/// are any. All points are those where such planes meet: so the pieces are the solid, exactly, none crosses another,
/// and their exact volumes add up to its volume. Few pieces are not the fewest: to find these is NP-hard.
///
/// @param solid  a chunk, a piece, a mesh that make_solid() read: closed, without rock outside; of several bodies and
///               with hollows, if it has them
/// @return kInvalid for a solid without faces or with rock outside, for options that are not finite or out of range,
///         and for a surface that crosses itself (check_solid() does not say so); kTooLarge where it takes more than
///         max_pieces. The same bits on every machine.
/// Costs, a piece, some thousand signs of exact predicates for each reflex edge that is left there: microseconds for a
/// box with a notch, a second for some hundred reflex edges. With max_concavity, also the distances of some thousand
/// points from the faces of each piece. Allocates as much as these.
/// Source: for division at reflex edges, B. Chazelle, Convex partitions of polyhedra, 1984.
[[nodiscard]] FIRMA_EXPORT Result<ConvexPieces> convex_pieces(const Solid& solid, const ConvexOptions& options = {});

}  // namespace firma
