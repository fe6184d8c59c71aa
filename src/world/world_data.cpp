// SPDX-License-Identifier: MIT
// A world's parts set, one at a time.
#include "world/world_data.h"

#include <utility>

namespace firma {

void WorldData::set_room(std::uint32_t number, std::shared_ptr<const RoomRecord> record, Ref<const RoomFaces> faces) {
    if (number < cells.room_count()) room_hashes -= hash_room(number, cells.room(number), faces_of(number));
    room_hashes += hash_room(number, *record, *faces);
    cells.set_room(number, std::move(record));
    room_faces.set(number, std::move(faces));
}

void WorldData::set_faces(RoomFacesMap faces) {
    room_faces = std::move(faces);
    room_hashes = 0;
    for (std::uint32_t k = 0; k < cells.room_count(); ++k) room_hashes += hash_room(k, cells.room(k), faces_of(k));
}

}  // namespace firma
