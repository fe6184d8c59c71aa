// SPDX-License-Identifier: MIT
// What each of two versions holds alone: blocks and rooms by address, and the exact faces that no shared block keeps.
#include "store/bytes_apart.h"

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

/// Of owners that `mine` alone holds.
std::size_t bytes_alone(const std::vector<OwnerUse>& mine, const std::vector<OwnerUse>& others) {
    std::size_t sum = 0;
    for (const OwnerUse& use : mine)
        if (!use.is_elsewhere() && !std::binary_search(others.begin(), others.end(), use, by_address))
            sum += use.owner->bytes();
    return sum;
}

std::size_t bytes_alone(std::span<const Block* const> blocks) {
    std::size_t sum = 0;
    for (const Block* block : blocks) sum += bytes_of(*block);
    return sum;
}

std::size_t bytes_of(const std::vector<std::string>* names) {
    if (!names) return 0;
    std::size_t sum = sizeof *names + names->capacity() * sizeof(std::string);
    for (const std::string& name : *names)
        if (name.capacity() > std::string().capacity()) sum += name.capacity() + 1;
    return sum;
}

std::size_t bytes_of_handle(const WorldData& data) {
    return sizeof data + data.rooms.capacity() * sizeof(data.rooms[0]);
}

}  // namespace

BytesApart bytes_apart(const World& before, const World& after) {
    const WorldData &old_data = before.data(), &new_data = after.data();
    if (&old_data == &new_data) return {};
    BytesApart apart{bytes_of_handle(old_data), bytes_of_handle(new_data)};
    if (old_data.materials != new_data.materials) {
        apart.gone += bytes_of(old_data.materials.get());
        apart.come += bytes_of(new_data.materials.get());
    }
    const auto &olds = old_data.rooms, &news = new_data.rooms;
    UnsharedBlocks all;
    for (std::size_t k = 0; k < std::max(olds.size(), news.size()); ++k) {
        const Room* old_room = k < olds.size() ? olds[k].get() : nullptr;
        const Room* new_room = k < news.size() ? news[k].get() : nullptr;
        if (old_room == new_room) continue;
        apart.gone += old_room ? pool_size(sizeof(Room)) : 0;
        apart.come += new_room ? pool_size(sizeof(Room)) : 0;
        const UnsharedBlocks found = unshared_blocks(old_room ? old_room->tree.get() : nullptr,  //
                                                     new_room ? new_room->tree.get() : nullptr);
        all.before.insert(all.before.end(), found.before.begin(), found.before.end());
        all.after.insert(all.after.end(), found.after.begin(), found.after.end());
    }
    const std::vector<OwnerUse> old_owners = owners_of(all.before), new_owners = owners_of(all.after);
    apart.gone += bytes_alone(all.before) + bytes_alone(old_owners, new_owners);
    apart.come += bytes_alone(all.after) + bytes_alone(new_owners, old_owners);
    return apart;
}

}  // namespace firma
