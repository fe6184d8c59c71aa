// SPDX-License-Identifier: MIT
// Casts by where they start and end.
#include "world/cast_order.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace firma {
namespace {

constexpr int kStartBits = 10, kEndBits = 4;  // of each coordinate
constexpr int kKeyBits = 3 * (kStartBits + kEndBits), kDigitBits = 11;
constexpr int kIndexBits = 64 - kKeyBits;
static_assert((std::size_t(1) << kIndexBits) >= kMostInOrder && kKeyBits <= 4 * kDigitBits &&
              kKeyBits > 3 * kDigitBits);

/// Not numbers become the middle.
double within(double x, double low, double high) {
    return x <= low ? low : x >= high ? high : x > low ? x : low + (high - low) / 2;
}

Vec3 within(const Vec3& p, const Box& box) {
    return {within(p.x, box.low.x, box.high.x), within(p.y, box.low.y, box.high.y), within(p.z, box.low.z, box.high.z)};
}

void widen(Box& box, const Vec3& p) {
    for (int axis = 0; axis < 3; ++axis) {
        if (p[axis] < box.low[axis]) box.low[axis] = p[axis];
        if (p[axis] > box.high[axis]) box.high[axis] = p[axis];
    }
}

/// Whole steps of a box's longest side, so that a flat world has no bits to tell heights apart.
class StepsInBox {
public:
    explicit StepsInBox(const Box& box) : low_(box.low) {
        const Vec3 size = box.high - box.low;
        const double longest = std::max({size.x, size.y, size.z});
        scale_ = longest > 0 ? double((1 << kStartBits) - 1) / longest : 0;
    }
    /// Their bits in turn, those of x the highest.
    std::uint64_t code_of(const Vec3& p) const {
        return apart(step(p, 0)) << 2 | apart(step(p, 1)) << 1 | apart(step(p, 2));
    }

private:
    std::uint32_t step(const Vec3& p, int axis) const {
        const double step = (p[axis] - low_[axis]) * scale_;
        return step > 0 ? std::uint32_t(step) & ((1u << kStartBits) - 1) : 0;
    }
    /// Two zeros between each two of ten bits.
    static std::uint64_t apart(std::uint32_t x) {
        x = (x | x << 16) & 0x030000ff;
        x = (x | x << 8) & 0x0300f00f;
        x = (x | x << 4) & 0x030c30c3;
        return (x | x << 2) & 0x09249249;
    }

    Vec3 low_;
    double scale_ = 0;
};

void sort_by_key(std::span<std::uint64_t> all, std::span<std::uint64_t> spare) {
    constexpr std::size_t kDigits = std::size_t(1) << kDigitBits;
    std::array<std::uint32_t, kDigits> first;
    for (int shift = kIndexBits; shift < kIndexBits + kKeyBits; shift += kDigitBits) {
        first.fill(0);
        const auto digit = [&](std::uint64_t entry) { return std::size_t(entry >> shift & (kDigits - 1)); };
        for (const std::uint64_t entry : all) ++first[digit(entry)];
        std::uint32_t sum = 0;
        for (std::uint32_t& count : first) sum += std::exchange(count, sum);
        for (const std::uint64_t entry : all) spare[first[digit(entry)]++] = entry;
        std::swap(all, spare);
    }
}

/// Whether most follow one of the same cell, where cells are so large that a good order has many in each.
bool come_together(std::span<const std::uint64_t> order) {
    constexpr int kManyInACell = 4;  // a power of two
    std::uint64_t differs = 0;
    for (const std::uint64_t entry : order) differs |= (entry ^ order[0]) >> kIndexBits;
    const int bits = int(std::bit_width(differs)) - int(std::bit_width(order.size())) + kManyInACell + 1;
    const int below = std::clamp(kIndexBits + bits, kIndexBits, 63);
    std::size_t together = 0;
    for (std::size_t k = 1; k < order.size(); ++k) together += order[k] >> below == order[k - 1] >> below;
    return together * 4 >= order.size() * 3;
}

}  // namespace

bool order_casts(const Box& world, FunctionRef<CastWay(std::size_t k)> way, std::span<std::uint64_t> order,
                 std::span<std::uint64_t> spare) {
    const auto ends = [&](std::size_t k) {
        const CastWay it = way(k);
        return std::pair(within(it.start, world), within(it.start + it.path, world));
    };
    if (order.empty()) return false;
    Box box{ends(0).first, ends(0).first};
    for (std::size_t k = 0; k < order.size(); ++k) {
        const auto [start, end] = ends(k);
        widen(box, start);
        widen(box, end);
    }
    const StepsInBox steps(box);
    for (std::size_t k = 0; k < order.size(); ++k) {
        const auto [start, end] = ends(k);
        const std::uint64_t key =
            steps.code_of(start) << 3 * kEndBits | steps.code_of(end) >> 3 * (kStartBits - kEndBits);
        order[k] = key << kIndexBits | k;
    }
    if (come_together(order)) return false;
    sort_by_key(order, spare);  // four passes: there and back
    return true;
}

}  // namespace firma
