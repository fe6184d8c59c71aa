// SPDX-License-Identifier: MIT
// How much memory worlds hold: each block, room and owner once, by address. Only a sum comes out, so no order shows.
#include "firma/memory.h"

#include <unordered_set>

#include "tree/statistics.h"
#include "world/world_data.h"

namespace firma {
namespace {

class Counter {
public:
    void add(const World& world) {
        const WorldData& data = world.data();
        if (is_new(&data)) bytes_ += sizeof data + data.rooms.capacity() * sizeof(data.rooms[0]);
        if (data.materials && is_new(data.materials.get())) add(*data.materials);
        if (data.room_records && is_new(data.room_records.get())) bytes_ += bytes_of(*data.room_records);
        if (data.portals && is_new(data.portals.get())) bytes_ += data.portals->bytes();
        if (data.closed && is_new(data.closed.get())) bytes_ += data.closed->bytes();
        if (data.room_boxes && is_new(data.room_boxes.get())) bytes_ += sizeof(BoxTree) + data.room_boxes->bytes();
        for (const Ref<const Room>& room : data.rooms) {
            if (!is_new(room.get())) continue;
            bytes_ += pool_size(sizeof(Room));
            if (room->tree) add(*room->tree);
        }
    }
    std::size_t bytes() const { return bytes_; }

private:
    bool is_new(const void* object) { return seen_.insert(object).second; }

    void add(const std::vector<std::string>& names) {
        bytes_ += sizeof names + names.capacity() * sizeof(std::string);
        const std::size_t inside = std::string().capacity();
        for (const std::string& name : names)
            if (name.capacity() > inside) bytes_ += name.capacity() + 1;
    }

    void add(const Block& block) {
        if (!is_new(&block)) return;
        bytes_ += bytes_of(block);
        for (const Ref<const FaceOwner>& owner : block.owners)
            if (is_new(owner.get())) bytes_ += owner->bytes();
        for (const Ref<const Block>& child : block.children) add(*child);
    }

    std::unordered_set<const void*> seen_;
    std::size_t bytes_ = 0;
};

}  // namespace

std::size_t bytes_of(const std::vector<RoomRecord>& records) {
    std::size_t sum = sizeof records + records.capacity() * sizeof(RoomRecord);
    for (const RoomRecord& record : records)
        if (record.name.capacity() > std::string().capacity()) sum += record.name.capacity() + 1;
    return sum;
}

std::size_t memory_used(std::span<const World> worlds) {
    Counter counter;
    for (const World& world : worlds) counter.add(world);
    return counter.bytes();
}

}  // namespace firma
