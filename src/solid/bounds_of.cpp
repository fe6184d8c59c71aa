// SPDX-License-Identifier: MIT
// How far faces reach.
#include "solid/bounds_of.h"

#include <algorithm>
#include <cmath>

#include "index/traverse.h"
#include "solid/block.h"

namespace firma {
namespace {

/// The farthest coordinate of all vertices in one of six directions.
struct Farthest {
    const int axis;
    const double sign;
    double best = -INFINITY;

    bool enter(const BoxF& box, double& nearest) const {
        nearest = -sign * double((sign > 0 ? box.high : box.low)[axis]);
        return still(nearest);
    }
    bool still(double nearest) const { return -nearest > best; }
    bool facets(const IndexedFacets& facets, std::uint32_t first, std::uint32_t count) {
        const Block& block = as_block(facets);
        for (std::uint32_t slot = first; slot < first + count; ++slot)
            for (std::uint32_t k = 0; k < block.faces[slot].corner_count; ++k)
                best = std::max(best, sign * to_metres(block.corner(block.faces[slot], k))[axis]);
        return false;
    }
};

}  // namespace

Box bounds_of(const Node& root) {
    Box box;
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {-1.0, 1.0}) {
            Farthest farthest{axis, sign};
            traverse(root, farthest);
            (sign > 0 ? box.high : box.low)[axis] = sign * farthest.best;
        }
    return box;
}

}  // namespace firma
