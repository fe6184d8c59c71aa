// SPDX-License-Identifier: MIT
// What a World is a handle to. Nothing in it changes once published.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/pool.h"
#include "base/ref.h"
#include "firma/carve_rules.h"
#include "firma/tolerance.h"
#include "firma/tree_options.h"
#include "firma/world.h"
#include "tree/block.h"
#include "tree/box_tree.h"
#include "world/portal_set.h"

namespace firma {

/// A volume of air: its faces, in a tree. Rooms name each other by id, never by pointer.
class Room : public RefCounted, public Pooled {
public:
    Ref<const Block> tree;  ///< null for a room without faces
};

/// What a room is besides its faces.
struct RoomRecord {
    std::string name;
    bool exterior = false;          ///< it reaches to infinity
    std::uint32_t merged_into = 0;  ///< itself; of a room that an edit made part of another: that one, to be followed
};

struct WorldData {
    std::vector<Ref<const Room>> rooms;
    std::shared_ptr<const std::vector<RoomRecord>> room_records;  ///< null: one room, and nothing to say of it
    std::shared_ptr<const PortalSet> portals;                     ///< null: none
    std::shared_ptr<const ClosedPortals> closed;                  ///< null: none is
    std::shared_ptr<const BoxTree> room_boxes;                    ///< around rooms, or a little wider; null: few rooms
    bool knows_walls = true;  ///< of several rooms: some face bounds the solid, so that rays from a point tell its room
    std::shared_ptr<const std::vector<std::string>> materials;
    Tolerance tolerance;
    TreeOptions tree_options;  ///< how trees are built, and rebuilt by edits
    std::uint64_t version = 0;
    std::size_t face_count = 0;
    std::uint32_t next_face = 0;              ///< the id that the next new face gets
    std::uint32_t edits = 0;                  ///< cuts so far: the next one's faces say they come from edit `edits + 1`
    bool rock_outside = false;                ///< whether what no face separates from infinity is solid
    std::shared_ptr<const CarveRules> rules;  ///< null: none
};

/// Memory of what rooms are besides their faces, with its strings.
std::size_t bytes_of(const std::vector<RoomRecord>& records);

/// Makes `room_boxes` fit the rooms, where there are so many that casts want them; keeps what fits.
void fit_room_boxes(WorldData& data);

/// Sets what follows from new rooms and their faces: `room_boxes` and `knows_walls`.
void finish_rooms(WorldData& data);

/// The room that a room is by now part of: itself, as long as no edit joined it to another.
inline std::uint32_t current_room(const WorldData& data, std::uint32_t room) {
    if (!data.room_records) return room;
    while ((*data.room_records)[room].merged_into != room) room = (*data.room_records)[room].merged_into;
    return room;
}

/// A copy to be filled by an edit: one version on, sharing every room until it is replaced. `face_count` and
/// `next_face` are for the edit to bring up to date.
inline std::shared_ptr<WorldData> next_version(const WorldData& data) {
    auto next = std::make_shared<WorldData>(data);
    ++next->version;
    return next;
}

}  // namespace firma
