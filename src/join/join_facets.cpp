// SPDX-License-Identifier: MIT
// The facets that casts meet, made from the polygons of a joined level, and the exact faces behind them.
#include "join/join_facets.h"

#include <algorithm>

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
    uses_.clear();
    for (const JoinStep& step : arrangement_.outline(face))
        uses_.emplace_back(edge(step.edge), step.corner != arrangement_.edges[step.edge].corner[0]);
    return make(face, faces_[face].piece.plane, uses_);
}

Ref<const SolidFace> JoinFaceMaker::make(std::uint32_t polygon, PlaneId plane, std::span<const SolidUse> uses) const {
    Ref<SolidFace> made(new SolidFace);
    made->plane = tables_.planes.stored(plane);
    for (const SolidUse& use : uses) {
        made->uses.push_back(use);
        made->box.add(use.from().point.rounded());
    }
    const auto end = std::uint32_t(uses.size());
    made->set_loop_ends({&end, 1});
    made->normal = tables_.planes.plane(plane).unit_normal();
    made->facets = std::uint32_t(facets_.count(polygon));
    made->set_hash();
    return Ref<const SolidFace>(made.get());
}

namespace {

std::uint64_t corner_pair(std::uint32_t a, std::uint32_t b) {
    return std::uint64_t(std::min(a, b)) << 32 | std::max(a, b);
}

}  // namespace

void JoinFaceMaker::know_edges() {
    if (edge_between_.size() > 0) return;
    for (std::uint32_t k = 0; k < arrangement_.edges.size(); ++k) {
        const JoinEdge& edge = arrangement_.edges[k];
        std::uint32_t& known = edge_between_.at(corner_pair(edge.corner[0], edge.corner[1]));
        if (known == FlatMap::kNone) known = k;
    }
}

bool JoinFaceMaker::portal_is_its_facets(std::uint32_t polygon) {
    const auto outline = arrangement_.outline(polygon);
    for (std::size_t k = 0; k < outline.size(); ++k) {
        if (!tables_.points.point(outline[k].corner).on_grid()) return false;
        const std::uint32_t next = outline[k + 1 < outline.size() ? k + 1 : 0].corner;
        const std::uint32_t edge = edge_between_.find(corner_pair(outline[k].corner, next));
        if (edge != FlatMap::kNone && arrangement_.edges[edge].doubled) return false;
    }
    return true;
}

Ref<const SolidFace> JoinFaceMaker::make_portal(std::uint32_t polygon, PlaneId plane) {
    know_edges();
    if (portal_is_its_facets(polygon)) return {};
    const auto outline = arrangement_.outline(polygon);
    uses_.clear();
    for (std::size_t k = 0; k < outline.size(); ++k) {
        SolidUse side = portal_side(outline[k].corner, outline[k + 1 < outline.size() ? k + 1 : 0].corner, plane);
        if (!side.address()) return {};
        uses_.push_back(std::move(side));
    }
    return make(polygon, plane, uses_);
}

SolidUse JoinFaceMaker::portal_side(std::uint32_t from, std::uint32_t to, PlaneId plane) {
    const std::uint64_t pair = corner_pair(from, to);
    if (const std::uint32_t known = edge_between_.find(pair); known != FlatMap::kNone)
        return SolidUse(edge(known), arrangement_.edges[known].corner[0] != from);
    std::uint32_t& known = air_edge_between_.at(pair);
    if (known == FlatMap::kNone) {
        Ref<SolidEdge> made(new SolidEdge);
        made->vertex[0] = vertex(std::min(from, to));
        made->vertex[1] = vertex(std::max(from, to));
        made->plane[0] = tables_.planes.stored(plane);
        const ExactPoint &a = made->vertex[0]->point, &b = made->vertex[1]->point;
        if (a.on_grid() && b.on_grid()) {
            made->plane[1] =
                Ref<const SolidPlane>(new SolidPlane(edge_plane(a.grid(), b.grid(), tables_.planes.plane(plane))));
        } else {
            const PlaneId other = plane_through(from, to, plane);
            if (other == kNoPlane) return {};
            made->plane[1] = tables_.planes.stored(other);
        }
        known = std::uint32_t(air_edges_.size());
        air_edges_.emplace_back(made.get());
    }
    return SolidUse(air_edges_[known], from > to);
}

/// Another plane that holds two corners, of those that meet in one of them.
PlaneId JoinFaceMaker::plane_through(std::uint32_t from, std::uint32_t to, PlaneId plane) const {
    for (const auto& [corner, other] : {std::pair(from, to), {to, from}}) {
        if (tables_.points.point(corner).on_grid()) continue;
        for (int k = 0; k < 3; ++k) {
            const PlaneId found = tables_.points.plane(corner, k);
            const Plane& it = tables_.planes.plane(found);
            if (!exact_parallel(it, tables_.planes.plane(plane)) && exact_side(it, tables_.points.point(other)) == 0)
                return found;
        }
    }
    return kNoPlane;
}

}  // namespace firma
