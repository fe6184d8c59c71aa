// SPDX-License-Identifier: MIT
// A world's hash: sums that edits keep, and what little there is besides.
#include "world/add_text.h"
#include "world/world_data.h"

namespace firma {

std::uint64_t hash_world(const World& world) {
    const WorldData& data = world.data();
    Hasher hasher;
    hasher.add(data.version);
    hasher.add(data.next_face(), data.edits());
    hasher.add(std::uint32_t(data.rock_outside()), std::uint32_t(data.cells.known()));
    hasher.add(data.tolerance.contact_offset);
    hasher.add(data.materials ? data.materials->size() : std::size_t(0));
    if (data.materials)
        for (const std::string& name : *data.materials) add_text(hasher, name);
    hasher.add(data.cells.room_count(), data.cells.portal_count());
    hasher.add(data.room_hashes + data.cells.hash());
    if (data.matters) hasher.add(data.matters->hash);
    return hasher.value();
}

std::uint64_t hash_room(const World& world, RoomId room) {
    const WorldData& data = world.data();
    if (room.value >= data.cells.room_count()) return 0;
    return hash_room(room.value, data.cells.room(room.value), data.faces_of(room.value));
}

std::vector<RegionHash> hash_regions(const World& world) {
    const WorldData& data = world.data();
    return region_hashes({&data.solid.data().faces.regions, &data.castable.regions}, data.solid.data().points);
}

std::uint64_t hash_solid(const World& world) {
    return hash_solid(world.solid());
}

bool same_solid(const World& a, const World& b) {
    return same_solid(a.solid(), b.solid());
}

std::optional<SolidFault> check_solid(const World& world) {
    return check_solid(world.solid());
}

SolidMeasures measure_solid(const World& world) {
    return measure_solid(world.solid());
}

}  // namespace firma
