// SPDX-License-Identifier: MIT
// From new loops to faces that can be kept.
#include "carve/make_faces.h"

namespace firma {
FaceMaker::FaceMaker(const CutInput& in, const Crossings& crossings, const NewLoops& loops, const NewSource& source)
    : patch_(in.patch), loops_(loops), view_(in, crossings, loops), source_(source) {
    vertices_.resize(view_.vertex_count());
    made_.corners.assign(vertices_.size(), ~0u);
    edges_.resize(view_.edge_count());
}

const Ref<const SolidVertex>& FaceMaker::vertex(std::uint32_t number) {
    Ref<const SolidVertex>& made = vertices_[number];
    if (made) return made;
    if (number < view_.first_cutter_vertex()) {
        const PatchVertex& old = patch_.vertices[number];
        made = Ref<const SolidVertex>(old.stored ? old.stored : new SolidVertex(old.point, old.planes));
    } else if (number < view_.first_real()) {
        made = Ref<const SolidVertex>(new SolidVertex(view_.point(number).grid()));
    } else {
        const CutPoint& crossing = view_.crossing(number);
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
    if (number < view_.first_new_edge()) {
        if (patch_.edges[number].stored) return made = Ref<const SolidEdge>(patch_.edges[number].stored);
        const PatchEdge& old = patch_.edges[number];
        for (int k = 0; k < 2; ++k) {
            fresh->vertex[k] = vertex(old.vertex[k]);
            fresh->plane[k] = Ref<const SolidPlane>(old.plane[k]);
        }
        fresh->doubled = old.doubled;
    } else {
        const NewEdge& part = view_.new_edge(number);
        fresh->vertex[0] = vertex(part.from);
        fresh->vertex[1] = vertex(part.to);
        for (std::size_t k = 0; k < 2; ++k) fresh->plane[k] = Ref<const SolidPlane>(part.plane[k]);
        fresh->doubled = part.doubled;
    }
    return made = Ref<const SolidEdge>(fresh.get());
}

/// A stored edge of the grid may run the other way than the patch met it.
bool FaceMaker::runs_against(std::uint32_t number, const SolidEdge& stored) {
    if (number >= view_.first_new_edge()) return false;
    const ExactPoint& first = patch_.vertices[patch_.edges[number].vertex[0]].point;
    const ExactPoint& kept = stored.vertex[0]->point;
    return first.on_grid() && kept.on_grid() ? first.grid() != kept.grid() : first.rounded() != kept.rounded();
}

void FaceMaker::make(const NewFace& face) {
    make({face.plane, loops_.uses(face), loops_.ends(face), face.face, face.triangle, face.material}, made_);
}

void FaceMaker::make_taken(const NewFace& face) {
    if (taken_.corners.empty()) taken_.corners.assign(vertices_.size(), ~0u);
    make({face.plane, loops_.uses(face), loops_.ends(face), face.face, face.triangle, face.material}, taken_);
}

void FaceMaker::make_kept(std::uint32_t index) {
    const PatchFace& face = patch_.faces[index];
    make({Ref<const SolidPlane>(face.plane), patch_.uses(face), patch_.ends(face), index, ~0u}, made_);
}

void FaceMaker::make(const Outline& outline, Target& target) {
    const std::span<const PatchUse> uses = outline.uses;
    points_.clear();
    for (const PatchUse& use : uses) points_.push_back(view_.point(view_.from(use)).rounded());
    const Plane& plane = outline.plane->plane;
    if (!facet_maker_.make(points_, outline.ends, plane.front_view(), facets_)) {
        exact_.clear();
        for (const PatchUse& use : uses) exact_.push_back(view_.point(view_.from(use)).approximate());
        facet_maker_.make_folded(points_, exact_, outline.ends, plane.front_view(), facets_);
    }

    Ref<SolidFace> made(new SolidFace);
    made->plane = outline.plane;
    made->uses.reserve(uses.size());
    for (const PatchUse& use : uses) {
        const Ref<const SolidEdge>& stored = edge(use.edge);
        made->uses.emplace_back(stored, use.reversed != runs_against(use.edge, *stored));
    }
    made->set_loop_ends(outline.ends);
    made->normal = plane.unit_normal();
    for (const GridPoint& p : points_) made->box.add(p);
    made->facets = std::uint32_t(facets_.first.size()) - 1;
    made->set_hash(hashes_);
    add_facets(outline, *made, target);
}

std::uint32_t FaceMaker::corner(std::uint32_t number, Target& target) const {
    std::uint32_t& known = target.corners[number];
    if (known == ~0u) {
        known = std::uint32_t(target.set.vertices.size());
        target.set.vertices.push_back(view_.point(number).rounded());
    }
    return known;
}

void FaceMaker::add_facets(const Outline& outline, const SolidFace& owner, Target& target) {
    FaceSet::Entry like;
    if (outline.face != ~0u) {
        const FaceRecord& old = patch_.faces[outline.face].facet.record();
        like.source = old.source;
        like.edit = old.edit;
        like.material = old.material;
        like.mask = old.mask;
        like.two_sided = old.two_sided;
        like.part = patch_.faces[outline.face].facet.block->part;
    } else {
        like.source = outline.triangle;
        like.edit = source_.edit;
        like.material = outline.material != ~0u ? outline.material : source_.material;
        like.part = source_.part;
    }
    like.solid = true;
    like.owner = &owner;
    target.set.owners.emplace_back(&owner);
    for (std::size_t k = 0; k + 1 < facets_.first.size(); ++k) {
        like.first_corner = std::uint32_t(target.set.corners.size());
        like.corner_count = facets_.first[k + 1] - facets_.first[k];
        for (std::uint32_t c = facets_.first[k]; c < facets_.first[k + 1]; ++c)
            target.set.corners.push_back(corner(view_.from(outline.uses[facets_.corners[c]]), target));
        target.set.faces.push_back(like);
    }
}

}  // namespace firma
