// SPDX-License-Identifier: MIT
// The rooms of an edit.
#include "carve/room_trees.h"

#include <algorithm>

#include "tree/append_faces.h"
#include "tree/build_blocks.h"
#include "tree/join_blocks.h"
#include "tree/rounded_box.h"

namespace firma {
namespace {

/// A joined tree deeper than this is built anew: joins one after another would make it ever deeper.
constexpr int kDeepestJoin = 48;

Ref<const Block> build_anew(const std::vector<Ref<const Block>>& roots, const TreeOptions& options) {
    FaceSet faces;
    for (const Ref<const Block>& root : roots) append_all_faces(*root, faces);
    return build_blocks(faces, options);
}

Ref<const Block> join(const std::vector<Ref<const Block>>& roots, const TreeOptions& options) {
    if (roots.empty()) return {};
    if (roots.size() == 1) return roots[0];
    if (roots.size() > kBlockItems) return build_anew(roots, options);
    for (const Ref<const Block>& root : roots)
        if (root->depth > kDeepestJoin) return build_anew(roots, options);
    std::vector<BlockItem> items;
    for (const Ref<const Block>& root : roots) items.push_back(BlockItem::of(*root, true));
    BlockJoiner joiner;
    joiner.divide(items);
    std::vector<std::uint32_t> nodes;
    joiner.group(kBlockItems, nodes);
    return joiner.join(items, nodes[0]);
}

}  // namespace

std::vector<RoomTree> trees_near(const WorldData& data, const GridBox& box) {
    std::vector<RoomTree> trees;
    const auto add = [&](std::uint32_t room) {
        const Block* root = data.rooms[room]->tree.get();
        if (root && boxes_meet(box, to_grid(root->bins[0].box))) trees.push_back({room, root});
        return false;
    };
    if (data.room_boxes)
        data.room_boxes->for_each_meeting(box, add);
    else
        for (std::uint32_t room = 0; room < data.rooms.size(); ++room) add(room);
    std::sort(trees.begin(), trees.end(), [](const RoomTree& a, const RoomTree& b) { return a.room < b.room; });
    return trees;
}

void RoomJoin::touch(std::uint32_t room) {
    const auto at = std::lower_bound(rooms_.begin(), rooms_.end(), room);
    if (at == rooms_.end() || *at != room) rooms_.insert(at, room);
}

void RoomJoin::touch_portals(const GridBox& box) {
    if (!data_->portals) return;
    const PortalSet& portals = *data_->portals;
    portals.boxes().for_each_meeting(box, [&](std::uint32_t number) {
        const Portal& portal = portals.portals()[portals.portal_of_box(number)];
        for (const PortalPolygon& polygon : portals.polygons_of(portal)) {
            GridBox own;
            for (const GridPoint& corner : polygon.corners) own.add(corner);
            if (!boxes_meet(box, own)) continue;
            for (const RoomId room : portal.rooms) touch(room.value);
        }
        return false;
    });
}

bool RoomJoin::touched(std::uint32_t room) const {
    return std::binary_search(rooms_.begin(), rooms_.end(), room);
}

Ref<const Block> RoomJoin::tree() const {
    std::vector<Ref<const Block>> roots;
    for (const std::uint32_t room : rooms_)
        if (data_->rooms[room]->tree) roots.push_back(data_->rooms[room]->tree);
    return join(roots, data_->tree_options);
}

void RoomJoin::publish(WorldData& next, Ref<const Block> tree) const {
    Ref<Room> room(new Room);
    room->tree = std::move(tree);
    if (target() == next.rooms.size()) next.rooms.emplace_back();
    next.rooms[target()] = Ref<const Room>(room.get());
    if (!next.room_records) return;
    for (std::size_t k = 1; k < rooms_.size(); ++k) next.rooms[rooms_[k]] = Ref<const Room>(new Room);
    publish_records(next);
    if (rooms_.size() > 1 && next.portals) publish_portals(next);
    fit_room_boxes(next);
}

void RoomJoin::publish_records(WorldData& next) const {
    if (rooms_.size() == 1) return;
    std::vector<RoomRecord> records = *next.room_records;
    if (rooms_.empty()) records.push_back({{}, false, target()});
    for (std::size_t k = 1; k < rooms_.size(); ++k) {
        RoomRecord& record = records[rooms_[k]];
        records[target()].exterior |= record.exterior;
        record.exterior = false;
        record.merged_into = target();
    }
    next.room_records = std::make_shared<const std::vector<RoomRecord>>(std::move(records));
}

void RoomJoin::publish_portals(WorldData& next) const {
    std::vector<PortalPart> parts;
    std::vector<std::uint8_t> closed;
    for (std::uint32_t k = 0; k < next.portals->portals().size(); ++k) {
        PortalPart part = next.portals->part(k);
        for (RoomId& room : part.rooms)
            if (touched(room.value)) room = {target()};
        if (part.rooms[0] == part.rooms[1]) part.polygons.clear();
        closed.push_back(next.closed && next.closed->is_closed[k] && !part.polygons.empty());
        parts.push_back(std::move(part));
    }
    next.portals = std::make_shared<const PortalSet>(parts, next.rooms.size());
    const bool any = std::find(closed.begin(), closed.end(), 1) != closed.end();
    next.closed = any ? std::make_shared<const ClosedPortals>(std::move(closed)) : nullptr;
}

}  // namespace firma
