// SPDX-License-Identifier: MIT
// The trees that an edit looks into, and the rooms that it ends in.
#pragma once

#include <cstdint>
#include <vector>

#include "base/ref.h"
#include "geometry/grid_box.h"
#include "world/world_data.h"

namespace firma {

struct RoomTree {
    std::uint32_t room = 0;
    const Block* root = nullptr;
};

/// Trees of the rooms whose faces may meet a box, by room; for what edits do, the order counts.
std::vector<RoomTree> trees_near(const WorldData& data, const GridBox& box);

/// Rooms that an edit touches: they become one. In a world of one room without a name all of this says "room 0".
class RoomJoin {
public:
    explicit RoomJoin(const WorldData& data) : data_(&data) {}

    /// A room of which a face goes, or where faces come.
    void touch(std::uint32_t room);
    /// Both rooms of each portal that meets a box.
    void touch_portals(const GridBox& box);
    bool any() const { return !rooms_.empty(); }

    /// The tree to be edited: that of the one room, or one over those of all. None was touched: of a new room.
    /// All faces of touched rooms must be looked for in it by block and slot, as before.
    Ref<const Block> tree() const;

    /// Puts the edited tree in its room, and what else changes with that: rooms that became part of it, portals.
    /// @param next  a copy of the world's data
    void publish(WorldData& next, Ref<const Block> tree) const;

private:
    std::uint32_t target() const { return rooms_.empty() ? std::uint32_t(data_->rooms.size()) : rooms_[0]; }
    bool touched(std::uint32_t room) const;
    void publish_records(WorldData& next) const;
    void publish_portals(WorldData& next) const;

    const WorldData* data_;
    std::vector<std::uint32_t> rooms_;  ///< ascending, each once
};

}  // namespace firma
