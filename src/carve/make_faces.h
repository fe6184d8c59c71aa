// SPDX-License-Identifier: MIT
// From new loops to faces that can be kept: shared vertices and edges, and facets for casts to meet.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "carve/cut_view.h"
#include "solid/face_set.h"
#include "solid/make_facets.h"

namespace firma {

/// The part of faces made of the cutter: whoever knows what parts are says which, before they come into a solid.
inline constexpr std::uint32_t kUnsetPart = ~0u;

/// What faces made of the cutter say of themselves.
struct NewSource {
    std::uint32_t edit = 0;
    std::uint32_t material = 0;
    std::uint32_t part = kUnsetPart;
};

/// Makes faces, one at a time; facets come in the order of the calls.
class FaceMaker {
public:
    /// @param in, crossings, loops  live as long as this
    FaceMaker(const CutInput& in, const Crossings& crossings, const NewLoops& loops, const NewSource& source);

    /// One of `loops`.
    void make(const NewFace& face);
    /// A face of the patch, as it is.
    void make_kept(std::uint32_t face);
    /// One of NewLoops::taken: into a set of its own, where parts are those that faces had.
    void make_taken(const NewFace& face);

    /// The facets made so far; ids are left open.
    const FaceSet& made() const { return made_.set; }
    /// Once: they are moved out.
    FaceSet take() { return std::move(made_.set); }
    const FaceSet& taken() const { return taken_.set; }
    FaceSet take_taken() { return std::move(taken_.set); }
    /// An edge by number, with the objects that faces made of it have.
    const Ref<const SolidEdge>& edge(std::uint32_t number);
    /// Whether that object runs against the edge as it is numbered.
    bool runs_against(std::uint32_t number, const SolidEdge& stored);

private:
    struct Target {
        FaceSet set;
        std::vector<std::uint32_t> corners;  ///< a vertex's place in set.vertices; ~0: none yet
    };

    /// What there is to make, wherever it comes from; `face` and `triangle` as in NewFace.
    struct Outline {
        Ref<const SolidPlane> plane;
        std::span<const PatchUse> uses;
        std::span<const std::uint32_t> ends;
        std::uint32_t face, triangle;
        std::uint32_t material = ~0u;  ///< as in NewFace
    };

    void make(const Outline& outline, Target& target);
    const Ref<const SolidVertex>& vertex(std::uint32_t number);
    std::uint32_t corner(std::uint32_t number, Target& target) const;
    void add_facets(const Outline& outline, const SolidFace& owner, Target& target);

    const SolidPatch& patch_;
    const NewLoops& loops_;
    const CutView view_;
    const NewSource source_;
    Target made_, taken_;
    std::vector<Ref<const SolidVertex>> vertices_;
    std::vector<Ref<const SolidEdge>> edges_;
    std::vector<GridPoint> points_;
    std::vector<Vec3> exact_;
    FacetMaker facet_maker_;
    Facets facets_;
    PlaneHashes hashes_;  ///< of planes that edges_ and made_ keep
};

}  // namespace firma
