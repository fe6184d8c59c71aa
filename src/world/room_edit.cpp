// SPDX-License-Identifier: MIT
// What a change to the solid does to rooms.
#include "world/room_edit.h"

#include <algorithm>

#include "index/join_nodes.h"

namespace firma {

void RoomEdit::touch(std::uint32_t part) {
    const std::uint32_t room = before_.cells.current_room(part);
    if (std::uint32_t& known = known_.at(room); known == FlatMap::kNone) {
        known = 0;
        rooms_.push_back(room);
        lowest_ = std::min(lowest_, room);
    }
}

void RoomEdit::touch_portals(const GridBox& box) {
    before_.cells.for_each_portal_where([&](const GridBox& other) { return boxes_meet(box, other); },
                                        [&](std::uint32_t, const Portal& portal) {
                                            for (const PortalPolygon& polygon : portal.polygons()) {
                                                GridBox own;
                                                for (const GridPoint& corner : polygon.corners) own.add(corner);
                                                if (!boxes_meet(box, own)) continue;
                                                for (const RoomId room : portal.made_between) touch(room.value);
                                            }
                                        });
}

bool RoomEdit::touched(std::uint32_t room) const {
    return std::binary_search(rooms_.begin(), rooms_.end(), room);
}

/// With nothing but the solid in one room, both are one index.
bool RoomEdit::shares_the_solids_index() const {
    return before_.cells.room_count() == 1 && !rooms_.empty() &&
           before_.faces_of(0).tree.get() == before_.solid.data().faces.root.get();
}

void RoomEdit::start(const SolidEdit& solid) {
    std::sort(rooms_.begin(), rooms_.end());
    solid_ = &solid;
    index_ = {};
    edits_.clear();
    if (shares_the_solids_index()) {
        index_ = solid.result().data().faces.root;
        return;
    }
    std::vector<Ref<const Node>> indices;
    for (const std::uint32_t room : rooms_)
        if (const Ref<const Node>& tree = before_.faces_of(room).tree) indices.push_back(tree);
    NodeEdit& edit = edits_.emplace_back(join_nodes(indices));
    for (const Block* block : solid.store().removed()) edit.remove(block, block->box());
    for (const Ref<const Node>& leaf : solid.store().added()) edit.add(leaf);
}

bool RoomEdit::step() {
    if (edits_.empty()) return false;
    if (edits_[0].step()) return true;
    index_ = edits_[0].result();
    return false;
}

/// Portals between the rooms that become one go, others lead to that one: they are looked at one by one in all rooms
/// but the one of the most.
/// @return those whose terms of the hash may change: up to Cells::kCrowd more than were looked at
std::vector<PortalId> RoomEdit::join_portals(Cells& next, std::vector<PortalId>& joined) const {
    const Cells& cells = before_.cells;
    const auto sort_once = [](std::vector<PortalId>& numbers) {
        std::sort(numbers.begin(), numbers.end());
        numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    };
    std::uint32_t largest = target();
    for (const std::uint32_t room : rooms_)
        if (cells.portals_of(room).size() > cells.portals_of(largest).size()) largest = room;
    std::vector<PortalId> changed;
    for (const std::uint32_t room : rooms_) {
        const auto portals = cells.portals_of(room);
        if (room != largest) changed.insert(changed.end(), portals.begin(), portals.end());
    }
    sort_once(changed);

    const auto all = cells.portals_of(largest);
    auto rest = all.begin();
    joined.reserve(all.size() + changed.size());
    for (const PortalId id : changed) {
        const auto here = std::lower_bound(rest, all.end(), id);
        joined.insert(joined.end(), rest, here);
        rest = here + (here != all.end() && *here == id);
        const Portal& portal = cells.portal(id.value);
        const std::array<RoomId, 2> rooms = cells.rooms_of(portal);
        if (!touched(rooms[0].value) || !touched(rooms[1].value)) {
            joined.push_back(id);
            continue;
        }
        const RoomId into{target()};
        PortalPart gone{{into, into}, {}, portal.name, portal.material, portal.mask};
        next.set_portal(id.value, Ref<const Portal>(new Portal(std::move(gone))), false);
    }
    joined.insert(joined.end(), rest, all.end());
    if (all.size() <= Cells::kCrowd || joined.size() <= Cells::kCrowd) {
        changed.insert(changed.end(), all.begin(), all.end());
        sort_once(changed);
    }
    return changed;
}

void RoomEdit::publish(WorldData& next) const {
    const Cells& cells = before_.cells;
    Ref<RoomFaces> made(new RoomFaces);
    made->tree = index_;
    RoomRecord record;
    record.merged_into = target();
    for (const std::uint32_t room : rooms_) {
        made->count += before_.faces_of(room).count;
        made->hash += before_.faces_of(room).hash;
        record.exterior |= cells.room(room).exterior;
    }
    for (const PartChange& change : solid_->store().parts()) {
        made->count += std::size_t(change.faces);
        made->hash += change.hash;
    }
    std::vector<PortalId> portals;
    if (rooms_.size() > 1) {
        record.name = cells.room(target()).name;
        portals = join_portals(next.cells, record.portals);
        record.portal_box = next.cells.box_of(record.portals);
        next.cells.take_out(portals);
        for (const std::uint32_t room : rooms_) {
            if (room == target()) continue;
            next.set_room(
                room, std::make_shared<const RoomRecord>(RoomRecord{cells.room(room).name, false, target(), {}, {}}),
                Ref<const RoomFaces>(new RoomFaces));
        }
    }
    const bool same_record = rooms_.size() == 1;
    next.set_room(target(),
                  same_record ? cells.record(target()) : std::make_shared<const RoomRecord>(std::move(record)),
                  Ref<const RoomFaces>(made.get()));
    next.cells.put_in(portals);
}

}  // namespace firma
