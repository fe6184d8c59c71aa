// SPDX-License-Identifier: MIT
// Eight boxes in eight bits a side. All in whole steps of the surface grid, so exact.
#include "index/wide_node.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace firma {
namespace {

constexpr std::uint32_t kMostSteps = 255;

/// Taken together by a processor (as GCC and Clang write it): a lane each.
using EightSteps [[gnu::vector_size(32)]] = std::uint32_t;
using EightBytes [[gnu::vector_size(8)]] = std::uint8_t;

/// 2^exponent.
float power_of_two(int exponent) {
    return std::bit_cast<float>(std::uint32_t(exponent + 127) << 23);
}
constexpr int kStepExponent = -18;  ///< of the surface grid's, metres
static_assert(kSurfaceSteps == 0x1p18);

int shift_of(const WideNode& node, int axis) {
    return int(std::bit_cast<std::uint32_t>(node.scale[axis]) >> 23) - 127 - kStepExponent;
}
std::int64_t base_of(const WideNode& node, int axis) {
    return std::int64_t(double(node.base[axis]) * kSurfaceSteps);
}

/// How many steps of 2^shift an extent has at least.
std::uint32_t steps_of(std::uint32_t extent, int shift) {
    return (extent >> shift) + ((extent & ((std::uint32_t(1) << shift) - 1)) != 0);
}

/// A box's sides along an axis, in a node's steps from its base: the low one rounded up, the high one down.
struct Inner {
    std::int64_t low, high;

    Inner(const WideNode& node, int axis, const GridBox& box) {
        const int shift = shift_of(node, axis);
        const std::int64_t base = base_of(node, axis);
        low = -((base - box.low[axis]) >> shift);
        high = (box.high[axis] - base) >> shift;
    }
};
/// The same, each rounded the other way.
struct Outer {
    std::int64_t low, high;

    Outer(const WideNode& node, int axis, const GridBox& box) {
        const int shift = shift_of(node, axis);
        const std::int64_t base = base_of(node, axis);
        low = (box.low[axis] - base) >> shift;
        high = -((base - box.high[axis]) >> shift);
    }
};

EightBytes load(const std::uint8_t (&sides)[WideNode::kLanes]) {
    EightBytes loaded;
    std::memcpy(&loaded, sides, sizeof loaded);
    return loaded;
}
EightBytes all(std::int64_t value) {
    return EightBytes{} + std::uint8_t(std::clamp(value, std::int64_t(0), std::int64_t(kMostSteps)));
}

/// A bit for each lane in use that has none set.
unsigned lanes_without(const WideNode& node, const EightBytes& out) {
    unsigned lanes = 0;
    for (std::uint32_t k = 0; k < WideNode::kLanes; ++k) lanes |= unsigned(out[k] == 0) << k;
    return lanes & ((1u << node.count) - 1);
}

}  // namespace

GridBox WideNode::grid_box(std::uint32_t lane) const {
    GridBox box;
    for (int axis = 0; axis < 3; ++axis) {
        const std::int64_t from = base_of(*this, axis);
        const int shift = shift_of(*this, axis);
        const auto at = [&](int which) {
            return std::int32_t(
                std::min(from + (std::int64_t(side[which][axis][lane]) << shift), std::int64_t(INT32_MAX)));
        };
        box.low[axis] = at(0);
        box.high[axis] = at(1);
    }
    return box;
}

// A float holds 24 bits. The base is a multiple of the step that floats have at the farthest side, and so are all sides
// that lie no farther; one that lies farther is rounded to the power of two beyond that side at least. So a side as
// floats have it is never inside the box.
void set_boxes(WideNode& node, std::span<const GridBox* const> boxes) {
    node.count = std::uint8_t(boxes.size());
    node.base[3] = 0;
    node.scale[3] = 1;
    for (int axis = 0; axis < 3; ++axis) {
        std::int32_t low = boxes[0]->low[axis], high = boxes[0]->high[axis];
        EightSteps lows{}, highs{};
        for (std::uint32_t k = 0; k < node.count; ++k) {
            low = std::min(low, boxes[k]->low[axis]);
            high = std::max(high, boxes[k]->high[axis]);
            lows[k] = std::uint32_t(boxes[k]->low[axis]);
            highs[k] = std::uint32_t(boxes[k]->high[axis]);
        }
        const std::uint32_t farthest = std::max(low < 0 ? 0u - std::uint32_t(low) : std::uint32_t(low),
                                                high < 0 ? 0u - std::uint32_t(high) : std::uint32_t(high));
        const int least = std::max(int(std::bit_width(farthest)) - 24, 0);
        const std::int32_t base = low & -(std::int32_t(1) << least);
        const std::uint32_t extent = std::uint32_t(high) - std::uint32_t(base);
        int shift = std::max(int(std::bit_width(extent)) - 8, least);
        shift += steps_of(extent, shift) > kMostSteps;
        const auto mask = (std::uint32_t(1) << shift) - 1;
        lows = (lows - std::uint32_t(base)) >> shift;
        highs -= std::uint32_t(base);
        highs = (highs >> shift) - EightSteps((highs & mask) != 0);
        for (std::uint32_t k = 0; k < WideNode::kLanes; ++k) {
            node.side[0][axis][k] = std::uint8_t(lows[k]);
            node.side[1][axis][k] = std::uint8_t(highs[k]);
        }
        for (std::uint32_t k = node.count; k < WideNode::kLanes; ++k) {
            node.side[0][axis][k] = kMostSteps;
            node.side[1][axis][k] = 0;
        }
        node.base[axis] = float(double(base) / kSurfaceSteps);
        node.scale[axis] = power_of_two(shift + kStepExponent);
    }
}

unsigned lanes_meeting(const WideNode& node, const GridBox& box) {
    EightBytes out{};
    for (int axis = 0; axis < 3; ++axis) {
        const Inner in(node, axis, box);
        if (in.low > std::int64_t(kMostSteps) || in.high < 0) return 0;
        out |= EightBytes(load(node.side[0][axis]) > all(in.high)) | EightBytes(load(node.side[1][axis]) < all(in.low));
    }
    return lanes_without(node, out);
}

unsigned lanes_around(const WideNode& node, const GridBox& box) {
    EightBytes out{};
    for (int axis = 0; axis < 3; ++axis) {
        const Outer it(node, axis, box);
        if (it.low < 0 || it.high > std::int64_t(kMostSteps)) return 0;
        out |= EightBytes(load(node.side[0][axis]) > all(it.low)) | EightBytes(load(node.side[1][axis]) < all(it.high));
    }
    return lanes_without(node, out);
}

}  // namespace firma
