// SPDX-License-Identifier: MIT
// Faces of the solid after a cut, in groups that grow across edges: those that the cut made and those around it by
// number, others as the index finds them. The solid after the cut need not be there yet.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/disjoint_sets.h"
#include "base/flat_map.h"
#include "carve/cut_view.h"
#include "carve/tile_faces.h"
#include "solid/anchors.h"
#include "solid/edge_key.h"
#include "solid/face_set.h"

namespace firma {

/// A face that the cut made (CutFaces::made), or one of the solid before it.
struct LiveFace {
    const SolidFace* stored = nullptr;  ///< null: no cut has touched it
    FacetPlace facet;                   ///< without a block for one that the cut made
    GridBox box() const;
};

/// What a cut made of the faces of a patch.
struct CutFaces {
    const CutView& view;
    const NewLoops& loops;
    const KeptPieces& kept;
    const FaceSet& made;  ///< an owner for each of loops.faces, then for each of kept.pieces

    std::uint32_t made_count() const { return std::uint32_t(loops.faces.size() + kept.pieces.size()); }
    const SolidFace& owner(std::uint32_t k) const { return static_cast<const SolidFace&>(*made.owners[k]); }
    /// The patch's face that a made one is a piece of; ~0: it is the cutter's.
    std::uint32_t parent(std::uint32_t k) const {
        return k < loops.faces.size() ? loops.faces[k].face : kept.pieces[k - loops.faces.size()];
    }
};

/// Puts facets of some of the faces that a cut made at the end of a set, their owners among them; ids are left open.
/// @param numbers  of CutFaces
void append_made(const FaceSet& made, std::span<const std::uint32_t> numbers, FaceSet& set);

/// Nodes are numbered: first what the cut made, then the patch's faces, whether they are still there or not, then
/// others as they are found. A group is known by any of its nodes.
class FaceGroups {
public:
    /// Groups what the cut made and what stays of the patch, by the edges that they share. Costs these.
    explicit FaceGroups(const CutFaces& cut);

    std::uint32_t group_of(std::uint32_t node) { return sets_.find(node); }
    /// Groups that one of loops.faces is in, ascending.
    const std::vector<std::uint32_t>& changed() const { return changed_; }
    /// Those of them that come from one shell, or several that touched the cutter together: by the faces that were side
    /// by side before the cut. All of them where one may have hung in a hollow of the others.
    struct Family {
        std::vector<std::uint32_t> groups;
        bool lost = false;  ///< whether one of `lost` was of it
    };
    /// Costs the patch.
    /// @param lost  faces of the patch that are not there any more
    std::vector<Family> families(std::span<const std::uint32_t> lost);

    /// Gets ready to grow. Costs the patch.
    /// @param root     of the index over the solid before the cut
    void start(const Node* root, const Anchors& anchors);
    /// Adds the face across one edge of a group, if it has an open one.
    /// @return whether it has: if not, it is closed
    bool grow(std::uint32_t node);
    /// A group of one face of the solid before the cut that is in no group yet.
    std::uint32_t add(const FacetPlace& facet);
    /// The node of a face of the solid before the cut: of the patch, or one that grow() or add() found; ~0 for others.
    std::uint32_t find(const FacetPlace& facet) const;

    bool is_closed(std::uint32_t node);
    bool is_held(std::uint32_t node) { return state(node).held; }
    /// Looks, by the face that it found last, for a quick proof that a group is of a shell that is held or looks
    /// inward; it counts as held then.
    void look_behind(std::uint32_t node);
    /// Around all its faces that are known.
    const GridBox& box(std::uint32_t node) { return state(node).box; }
    /// In order: what the cut made, the patch's, the others as they were found. Costs the patch, and the group.
    std::vector<LiveFace> faces(std::uint32_t node);
    /// Of loops.faces and kept.pieces, numbered through. Costs these.
    std::vector<std::uint32_t> made(std::uint32_t node);
    /// Whether that face is still there, as it was.
    bool stays(const FacetPlace& facet) const {
        const std::uint32_t face = patch_.find(facet);
        return face == SolidPatch::kNone || stays_[face] != 0;
    }
    /// How many faces were looked for in the index.
    std::size_t searched() const { return searched_; }

private:
    static constexpr std::uint32_t kNone = ~0u;
    struct OpenEdge {
        KeyedUse use;
        std::uint32_t node;
        bool open = true;
    };
    struct State {
        std::vector<std::uint32_t> edges;  ///< of open_; some are closed by now
        std::size_t next = 0;              ///< of these
        std::vector<FacetPlace> found;
        GridBox box;
        bool held = false;
    };

    bool lies_in_the_cutter(std::uint32_t group);
    std::uint32_t patch_node(std::uint32_t face) const { return cut_.made_count() + face; }
    State& state(std::uint32_t node) { return states_[state_of_[sets_.find(node)]]; }
    std::uint32_t join(std::uint32_t a, std::uint32_t b);
    std::uint32_t& edge_with(const EdgeKey& key);
    void open(const KeyedUse& use, std::uint32_t node);
    void add_face(std::uint32_t node, const FacetPlace& facet);
    bool has_open_edge(State& state) const;
    bool reaches_into_a_volume(const LiveFace& face);

    const CutFaces& cut_;
    const SolidPatch& patch_;
    DisjointSets sets_;
    std::vector<std::uint8_t> stays_;  ///< of each patch face
    std::vector<std::uint32_t> user_;  ///< of each edge of the view, forward and back: a node
    std::vector<std::uint32_t> changed_;

    // Once started:
    const Node* root_ = nullptr;
    const Anchors* anchors_ = nullptr;
    std::vector<State> states_;
    std::vector<std::uint32_t> state_of_;  ///< of the lowest node of each group
    std::vector<OpenEdge> open_;
    FlatMap edge_of_key_, node_of_face_;
    std::size_t searched_ = 0;
    std::vector<Vec3> loop_;
};

}  // namespace firma
