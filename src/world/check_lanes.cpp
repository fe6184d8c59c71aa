// SPDX-License-Identifier: MIT
// Wide nodes and lanes against the nodes and the block that they lead to, one by one.
#include "world/check_lanes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "base/seldom.h"
#include "solid/block.h"
#include "solid/face_shape.h"

namespace firma {
namespace {

/// Where something stands in an array, or none.
template <class T>
std::size_t place_in(const PoolVector<T>& array, const void* at) {
    const auto* const first = reinterpret_cast<const std::byte*>(array.data());
    const auto* const last = first + array.size() * sizeof(T);
    const auto* const it = static_cast<const std::byte*>(at);
    const std::less<const std::byte*> before;
    if (array.empty() || before(it, first) || !before(it, last) || std::size_t(it - first) % sizeof(T) != 0)
        return array.size();
    return std::size_t(it - first) / sizeof(T);
}

constexpr float kAny = std::numeric_limits<float>::infinity();

/// As sides have to be that boxes of the grid are compared with exactly.
bool is_whole_steps(float side) {
    const double steps = double(side) * kSurfaceSteps;
    return steps == std::floor(steps) && std::fabs(steps) <= -double(INT32_MIN);
}

class LanesChecker {
public:
    explicit LanesChecker(const Node& node) : node_(node) {}

    std::optional<WorldFault> check() {
        led_to_.assign(node_.wide.size(), 0);
        led_to_[0] = 1;
        if (node_.is_leaf()) {
            triangles_.fill(0);
            lanes_.assign(block_of(node_).lanes.size(), 0);
        }
        check_wide(0, {{-kAny, -kAny, -kAny}, {kAny, kAny, kAny}}, 1);
        if (fault_) return fault_;
        if (next_item_ != (node_.is_leaf() ? block_of(node_).faces.size() : node_.children.size()))
            report("an item is not in exactly one wide node");
        for (const int times : led_to_)
            if (times != 1) report("a wide node is not led to exactly once");
        for (const int times : lanes_)
            if (times != 1) report("lanes are not led to exactly once");
        if (deepest_ != node_.depth) report("an index block's depth is not how deep it is");
        if (node_.is_leaf()) check_all_there();
        return fault_;
    }

private:
    void report(const char* what, FaceId face = {}) {
        if (!fault_) fault_ = WorldFault{what, face};
    }

    /// @param around  what everything below must lie in; boxes of wide nodes themselves may reach out, as they are
    ///                rounded outward at each level
    void check_wide(std::size_t index, const BoxF& around, int depth) {
        const WideNode& wide = node_.wide[index];
        const LaneItems& items = node_.lane_items[index];
        if (items.count == 0 || items.count > WideNode::kLanes) return report("a wide node does not hold 1 to 8 boxes");
        for (std::uint32_t lane = 0; lane < WideNode::kLanes; ++lane)
            if (items.first[lane] > items.first[lane + 1] || (lane < items.count) != (items.items(lane) > 0))
                return report("a wide node's boxes do not hold an item and more each");
        for (std::uint32_t lane = items.count; lane < WideNode::kLanes; ++lane) {
            if (wide.below[lane]) return report("a wide node has boxes beyond those in use");
            for (int axis = 0; axis < 3; ++axis)
                if (wide.side[0][axis][lane] != kAny || wide.side[1][axis][lane] != -kAny)
                    return report("a wide node has boxes beyond those in use");
        }
        for (std::uint32_t lane = 0; lane < items.count && !fault_; ++lane) {
            if (items.first[lane] != next_item_) return report("an item is not in exactly one wide node");
            BoxF box;
            for (int axis = 0; axis < 3; ++axis) {
                const float low = wide.side[0][axis][lane], high = wide.side[1][axis][lane];
                if (!is_whole_steps(low) || !is_whole_steps(high))
                    return report("a side of a wide node is no whole step");
                box.low[axis] = std::max(around.low[axis], low);
                box.high[axis] = std::min(around.high[axis], high);
            }
            check_lane(index, wide, lane, box, depth);
            if (next_item_ != items.first[lane + 1]) report("an item is not in exactly one wide node");
        }
    }

    void check_lane(std::size_t index, const WideNode& wide, std::uint32_t lane, const BoxF& box, int depth) {
        if (wide.leads_to_facets(lane)) return check_facets(wide, lane, box, depth);
        if (node_.leads_to_node(wide, lane)) return check_node(wide, lane, box, depth);
        const std::size_t below = place_in(node_.wide, wide.wide(lane));
        if (below >= node_.wide.size()) return report("a wide node leads to nothing of its index block");
        if (below <= index) return report("a wide node leads backward");
        if (++led_to_[below] > 1) return report("a wide node is not led to exactly once");
        check_wide(below, box, depth + 1);
    }

