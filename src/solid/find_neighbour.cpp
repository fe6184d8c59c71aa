// SPDX-License-Identifier: MIT
// The face across an edge: a traversal to the edge's midpoint, which lies in the box of every face that holds the edge.
#include "solid/find_neighbour.h"

#include "index/traverse.h"

namespace firma {
namespace {

struct EdgeVisitor {
    const GridPoint a, b;
    const Vec3 middle;  ///< exact: two 32-bit numbers and their mean fit a double
    FaceId one{}, two{};
    int uses = 0;
    int forward = 0;  ///< how many of them from a to b

    bool enter(const BoxF& box, double& nearest) const {
        nearest = 0;
        for (int axis = 0; axis < 3; ++axis)
            if (middle[axis] < double(box.low[axis]) || middle[axis] > double(box.high[axis])) return false;
        return true;
    }
    bool still(double) const { return true; }

    /// A third use settles it.
    bool facets(const IndexedFacets& facets, std::uint32_t first, std::uint32_t count) {
        const Block& block = as_block(facets);
        for (std::uint32_t slot = first; slot < first + count; ++slot) look_at(block, block.faces[slot]);
        return uses > 2;
    }

    void look_at(const Block& block, const FaceRecord& face) {
        GridPoint from = block.corner(face, face.corner_count - 1u);
        for (std::uint32_t k = 0; k < face.corner_count; ++k) {
            const GridPoint to = block.corner(face, k);
            const bool along = from == a && to == b;
            if (along || (from == b && to == a)) {
                ++uses;
                forward += along;
                two = one;
                one = face.id;
            }
            from = to;
        }
    }
};

}  // namespace

FaceId find_neighbour(const Node& root, const Block& block, const FaceRecord& face, std::uint32_t corner) {
    const GridPoint a = block.corner(face, corner);
    const GridPoint b = block.corner(face, corner + 1u < face.corner_count ? corner + 1 : 0);
    EdgeVisitor visitor{a, b, (to_metres(a) + to_metres(b)) * 0.5};
    traverse(root, visitor);
    if (visitor.uses != 2 || visitor.forward != 1) return {};
    return visitor.one == face.id ? visitor.two : visitor.one;
}

}  // namespace firma
