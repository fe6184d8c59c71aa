// SPDX-License-Identifier: MIT
// The facets that casts meet, made from the polygons of a joined level, and the exact faces behind them.
#include "join/join_facets.h"

#include "geometry/polygon_shape.h"

namespace firma {

bool PolygonFacets::make(PlaneId plane, std::span<const std::uint32_t> corners,
                         std::vector<std::vector<GridPoint>>& facets) {
    facets.clear();
    points_.clear();
    for (const std::uint32_t corner : corners) points_.push_back(tables_.points.point(corner).rounded());
    const auto end = std::uint32_t(points_.size());
    if (!maker_.make(points_, {&end, 1}, tables_.planes.plane(plane).front_view(), made_)) return false;
    for (std::size_t k = 0; k < made_.count(); ++k) {
        std::vector<GridPoint>& facet = facets.emplace_back();
        for (std::uint32_t c = made_.first[k]; c < made_.first[k + 1]; ++c) facet.push_back(points_[made_.corners[c]]);
    }
    return true;
}

JoinFacets make_join_facets(const ExactTables& tables, std::span<const PlaneId> planes,
                            const Arrangement& arrangement) {
    JoinFacets made;
    PolygonFacets maker(tables);
    std::vector<std::uint32_t> corners;
    std::vector<std::vector<GridPoint>> facets;
    made.first.push_back(0);
    for (std::uint32_t p = 0; p < planes.size(); ++p) {
        corners.clear();
        for (const JoinStep& step : arrangement.outline(p)) corners.push_back(step.corner);
        if (!maker.make(planes[p], corners, facets)) made.unsound.push_back(p);
        made.add(std::move(facets));
    }
    return made;
}

void add_facet(FaceSet& set, std::span<const GridPoint> corners, FaceSet::Entry face) {
    face.first_corner = std::uint32_t(set.corners.size());
    face.corner_count = std::uint32_t(corners.size());
    for (const GridPoint& corner : corners) {
        set.corners.push_back(std::uint32_t(set.vertices.size()));
        set.vertices.push_back(corner);
    }
    set.faces.push_back(face);
}

JoinFaceMaker::JoinFaceMaker(const ExactTables& tables, std::span<const JoinPiece> faces,
                             const Arrangement& arrangement, const JoinFacets& facets)
    : tables_(tables), faces_(faces), arrangement_(arrangement), facets_(facets) {
    vertices_.resize(tables.points.size());
    edges_.resize(arrangement.edges.size());
}

bool JoinFaceMaker::is_own_facet(std::uint32_t face) const {
    if (facets_.count(face) != 1) return false;
    for (const JoinStep& step : arrangement_.outline(face))
        if (!tables_.points.point(step.corner).on_grid() || arrangement_.edges[step.edge].doubled) return false;
    return true;
}

const Ref<const SolidVertex>& JoinFaceMaker::vertex(std::uint32_t index) {
    Ref<const SolidVertex>& made = vertices_[index];
    if (made) return made;
    const ExactPoint& point = tables_.points.point(index);
    Ref<const SolidPlane> planes[3];
    if (!point.on_grid())
        for (int k = 0; k < 3; ++k) planes[k] = tables_.planes.stored(tables_.points.plane(index, k));
    return made = Ref<const SolidVertex>(new SolidVertex(point, planes));
}

const Ref<const SolidEdge>& JoinFaceMaker::edge(std::uint32_t index) {
    Ref<const SolidEdge>& made = edges_[index];
    if (made) return made;
    const JoinEdge& edge = arrangement_.edges[index];
    Ref<SolidEdge> fresh(new SolidEdge);
    for (int k = 0; k < 2; ++k) {
        fresh->vertex[k] = vertex(edge.corner[k]);
        fresh->plane[k] = tables_.planes.stored(faces_[edge.face[k]].piece.plane);
    }
    // Of two faces in one plane, the edge has another plane.
    if (same_plane(faces_[edge.face[0]].piece.plane, faces_[edge.face[1]].piece.plane))
        fresh->plane[1] = tables_.planes.stored(edge.across & ~1u);
    fresh->doubled = edge.doubled;
    return made = Ref<const SolidEdge>(fresh.get());
}

Ref<const SolidFace> JoinFaceMaker::make(std::uint32_t face) {
    if (is_own_facet(face)) return {};
    Ref<SolidFace> made(new SolidFace);
    const PlaneId id = faces_[face].piece.plane;
    made->plane = tables_.planes.stored(id);
    for (const JoinStep& step : arrangement_.outline(face)) {
        made->uses.emplace_back(edge(step.edge), step.corner != arrangement_.edges[step.edge].corner[0]);
        made->box.add(tables_.points.point(step.corner).rounded());
    }
    const auto end = std::uint32_t(made->uses.size());
    made->set_loop_ends({&end, 1});
    made->normal = tables_.planes.plane(id).unit_normal();
    made->facets = std::uint32_t(facets_.count(face));
    made->set_hash();
    return Ref<const SolidFace>(made.get());
}

}  // namespace firma