    void check_node(const WideNode& wide, std::uint32_t lane, const BoxF& box, int depth) {
        if (next_item_ >= node_.children.size()) return report("a wide node leads to nothing of its index block");
        const Node& child = *node_.children[next_item_++];
        if (wide.wide(lane) != child.wide.data()) return report("a wide node leads to nothing of its index block");
        deepest_ = std::max(deepest_, depth + child.depth);
        const Vec3 low = to_metres(child.box.low), high = to_metres(child.box.high);
        for (int axis = 0; axis < 3; ++axis)
            if (!(low[axis] >= double(box.low[axis]) && high[axis] <= double(box.high[axis])))
                return report("an index block reaches out of its wide node");
    }

    void check_facets(const WideNode& wide, std::uint32_t lane, const BoxF& box, int depth) {
        if (!node_.is_leaf()) return report("a wide node leads to faces from above index blocks");
        const Block& block = block_of(node_);
        const LaneItems& items = node_.items_of(wide);
        if (items.first[lane + 1] > block.faces.size()) return report("a wide node leads to faces that are not there");
        deepest_ = std::max(deepest_, depth);
        next_item_ = items.first[lane + 1];
        for (std::uint32_t slot = items.first[lane]; slot < next_item_; ++slot) {
            const FaceRecord& face = block.faces[slot];
            check_box(block, face, box);
            if (slot > items.first[lane] && !(block.faces[slot - 1].id < face.id))
                report("faces below a lane do not lie by rising ids", face.id);
        }
        std::size_t k = place_in(block.lanes, wide.facets(lane));
        for (bool more = true; more && !fault_;) {
            if (k >= block.lanes.size()) return report("a wide node leads out of its lanes");
            const FaceLanes& it = block.lanes[k];
            if (k + it.in_a_row() > block.lanes.size()) return report("a wide node leads out of its lanes");
            for (const std::size_t next = k + it.in_a_row(); k < next; ++k) ++lanes_[k];
            more = it.more_follow();
            check_lanes(block, it, items.first[lane], next_item_);
        }
    }

    /// @param first, end  slots of the faces that the lanes are of
    void check_lanes(const Block& block, const FaceLanes& it, std::uint32_t first, std::uint32_t end) {
        for (std::uint32_t lane = 0; lane < it.count() && !fault_; ++lane) {
            const std::uint32_t slot = it.slot(lane);
            if (slot < first || slot >= end) return report("a lane names a face that does not lie there");
            const FaceRecord& face = block.faces[slot];
            if (lane == 0 || it.slot(lane - 1) != slot) check_plane(block, it, face);
            const std::uint32_t k = triangles_[slot]++;
            if (k + 2 >= face.corner_count) return report("lanes hold more triangles than their face", face.id);
            check_triangle(block, it, lane, face, k);
        }
    }

    void check_box(const Block& block, const FaceRecord& face, const BoxF& box) {
        for (std::uint32_t k = 0; k < face.corner_count; ++k) {
            const Vec3 corner = to_metres(block.corner(face, k));
            for (int axis = 0; axis < 3; ++axis)
                if (!(corner[axis] >= double(box.low[axis]) && corner[axis] <= double(box.high[axis])))
                    return report("a face reaches out of its wide node", face.id);
        }
    }

    void check_plane(const Block& block, const FaceLanes& it, const FaceRecord& face) {
        if (face.corner_count == 3) return;
        const FaceShape shape(block, face);
        if (!shape.polygon.has_area()) return;
        const Vec3 normal = shape.polygon.unit_normal();
        for (const Vec3& corner : shape.polygon.corners)
            if (!(std::fabs(dot(corner - shape.polygon.corners[0], normal)) <= double(it.uneven())))
                return report("a face is less even than its lanes say", face.id);
    }

