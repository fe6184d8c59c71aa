// SPDX-License-Identifier: MIT
// From new loops to faces that can be kept: shared vertices and edges, and facets for casts to meet.
#pragma once

#include "carve/cut_state.h"
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

/// Makes the new faces of a cut, one at a time, in their order.
class FaceMaker {
public:
    /// @param come  the facets, added to; ids are left open
    FaceMaker(Cut& cut, const NewSource& source, FaceSet& come);

    /// @return false when the face's rounded corners do not make sound facets: degenerate position, and what the cutter
    ///         has to do with the face is added to Cut::touching
    bool make(std::uint32_t new_face);

private:
    const Ref<const SolidVertex>& vertex(std::uint32_t number);
    const Ref<const SolidEdge>& edge(std::uint32_t number);
    bool runs_against(std::uint32_t number, const SolidEdge& stored);
    std::uint32_t corner(std::uint32_t number);
    void add_facets(const NewFace& face, const SolidFace& owner);

    Cut& cut_;
    const NewSource source_;
    FaceSet& come_;
    std::vector<Ref<const SolidVertex>> vertices_;
    std::vector<Ref<const SolidEdge>> edges_;
    std::vector<std::uint32_t> corners_;  ///< a vertex's place in come_.vertices; ~0: none yet
    std::vector<GridPoint> points_;
    FacetMaker facet_maker_;
    Facets facets_;
};

}  // namespace firma
