// SPDX-License-Identifier: MIT
// What a change to the solid does to rooms.
#include "world/room_edit.h"

#include <algorithm>

#include "index/join_nodes.h"

namespace firma {

void RoomEdit::touch(std::uint32_t part) {
    const std::uint32_t room = before_.cells.current_room(part);
    const auto at = std::lower_bound(rooms_.begin(), rooms_.end(), room);
    if (at == rooms_.end() || *at != room) rooms_.insert(at, room);
}

void RoomEdit::touch_portals(const GridBox& box) {
    before_.cells.for_each_portal_where([&](const GridBox& other) { return boxes_meet(box, other); },
                                        [&](std::uint32_t, const Portal& portal) {
                                            for (const PortalPolygon& polygon : portal.polygons()) {
                                                GridBox own;
                                                for (const GridPoint& corner : polygon.corners) own.add(corner);
                                                if (!boxes_meet(box, own)) continue;
                                                for (const RoomId room : portal.rooms) touch(room.value);
                                            }
                                        });
}

bool RoomEdit::touched(std::uint32_t room) const {
    return std::binary_search(rooms_.begin(), rooms_.end(), room);
}

/// With nothing but the solid in one room, both are one index.
bool RoomEdit::shares_the_solids_index() const {
    return before_.cells.room_count() == 1 && !rooms_.empty() &&
           before_.cells.room(0).tree.get() == before_.solid.data().faces.root.get();
}

void RoomEdit::start(const SolidEdit& solid) {
    solid_ = &solid;
    index_ = {};
    edits_.clear();
    if (shares_the_solids_index()) {
        index_ = solid.result().data().faces.root;
        return;
    }
    std::vector<Ref<const Node>> indices;
    for (const std::uint32_t room : rooms_)
        if (before_.cells.room(room).tree) indices.push_back(before_.cells.room(room).tree);
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

void RoomEdit::publish(WorldData& next) const {
    const Cells& cells = before_.cells;
    Ref<Room> made(new Room);
    made->tree = index_;
    RoomRecord record;
    record.merged_into = target();
    if (!rooms_.empty()) record = *cells.room(target()).record;
    for (const std::uint32_t room : rooms_) {
        made->faces += cells.room(room).faces;
        made->face_hash += cells.room(room).face_hash;
        record.exterior |= cells.room(room).record->exterior;
    }
    for (const PartChange& change : solid_->store().parts()) {
        made->faces += std::size_t(change.faces);
        made->face_hash += change.hash;
    }
    if (rooms_.size() > 1) {
        // Portals between them go, others lead to the one that they become.
        std::vector<std::uint32_t> portals;
        for (const std::uint32_t room : rooms_)
            for (const std::uint32_t portal : cells.portals_of(room)) portals.push_back(portal);
        std::sort(portals.begin(), portals.end());
        portals.erase(std::unique(portals.begin(), portals.end()), portals.end());
        record.portals.clear();
        for (const std::uint32_t number : portals) {
            PortalPart part = cells.portal(number).part();
            for (RoomId& room : part.rooms)
                if (touched(room.value)) room = {target()};
            const bool goes = part.rooms[0] == part.rooms[1];
            if (goes) part.polygons.clear();
            if (!goes) record.portals.push_back(number);
            next.cells.set_portal(number, Ref<const Portal>(new Portal(std::move(part))),
                                  !goes && cells.is_closed(number));
        }
        for (const std::uint32_t room : rooms_) {
            if (room == target()) continue;
            Ref<Room> empty(new Room);
            RoomRecord merged = *cells.room(room).record;
            merged.exterior = false;
            merged.merged_into = target();
            merged.portals.clear();
            empty->record = std::make_shared<const RoomRecord>(std::move(merged));
            next.cells.set_room(room, Ref<const Room>(empty.get()));
        }
    }
    const bool same_record = rooms_.size() == 1;
    made->record = same_record ? cells.room(target()).record : std::make_shared<const RoomRecord>(std::move(record));
    next.cells.set_room(target(), Ref<const Room>(made.get()));
}

}  // namespace firma
