// SPDX-License-Identifier: MIT
// What follows from the faces of rooms: an index over them, how many there are, their hash. It can be worked out anew
// from a solid, what is castable only, and the cells, and depends on nothing else.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>

#include "base/persistent_map.h"
#include "base/pool.h"
#include "base/ref.h"
#include "index/node.h"
#include "solid/face_store.h"
#include "world/cells.h"

namespace firma {

/// Of the faces whose part is a room, or one that became part of it.
struct RoomFaces : RefCounted, Pooled {
    Ref<const Node> tree;  ///< null for none
    std::size_t count = 0;
    std::uint64_t hash = 0;  ///< sum of hash_facet()
};

using RoomFacesMap = PersistentMap<Ref<const RoomFaces>>;

/// Of all rooms of some cells.
/// @param stores  of the solid, and of what is castable only; their parts are rooms of the cells
RoomFacesMap faces_of_rooms(const Cells& cells, std::initializer_list<const BuiltStore*> stores);

/// A store as it is, with an index over each of its parts and its sums. Costs all faces.
BuiltStore parts_of(const FaceStore& store);

/// All that a room is: a term of WorldData::room_hashes.
std::uint64_t hash_room(std::uint32_t number, const RoomRecord& record, const RoomFaces& faces);

}  // namespace firma
