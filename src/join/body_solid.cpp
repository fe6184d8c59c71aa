// SPDX-License-Identifier: MIT
// A convex body as a Solid: its polygons as for a brush, with shared vertices and edges.
#include "join/body_solid.h"

#include <map>
#include <utility>
#include <vector>

#include "join/brush_shape.h"
#include "join/join_facets.h"
#include "solid/append_faces.h"
#include "solid/face_store.h"
#include "solid/make_facets.h"
#include "solid/solid_data.h"

namespace firma {
namespace {

bool shape_of(ExactTables& tables, std::span<const Ref<const SolidPlane>> planes, BrushShape& shape) {
    std::vector<PlaneId> ids;
    for (const Ref<const SolidPlane>& plane : planes) ids.push_back(tables.planes.add(plane->plane));
    return make_brush_shape(tables, ids, shape) == BrushFault::kNone;
}

class BodyMaker {
public:
    BodyMaker(const ExactTables& tables, const BrushShape& shape) : tables_(tables), shape_(shape) {
        for (std::uint32_t f = 0; f < shape.faces.size(); ++f) {
            const ConvexPiece& piece = shape.faces[f].piece;
            for (std::size_t k = 0; k < piece.sides.size(); ++k)
                face_of_side_[{piece.corner(k), piece.corner(piece.next(k))}] = f;
        }
    }

    std::optional<Solid> make() {
        FaceSet set;
        for (std::uint32_t f = 0; f < shape_.faces.size(); ++f)
            if (!add_face(f, set)) return std::nullopt;
        return solid_of(build_store(set, {}).store, false, std::uint32_t(set.faces.size()), 0, {});
    }

private:
    const Ref<const SolidVertex>& vertex(std::uint32_t corner) {
        Ref<const SolidVertex>& made = vertices_[corner];
        if (made) return made;
        const ExactPoint& point = tables_.points.point(corner);
        Ref<const SolidPlane> planes[3];
        if (!point.on_grid())
            for (int k = 0; k < 3; ++k) planes[k] = tables_.planes.stored(tables_.points.plane(corner, k));
        return made = Ref<const SolidVertex>(new SolidVertex(point, planes));
    }

    /// Null where no other face is across it: then the planes do not close the body.
    Ref<const SolidEdge> edge(std::uint32_t a, std::uint32_t b) {
        Ref<const SolidEdge>& made = edges_[{std::min(a, b), std::max(a, b)}];
        if (made) return made;
        const auto one = face_of_side_.find({a, b}), other = face_of_side_.find({b, a});
        if (one == face_of_side_.end() || other == face_of_side_.end()) return {};
        Ref<SolidEdge> fresh(new SolidEdge);
        fresh->vertex[0] = vertex(std::min(a, b));
        fresh->vertex[1] = vertex(std::max(a, b));
        fresh->plane[0] = tables_.planes.stored(shape_.faces[one->second].piece.plane);
        fresh->plane[1] = tables_.planes.stored(shape_.faces[other->second].piece.plane);
        return made = Ref<const SolidEdge>(fresh.get());
    }

    bool add_face(std::uint32_t f, FaceSet& set) {
        const ConvexPiece& piece = shape_.faces[f].piece;
        const Plane& plane = tables_.planes.plane(piece.plane);
        std::vector<GridPoint> points;
        std::vector<Vec3> exact;
        Ref<SolidFace> made(new SolidFace);
        bool on_grid = true;
        for (std::size_t k = 0; k < piece.sides.size(); ++k) {
            const std::uint32_t a = piece.corner(k), b = piece.corner(piece.next(k));
            const ExactPoint& point = tables_.points.point(a);
            on_grid = on_grid && point.on_grid();
            points.push_back(point.rounded());
            exact.push_back(point.approximate());
            made->box.add(point.rounded());
            const Ref<const SolidEdge> used = edge(a, b);
            if (!used) return false;
            made->uses.emplace_back(used, b < a);
        }
        const auto end = std::uint32_t(points.size());
        if (!facet_maker_.make(points, {&end, 1}, plane.front_view(), facets_))
            facet_maker_.make_folded(points, exact, {&end, 1}, plane.front_view(), facets_);
        made->plane = tables_.planes.stored(piece.plane);
        made->set_loop_ends({&end, 1});
        made->normal = plane.unit_normal();
        made->facets = std::uint32_t(facets_.count());
        made->set_hash();
        FaceSet::Entry face;
        face.source = shape_.faces[f].side;
        face.solid = true;
        if (!on_grid || facets_.count() != 1) {
            face.owner = made.get();
            set.owners.emplace_back(made.get());
        }
        std::vector<GridPoint> corners;
        for (std::size_t k = 0; k < facets_.count(); ++k) {
            corners.clear();
            for (std::uint32_t c = facets_.first[k]; c < facets_.first[k + 1]; ++c)
                corners.push_back(points[facets_.corners[c]]);
            face.id = {std::uint32_t(set.faces.size())};
            add_facet(set, corners, face);
        }
        return true;
    }

    const ExactTables& tables_;
    const BrushShape& shape_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> face_of_side_;
    std::map<std::uint32_t, Ref<const SolidVertex>> vertices_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, Ref<const SolidEdge>> edges_;
    FacetMaker facet_maker_;
    Facets facets_;
};

}  // namespace

std::optional<Solid> solid_of_planes(std::span<const Ref<const SolidPlane>> planes) {
    ExactTables tables;
    BrushShape shape;
    if (!shape_of(tables, planes, shape)) return std::nullopt;
    return BodyMaker(tables, shape).make();
}

std::optional<GridBox> box_of_planes(std::span<const Ref<const SolidPlane>> planes) {
    ExactTables tables;
    BrushShape shape;
    if (!shape_of(tables, planes, shape)) return std::nullopt;
    return shape.box;
}

}  // namespace firma
