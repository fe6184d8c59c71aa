// SPDX-License-Identifier: MIT
// How a bin is divided.
// Source: the article's "Putting Boxes into Bins"; I. Wald, On fast Construction of SAH-based Bounding Volume
// Hierarchies, 2007.
#include "tree/split_bin.h"

#include <algorithm>
#include <array>

namespace firma {
namespace {

std::array<int, 3> axes_by_extent(const GridBox& box) {
    std::array<int, 3> axes{0, 1, 2};
    std::sort(axes.begin(), axes.end(),
              [&](int a, int b) { return box.extent(a) != box.extent(b) ? box.extent(a) > box.extent(b) : a < b; });
    return axes;
}

template <class GoesLeft>
std::size_t partition_items(std::span<BuildItem> items, const GoesLeft& goes_left) {
    return std::size_t(std::partition(items.begin(), items.end(), goes_left) - items.begin());
}

/// In half across the longest axis; across the next one when that leaves a side empty. 0 when none separates.
std::size_t split_longest_axis(std::span<BuildItem> items, const GridBox& box) {
    for (const int axis : axes_by_extent(box)) {
        const std::int64_t middle = std::int64_t(box.low[axis]) + box.high[axis];
        const std::size_t left =
            partition_items(items, [&](const BuildItem& item) { return item.centre(axis) < middle; });
        if (left != 0 && left != items.size()) return left;
    }
    return 0;
}

constexpr int kBuckets = 16;

/// Where centres fall along one axis.
struct Buckets {
    std::int64_t low = 0, high = 0;
    double scale = 0;

    Buckets(std::span<const BuildItem> items, int axis) : low(items[0].centre(axis)), high(low) {
        for (const BuildItem& item : items) {
            low = std::min(low, item.centre(axis));
            high = std::max(high, item.centre(axis));
        }
        scale = kBuckets / double(high - low + 1);
    }
    /// (centre - low) * kBuckets / (high - low + 1), rounded down: exact, as half a step more stays far enough from the
    /// next whole number for the rounding of doubles.
    int of(std::int64_t centre) const { return int((double(centre - low) + 0.5 / kBuckets) * scale); }
};

struct Plane {
    int axis = -1;
    int bucket = 0;  ///< the last one that goes left
    double cost = 0;
};

constexpr std::size_t kFew = 12;  ///< items that are sorted rather than dropped into buckets

/// improve_along_axis() for few items: sweeps over them in order of their buckets.
void improve_with_few(std::span<const BuildItem> items, const Buckets& buckets, int axis, Plane& best) {
    std::array<int, kFew> bucket_of;
    std::array<std::uint8_t, kFew> order;
    for (std::size_t k = 0; k < items.size(); ++k) {
        bucket_of[k] = buckets.of(items[k].centre(axis));
        std::size_t at = k;
        for (; at > 0 && bucket_of[order[at - 1]] > bucket_of[k]; --at) order[at] = order[at - 1];
        order[at] = std::uint8_t(k);
    }
    std::array<double, kFew> right_cost;  // of all from this one on
    GridBox box;
    for (std::size_t k = items.size(); k-- > 1;) {
        box.add(items[order[k]].box);
        right_cost[k] = box.half_area() * double(items.size() - k);
    }
    box = {};
    for (std::size_t k = 0; k + 1 < items.size(); ++k) {
        box.add(items[order[k]].box);
        const int bucket = bucket_of[order[k]];
        if (bucket == bucket_of[order[k + 1]]) continue;
        const double cost = box.half_area() * double(k + 1) + right_cost[k + 1];
        if (best.axis < 0 || cost < best.cost) best = {axis, bucket, cost};
    }
}

void improve_along_axis(std::span<const BuildItem> items, int axis, Plane& best) {
    const Buckets buckets(items, axis);
    if (buckets.low == buckets.high) return;
    if (items.size() <= kFew) return improve_with_few(items, buckets, axis, best);
    std::array<GridBox, kBuckets> boxes;
    std::array<std::size_t, kBuckets> counts{};
    for (const BuildItem& item : items) {
        const int bucket = buckets.of(item.centre(axis));
        boxes[bucket].add(item.box);
        ++counts[bucket];
    }
    // The first and the last bucket hold something. Planes on either side of an empty one part the items alike: the
    // lower stands for both.
    std::array<double, kBuckets> right_cost;
    GridBox box;
    std::size_t count = 0;
    for (int k = kBuckets - 1; k > 0; --k) {
        if (counts[k]) {
            box.add(boxes[k]);
            count += counts[k];
            right_cost[k - 1] = box.half_area() * double(count);
        } else {
            right_cost[k - 1] = right_cost[k];
        }
    }
    box = {};
    count = 0;
    for (int k = 0; k + 1 < kBuckets; ++k) {
        if (!counts[k]) continue;
        box.add(boxes[k]);
        count += counts[k];
        const double cost = box.half_area() * double(count) + right_cost[k];
        if (best.axis < 0 || cost < best.cost) best = {axis, k, cost};
    }
}

std::size_t split_surface_area(std::span<BuildItem> items) {
    Plane best;
    for (int axis = 0; axis < 3; ++axis) improve_along_axis(items, axis, best);
    if (best.axis < 0) return 0;
    const Buckets buckets(items, best.axis);
    return partition_items(items,
                           [&](const BuildItem& item) { return buckets.of(item.centre(best.axis)) <= best.bucket; });
}

}  // namespace

std::size_t split_by_count(std::span<BuildItem> items) {
    const std::size_t left = items.size() / 2;
    std::nth_element(items.begin(), items.begin() + std::ptrdiff_t(left), items.end(),
                     [](const BuildItem& a, const BuildItem& b) { return a.face < b.face; });
    return left;
}

std::size_t split_bin(std::span<BuildItem> items, const GridBox& box, Split split) {
    const std::size_t left = split == Split::kSurfaceArea ? split_surface_area(items) : split_longest_axis(items, box);
    return left != 0 ? left : split_by_count(items);
}

}  // namespace firma
