// SPDX-License-Identifier: MIT
// The facets that casts meet, made from the polygons of a joined level, and the exact faces behind them.
#include "join/join_facets.h"

#include "geometry/polygon_shape.h"

namespace firma {

JoinFacets make_join_facets(const JoinTables& tables, std::span<const PlaneId> planes, const Arrangement& arrangement) {
    JoinFacets made;
    FacetMaker maker;
    Facets facets;
    std::vector<GridPoint> points;
    made.first.push_back(0);
    for (std::uint32_t p = 0; p < planes.size(); ++p) {
        points.clear();
        for (const JoinStep& step : arrangement.outline(p))
            points.push_back(tables.points.point(step.corner).rounded());
        const Plane& plane = tables.planes.plane(planes[p]);
        const int axis = plane.dominant_axis();
        const auto end = std::uint32_t(points.size());
        if (maker.make(points, {&end, 1}, axis, plane.normal[axis] < 0, facets)) {
            for (std::size_t k = 0; k < facets.count(); ++k) {
                std::vector<GridPoint>& corners = made.corners.emplace_back();
                for (std::uint32_t c = facets.first[k]; c < facets.first[k + 1]; ++c)
                    corners.push_back(points[facets.corners[c]]);
            }
        } else {
            made.unsound.push_back(p);
        }
        made.first.push_back(std::uint32_t(made.corners.size()));
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

JoinFaceMaker::JoinFaceMaker(const JoinTables& tables, std::span<const JoinPiece> faces, const Arrangement& arrangement,
                             const JoinFacets& facets)
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
    // Of two faces in one plane, the line has another plane.
    for (int k = 0; same_plane(faces_[edge.face[0]].piece.plane, faces_[edge.face[1]].piece.plane) && k < 2; ++k)
        if (!same_plane(edge.planes[k], faces_[edge.face[0]].piece.plane))
            fresh->plane[1] = tables_.planes.stored(edge.planes[k]);
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
    const Plane& plane = tables_.planes.plane(id);
    const Vec3 normal = plane.direction();
    made->normal = normal * (1 / length(normal));
    made->facets = std::uint32_t(facets_.count(face));
    made->set_hash();
    return Ref<const SolidFace>(made.get());
}

}  // namespace firma
