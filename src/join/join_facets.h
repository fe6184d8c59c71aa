// SPDX-License-Identifier: MIT
// The facets that casts meet, made from the polygons of a joined level, and the exact faces behind them.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "join/arrangement.h"
#include "solid/face_set.h"
#include "solid/make_facets.h"

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

/// Puts a facet into a set: a face like `face`, with corners of its own.
void add_facet(FaceSet& set, std::span<const GridPoint> corners, FaceSet::Entry face);

/// Makes the exact faces of a joined solid: vertices, edges and planes are shared objects, each made once.
class JoinFaceMaker {
public:
    JoinFaceMaker(const ExactTables& tables, std::span<const JoinPiece> faces, const Arrangement& arrangement,
                  const JoinFacets& facets);

    /// The face's exact form; null where its one facet says it all.
    Ref<const SolidFace> make(std::uint32_t face);

private:
    bool is_own_facet(std::uint32_t face) const;
    const Ref<const SolidVertex>& vertex(std::uint32_t point);
    const Ref<const SolidEdge>& edge(std::uint32_t index);

    const ExactTables& tables_;
    const std::span<const JoinPiece> faces_;
    const Arrangement& arrangement_;
    const JoinFacets& facets_;
    std::vector<Ref<const SolidVertex>> vertices_;
    std::vector<Ref<const SolidEdge>> edges_;
};

}  // namespace firma
