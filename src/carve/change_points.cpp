// SPDX-License-Identifier: MIT
// What a cut does to the hash of the solid's points.
#include "carve/change_points.h"

#include "solid/hash_points.h"

namespace firma {

SumsByKey change_of_points(const CutView& view, const NewLoops& loops) {
    const SolidPatch& patch = view.patch();
    PointHash hash;
    // By edge and direction: pieces of a face lie in its plane, so what they keep of its rim cancels.
    std::vector<bool> kept(2 * patch.edges.size(), false);
    for (const NewFace& face : loops.faces) {
        hash.start_face(face.plane->plane, 1);
        for (const PatchUse& use : loops.uses(face)) {
            if (use.edge < view.first_new_edge()) {
                kept[2 * use.edge + use.reversed] = true;
                continue;
            }
            const NewEdge& edge = view.new_edge(use.edge);
            hash.add_edge(view.point(view.from(use)).rounded(), view.point(view.to(use)).rounded(),
                          LineDirection::of(edge.plane[0]->plane, edge.plane[1]->plane));
        }
    }
    for (const std::uint32_t at : loops.gone) {
        const PatchFace& face = patch.faces[at];
        hash.start_face(face.plane->plane, -1);
        for (const PatchUse& use : patch.uses(face))
            if (!kept[2 * use.edge + use.reversed])
                hash.add_edge(patch.vertices[patch.from(use)].point.rounded(),
                              patch.vertices[patch.to(use)].point.rounded(), patch.direction_of(use.edge));
    }
    return hash.finish();
}

}  // namespace firma
