// SPDX-License-Identifier: MIT
// Boxes between the grid and floats.
#include "index/rounded_box.h"

#include <bit>
#include <limits>

namespace firma {
namespace {

float next_below(float f) {
    if (f == 0) return -std::numeric_limits<float>::denorm_min();
    const auto bits = std::bit_cast<std::uint32_t>(f);
    return std::bit_cast<float>(f > 0 ? bits - 1 : bits + 1);
}

float round_down(double value) {
    const float f = float(value);
    return double(f) > value ? next_below(f) : f;
}

float round_up(double value) {
    return -round_down(-value);
}

std::int32_t to_step(float metres) {
    const double step = double(metres) * kSurfaceSteps;
    return step >= double(INT32_MAX) ? INT32_MAX : std::int32_t(step);
}

}  // namespace

BoxF to_floats(const GridBox& box) {
    const Vec3 low = to_metres(box.low), high = to_metres(box.high);
    return {{round_down(low.x), round_down(low.y), round_down(low.z)},
            {round_up(high.x), round_up(high.y), round_up(high.z)}};
}

BoxF to_floats_within(const GridBox& box) {
    const Vec3 low = to_metres(box.low), high = to_metres(box.high);
    return {{round_up(low.x), round_up(low.y), round_up(low.z)},
            {round_down(high.x), round_down(high.y), round_down(high.z)}};
}

GridBox to_grid(const BoxF& box) {
    return {{to_step(box.low[0]), to_step(box.low[1]), to_step(box.low[2])},
            {to_step(box.high[0]), to_step(box.high[1]), to_step(box.high[2])}};
}

}  // namespace firma
