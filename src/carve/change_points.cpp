// SPDX-License-Identifier: MIT
// What a cut does to the hash of the solid's points.
#include "carve/change_points.h"

#include "solid/hash_points.h"

namespace firma {

SumsByKey change_of_points(const Cut& cut) {
    const SolidPatch& patch = *cut.patch;
    PointHash hash;
    // By edge and direction: pieces of a face lie in its plane, so what they keep of its rim cancels.
    std::vector<bool> kept(2 * patch.edges.size(), false);
    for (std::size_t k = 0; k < cut.first_kept; ++k) {
        const NewFace& face = cut.new_faces[k];
        hash.start_face(face.plane->plane, 1);
        for (std::uint32_t u = face.first_use; u < face.first_use + face.use_count; ++u) {
            const PatchUse& use = cut.uses[u];
            if (use.edge < cut.first_new_edge()) {
                kept[2 * use.edge + use.reversed] = true;
                continue;
            }
            const NewEdge& edge = cut.new_edges[use.edge - cut.first_new_edge()];
            hash.add_edge(cut.point(cut.from(use)).rounded(), cut.point(cut.to(use)).rounded(),
                          LineDirection::of(edge.plane[0]->plane, edge.plane[1]->plane));
        }
    }
    for (const std::uint32_t at : cut.gone) {
        const PatchFace& face = patch.faces[at];
        if (face.replaced) continue;  // only divided: its pieces count
        hash.start_face(face.plane->plane, -1);
        for (const PatchUse& use : patch.uses(face))
            if (!kept[2 * use.edge + use.reversed])
                hash.add_edge(patch.vertices[patch.from(use)].point.rounded(),
                              patch.vertices[patch.to(use)].point.rounded(), patch.direction_of(use.edge));
    }
    return hash.finish();
}

}  // namespace firma
