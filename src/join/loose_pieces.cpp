// SPDX-License-Identifier: MIT
// What casts meet and no solid is bounded by.
#include "join/loose_pieces.h"

#include "join/arrangement.h"
#include "join/join_facets.h"

namespace firma {

std::vector<LooseFacet> make_loose_facets(const ExactTables& tables, const std::vector<JoinPiece>& pieces) {
    std::vector<OpenEdge> open;  // most edges are: these pieces bound nothing
    const Arrangement arrangement = arrange(tables, pieces, {}, open);
    std::vector<PlaneId> planes;
    for (const JoinPiece& piece : pieces) planes.push_back(piece.piece.plane);
    JoinFacets facets = make_join_facets(tables, planes, arrangement);
    std::vector<LooseFacet> made;
    for (std::uint32_t p = 0; p < pieces.size(); ++p)
        for (std::uint32_t k = facets.first[p]; k < facets.first[p + 1]; ++k) {
            LooseFacet facet;
            facet.corners = std::move(facets.corners[k]);
            facet.source = pieces[p].source;
            facet.material = pieces[p].material;
            facet.mask = pieces[p].mask;
            made.push_back(std::move(facet));
        }
    return made;
}

ConvexPiece piece_of_corners(ExactTables& tables, const std::vector<InputPoint>& corners) {
    const std::size_t count = corners.size();
    Plane plane;
    for (std::size_t k = 2; k < count && !plane.valid(); ++k)
        plane = plane_through(corners[0], corners[k - 1], corners[k]);
    ConvexPiece piece;
    piece.plane = tables.planes.add(plane);
    std::vector<PlaneId> around;
    for (std::size_t k = 0; k < count; ++k) {
        const Plane side = edge_plane(corners[k], corners[(k + 1) % count], plane);
        int at = 0;
        for (std::size_t c = 0; c < count && at == 0; ++c) at = exact_side(side, ExactPoint(corners[c]));
        const PlaneId id = tables.planes.add(at > 0 ? flipped(side) : side);
        if (around.empty() || around.back() != id) around.push_back(id);  // corners along a side are none
    }
    while (around.size() > 1 && around.front() == around.back()) around.pop_back();
    for (std::size_t k = 0; k < around.size(); ++k) {
        const PlaneId before = around[k > 0 ? k - 1 : around.size() - 1];
        piece.sides.push_back({tables.points.add(piece.plane, before, around[k]), around[k]});
    }
    return piece;
}

}  // namespace firma
