// SPDX-License-Identifier: MIT
// Is this world sound: every invariant, one by one, the slow and sure way.
#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include "base/sort.h"
#include "firma/world.h"
#include "index/traverse.h"
#include "solid/face_ids.h"
#include "solid/hash_facet.h"
#include "world/block_faces.h"
#include "world/check_exchange.h"
#include "world/check_lanes.h"
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

}  // namespace

const char* fault_of_face(const Block& block, const FaceRecord& record, bool solid) {
    if (record.owner != kNoOwner && record.owner >= block.owners.size()) return "a face has an owner that is not there";
    Vec3 corners[256];
    for (std::uint32_t k = 0; k < record.corner_count; ++k) corners[k] = to_metres(block.corner(record, k));
    const PolygonFault polygon = check_polygon({corners, record.corner_count});
    const bool flattened = polygon == PolygonFault::kNoArea && record.owner != kNoOwner;  // by rounding
    if (polygon != PolygonFault::kNone && !flattened) return describe(polygon);
    if (!record.id.valid()) return "a face has no id";
    if (record.solid != solid)
        return solid ? "a face of the solid does not say so" : "a castable-only face says it is solid";
    return nullptr;
}

namespace {

class Checker {
public:
    std::optional<WorldFault> check(const World& world) {
        const WorldData& data = world.data();
        if (const Node* root = data.solid.data().faces.root.get()) check_store(*root, true);
        if (const Node* root = data.castable.root.get()) check_store(*root, false);
        if (!fault_ && ids_.size() != world.face_count()) report("the count of faces is not how many there are", {});
        if (!fault_) check_ids(world);
        if (data.room_faces.size() != data.cells.room_count())
            report("the indices of rooms are not as many as the rooms", {});
        if (!fault_)
            data.room_faces.for_each(
                [&](std::uint32_t number, const Ref<const RoomFaces>& faces) { check_room(number, *faces); });
        if (!fault_) check_all_in_rooms(data);
        if (!fault_) check_hashes(data);
        if (!fault_) fault_ = check_rooms(world);
        return fault_;
    }

private:
    void report(const char* what, FaceId face) {
        if (!fault_) fault_ = WorldFault{what, face};
    }

    /// What faces are kept in: each block looked at, face by face.
    void check_store(const Node& root, bool solid) {
        in_store_ = true;
        solid_ = solid;
        check_node(root);
    }

    /// A room's index: over blocks that were looked at.
    void check_room(std::uint32_t number, const RoomFaces& room) {
        in_store_ = false;
        faces_ = 0;
        hash_ = 0;
        room_ = number;
        if (room.tree) check_node(*room.tree);
        if (!fault_ && room.count != faces_) report("a room's count of faces is not how many there are", {});
        if (!fault_ && room.hash != hash_) report("a room's hash is not that of its faces", {});
    }

    void check_node(const Node& node) {
        if (fault_) return;
        if (node.wide.empty()) return report("an index block has no nodes", {});
        if (node.lane_items.size() != node.wide.size())
            return report("an index block does not tell of each wide node what it leads to", {});
        if (node.is_leaf() != bool(node.facets))
            return report("an index block holds both facets and blocks, or neither", {});
        const std::size_t items = node.is_leaf() ? block_of(node).faces.size() : node.children.size();
        if (items == 0 || items > kNodeItems) return report("an index block does not hold 1 to 64 items", {});
        if (node.facets_below != facets_below(node))
            report("an index block's count of faces is not how many there are", {});
        if (node.depth > kDeepestTree) report("an index is deeper than traversals can go", {});
        GridBox around;
        if (node.is_leaf() && !fault_) fault_ = fault_of_corners(block_of(node));
        if (fault_) return;
        if (node.is_leaf())
            for (const FaceRecord& face : block_of(node).faces) check_face(block_of(node), face, around);
        for (const Ref<const Node>& child : node.children) {
            check_node(*child);
            around.add(child->box);
        }
        if (!fault_ && node.box != around) report("an index block's box is not that around what it holds", {});
        // A leaf that is in a room is one that is in a store.
        if (!fault_ && (in_store_ || !node.is_leaf())) fault_ = fault_of_wide_nodes(node);
        if (!fault_ && node.is_leaf()) check_leaf(node);
    }

