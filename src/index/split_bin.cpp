// SPDX-License-Identifier: MIT
// How a bin is divided.
// Source: the article's "Putting Boxes into Bins"; I. Wald, On fast Construction of SAH-based Bounding Volume
// Hierarchies, 2007.
#include "index/split_bin.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "index/box_growth.h"

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

/// Taken together by a processor (as GCC and Clang write it): an axis each; the last is not used.
using FourSteps [[gnu::vector_size(16)]] = std::int32_t;
using FourFloats [[gnu::vector_size(16)]] = float;

/// The sides of an item's box in steps. Whole lines of memory: what stands behind them is in the last place.
struct Sides {
    FourSteps low, high;

    explicit Sides(const BuildItem& item) {
        static_assert(sizeof(GridPoint) == 12 && sizeof(BuildItem) == 28);
        std::memcpy(&low, reinterpret_cast<const char*>(&item), sizeof low);
        std::memcpy(&high, reinterpret_cast<const char*>(&item) + sizeof(GridPoint), sizeof high);
    }
};

/// A box as the rule by surface area wants it: in steps, rounded to floats.
struct Extent {
    FourFloats low = FourFloats{} + INFINITY, high = FourFloats{} - INFINITY;

    Extent() = default;
    explicit Extent(const Sides& sides)
        : low(__builtin_convertvector(sides.low, FourFloats)), high(__builtin_convertvector(sides.high, FourFloats)) {}
    void add(const Extent& other) {
        low = other.low < low ? other.low : low;
        high = other.high > high ? other.high : high;
    }
    float half_area() const {
        const FourFloats length = high - low;
        return length[0] * length[1] + length[1] * length[2] + length[2] * length[0];
    }
};

/// Where twice the centres of items lie, seen from the low corner of the box around all, and into which bucket they
/// fall. In floats, each by the same operations, so that one item always falls into the same.
class Centres {
public:
    /// Not in three places: the module for browsers has to be small.
    [[gnu::noinline]] Centres(std::span<const BuildItem> items, const GridBox& box)
        : base_{box.low.x, box.low.y, box.low.z, 0} {
        for (int axis = 0; axis < 3; ++axis)
            if (std::uint32_t(box.high[axis]) - std::uint32_t(box.low[axis]) >= std::uint32_t(1) << 30) shift_ = 2;
        FourFloats low = of(Sides(items[0])), high = low;
        for (const BuildItem& item : items) {
            const FourFloats centre = of(Sides(item));
            low = centre < low ? centre : low;
            high = centre > high ? centre : high;
        }
        low_ = low;
        for (int axis = 0; axis < 3; ++axis) {
            apart[std::size_t(axis)] = high[axis] > low[axis];
            // The farthest comes below the last bucket's end by more than two products are rounded.
            if (high[axis] > low[axis]) scale_[axis] = kBuckets * (1 - 0x1p-20f) / (high[axis] - low[axis]);
        }
    }

    /// For each axis; 0 where all centres are one.
    FourSteps buckets_of(const Sides& sides) const {
        return __builtin_convertvector((of(sides) - low_) * scale_, FourSteps);
    }
    /// Whether an item falls into none after `bucket`.
    bool falls_before(const BuildItem& item, int axis, int bucket) const {
        const auto from = [&](std::int32_t side) {
            return (std::uint32_t(side) - std::uint32_t(base_[axis])) >> shift_;
        };
        const auto centre = float(std::int32_t(from(item.box.low[axis]) + from(item.box.high[axis])));
        return (centre - low_[axis]) * scale_[axis] < float(bucket + 1);
    }

    /// Along which they lie farthest apart; -1 where all are one.
    int widest_axis() const {
        int widest = -1;
        for (int axis = 0; axis < 3; ++axis)
            if (apart[std::size_t(axis)] && (widest < 0 || scale_[axis] < scale_[widest])) widest = axis;
        return widest;
    }

    std::array<bool, 3> apart{};

private:
    using FourSizes [[gnu::vector_size(16)]] = std::uint32_t;

    /// Below 2^31.
    FourFloats of(const Sides& sides) const {
        const FourSizes low = FourSizes(sides.low) - FourSizes(base_), high = FourSizes(sides.high) - FourSizes(base_);
        return __builtin_convertvector(FourSteps((low >> shift_) + (high >> shift_)), FourFloats);
    }

    FourSteps base_;
    std::uint32_t shift_ = 0;
    FourFloats low_{}, scale_{};
};

struct Plane {
    int axis = -1;
    int bucket = 0;  ///< the last one that goes left
    float cost = 0;
};

/// What it costs to look at some of so many items, with as many side by side as casts take at once: then a bin that
/// fills them costs no more than one that does not.
float cost_of(std::size_t count, std::size_t all) {
    constexpr std::size_t kAtOnce = 8;
    return float(all > kAtOnce ? (count + kAtOnce - 1) / kAtOnce : count);
}

/// Few items, which are sorted rather than dropped into buckets.
struct FewItems {
    std::size_t count;
    std::array<Extent, kFewItems> extents;
    std::array<FourSteps, kFewItems> buckets;

    FewItems(std::span<const BuildItem> items, const Centres& centres) : count(items.size()) {
        for (std::size_t k = 0; k < count; ++k) {
            const Sides sides(items[k]);
            extents[k] = Extent(sides);
            buckets[k] = centres.buckets_of(sides);
        }
    }
};

