// SPDX-License-Identifier: MIT
// A tree over polygons that keeps, for each bin, a slab across each of some directions: the axes and those that most
// polygons face. Polygons in each other like the skins of an onion have boxes in each other, but thin slabs apart.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/polygons_cross.h"

namespace firma {

class SlabTree {
public:
    /// @param polygons  numbered as they stand
    SlabTree(std::span<const InputPoint> points, std::span<const MeshPolygon> polygons);

    /// Polygons as the tree has them: neighbours in this order are mostly neighbours in space.
    std::span<const std::uint32_t> order() const { return order_; }

    /// Calls `function(number)` for each polygon, itself included, whose slabs meet those of the polygon at a place of
    /// order(); of polygons that share a point all do. In an order that depends on the polygons alone.
    /// @return how many slabs of bins and polygons were compared
    template <class Function>
    std::uint64_t for_each_meeting(std::uint32_t place, const Function& function) const {
        const Slabs& mine = slabs_[place];
        std::uint64_t visits = 0;
        std::uint32_t waiting[kDeepest];
        int count = 0;
        if (!nodes_.empty()) waiting[count++] = 0;
        while (count > 0) {
            const std::uint32_t at = waiting[--count];
            const Node& node = nodes_[at];
            ++visits;
            if (!meet(node.slabs, mine)) continue;
            if (node.count == 0) {
                waiting[count++] = node.first;
                waiting[count++] = at + 1;
                continue;
            }
            visits += node.count;
            for (std::uint32_t k = node.first; k < node.first + node.count; ++k)
                if (meet(slabs_[k], mine)) function(order_[k]);
        }
        return visits;
    }

private:
    static constexpr std::size_t kMostDirections = 13;
    static constexpr std::uint32_t kLeafItems = 4;
    static constexpr int kDeepest = 64;  ///< halved by count, so 2^32 polygons stay below

    struct Direction {
        std::int32_t x = 0, y = 0, z = 0;  ///< at most kLength each
        friend bool operator==(const Direction&, const Direction&) = default;
    };
    static constexpr int kLength = 1023;
    static constexpr int kShift = 6;  ///< products of 2^25 and kLength, three added up, then fit 32 bits

    struct Slab {
        std::int32_t low = INT32_MAX, high = INT32_MIN;
    };
    using Slabs = std::array<Slab, kMostDirections>;

    /// With a count: a leaf. Without: the parent of the node after it and of `first`.
    struct Node {
        Slabs slabs;
        std::uint32_t first = 0, count = 0;
    };

    bool meet(const Slabs& a, const Slabs& b) const {
        for (std::size_t k = 0; k < directions_.size(); ++k)
            if (a[k].high < b[k].low || b[k].high < a[k].low) return false;
        return true;
    }

    void choose_directions(std::span<const MeshPolygon> polygons);
    Slabs slabs_of(std::span<const InputPoint> points, const MeshPolygon& polygon) const;
    void build(std::vector<Slabs>& slabs, std::uint32_t first, std::uint32_t count);

    std::vector<Direction> directions_;
    std::vector<std::uint32_t> order_;
    std::vector<Slabs> slabs_;  ///< in that order
    std::vector<Node> nodes_;
};

}  // namespace firma
