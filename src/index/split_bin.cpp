// SPDX-License-Identifier: MIT
// How a bin is divided.
// Source: the article's "Putting Boxes into Bins"; I. Wald, On fast Construction of SAH-based Bounding Volume
// Hierarchies, 2007.
#include "index/split_bin.h"

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

/// Taken together by a processor (as GCC and Clang write it); the last is not used.
using FourSteps [[gnu::vector_size(16)]] = std::int32_t;

/// A box as the rule by surface area wants it. In steps: areas are those in square metres times a power of two, so they
/// compare the same, rounding and all.
struct Extent {
    FourSteps low, high;

    static Extent of(const GridBox& box) {
        return {FourSteps{box.low.x, box.low.y, box.low.z, 0}, FourSteps{box.high.x, box.high.y, box.high.z, 0}};
    }
    void add(const Extent& other) {
        low = other.low < low ? other.low : low;
        high = other.high > high ? other.high : high;
    }
    /// Up to twice what the signed type holds.
    double length(int axis) const { return double(std::uint32_t(high[axis]) - std::uint32_t(low[axis])); }
    double half_area() const {
        const double x = length(0), y = length(1), z = length(2);
        return x * y + y * z + z * x;
    }
};

/// Where centres fall along one axis.
struct Buckets {
    std::int64_t low, high;  ///< twice the least and the greatest centre
    double start = 0, scale = 0;

    void set_scale() {
        start = double(low) - 0.5 / kBuckets;
        scale = kBuckets / (double(high - low) + 1);
    }
    /// (centre - low) * kBuckets / (high - low + 1), rounded down: exact, as half a step more stays far enough from the
    /// next whole number for the rounding of doubles.
    int of(std::int64_t centre) const { return int((double(centre) - start) * scale); }
};

struct Plane {
    int axis = -1;
    int bucket = 0;  ///< the last one that goes left
    double cost = 0;
};

/// What it costs to look at some of so many items, with as many side by side as casts take at once: then a bin that
/// fills them costs no more than one that does not.
double cost_of(std::size_t count, std::size_t all) {
    constexpr std::size_t kAtOnce = 8;
    return double(all > kAtOnce ? (count + kAtOnce - 1) / kAtOnce : count);
}

constexpr std::size_t kFew = 12;  ///< items that are sorted rather than dropped into buckets

/// The best plane along one axis, by sweeps over few items in order of their buckets.
void improve_with_few(std::span<const BuildItem> items, std::span<const Extent> extents, const Buckets& buckets,
                      int axis, Plane& best) {
    std::array<int, kFew> bucket_of;
    std::array<std::uint8_t, kFew> order;
    for (std::size_t k = 0; k < items.size(); ++k) {
        bucket_of[k] = buckets.of(items[k].centre(axis));
        std::size_t at = k;
        for (; at > 0 && bucket_of[order[at - 1]] > bucket_of[k]; --at) order[at] = order[at - 1];
        order[at] = std::uint8_t(k);
    }
    std::array<double, kFew> right_cost;  // of all from this one on
    Extent box = extents[order[items.size() - 1]];
    for (std::size_t k = items.size(); k-- > 1;) {
        box.add(extents[order[k]]);
        right_cost[k] = box.half_area() * cost_of(items.size() - k, items.size());
    }
    box = extents[order[0]];
    for (std::size_t k = 0; k + 1 < items.size(); ++k) {
        box.add(extents[order[k]]);
        const int bucket = bucket_of[order[k]];
        if (bucket == bucket_of[order[k + 1]]) continue;
        const double cost = box.half_area() * cost_of(k + 1, items.size()) + right_cost[k + 1];
        if (best.axis < 0 || cost < best.cost) best = {axis, bucket, cost};
    }
}

/// What lies in the buckets of one axis. Nothing asks whether an item is a bucket's first: that is hard to predict.
struct Filled {
    std::array<Extent, kBuckets> boxes;
    std::array<std::uint32_t, kBuckets> counts{};

