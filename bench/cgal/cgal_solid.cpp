// SPDX-License-Identifier: MIT
// Firma's exact solids as CGAL's meshes with exact coordinates.
#include "cgal/cgal_solid.h"

#include <CGAL/Constrained_triangulation_2.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Projection_traits_3.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <utility>

#include "carve/gather.h"
#include "solid/solid_data.h"

namespace firma::bench {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;
using Number = ExactKernel::FT;

struct Domain {
    bool known = false, inside = false;
};
using Traits = CGAL::Projection_traits_3<ExactKernel>;
using Vertices = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Traits>;
using Faces =
    CGAL::Triangulation_face_base_with_info_2<Domain, Traits, CGAL::Constrained_triangulation_face_base_2<Traits>>;
using Triangulation = CGAL::Constrained_triangulation_2<Traits, CGAL::Triangulation_data_structure_2<Vertices, Faces>,
                                                        CGAL::No_constraint_intersection_requiring_constructions_tag>;

/// From halves that a double holds.
Number exact(Int128 value) {
    const Number half(4294967296.0);
    Number sum(0);
    for (int k = 3; k >= 0; --k) {
        const auto part = k == 3 ? double(std::int32_t(value >> 96)) : double(std::uint32_t(value >> (32 * k)));
        sum = sum * half + Number(part);
    }
    return sum;
}

ExactKernel::Plane_3 exact(const Plane& plane) {
    return {exact(Int128(plane.normal[0])), exact(Int128(plane.normal[1])), exact(Int128(plane.normal[2])),
            exact(plane.offset())};
}

ExactKernel::Point_3 exact(const ExactPoint& point) {
    if (point.on_grid()) {
        const InputPoint at = point.grid();
        return {double(at.x), double(at.y), double(at.z)};
    }
    const auto meeting = CGAL::intersection(exact(*point.plane(0)), exact(*point.plane(1)), exact(*point.plane(2)));
    return boost::get<ExactKernel::Point_3>(*meeting);
}

/// Inside is what an odd number of loops lies around.
void find_domain(Triangulation& triangulation) {
    std::vector<std::pair<Triangulation::Face_handle, bool>> waiting{{triangulation.infinite_face(), false}};
    while (!waiting.empty()) {
        const auto [face, inside] = waiting.back();
        waiting.pop_back();
        if (face->info().known) continue;
        face->info() = {true, inside};
        for (int k = 0; k < 3; ++k) waiting.emplace_back(face->neighbor(k), inside != face->is_constrained(k));
    }
}

}  // namespace

CgalSolid::CgalSolid(const Solid& solid) {
    SolidPatch patch;
    patch.add(all_facets(solid.data().faces.root.get()));
    for (const PatchVertex& vertex : patch.vertices) points_.push_back(exact(vertex.point));
    for (const PatchFace& face : patch.faces) add_face(patch, face);
}

void CgalSolid::add_face(const SolidPatch& patch, const PatchFace& face) {
    Triangulation triangulation(Traits(exact(face.plane->plane).orthogonal_vector()));
    std::uint32_t first = 0;
    const auto corner = [&](std::uint32_t k) { return patch.from(patch.uses(face)[k]); };
    for (const std::uint32_t end : patch.ends(face)) {
        std::vector<Triangulation::Vertex_handle> loop;
        for (std::uint32_t k = first; k < end; ++k) {
            loop.push_back(triangulation.insert(points_[corner(k)]));
            loop.back()->info() = corner(k);
        }
        for (std::size_t k = 0; k < loop.size(); ++k)
            triangulation.insert_constraint(loop[k], loop[k + 1 < loop.size() ? k + 1 : 0]);
        first = end;
    }
    find_domain(triangulation);
    const ExactKernel::Vector_3 out = exact(face.plane->plane).orthogonal_vector();
    for (const auto& it : triangulation.finite_face_handles()) {
        if (!it->info().inside) continue;
        std::vector<std::size_t> corners{it->vertex(0)->info(), it->vertex(1)->info(), it->vertex(2)->info()};
        const auto &a = points_[corners[0]], &b = points_[corners[1]], &c = points_[corners[2]];
        if (CGAL::cross_product(b - a, c - a) * out < 0) std::swap(corners[1], corners[2]);
        triangles_.push_back(std::move(corners));
    }
}

std::optional<ExactMesh> CgalSolid::mesh() const {
    if (!pmp::is_polygon_soup_a_polygon_mesh(triangles_)) return std::nullopt;
    ExactMesh mesh;
    pmp::polygon_soup_to_polygon_mesh(points_, triangles_, mesh);
    return mesh;
}

}  // namespace firma::bench
