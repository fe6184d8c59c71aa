// SPDX-License-Identifier: MIT
// How the polygons of a joined level meet: sides divided where others begin, edges with the two faces that bound the
// same air, and which sides of polygons see each other around an edge.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/disjoint_sets.h"
#include "join/line_table.h"
#include "join/merge_pieces.h"

namespace firma {

/// Part of a line between neighbouring corners, and the two faces that bound one wedge of air there.
struct JoinEdge {
    std::uint32_t corner[2] = {0, 0};  ///< as the first face runs
    std::uint32_t face[2] = {0, 0};
    PlaneId planes[2] = {0, 0};  ///< that meet in it; one at least is not the faces'
    bool doubled = false;        ///< there are more between the same corners
};

/// One step of a polygon's outline.
struct JoinStep {
    std::uint32_t corner = 0;  ///< where it begins
    std::uint32_t edge = 0;    ///< of faces only
};

/// Faces come first, by their numbers; a portal's two sides follow: side of the front `faces + 2 k`, of the back one
/// more.
struct Arrangement {
    std::vector<JoinStep> steps;            ///< of all polygons in a row, portals after faces
    std::vector<std::uint32_t> first_step;  ///< a polygon each, and the end
    std::vector<JoinEdge> edges;
    DisjointSets seen_together{0};  ///< sides of polygons between which there is nothing but air, around some edge

    std::span<const JoinStep> outline(std::uint32_t polygon) const {
        return {steps.data() + first_step[polygon], first_step[polygon + 1] - first_step[polygon]};
    }
};

/// Where polygons do not bound a solid: an edge around which air and solid do not alternate.
struct OpenEdge {
    std::uint32_t corner[2] = {0, 0};
    std::vector<std::uint32_t> polygons;  ///< that meet there
};

/// @param faces    polygons that bound a solid, their fronts in the air; none overlap
/// @param portals  polygons in the air
/// @param open     what keeps the faces from bounding a solid: empty when they do
Arrangement arrange(const JoinTables& tables, std::span<const JoinPiece> faces, std::span<const ConvexPiece> portals,
                    std::vector<OpenEdge>& open);

}  // namespace firma