    Filled() { boxes.fill(Extent::of({})); }
    void add(int bucket, const Extent& item) {
        ++counts[bucket];
        boxes[bucket].add(item);
    }
};

/// The best plane along one axis. The first bucket holds something, and so does a later one: the last, unless centres
/// are within a few steps. Planes on either side of an empty bucket part the items alike: the lower stands for both.
void improve_with_buckets(const Filled& filled, std::size_t all, int axis, Plane& best) {
    const auto& [boxes, counts] = filled;
    int last = kBuckets - 1;
    while (counts[last] == 0) --last;
    std::array<double, kBuckets> right_cost;
    Extent box = boxes[last];
    std::size_t count = 0;
    for (int k = last; k > 0; --k) {
        if (counts[k]) {
            box.add(boxes[k]);
            count += counts[k];
            right_cost[k - 1] = box.half_area() * cost_of(count, all);
        } else {
            right_cost[k - 1] = right_cost[k];
        }
    }
    box = boxes[0];
    count = 0;
    for (int k = 0; k < last; ++k) {
        if (!counts[k]) continue;
        box.add(boxes[k]);
        count += counts[k];
        const double cost = box.half_area() * cost_of(count, all) + right_cost[k];
        if (best.axis < 0 || cost < best.cost) best = {axis, k, cost};
    }
}

std::array<Buckets, 3> buckets_of(std::span<const BuildItem> items) {
    std::array<Buckets, 3> buckets;
    for (int axis = 0; axis < 3; ++axis) {
        std::int64_t low = items[0].centre(axis), high = low;
        for (const BuildItem& item : items) {
            low = std::min(low, item.centre(axis));
            high = std::max(high, item.centre(axis));
        }
        buckets[axis].low = low;
        buckets[axis].high = high;
        buckets[axis].set_scale();
    }
    return buckets;
}

/// @return the plane of least cost; without an axis when all centres are one
Plane best_plane(std::span<const BuildItem> items, const std::array<Buckets, 3>& buckets) {
    Plane best;
    if (items.size() <= kFew) {
        std::array<Extent, kFew> extents;
        for (std::size_t k = 0; k < items.size(); ++k) extents[k] = Extent::of(items[k].box);
        for (int axis = 0; axis < 3; ++axis)
            if (buckets[axis].low != buckets[axis].high) improve_with_few(items, extents, buckets[axis], axis, best);
        return best;
    }
    std::array<Filled, 3> filled;
    for (const BuildItem& item : items) {
        const Extent extent = Extent::of(item.box);
        for (int axis = 0; axis < 3; ++axis) filled[axis].add(buckets[axis].of(item.centre(axis)), extent);
    }
    for (int axis = 0; axis < 3; ++axis)
        if (buckets[axis].low != buckets[axis].high) improve_with_buckets(filled[axis], items.size(), axis, best);
    return best;
}

}  // namespace

std::size_t split_by_count(std::span<BuildItem> items) {
    const std::size_t left = items.size() / 2;
    std::nth_element(items.begin(), items.begin() + std::ptrdiff_t(left), items.end(),
                     [](const BuildItem& a, const BuildItem& b) { return a.face < b.face; });
    return left;
}

std::size_t split_by_area(std::span<BuildItem> items) {
    const std::array<Buckets, 3> buckets = buckets_of(items);
    const Plane best = best_plane(items, buckets);
    if (best.axis < 0) return 0;
    const Buckets& along = buckets[best.axis];
    return partition_items(items,
                           [&](const BuildItem& item) { return along.of(item.centre(best.axis)) <= best.bucket; });
}

std::size_t split_bin(std::span<BuildItem> items, const GridBox& box, Split split) {
    const std::size_t left = split == Split::kSurfaceArea ? split_by_area(items) : split_longest_axis(items, box);
    return left != 0 ? left : split_by_count(items);
}

}  // namespace firma
