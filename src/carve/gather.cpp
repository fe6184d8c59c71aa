// SPDX-License-Identifier: MIT
// The faces that a cut may touch, taken out of the tree.
#include "carve/gather.h"

#include "tree/visit.h"

namespace firma {
namespace {

/// A box in metres: whole surface steps, so exact in double.
struct Bounds {
    Vec3 low, high;

    explicit Bounds(const GridBox& box) : low(to_metres(box.low)), high(to_metres(box.high)) {}
    bool meets(const BoxF& box) const {
        for (int axis = 0; axis < 3; ++axis)
            if (double(box.high[axis]) < low[axis] || double(box.low[axis]) > high[axis]) return false;
        return true;
    }
};

bool meets(const Block& block, const FaceRecord& face, const GridBox& box) {
    const GridBox own = block.box_of(face);
    for (int axis = 0; axis < 3; ++axis)
        if (own.high[axis] < box.low[axis] || own.low[axis] > box.high[axis]) return false;
    return true;
}

template <class Found>
struct BoxVisitor {
    const GridBox& box;
    const Bounds bounds;
    const Found& found;

    bool enter(const Bin& bin, double& nearest) const {
        nearest = 0;
        return bounds.meets(bin.box);
    }
    bool still(double) const { return true; }
    bool faces(const Block& block, std::uint32_t first, std::uint32_t count) const {
        for (std::uint32_t slot = first; slot < first + count; ++slot) {
            const FaceRecord& face = block.faces[slot];
            if (face.solid && meets(block, face, box)) found(FacetPlace{&block, slot});
        }
        return false;
    }
};

template <class Found>
void visit_box(const Block& root, const GridBox& box, const Found& found) {
    BoxVisitor<Found> visitor{box, Bounds(box), found};
    visit(root, visitor);
}

}  // namespace

void gather_facets(const Block& root, const GridBox& box, std::vector<FacetPlace>& facets) {
    visit_box(root, box, [&](const FacetPlace& place) { facets.push_back(place); });
}

GridBox grown(const GridBox& box, std::int32_t steps) {
    GridBox result;
    for (int axis = 0; axis < 3; ++axis) {
        result.low[axis] = box.low[axis] >= INT32_MIN + steps ? box.low[axis] - steps : INT32_MIN;
        result.high[axis] = box.high[axis] <= INT32_MAX - steps ? box.high[axis] + steps : INT32_MAX;
    }
    return result;
}

}  // namespace firma
