// SPDX-License-Identifier: MIT
// The pieces of a level's surface on their way to a verdict: can they be carved, and if not, what shows it?
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/edge_sides.h"
#include "firma/level.h"
#include "firma/solid.h"
#include "geometry/polygons_cross.h"
#include "index/box_tree.h"

namespace firma {

/// A level's faces with one number for each position, and its edges.
struct SolidMesh {
    const Level* level = nullptr;
    std::vector<InputPoint> points;           ///< by number
    std::vector<std::uint32_t> corner_point;  ///< number of each of Level::corners
    std::vector<EdgeSide> sides;              ///< by edge; their owners are faces

    std::span<const std::uint32_t> corners(std::uint32_t face) const {
        const LevelFace& it = level->faces[face];
        return {corner_point.data() + it.first_corner, it.corner_count};
    }
    MeshPolygon polygon(std::uint32_t face) const { return {corners(face), polygon_normal(points, corners(face))}; }
    Vec3 metres(std::uint32_t point) const { return to_metres(to_surface(points[point])); }
};

/// An edge of several: it bounds the air between two faces.
struct DoubledEdge {
    std::uint32_t low, high;
    std::uint32_t upward, downward;  ///< faces
};

/// How much may be looked at, of pairs of faces and on rays each: a level that asks for more keeps pieces castable
/// only.
struct SolidLimits {
    std::uint64_t pairs_with_boxes = 64;  ///< for each face; usual levels have some ten. More, and slabs are asked
    std::uint64_t at_all = std::uint64_t(1) << 24;
    std::uint64_t a_face = 2048;  ///< in addition

    std::uint64_t most(std::size_t faces) const { return at_all + a_face * faces; }
};

/// What was looked at.
struct SolidWork {
    std::uint64_t pairs = 0;     ///< of faces with boxes, or slabs, that meet
    std::uint64_t compared = 0;  ///< slabs with slabs
    std::uint64_t on_rays = 0;   ///< faces with boxes that rays meet

    /// A pair takes about as long as comparing so many slabs.
    static constexpr std::uint64_t kPairInSlabs = 16;
    std::uint64_t of_pairs() const { return compared + kPairInSlabs * pairs; }
};

struct SolidPieces {
    std::vector<std::uint32_t> of_face;
    struct Piece {
        std::uint32_t first = 0;  ///< face
        std::size_t faces = 0;
        std::optional<SolidNote> note;  ///< the first reason found; none: so far it can be carved
    };
    std::vector<Piece> pieces;  ///< by their first faces
    std::vector<DoubledEdge> doubled;
    SolidLimits limits;
    SolidWork work;

    bool good(std::uint32_t face) const { return !pieces[of_face[face]].note; }
    void refuse(std::uint32_t piece, const SolidNote& note) {
        if (!pieces[piece].note) pieces[piece].note = note;
    }
};

SolidMesh solid_mesh(const Level& level);

/// Joins faces by edges and looks at edges, sides and vertices.
SolidPieces join_pieces(const SolidMesh& mesh);

/// Faces with a tree around them.
struct FaceTree {
    std::vector<std::uint32_t> faces;  ///< by their numbers in the tree
    BoxTree tree;
};

/// Those of pieces that are good so far.
FaceTree good_faces(const SolidMesh& mesh, const SolidPieces& pieces);

/// Refuses pieces that cross or touch themselves or each other, and those for which finding out would take too long.
void refuse_crossing(const SolidMesh& mesh, const FaceTree& tree, SolidPieces& pieces);

/// Refuses pieces that are turned the wrong way for where they lie, and those for which finding out would take too
/// long.
/// @return whether rock is outside: what the outermost piece says
bool refuse_wrong_way(const SolidMesh& mesh, const FaceTree& tree, SolidPieces& pieces);

}  // namespace firma