    /// Triangle k of a face's fan.
    void check_triangle(const Block& block, const FaceLanes& it, std::uint32_t lane, const FaceRecord& face,
                        std::uint32_t k) {
        bool exact = face.corner_count == 3;
        double off = face.corner_count > 3 ? 1 / kSurfaceSteps : 0;
        FaceFan fan = block.fan_of(face);
        fan.advance(k);
        if (fan.lanes() != &it || fan.lane() != lane)
            return report("lanes hold more triangles than their face", face.id);
        for (std::uint32_t c = 0; c < 3; ++c) {
            const GridPoint point = it.grid_corner(lane, c);
            double size = 0, shift = 0;
            for (int axis = 0; axis < 3; ++axis) {
                const double from = double(std::int64_t(point[axis]) - it.origin[axis]) / kSurfaceSteps;
                size += std::fabs(from);
                shift += std::fabs(from - double(float(from)));
                exact = exact && (!it.is_wide() || std::fabs(from) <= 128);
            }
            if (!(size <= double(it.size))) return report("a lane's corner is farther than its lanes say", face.id);
            off = std::max(off, shift);
        }
        if (!(off <= double(it.shifted())))
            return report("a lane's corner is shifted more than its lanes say", face.id);
        if ((it.whole >> lane & 1) && !exact) return report("a lane says it is exact and is not", face.id);
        if ((it.two_sided >> lane & 1) != face.two_sided)
            return report("a lane says which sides its face has, and is wrong", face.id);
        if (it.mask_of_all & ~face.mask) report("lanes have bits in their mask that a face has not", face.id);
    }

    void check_all_there() {
        const Block& block = block_of(node_);
        for (std::size_t slot = 0; slot < block.faces.size(); ++slot) {
            const FaceRecord& face = block.faces[slot];
            if (triangles_[slot] + 2u != face.corner_count)
                report("lanes hold fewer triangles than their face", face.id);
            if (block.mask_of_all & ~face.mask) report("a block has bits in its mask that a face has not", face.id);
        }
    }

    const Node& node_;
    std::optional<WorldFault> fault_;
    std::uint32_t next_item_ = 0;
    int deepest_ = 0;
    std::vector<int> led_to_, lanes_;  ///< how often, of wide nodes and of lanes
    std::array<std::uint32_t, kNodeItems> triangles_;
};

/// Whether a face's corners may be read, and are the same in all triangles that have them.
class CornersChecker {
public:
    explicit CornersChecker(const Block& block) : block_(block) {}

    FIRMA_SELDOM std::optional<WorldFault> check() {
        for (std::size_t at = 0; at < block_.lanes.size(); at += block_.lanes[at].in_a_row()) {
            const FaceLanes& it = block_.lanes[at];
            if (it.block != &block_ || it.faces != block_.faces.data())
                return WorldFault{"lanes name another block than theirs", {}};
            int exponent;
            if (!(std::frexp(it.step, &exponent) == 0.5f))
                return WorldFault{"a step of lanes is not a power of two", {}};
            if (at + it.in_a_row() > block_.lanes.size()) return WorldFault{"lanes lack their second half", {}};
            for (std::uint32_t lane = 0; lane < it.count(); ++lane)
                if (it.slot(lane) >= block_.faces.size())
                    return WorldFault{"a lane names a face that does not lie there", {}};
        }
        for (std::uint32_t slot = 0; slot < block_.faces.size(); ++slot)
            if (const char* const fault = fault_of_fan(slot)) return WorldFault{fault, block_.faces[slot].id};
        return {};
    }

private:
    FIRMA_SELDOM const char* fault_of_fan(std::uint32_t slot) const {
        const FaceRecord& face = block_.faces[slot];
        if (face.corner_count < 3) return "a face has corners that are not there";
        std::size_t at = face.first_lane / FaceLanes::kLanes;
        std::uint32_t lane = face.first_lane % FaceLanes::kLanes;
        GridPoint first, last;
        for (std::uint32_t k = 0; k + 2u < face.corner_count; ++k, ++lane) {
            if (lane == FaceLanes::kLanes) {
                at += block_.lanes[at].in_a_row();
                lane = 0;
            }
            if (at >= block_.lanes.size()) return "a face has corners that are not there";
            const FaceLanes& it = block_.lanes[at];
            if (at + it.in_a_row() > block_.lanes.size() || lane >= it.count() || it.slot(lane) != slot)
                return "lanes hold fewer triangles than their face";
            if (k > 0 && (it.grid_corner(lane, 0) != first || it.grid_corner(lane, 1) != last))
                return "a lane has another triangle than its face";
            first = it.grid_corner(lane, 0);
            last = it.grid_corner(lane, 2);
        }
        return nullptr;
    }

    const Block& block_;
};

}  // namespace

std::optional<WorldFault> fault_of_corners(const Block& block) {
    return CornersChecker(block).check();
}

std::optional<WorldFault> fault_of_wide_nodes(const Node& node) {
    return LanesChecker(node).check();
}

}  // namespace firma
