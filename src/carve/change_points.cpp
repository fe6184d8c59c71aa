// SPDX-License-Identifier: MIT
// What a cut does to the hash of the solid's points.
#include "carve/change_points.h"

#include <cstdint>
#include <vector>

#include "solid/hash_points.h"

namespace firma {
namespace {

/// Directions of edges, each found once: two faces ask.
class EdgeDirections {
public:
    explicit EdgeDirections(const CutView& view)
        : view_(view), known_(view.edge_count(), false), directions_(view.edge_count()) {}

    const LineDirection& of(std::uint32_t edge) {
        if (!known_[edge]) {
            known_[edge] = true;
            directions_[edge] = find(edge);
        }
        return directions_[edge];
    }

private:
    LineDirection find(std::uint32_t index) const {
        if (index < view_.first_new_edge()) return view_.patch().direction_of(index);
        const NewEdge& edge = view_.new_edge(index);
        return LineDirection::of(edge.plane[0]->plane, edge.plane[1]->plane);
    }

    const CutView& view_;
    std::vector<bool> known_;
    std::vector<LineDirection> directions_;
};

}  // namespace

SumsByKey change_of_points(const CutView& view, const NewLoops& loops) {
    const SolidPatch& patch = view.patch();
    PointHash hash;
    EdgeDirections directions(view);
    // By edge and direction: pieces of a face lie in its plane, so what they keep of its rim cancels.
    std::vector<bool> kept(2 * patch.edges.size(), false);
    for (const NewFace& face : loops.faces) {
        hash.start_face(face.plane->plane, 1);
        for (const PatchUse& use : loops.uses(face)) {
            if (use.edge < view.first_new_edge()) {
                kept[2 * use.edge + use.reversed] = true;
                continue;
            }
            hash.add_edge(view.point(view.from(use)).rounded(), view.point(view.to(use)).rounded(),
                          directions.of(use.edge));
        }
    }
    for (const std::uint32_t at : loops.gone) {
        const PatchFace& face = patch.faces[at];
        hash.start_face(face.plane->plane, -1);
        for (const PatchUse& use : patch.uses(face))
            if (!kept[2 * use.edge + use.reversed])
                hash.add_edge(patch.vertices[patch.from(use)].point.rounded(),
                              patch.vertices[patch.to(use)].point.rounded(), directions.of(use.edge));
    }
    return hash.finish();
}

}  // namespace firma
