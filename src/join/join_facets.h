// SPDX-License-Identifier: MIT
// The facets that casts meet, made from the polygons of a joined level, and the exact faces behind them.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/flat_map.h"
#include "join/arrangement.h"
#include "solid/face_set.h"
#include "solid/make_facets.h"
#include "solid/solid_face.h"

namespace firma {

/// Makes the facets of one polygon after the other. Keeps its scratch.
class PolygonFacets {
public:
    explicit PolygonFacets(const ExactTables& tables) : tables_(tables) {}

    /// @param corners  the polygon's outline
    /// @param facets   replaced by its facets
    /// @return false when the outline makes no sound facets, once it is rounded: then there are none
    bool make(PlaneId plane, std::span<const std::uint32_t> corners, std::vector<std::vector<GridPoint>>& facets);

private:
    const ExactTables& tables_;
    FacetMaker maker_;
    Facets made_;
    std::vector<GridPoint> points_;
};

/// Facets of polygons in a row: polygon p has facets first[p] .. first[p + 1].
struct JoinFacets {
    std::vector<std::vector<GridPoint>> corners;
    std::vector<std::uint32_t> first;
    std::vector<std::uint32_t>
        unsound;  ///< polygons whose rounded outline makes no sound facets, ascending; without any

    std::size_t count(std::uint32_t polygon) const { return first[polygon + 1] - first[polygon]; }
    /// Of the next polygon.
    void add(std::vector<std::vector<GridPoint>> facets) {
        for (std::vector<GridPoint>& facet : facets) corners.push_back(std::move(facet));
        first.push_back(std::uint32_t(corners.size()));
    }
};

/// @param planes       of each polygon of the arrangement
JoinFacets make_join_facets(const ExactTables& tables, std::span<const PlaneId> planes, const Arrangement& arrangement);

/// Makes the exact faces of a joined solid: vertices, edges and planes are shared objects, each made once.
class JoinFaceMaker {
public:
    JoinFaceMaker(const ExactTables& tables, std::span<const JoinPiece> faces, const Arrangement& arrangement,
                  const JoinFacets& facets);

    /// The face's exact form; null where its one facet says it all.
    Ref<const SolidFace> make(std::uint32_t face);
    /// Likewise of a portal's polygon, with the edges that faces have. Null also where no plane is known that holds one
    /// of its edges in the air.
    /// @param polygon  of the arrangement, behind the faces
    Ref<const SolidFace> make_portal(std::uint32_t polygon, PlaneId plane);

private:
    bool is_own_facet(std::uint32_t face) const;
    bool portal_is_its_facets(std::uint32_t polygon);
    Ref<const SolidFace> make(std::uint32_t polygon, PlaneId plane, std::span<const SolidUse> uses) const;
    void know_edges();
    SolidUse portal_side(std::uint32_t from, std::uint32_t to, PlaneId plane);
    PlaneId plane_through(std::uint32_t from, std::uint32_t to, PlaneId plane) const;
    const Ref<const SolidVertex>& vertex(std::uint32_t point);
    const Ref<const SolidEdge>& edge(std::uint32_t index);

    const ExactTables& tables_;
    const std::span<const JoinPiece> faces_;
    const Arrangement& arrangement_;
    const JoinFacets& facets_;
    std::vector<Ref<const SolidVertex>> vertices_;
    std::vector<Ref<const SolidEdge>> edges_;
    FlatMap edge_between_;      ///< of two corners: of the arrangement, of several one that is doubled
    FlatMap air_edge_between_;  ///< of two corners: in air_edges_
    std::vector<Ref<const SolidEdge>> air_edges_;  ///< of portals alone
    std::vector<SolidUse> uses_;
};

}  // namespace firma
