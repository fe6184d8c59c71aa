// SPDX-License-Identifier: MIT
// What of a level is made of what: its brushes and closed meshes, each with its matter, and the table they are of.
// Nothing in it changes once made: all versions of a world share it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "firma/matter.h"
#include "firma/solid.h"
#include "geometry/grid_box.h"
#include "index/box_tree.h"
#include "solid/solid_face.h"

namespace firma {

/// A convex body by its planes, or a closed mesh. Its number is its place among the others: the lower one wins where
/// two overlap.
struct MatterPiece {
    std::uint32_t matter = 0;
    std::uint32_t look = 0;  ///< the material that most of its sides have
    bool sky = false;        ///< painted with the sky, by its material `look`: may not be carved
    GridBox box;
    std::uint32_t first_plane = 0, plane_count = 0;        ///< that bound it, looking out; none: a mesh
    std::uint32_t first_material = 0, material_count = 0;  ///< of its sides, ascending, each once
    std::optional<Solid> mesh;
};

/// Faces of the level by source: from `first` on, up to the next one's, they are of this matter.
struct MatterOfSources {
    std::uint32_t first = 0, matter = 0;
    friend bool operator==(const MatterOfSources&, const MatterOfSources&) = default;
};

struct MatterPieces {
    MatterTable table = default_matters();
    std::uint32_t rest = 0;       ///< the matter of what is in no piece
    std::uint32_t rest_look = 0;  ///< and its material, where there is one
    std::vector<MatterPiece> pieces;
    std::vector<Ref<const SolidPlane>> planes;
    std::vector<std::uint32_t> materials;
    std::vector<MatterOfSources> sources;  ///< ascending; before the first: the first of the table

    // What follows from the above; finish() sets it.
    BoxTree tree;
    std::uint64_t hash = 0;
    bool same = true;      ///< all pieces and the rest are of one matter
    bool any_sky = false;  ///< some piece is

    /// Once all else is set.
    void finish();

    std::span<const Ref<const SolidPlane>> planes_of(const MatterPiece& piece) const {
        return {planes.data() + piece.first_plane, piece.plane_count};
    }
    std::span<const std::uint32_t> materials_of(const MatterPiece& piece) const {
        return {materials.data() + piece.first_material, piece.material_count};
    }
    std::uint32_t of_source(std::uint32_t source) const;
    std::size_t bytes() const;
};

/// Whether there is nothing to say: no piece, no source, all of it of the first matter of the built-in table. Worlds
/// keep none then.
bool says_nothing(const MatterPieces& pieces);

/// How hard a piece is under rules: 1 where it is sky or one of its materials may not be carved; else what the rules
/// say of its material, else that of its matter.
/// @param rules  null: none
double hardness_of(const MatterPieces& pieces, const MatterPiece& piece, const CarveRules* rules);
double hardness_of_rest(const MatterPieces& pieces, const CarveRules* rules);
/// Whether anything at all may be harder than 0: what says no saves asking for each.
bool any_hard(const MatterPieces& pieces, const CarveRules* rules);

/// The side of a plane that a point of the surface grid lies on, exactly: 1 in front, 0 on it, -1 behind.
int side_of_plane(const Plane& plane, const GridPoint& point);

/// Whether a piece holds a point: its inside, and of a body also its surface.
bool holds(const MatterPieces& pieces, const MatterPiece& piece, const GridPoint& point);

/// The number of the piece that a point is in, see matter_at(); nothing: the rest.
std::optional<std::uint32_t> piece_at(const MatterPieces& pieces, const GridPoint& point, const CarveRules* rules);

}  // namespace firma