    void check_leaf(const Node& leaf) {
        if (in_store_) return leaves_.push_back(&leaf);
        in_rooms_.push_back(&leaf);
        const Block& block = block_of(leaf);
        faces_ += block.faces.size();
        for (const FaceRecord& face : block.faces) hash_ += hash_facet(block, face);
        parts_.push_back({block.part, room_});
    }

    static std::size_t facets_below(const Node& node) {
        if (node.is_leaf()) return block_of(node).faces.size();
        std::size_t sum = 0;
        for (const Ref<const Node>& child : node.children) sum += child->facets_below;
        return sum;
    }

    /// In a store all that it is, in a room's index where it lies.
    void check_face(const Block& block, const FaceRecord& record, GridBox& around) {
        around.add(block.box_of(record));
        if (!in_store_) return;
        if (const char* fault = fault_of_face(block, record, solid_)) return report(fault, record.id);
        ids_.push_back(record.id.value);
    }

    /// By sorting: a set of numbers that someone chose can be slow.
    void check_ids(const World& world) {
        sort_range(ids_);
        const auto twice = std::adjacent_find(ids_.begin(), ids_.end());
        if (twice != ids_.end()) return report("two faces have one id", {*twice});
        for (const std::uint32_t id : ids_)
            if (!was_given(id, world.data().next_face(), world.data().edits()))
                return report("a face's id is not below the next one", {id});
    }

    /// Each block lies in the index of the one room that its faces are part of.
    void check_all_in_rooms(const WorldData& data) {
        for (const auto& [part, room] : parts_)
            if (part >= data.cells.room_count() || data.cells.current_room(part) != room)
                return report("a block lies in a room that its faces are not part of", {});
        sort_range(leaves_, std::less<const Node*>());
        sort_range(in_rooms_, std::less<const Node*>());
        if (leaves_ != in_rooms_) report("a block lies in no room, in several, or in another leaf there", {});
    }

    /// By region, those that are zero left out.
    static std::vector<std::pair<std::uint32_t, std::uint64_t>> sums_of(const PersistentMap<std::uint64_t>& regions) {
        std::vector<std::pair<std::uint32_t, std::uint64_t>> sums;
        regions.for_each([&](std::uint32_t region, std::uint64_t sum) {
            if (sum != 0) sums.emplace_back(region, sum);
        });
        return sums;
    }

    void check_hashes(const WorldData& data) {
        SolidData anew = data.solid.data();
        const std::uint64_t points = anew.point_sum;
        hash_points_anew(anew);
        if (anew.point_sum != points) return report("the hash of the solid is not that of its faces", {});
        if (sums_of(anew.points) != sums_of(data.solid.data().points))
            return report("a region's hash of points is not that of its points", {});
        for (const FaceStore* store : {&data.solid.data().faces, &data.castable}) {
            FaceSums sums;
            FaceStore counted;
            if (store->root)
                for_each_block(*store->root, [&](const Block& block) {
                    for (const FaceRecord& face : block.faces) sums.add(block, face);
                });
            sums.add_to(counted);
            if (counted.hash != store->hash || counted.count != store->count)
                return report("a hash of faces is not that of the faces", {});
            if (sums_of(counted.regions) != sums_of(store->regions))
                return report("a region's hash of faces is not that of its faces", {});
        }
        std::uint64_t sum = 0;
        for (std::uint32_t k = 0; k < data.cells.room_count(); ++k)
            sum += hash_room(k, data.cells.room(k), data.faces_of(k));
        for (std::uint32_t k = 0; k < data.cells.portal_count(); ++k) sum += data.cells.hash_of_portal(k);
        if (sum != data.room_hashes + data.cells.hash()) report("the hash of rooms and portals is not theirs", {});
    }

    std::optional<WorldFault> fault_;
    std::vector<std::uint32_t> ids_;
    std::vector<const Node*> leaves_, in_rooms_;                  ///< of the stores, and of all rooms
    std::vector<std::pair<std::uint32_t, std::uint32_t>> parts_;  ///< of each block in a room, and the room
    bool in_store_ = false, solid_ = false;
    std::size_t faces_ = 0;
    std::uint64_t hash_ = 0;
    std::uint32_t room_ = 0;
};

}  // namespace

std::optional<WorldFault> check_world(const World& world) {
    return Checker().check(world);
}

}  // namespace firma
