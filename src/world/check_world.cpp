// SPDX-License-Identifier: MIT
// Is this world sound: every invariant, one by one, the slow and sure way.
#include <algorithm>
#include <vector>

#include "base/sort.h"
#include "firma/world.h"
#include "tree/visit.h"
#include "world/block_faces.h"
#include "world/check_rooms.h"
#include "world/world_data.h"

namespace firma {
namespace {

const char* describe(PolygonFault fault) {
    switch (fault) {
        case PolygonFault::kNone:
            return "sound";
        case PolygonFault::kTooFewCorners:
            return "a face has fewer than three corners";
        case PolygonFault::kOffGrid:
            return "a corner is off the grid or outside the world";
        case PolygonFault::kNoArea:
            return "a face has no area";
        case PolygonFault::kNotPlanar:
            return "a face is not planar";
        case PolygonFault::kNotConvex:
            return "a face is not convex";
    }
    return "unknown";
}

bool contains(const BoxF& outer, const BoxF& inner) {
    for (int axis = 0; axis < 3; ++axis)
        if (inner.low[axis] < outer.low[axis] || inner.high[axis] > outer.high[axis]) return false;
    return true;
}

bool contains(const BoxF& box, const Vec3& p) {
    for (int axis = 0; axis < 3; ++axis)
        if (p[axis] < double(box.low[axis]) || p[axis] > double(box.high[axis])) return false;
    return true;
}

class Checker {
public:
    std::optional<WorldFault> check(const World& world) {
        for (const Ref<const Room>& room : world.data().rooms)
            if (room->tree) check_block(*room->tree, nullptr);
        if (!fault_ && ids_.size() != world.face_count()) report("the count of faces is not how many there are", {});
        if (!fault_) check_ids(world);
        if (!fault_) fault_ = check_rooms(world);
        return fault_;
    }

private:
    void report(const char* what, FaceId face) {
        if (!fault_) fault_ = WorldFault{what, face};
    }

    void check_block(const Block& block, const BoxF* around) {
        if (fault_) return;
        if (block.bins.empty()) return report("a block has no bins", {});
        if (block.holds_blocks() != block.faces.empty())
            return report("a block holds both faces and blocks, or neither", {});
        const std::size_t items = block.holds_blocks() ? block.children.size() : block.faces.size();
        if (items > kBlockItems) return report("a block holds more than 64 items", {});
        if (around && !contains(*around, block.bins[0].box)) return report("a block reaches out of its bin", {});
        std::vector<int> held(items, 0);
        const std::size_t used = check_bin(block, 0, held);
        if (used != block.bins.size()) report("a block has bins that no other leads to", {});
        if (block.faces_below != faces_below(block)) report("a block's count of faces is not how many there are", {});
        if (block.depth != depth_below(block, 0)) report("a block's depth is not how deep it is", {});
        if (block.depth > kDeepestTree) report("a tree is deeper than walks can go", {});
        for (const int times : held)
            if (times != 1) report("an item is not in exactly one bin", {});
    }

    static std::size_t faces_below(const Block& block) {
        std::size_t sum = block.faces.size();
        for (const Ref<const Block>& child : block.children) sum += child->faces_below;
        return sum;
    }

    /// Of a block whose bins are sound.
    int depth_below(const Block& block, std::size_t index) const {
        if (fault_) return block.depth;
        const Bin& bin = block.bins[index];
        if (bin.is_leaf()) return block.holds_blocks() ? block.children[bin.first]->depth : 0;
        return 1 + std::max(depth_below(block, index + 1), depth_below(block, bin.first));
    }

    /// @return bins in this subtree
    std::size_t check_bin(const Block& block, std::size_t index, std::vector<int>& held) {
        if (fault_) return 0;
        if (index >= block.bins.size()) return report("a bin leads out of its block", {}), 0;
        const Bin& bin = block.bins[index];
        if (!bin.is_leaf()) {
            if (bin.first <= index + 1 || bin.first >= block.bins.size()) return report("a bin leads backward", {}), 0;
            if (!contains(bin.box, block.bins[index + 1].box) || !contains(bin.box, block.bins[bin.first].box))
                report("a bin reaches out of its parent", {});
            const std::size_t left = check_bin(block, index + 1, held);
            return 1 + left + check_bin(block, bin.first, held);
        }
        if (block.holds_blocks() && bin.count != 1) report("a bin holds more than one block", {});
        if (std::size_t(bin.first) + bin.count > held.size())
            return report("a bin holds items that are not there", {}), 0;
        for (std::uint32_t item = bin.first; item < bin.first + bin.count; ++item) {
            ++held[item];
            if (block.holds_blocks())
                check_block(*block.children[item], &bin.box);
            else
                check_face(block, block.faces[item], bin.box);
        }
        return 1;
    }

    void check_face(const Block& block, const FaceRecord& record, const BoxF& box) {
        if (std::size_t(record.first_corner) + record.corner_count > block.corner_vertices.size())
            return report("a face has corners that are not there", record.id);
        for (const std::uint16_t vertex : block.corners_of(record))
            if (vertex >= block.vertices.size()) return report("a corner has no vertex", record.id);
        if (record.owner != kNoOwner && record.owner >= block.owners.size())
            return report("a face has an owner that is not there", record.id);
        const Face face = describe_face(block, record);
        const PolygonFault polygon = check_polygon(face.corners);
        if (polygon != PolygonFault::kNone) return report(describe(polygon), face.id);
        for (const Vec3& corner : face.corners)
            if (!contains(box, corner)) return report("a face reaches out of its bin", face.id);
        if (!face.id.valid()) return report("a face has no id", face.id);
        ids_.push_back(face.id.value);
    }

    /// By sorting: a set of numbers that someone chose can be slow.
    void check_ids(const World& world) {
        sort_range(ids_);
        const auto twice = std::adjacent_find(ids_.begin(), ids_.end());
        if (twice != ids_.end()) return report("two faces have one id", {*twice});
        if (!ids_.empty() && ids_.back() >= world.data().next_face)
            report("a face's id is not below the next one", {ids_.back()});
    }

    std::optional<WorldFault> fault_;
    std::vector<std::uint32_t> ids_;
};

}  // namespace

std::optional<WorldFault> check_world(const World& world) {
    return Checker().check(world);
}

}  // namespace firma
