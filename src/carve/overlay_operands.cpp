// SPDX-License-Identifier: MIT
// Puts the two solids of a cut into an overlay.
#include "carve/overlay_operands.h"

namespace firma {
namespace {

constexpr std::uint32_t kNotAdded = ~0u;

}  // namespace

PatchAdder::PatchAdder(const SolidPatch& patch, std::uint8_t operand, Overlay& overlay)
    : patch_(patch),
      operand_(operand),
      overlay_(overlay),
      point_of_(patch.vertices.size(), kNotAdded),
      edge_of_(patch.edges.size(), kNotAdded) {}

bool PatchAdder::add(WorkSlice& slice) {
    return go_on(next_, patch_.faces.size(), slice, [&](std::uint32_t index) {
        const PatchFace& face = patch_.faces[index];
        if (face.replaced) return;
        slice.take(face.use_count);
        sides_.clear();
        for (const PatchUse& use : patch_.uses(face)) sides_.push_back({edge(use.edge), use.reversed});
        overlay_.add_face(overlay_.tables.planes.add(face.plane->plane), operand_, sides_, patch_.ends(face));
        faces_.push_back(index);
    });
}

std::uint32_t PatchAdder::point(std::uint32_t vertex) {
    std::uint32_t& known = point_of_[vertex];
    if (known != kNotAdded) return known;
    const ExactPoint& point = patch_.vertices[vertex].point;
    if (point.on_grid()) return known = overlay_.tables.points.add(point.grid());
    PlaneId planes[3];
    for (int k = 0; k < 3; ++k) planes[k] = overlay_.tables.planes.add(*point.plane(k));
    return known = overlay_.tables.points.add(planes[0], planes[1], planes[2]);
}

std::uint32_t PatchAdder::edge(std::uint32_t index) {
    std::uint32_t& known = edge_of_[index];
    if (known != kNotAdded) return known;
    const PatchEdge& edge = patch_.edges[index];
    OverlayEdge made;
    made.from = point(edge.vertex[0]);
    made.to = point(edge.vertex[1]);
    for (int k = 0; k < 2; ++k) made.plane[k] = overlay_.tables.planes.add(edge.plane[k]->plane);
    made.doubled = edge.doubled;
    edges_.push_back(index);
    return known = overlay_.add_edge(made);
}

MeshAdder::MeshAdder(const CutterSolid& cutter, std::uint8_t operand, Overlay& overlay)
    : cutter_(cutter),
      operand_(operand),
      overlay_(overlay),
      edge_of_(cutter.edges.size(), kNotAdded),
      face_of_(cutter.planes.size(), kNotAdded),
      seen_(3 * cutter.planes.size(), 0) {}

bool MeshAdder::add(WorkSlice& slice) {
    const std::size_t count = cutter_.planes.size();
    switch (stage_) {
        case Stage::kPlanes:
            if (!go_on(next_, count, slice, [&](std::uint32_t t) {
                    planes_.push_back(overlay_.tables.planes.add(cutter_.planes[t]->plane));
                }))
                return false;
            stage_ = Stage::kPoints;
            [[fallthrough]];
        case Stage::kPoints:
            if (!go_on(next_, cutter_.points.size(), slice, [&](std::uint32_t v) {
                    point_of_.push_back(overlay_.tables.points.add(cutter_.placed.vertices[v]));
                }))
                return false;
            stage_ = Stage::kRims;
            [[fallthrough]];
        case Stage::kRims:
            if (!go_on(next_, cutter_.edges.size(), slice, [&](std::uint32_t edge) {
                    if (is_rim(edge)) add_rim(edge);
                }))
                return false;
            stage_ = Stage::kFaces;
            [[fallthrough]];
        case Stage::kFaces:
            break;
    }
    return go_on(next_, count, slice, [&](std::uint32_t polygon) {
        slice.take(4 * cutter_.polygons.count(polygon));
        if (cutter_.polygons.of(polygon) == polygon) add_face(polygon);
    });
}

void MeshAdder::add_rim(std::uint32_t edge) {
    const CutterSolid::Edge& it = cutter_.edges[edge];
    OverlayEdge made{point_of_[it.a], point_of_[it.b], {planes_[it.left], planes_[it.right]}};
    if (it.flat) made.plane[1] = overlay_.tables.planes.add(it.plane[1]->plane);
    edge_of_[edge] = overlay_.add_edge(made);
    ++edge_count_;
}

/// The loop of rims that a triangle's side is part of.
void MeshAdder::walk_rim(std::uint32_t triangle, std::uint32_t side) {
    loop_.clear();
    corners_.clear();
    for (std::uint32_t t = triangle, at = side; !seen_[3 * t + at];) {
        seen_[3 * t + at] = 1;
        const std::uint32_t edge = cutter_.edge_of(t, int(at));
        loop_.push_back({edge_of_[edge], cutter_.edges[edge].left != t});
        corners_.push_back(project(cutter_.points[cutter_.triangle(t)[at]].rounded(), view_));
        // Around the corner at its end, through triangles of the same face.
        at = (at + 1) % 3;
        for (std::uint32_t next = cutter_.edge_of(t, int(at)); !is_rim(next); next = cutter_.edge_of(t, int(at))) {
            t = cutter_.edges[next].left == t ? cutter_.edges[next].right : cutter_.edges[next].left;
            at = 0;
            while (cutter_.edge_of(t, int(at)) != next) ++at;
            at = (at + 1) % 3;
        }
    }
}

void MeshAdder::add_face(std::uint32_t polygon) {
    sides_.clear();
    holes_.clear();
    hole_ends_.clear();
    view_ = cutter_.planes[polygon]->plane.front_view();
    cutter_.polygons.for_each(polygon, [&](std::uint32_t t) {
        for (std::uint32_t k = 0; k < 3; ++k) {
            if (seen_[3 * t + k] || !is_rim(cutter_.edge_of(t, int(k)))) continue;
            walk_rim(t, k);
            if (sides_.empty() && twice_area(corners_) > 0) {
                sides_ = loop_;
            } else {
                holes_.insert(holes_.end(), loop_.begin(), loop_.end());
                hole_ends_.push_back(std::uint32_t(holes_.size()));
            }
        }
    });
    ends_.assign(1, std::uint32_t(sides_.size()));
    for (const std::uint32_t end : hole_ends_) ends_.push_back(std::uint32_t(sides_.size()) + end);
    sides_.insert(sides_.end(), holes_.begin(), holes_.end());
    const std::uint32_t face = overlay_.add_face(planes_[polygon], operand_, sides_, ends_);
    triangles_.push_back(polygon);
    cutter_.polygons.for_each(polygon, [&](std::uint32_t t) { face_of_[t] = face; });
}

}  // namespace firma
