// SPDX-License-Identifier: MIT
// What a crater leaves, by what it is made of: new faces are split exactly along the planes where pieces of different
// matter meet, and each part gets the material of its inside.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "carve/cut_view.h"
#include "solid/matter_pieces.h"

namespace firma {

/// What a cut asks about what the solid is made of.
struct CutMatters {
    const MatterPieces* pieces = nullptr;   ///< null: of nothing special
    std::span<const std::uint32_t> inside;  ///< a material for each matter of the table: of new faces in it
};

/// The matter of all pieces that a box may meet, where they are of one; nothing where they are of several.
/// @param box  surface steps
std::optional<std::uint32_t> one_matter_near(const MatterPieces& pieces, const GridBox& box);

/// Splits the cutter's faces of a cut: a copy of what the cut made, to go on with instead.
///
/// A face is divided by the planes of the pieces near it, in the order in which they win (piece_at()), as far as what
/// lies behind it is of different matters on either side; closed meshes hold all of a face or nothing. Neighbours,
/// faces of the world too, take over the halves of edges that are split. A division that rounding leaves open is not
/// made: such a part is of the matter behind one point of it.
class MatterSplitter {
public:
    /// @param in, crossings, loops, matters  live as long as this
    MatterSplitter(const CutInput& in, const Crossings& crossings, const NewLoops& loops, const CutMatters& matters,
                   const CarveRules* rules);

    /// Does one piece of work: one face. False once there is none left.
    bool step();

    // Once step() said false:
    const Crossings& crossings() const { return crossings_; }
    const NewLoops& loops() const { return made_; }

private:
    /// Part of a face: loops of uses, the outer one first.
    struct Part {
        std::vector<PatchUse> uses;
        std::vector<std::uint32_t> ends;
    };
    struct Assigned {
        Part part;
        std::uint32_t matter;
    };
    struct Sides {
        bool behind = false, front = false;
    };
    /// Where a loop changes its side of a plane, at the vertex that item `item` begins with.
    struct SideChange {
        std::uint32_t item = 0;  ///< in items_
        std::uint32_t vertex = 0;
        bool to_front = false;
        std::uint32_t next = 0;     ///< of the same loop
        std::uint32_t partner = 0;  ///< the other end of the part of the line that lies in the face
    };
    struct Base {
        std::uint32_t from, to;
        const SolidPlane* plane[2];
        bool doubled;
    };

    void assign(const NewFace& face);
    void list_candidates();
    std::vector<std::uint32_t> near(const Part& part, std::span<const std::uint32_t> candidates) const;
    bool are_of_one(std::span<const std::uint32_t> pieces) const;
    std::vector<Assigned> resolve(Part part, std::span<const std::uint32_t> candidates);
    std::vector<Assigned> divide(Part part, std::span<const std::uint32_t> candidates, std::size_t plane);
    static std::vector<Assigned> one(Part part, std::uint32_t matter);
    bool all_of_one(const std::vector<Assigned>& parts) const;
    GridBox reach_of(std::span<const PatchUse> uses) const;
    Sides sides(const Part& part, const SolidPlane& plane) const;
    bool keeps_away(const SolidPlane& plane, const Part& part) const;
    std::uint32_t matter_at_point(const Part& part, std::span<const std::uint32_t> candidates) const;
    std::optional<GridPoint> point_within(const Part& part) const;

    bool split(const Part& part, const Ref<const SolidPlane>& plane, std::vector<Part>& behind,
               std::vector<Part>& front);
    bool cut_items(const Part& part, const Ref<const SolidPlane>& plane);
    bool pair_changes(const Plane& plane);
    bool trace(bool front, const SolidPlane* plane, std::vector<Part>& parts);
    void add_line(std::uint32_t enters, const SolidPlane& plane, bool backward, std::vector<PatchUse>& uses);
    static void take_out_returns(std::vector<std::vector<PatchUse>>& loops);
    const Plane* across(std::uint32_t vertex, const Plane& plane) const;
    int order(const Plane& plane, std::uint32_t a, std::uint32_t b);

    const Base& base_of(std::uint32_t edge);
    std::uint32_t base_number(std::uint32_t edge) const;
    std::uint32_t edge_between(std::uint32_t base, std::uint32_t a, std::uint32_t b);
    std::uint32_t split_vertex(std::uint32_t base, const Ref<const SolidPlane>& plane);
    PatchUse use_between(const PatchUse& use, std::uint32_t a, std::uint32_t b);

    void note_vertices(const Part& part);
    void finish();
    void divide_taken();
    void mark_doubled();
    void add_division(std::uint32_t edge, std::span<const PatchUse> parts);
    void expand(const PatchUse& use, std::vector<PatchUse>& uses);
    void add_face(const NewFace& like, std::span<const PatchUse> uses, std::span<const std::uint32_t> ends,
                  std::uint32_t material);

    const CutInput& in_;
    const NewLoops& loops_;
    const MatterPieces& pieces_;
    const std::span<const std::uint32_t> inside_;
    const CarveRules* const rules_;
    Crossings crossings_;
    NewLoops made_;
    CutView view_;
    std::uint32_t next_ = 0;
    bool whole_ = true;  ///< nothing was split so far

    std::vector<std::uint32_t> candidates_;        ///< pieces near the cut, in the order in which they win
    std::vector<std::vector<Assigned>> assigned_;  ///< by face of loops_; empty for the world's

    // Edges that are parts of others, and new ones: by number from first_part_ on.
    std::uint32_t first_part_;
    std::vector<std::uint32_t> base_of_part_;
    std::map<std::uint32_t, Base> bases_;
    std::map<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>, std::uint32_t> part_of_;
    std::map<std::pair<std::uint32_t, const SolidPlane*>, std::uint32_t> vertex_on_;
    std::map<GridPoint, std::vector<std::uint32_t>> made_vertices_;
    std::map<std::uint32_t, std::vector<std::uint32_t>> on_base_;  ///< vertices of final parts within it, in order
    std::vector<Ref<const SolidPlane>> axis_planes_;

    // Of the face at hand:
    const SolidPlane* plane_ = nullptr;  ///< of the face
    const NewFace* face_ = nullptr;
    // Of the split at hand:
    std::vector<PatchUse> items_;
    std::vector<std::uint32_t> item_ends_;
    std::vector<std::int8_t> item_sides_;  ///< of the vertex that each begins with; 0 on the plane
    std::vector<SideChange> changes_;
    std::vector<std::uint32_t> touching_;  ///< vertices on the plane, in order along the line
    std::vector<std::uint32_t> order_;
    std::vector<std::uint32_t> line_edge_;  ///< by change that enters: the edge from there to its partner
    std::map<std::pair<std::uint32_t, std::uint32_t>, PatchUse> on_line_;  ///< items that run along it
};

}  // namespace firma
