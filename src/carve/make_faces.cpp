// SPDX-License-Identifier: MIT
// From new loops to faces that can be kept.
#include "carve/make_faces.h"

namespace firma {
namespace {

Vec3 unit_normal(const Plane& plane) {
    const Vec3 n = plane.direction();
    return n * (1 / length(n));
}

}  // namespace

FaceMaker::FaceMaker(Cut& cut, const NewSource& source, FaceSet& come) : cut_(cut), source_(source), come_(come) {
    vertices_.resize(cut.first_real() + cut.real.size());
    corners_.assign(vertices_.size(), ~0u);
    edges_.resize(cut.first_new_edge() + cut.new_edges.size());
}

const Ref<const SolidVertex>& FaceMaker::vertex(std::uint32_t number) {
    Ref<const SolidVertex>& made = vertices_[number];
    if (made) return made;
    if (number < cut_.first_cutter_vertex()) {
        const PatchVertex& old = cut_.patch->vertices[number];
        made = Ref<const SolidVertex>(old.stored ? old.stored : new SolidVertex(old.point, old.planes));
    } else if (number < cut_.first_real()) {
        made = Ref<const SolidVertex>(new SolidVertex(cut_.point(number).grid()));
    } else {
        const CutPoint& crossing = cut_.crossings[cut_.real[number - cut_.first_real()]];
        Ref<const SolidPlane> planes[3];
        for (std::size_t k = 0; k < 3; ++k) planes[k] = Ref<const SolidPlane>(crossing.planes[k]);
        made = Ref<const SolidVertex>(new SolidVertex(crossing.point, planes));
    }
    return made;
}

const Ref<const SolidEdge>& FaceMaker::edge(std::uint32_t number) {
    Ref<const SolidEdge>& made = edges_[number];
    if (made) return made;
    Ref<SolidEdge> fresh(new SolidEdge);
    if (number < cut_.first_new_edge()) {
        if (cut_.patch->edges[number].stored) return made = Ref<const SolidEdge>(cut_.patch->edges[number].stored);
        cut_.patch->settle_planes(number);
        const PatchEdge& old = cut_.patch->edges[number];
        for (int k = 0; k < 2; ++k) {
            fresh->vertex[k] = vertex(old.vertex[k]);
            fresh->plane[k] = Ref<const SolidPlane>(old.plane[k]);
        }
        fresh->doubled = old.doubled;
    } else {
        const NewEdge& part = cut_.new_edges[number - cut_.first_new_edge()];
        fresh->vertex[0] = vertex(part.from);
        fresh->vertex[1] = vertex(part.to);
        for (std::size_t k = 0; k < 2; ++k) fresh->plane[k] = Ref<const SolidPlane>(part.plane[k]);
    }
    return made = Ref<const SolidEdge>(fresh.get());
}

/// A stored edge of the grid may run the other way than the patch met it.
bool FaceMaker::runs_against(std::uint32_t number, const SolidEdge& stored) {
    if (number >= cut_.first_new_edge()) return false;
    const ExactPoint& first = cut_.patch->vertices[cut_.patch->edges[number].vertex[0]].point;
    const ExactPoint& kept = stored.vertex[0]->point;
    return first.on_grid() && kept.on_grid() ? first.grid() != kept.grid() : first.rounded() != kept.rounded();
}

bool FaceMaker::make(std::uint32_t index) {
    const NewFace& face = cut_.new_faces[index];
    const std::span<const PatchUse> uses(cut_.uses.data() + face.first_use, face.use_count);
    const std::span<const std::uint32_t> ends(cut_.loop_ends.data() + face.first_loop, face.loop_count);
    points_.clear();
    for (const PatchUse& use : uses) points_.push_back(cut_.point(cut_.from(use)).rounded());
    const Plane& plane = face.plane->plane;
    const int axis = plane.dominant_axis();
    if (!facet_maker_.make(points_, ends, axis, plane.normal[axis] < 0, facets_)) {
        cut_.face_touches(uses);
        return false;
    }

    Ref<SolidFace> made(new SolidFace);
    made->plane = face.plane;
    made->uses.reserve(uses.size());
    for (const PatchUse& use : uses) {
        const Ref<const SolidEdge>& stored = edge(use.edge);
        made->uses.emplace_back(stored, use.reversed != runs_against(use.edge, *stored));
    }
    made->set_loop_ends(ends);
    made->normal = unit_normal(plane);
    for (const GridPoint& p : points_) made->box.add(p);
    made->facets = std::uint32_t(facets_.first.size()) - 1;
    made->set_hash();
    add_facets(face, *made);
    return true;
}

std::uint32_t FaceMaker::corner(std::uint32_t number) {
    std::uint32_t& known = corners_[number];
    if (known == ~0u) {
        known = std::uint32_t(come_.vertices.size());
        come_.vertices.push_back(cut_.point(number).rounded());
    }
    return known;
}

void FaceMaker::add_facets(const NewFace& face, const SolidFace& owner) {
    FaceSet::Entry like;
    if (face.face != ~0u) {
        const FaceRecord& old = cut_.patch->faces[face.face].facet.record();
        like.source = old.source;
        like.edit = old.edit;
        like.material = old.material;
        like.mask = old.mask;
        like.two_sided = old.two_sided;
        like.part = cut_.patch->faces[face.face].facet.block->part;
    } else {
        like.source = face.triangle;
        like.edit = source_.edit;
        like.material = source_.material;
        like.part = source_.part;
    }
    like.solid = true;
    like.owner = &owner;
    come_.owners.emplace_back(&owner);
    for (std::size_t k = 0; k + 1 < facets_.first.size(); ++k) {
        like.first_corner = std::uint32_t(come_.corners.size());
        like.corner_count = facets_.first[k + 1] - facets_.first[k];
        for (std::uint32_t c = facets_.first[k]; c < facets_.first[k + 1]; ++c)
            come_.corners.push_back(corner(cut_.from(cut_.uses[face.first_use + facets_.corners[c]])));
        come_.faces.push_back(like);
    }
}

}  // namespace firma
