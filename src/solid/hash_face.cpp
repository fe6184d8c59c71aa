// SPDX-License-Identifier: MIT
// What a face adds to the hash of a solid's points.
#include "solid/hash_face.h"

namespace firma {

void add_face(const SolidFace& face, int sign, PointHash& hash) {
    hash.start_face(face.plane->plane, sign);
    for (const SolidUse& use : face.uses) {
        const SolidEdge& edge = use.edge();
        const ExactPoint &from = edge.vertex[use.reversed()]->point, &to = edge.vertex[!use.reversed()]->point;
        hash.add_edge(from.rounded(), to.rounded(),
                      from.on_grid() && to.on_grid() ? LineDirection::along(from.rounded(), to.rounded())
                                                     : LineDirection::of(edge.plane[0]->plane, edge.plane[1]->plane));
    }
}

/// Of a face that no cut has touched, its corners say it all.
void add_face(const Block& block, const FaceRecord& face, int sign, PointHash& hash) {
    if (const FaceOwner* owner = block.owner_of(face))
        return add_face(static_cast<const SolidFace&>(*owner), sign, hash);
    Plane plane;
    for (std::size_t k = 2; k < face.corner_count && !plane.valid(); ++k)  // the first ones may lie on a line
        plane = plane_through(to_input(block.corner(face, 0)), to_input(block.corner(face, k - 1)),
                              to_input(block.corner(face, k)));
    hash.start_face(plane, sign);
    for (std::size_t k = 0; k < face.corner_count; ++k) {
        const GridPoint from = block.corner(face, k);
        const GridPoint to = block.corner(face, k + 1u < face.corner_count ? k + 1 : 0);
        hash.add_edge(from, to, LineDirection::along(from, to));
    }
}

}  // namespace firma