/// The best plane along one axis, by sweeps over the items in order of their buckets.
/// @param counted  whether many items cost more
void improve_with_few(const FewItems& items, int axis, bool counted, Plane& best) {
    const auto& [count, extents, buckets] = items;
    const auto cost = [counted, all = items.count](const Extent& box, std::size_t some) {
        return counted ? box.half_area() * cost_of(some, all) : box.half_area();
    };
    std::array<std::uint8_t, kFewItems> order;
    for (std::size_t k = 0; k < count; ++k) {
        std::size_t at = k;
        for (; at > 0 && buckets[order[at - 1]][axis] > buckets[k][axis]; --at) order[at] = order[at - 1];
        order[at] = std::uint8_t(k);
    }
    std::array<float, kFewItems> right_cost;  // of all from this one on
    Extent box = extents[order[count - 1]];
    for (std::size_t k = count; k-- > 1;) {
        box.add(extents[order[k]]);
        right_cost[k] = cost(box, count - k);
    }
    box = extents[order[0]];
    for (std::size_t k = 0; k + 1 < count; ++k) {
        box.add(extents[order[k]]);
        const int bucket = buckets[order[k]][axis];
        if (bucket == buckets[order[k + 1]][axis]) continue;
        const float both = cost(box, k + 1) + right_cost[k + 1];
        if (best.axis < 0 || both < best.cost) best = {axis, bucket, both};
    }
}

/// What lies in the buckets of one axis. Nothing asks whether an item is a bucket's first: that is hard to predict.
struct Filled {
    std::array<Extent, kBuckets> boxes;
    std::array<std::uint32_t, kBuckets> counts{};

    void add(int bucket, const Extent& item) {
        ++counts[std::size_t(bucket)];
        boxes[std::size_t(bucket)].add(item);
    }
};

/// The best plane along one axis. The first bucket holds something, and so does the last one. Planes on either side of
/// an empty bucket part the items alike: the lower stands for both.
void improve_with_buckets(const Filled& filled, std::size_t all, int axis, Plane& best) {
    const auto& [boxes, counts] = filled;
    std::array<float, kBuckets> right_cost{};
    Extent box;
    std::size_t count = 0;
    for (std::size_t k = kBuckets - 1; k > 0; --k) {
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
    for (std::size_t k = 0; k + 1 < kBuckets; ++k) {
        if (!counts[k]) continue;
        box.add(boxes[k]);
        count += counts[k];
        const float cost = box.half_area() * cost_of(count, all) + right_cost[k];
        if (best.axis < 0 || cost < best.cost) best = {axis, int(k), cost};
    }
}

/// @return the plane of least cost; without an axis when all centres are one
Plane best_plane(std::span<const BuildItem> items, const Centres& centres) {
    Plane best;
    if (items.size() <= kFewItems) {
        const FewItems few(items, centres);
        for (int axis = 0; axis < 3; ++axis)
            if (centres.apart[std::size_t(axis)]) improve_with_few(few, axis, true, best);
        return best;
    }
    std::array<Filled, 3> filled;
    for (const BuildItem& item : items) {
        const Sides sides(item);
        const FourSteps buckets = centres.buckets_of(sides);
        const Extent extent(sides);
        for (int axis = 0; axis < 3; ++axis) filled[std::size_t(axis)].add(buckets[axis], extent);
    }
    for (int axis = 0; axis < 3; ++axis)
        if (centres.apart[std::size_t(axis)]) improve_with_buckets(filled[std::size_t(axis)], items.size(), axis, best);
    return best;
}

std::size_t split_at(std::span<BuildItem> items, const Plane& plane, const Centres& centres) {
    if (plane.axis < 0) return 0;
    return partition_items(items,
                           [&](const BuildItem& item) { return centres.falls_before(item, plane.axis, plane.bucket); });
}

}  // namespace

std::size_t split_by_count(std::span<BuildItem> items) {
    const std::size_t left = items.size() / 2;
    std::nth_element(items.begin(), items.begin() + std::ptrdiff_t(left), items.end(),
                     [](const BuildItem& a, const BuildItem& b) { return a.face < b.face; });
    return left;
}

std::size_t split_by_area(std::span<BuildItem> items, const GridBox& box) {
    const Centres centres(items, box);
    return split_at(items, best_plane(items, centres), centres);
}

std::size_t split_apart(std::span<BuildItem> items, const GridBox& box, double share) {
    const Centres centres(items, box);
    Plane best;
    if (const int axis = centres.widest_axis(); axis >= 0)
        improve_with_few(FewItems(items, centres), axis, false, best);
    return double(best.cost) < share * half_area(box) ? split_at(items, best, centres) : 0;
}

std::size_t split_bin(std::span<BuildItem> items, const GridBox& box, Split split) {
    const std::size_t left = split == Split::kSurfaceArea ? split_by_area(items, box) : split_longest_axis(items, box);
    return left != 0 ? left : split_by_count(items);
}

GridBox box_around(std::span<const BuildItem> items) {
    FourSteps low = Sides(items[0]).low, high = Sides(items[0]).high;
    for (const BuildItem& item : items.subspan(1)) {
        const Sides sides(item);
        low = sides.low < low ? sides.low : low;
        high = sides.high > high ? sides.high : high;
    }
    return {{low[0], low[1], low[2]}, {high[0], high[1], high[2]}};
}

}  // namespace firma
