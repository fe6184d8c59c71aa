// SPDX-License-Identifier: MIT
// What a version holds alone: blocks and rooms by address, and the exact faces that no shared block keeps.
#include "store/bytes_alone.h"

#include <algorithm>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "tree/statistics.h"
#include "tree/unshared_blocks.h"
#include "world/world_data.h"

namespace firma {
namespace {

/// An exact face as one side's unshared blocks know it.
struct OwnerUse {
    const FaceOwner* owner;
    std::size_t facets;  ///< of it, in these blocks

    /// Whether blocks that both versions have keep it as well.
    bool is_elsewhere() const { return facets < owner->facets; }
};

bool by_address(const OwnerUse& a, const OwnerUse& b) {
    return std::less<const FaceOwner*>()(a.owner, b.owner);
}

/// Each owner once, by address: for comparing with another such list, and nothing else.
std::vector<OwnerUse> owners_of(std::span<const Block* const> blocks) {
    std::vector<OwnerUse> uses;
    for (const Block* block : blocks) {
        const std::size_t first = uses.size();
        for (const Ref<const FaceOwner>& owner : block->owners) uses.push_back({owner.get(), 0});
        for (const FaceRecord& face : block->faces)
            if (face.owner != kNoOwner) ++uses[first + face.owner].facets;
    }
    std::sort(uses.begin(), uses.end(), by_address);
    std::size_t kept = 0;
    for (const OwnerUse& use : uses) {
        if (kept > 0 && uses[kept - 1].owner == use.owner)
            uses[kept - 1].facets += use.facets;
        else
            uses[kept++] = use;
    }
    uses.resize(kept);
    return uses;
}

std::size_t bytes_of(const std::vector<std::string>* names) {
    if (!names) return 0;
    std::size_t sum = sizeof *names + names->capacity() * sizeof(std::string);
    for (const std::string& name : *names)
        if (name.capacity() > std::string().capacity()) sum += name.capacity() + 1;
    return sum;
}

/// Of what is beside the rooms' faces.
std::size_t bytes_of_rooms_alone(const WorldData& mine, const WorldData& theirs) {
    std::size_t sum = 0;
    if (mine.room_records && mine.room_records != theirs.room_records) sum += bytes_of(*mine.room_records);
    if (mine.portals && mine.portals != theirs.portals) sum += mine.portals->bytes();
    if (mine.closed && mine.closed != theirs.closed) sum += mine.closed->bytes();
    if (mine.room_boxes && mine.room_boxes != theirs.room_boxes) sum += sizeof(BoxTree) + mine.room_boxes->bytes();
    return sum;
}

}  // namespace

std::size_t bytes_alone(const World& world, const World& other) {
    const WorldData &mine = world.data(), &theirs = other.data();
    if (&mine == &theirs) return 0;
    std::size_t sum = sizeof mine + mine.rooms.capacity() * sizeof(mine.rooms[0]);
    if (mine.materials != theirs.materials) sum += bytes_of(mine.materials.get());
    sum += bytes_of_rooms_alone(mine, theirs);
    std::vector<const Block*> my_roots, their_roots;  // a tree may be in another room of the other world
    for (std::size_t k = 0; k < std::max(mine.rooms.size(), theirs.rooms.size()); ++k) {
        const Room* my_room = k < mine.rooms.size() ? mine.rooms[k].get() : nullptr;
        const Room* their_room = k < theirs.rooms.size() ? theirs.rooms[k].get() : nullptr;
        if (my_room == their_room) continue;
        if (my_room) sum += pool_size(sizeof(Room));
        if (my_room && my_room->tree) my_roots.push_back(my_room->tree.get());
        if (their_room && their_room->tree) their_roots.push_back(their_room->tree.get());
    }
    const UnsharedBlocks all = unshared_blocks(my_roots, their_roots);
    for (const Block* block : all.before) sum += bytes_of(*block);
    const std::vector<OwnerUse> kept = owners_of(all.after);
    for (const OwnerUse& use : owners_of(all.before))
        if (!use.is_elsewhere() && !std::binary_search(kept.begin(), kept.end(), use, by_address))
            sum += use.owner->bytes();
    return sum;
}

}  // namespace firma
