// SPDX-License-Identifier: MIT
// Eight boxes in eight bits a side.
#include "index/wide_node.h"

#include <algorithm>
#include <cmath>

namespace firma {
namespace {

constexpr int kMostSteps = 255;
/// Finer steps than this are no use: the grid's are 2^-18 m.
constexpr int kFinest = -22;

/// The finest power of two of which 255 reach across.
int exponent_for(double extent) {
    int exponent = kFinest;
    if (extent > kMostSteps * std::ldexp(1.0, kFinest)) std::frexp(extent / kMostSteps, &exponent);
    return exponent;
}

/// Rounded outward; false where a side is farther than 255 steps.
bool set_axis(WideNode& node, std::span<const BoxF> boxes, int axis, float base, float scale) {
    node.base[axis] = base;
    node.scale[axis] = scale;
    for (std::uint32_t k = 0; k < boxes.size(); ++k) {
        const double low = (double(boxes[k].low[axis]) - base) / scale;
        const double high = (double(boxes[k].high[axis]) - base) / scale;
        int from = int(std::clamp(std::floor(low), 0.0, double(kMostSteps)));
        int to = int(std::clamp(std::ceil(high), 0.0, double(kMostSteps)));
        while (from > 0 && base + scale * float(from) > boxes[k].low[axis]) --from;
        while (to < kMostSteps && base + scale * float(to) < boxes[k].high[axis]) ++to;
        if (base + scale * float(to) < boxes[k].high[axis]) return false;
        node.side[0][axis][k] = std::uint8_t(from);
        node.side[1][axis][k] = std::uint8_t(to);
    }
    return true;
}

}  // namespace

void set_boxes(WideNode& node, std::span<const BoxF> boxes) {
    node.count = std::uint32_t(boxes.size());
    node.base[3] = 0;
    node.scale[3] = 1;
    for (int axis = 0; axis < 3; ++axis) {
        float low = boxes[0].low[axis], high = boxes[0].high[axis];
        for (const BoxF& box : boxes) {
            low = std::min(low, box.low[axis]);
            high = std::max(high, box.high[axis]);
        }
        int exponent = exponent_for(double(high) - low);
        while (!set_axis(node, boxes, axis, low, std::ldexp(1.0f, exponent))) ++exponent;
        for (std::uint32_t k = node.count; k < WideNode::kLanes; ++k) {
            node.side[0][axis][k] = kMostSteps;
            node.side[1][axis][k] = 0;
        }
    }
}

}  // namespace firma
