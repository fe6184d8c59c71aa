// SPDX-License-Identifier: MIT
// Eight boxes side by side, and those of them that a box meets.
#include "index/wide_node.h"

#include <cstring>
#include <limits>

#include "index/rounded_box.h"

namespace firma {
namespace {

constexpr float kBeyondAll = std::numeric_limits<float>::infinity();

/// Taken together by a processor (as GCC and Clang write it): a lane each.
using EightFloats [[gnu::vector_size(32)]] = float;
using EightAnswers [[gnu::vector_size(32)]] = std::int32_t;

void load(const float (&sides)[WideNode::kLanes], EightFloats& loaded) {
    std::memcpy(&loaded, sides, sizeof loaded);
}

unsigned lanes_without(const EightAnswers& out) {
    unsigned lanes = 0;
    for (std::uint32_t k = 0; k < WideNode::kLanes; ++k) lanes |= unsigned(out[k] == 0) << k;
    return lanes;
}

/// Lanes whose low sides are at most the given ones, and whose high sides at least.
unsigned lanes_from_to(const WideNode& node, const float (&low_at_most)[3], const float (&high_at_least)[3]) {
    EightAnswers out{};
    for (int axis = 0; axis < 3; ++axis) {
        EightFloats low, high;
        load(node.side[0][axis], low);
        load(node.side[1][axis], high);
        out |= (low > low_at_most[axis]) | (high < high_at_least[axis]);
    }
    return lanes_without(out);
}

}  // namespace

void set_boxes(WideNode& node, std::span<const GridBox* const> boxes) {
    for (std::uint32_t k = 0; k < WideNode::kLanes; ++k) {
        const BoxF box = k < boxes.size()
                             ? to_floats(*boxes[k])
                             : BoxF{{kBeyondAll, kBeyondAll, kBeyondAll}, {-kBeyondAll, -kBeyondAll, -kBeyondAll}};
        for (int axis = 0; axis < 3; ++axis) {
            node.side[0][axis][k] = box.low[axis];
            node.side[1][axis][k] = box.high[axis];
        }
        node.below[k] = 0;
    }
}

// A side is a float, so it is at most a number just if it is at most the next float below that.
unsigned lanes_meeting(const WideNode& node, const GridBox& box) {
    const BoxF within = to_floats_within(box);
    return lanes_from_to(node, within.high, within.low);
}

unsigned lanes_around(const WideNode& node, const GridBox& box) {
    const BoxF around = to_floats(box);
    return lanes_from_to(node, around.low, around.high);
}

}  // namespace firma
