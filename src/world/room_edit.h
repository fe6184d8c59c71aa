// SPDX-License-Identifier: MIT
// What a change to the solid does to rooms: which of them it touches, and the cells after it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/flat_map.h"
#include "index/edit_nodes.h"
#include "solid/change_solid.h"
#include "world/world_data.h"

namespace firma {

/// Rooms that an edit touches become one. In a world of one room without a name all of this says "room 0".
class RoomEdit {
public:
    /// @param before  kept alive by the caller, as is all that is given here
    explicit RoomEdit(const WorldData& before) : before_(before) {}

    /// A room of which a face goes.
    void touch(std::uint32_t part);
    /// Both rooms of each portal that meets a box.
    void touch_portals(const GridBox& box);
    bool any() const { return !rooms_.empty(); }
    /// The part of the faces that come, of the cutter and of no room yet: the lowest of the rooms, or a new one.
    std::uint32_t target() const { return std::min(lowest_, before_.cells.room_count()); }

    /// Begins to edit the index of what the rooms become.
    void start(const SolidEdit& solid);
    /// Does one piece of work; false once there is none left.
    bool step();

    /// Once step() said false: puts the cells after the edit in place.
    void publish(WorldData& next) const;

private:
    bool touched(std::uint32_t room) const;
    bool shares_the_solids_index() const;
    std::vector<PortalId> join_portals(Cells& next, std::vector<PortalId>& joined) const;

    const WorldData& before_;
    std::vector<std::uint32_t> rooms_;  ///< each once; ascending from start() on
    FlatMap known_;                     ///< those that are among them
    std::uint32_t lowest_ = ~0u;        ///< of them
    std::vector<NodeEdit> edits_;       ///< of the one index over all of them; none: it is the solid's
    Ref<const Node> index_;
    const SolidEdit* solid_ = nullptr;
};

}  // namespace firma
