// SPDX-License-Identifier: MIT
// The exact form of a polygon that is its own exact face.
#include "solid/own_face.h"

namespace firma {

Ref<const SolidPlane> plane_of_corners(std::span<const GridPoint> corners) {
    Plane plane;
    for (std::size_t k = 2; k < corners.size() && !plane.valid(); ++k)  // the first ones may lie on a line
        plane = plane_through(to_input(corners[0]), to_input(corners[k - 1]), to_input(corners[k]));
    return Ref<const SolidPlane>(new SolidPlane(plane));
}

SolidUse side_between(const InputPoint& from, const InputPoint& to, const Ref<const SolidPlane>& plane) {
    Ref<SolidEdge> edge(new SolidEdge);
    edge->vertex[0] = Ref<const SolidVertex>(new SolidVertex(from));
    edge->vertex[1] = Ref<const SolidVertex>(new SolidVertex(to));
    edge->plane[0] = plane;
    edge->plane[1] = Ref<const SolidPlane>(new SolidPlane(edge_plane(from, to, plane->plane)));
    return SolidUse(Ref<const SolidEdge>(edge.get()), false);
}

Ref<const SolidFace> face_of_corners(std::span<const GridPoint> corners) {
    Ref<SolidFace> face(new SolidFace);
    face->plane = plane_of_corners(corners);
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const GridPoint& next = corners[k + 1 < corners.size() ? k + 1 : 0];
        face->uses.push_back(side_between(to_input(corners[k]), to_input(next), face->plane));
        face->box.add(corners[k]);
    }
    const auto end = std::uint32_t(corners.size());
    face->set_loop_ends({&end, 1});
    face->normal = face->plane->plane.unit_normal();
    face->set_hash();
    return Ref<const SolidFace>(face.get());
}

}  // namespace firma
