// SPDX-License-Identifier: MIT
// What a version holds alone: nodes, blocks and rooms by address, and the exact faces that no shared block keeps.
#include "store/bytes_alone.h"

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "index/statistics.h"
#include "index/unshared_nodes.h"
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
std::vector<OwnerUse> owners_of(const std::vector<const Block*>& blocks) {
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

/// Of what is beside the faces.
std::size_t bytes_of_cells_alone(const Cells& mine, const Cells& theirs) {
    std::size_t sum = mine.rooms().bytes_unshared(theirs.rooms()) + mine.portals().bytes_unshared(theirs.portals());
    if (mine.boxes() && mine.boxes() != theirs.boxes())
        sum += sizeof(PortalBoxes) + mine.boxes()->tree.bytes() +
               mine.boxes()->portals.capacity() * sizeof(std::uint32_t);
    mine.rooms().for_each_unshared(
        theirs.rooms(), [&](std::uint32_t, const Ref<const Room>* own, const Ref<const Room>* other) {
            if (!own || (other && own->get() == other->get())) return;
            sum += pool_size(sizeof(Room));
            if (!other || (*own)->record != (*other)->record) sum += bytes_of(*(*own)->record);
        });
    mine.portals().for_each_unshared(theirs.portals(),
                                     [&](std::uint32_t, const PortalState* own, const PortalState* other) {
                                         if (own && (!other || own->portal.get() != other->portal.get()))
                                             sum += own->portal->bytes();
                                     });
    return sum;
}

/// Indices of the rooms that two worlds do not share, of their solids, and of what is castable only.
void add_roots(const WorldData& mine, const WorldData& theirs, std::vector<const Node*>& my_roots,
               std::vector<const Node*>& their_roots) {
    const auto add = [&](const Ref<const Node>& own, const Ref<const Node>& other) {
        if (own.get() == other.get()) return;
        if (own) my_roots.push_back(own.get());
        if (other) their_roots.push_back(other.get());
    };
    add(mine.solid.data().faces.root, theirs.solid.data().faces.root);
    add(mine.castable.root, theirs.castable.root);
    mine.cells.rooms().for_each_unshared(
        theirs.cells.rooms(), [&](std::uint32_t, const Ref<const Room>* own, const Ref<const Room>* other) {
            add(own ? (*own)->tree : Ref<const Node>(), other ? (*other)->tree : Ref<const Node>());
        });
}

/// Each once, in order of address.
template <class Object>
void sort_once(std::vector<const Object*>& objects) {
    std::sort(objects.begin(), objects.end(), std::less<const Object*>());
    objects.erase(std::unique(objects.begin(), objects.end()), objects.end());
}

std::vector<const Block*> blocks_of(const std::vector<const Node*>& nodes) {
    std::vector<const Block*> blocks;
    for (const Node* node : nodes)
        if (node->is_leaf()) blocks.push_back(&block_of(*node));
    sort_once(blocks);
    return blocks;
}

}  // namespace

std::size_t bytes_alone(const World& world, const World& other) {
    const WorldData &mine = world.data(), &theirs = other.data();
    if (&mine == &theirs) return 0;
    std::size_t sum = sizeof mine;
    if (&mine.solid.data() != &theirs.solid.data()) sum += sizeof(SolidData);
    if (mine.materials != theirs.materials) sum += bytes_of(mine.materials.get());
    sum += bytes_of_cells_alone(mine.cells, theirs.cells);
    const SolidData &my_solid = mine.solid.data(), &their_solid = theirs.solid.data();
    sum += my_solid.points.bytes_unshared(their_solid.points) +
           my_solid.faces.regions.bytes_unshared(their_solid.faces.regions);
    std::vector<const Node*> my_roots, their_roots;
    add_roots(mine, theirs, my_roots, their_roots);
    // A node may be in several indices.
    sort_once(my_roots);
    sort_once(their_roots);
    UnsharedNodes all = unshared_nodes(my_roots, their_roots);
    sort_once(all.before);
    for (const Node* node : all.before) sum += bytes_of(*node);
    const std::vector<const Block*> my_blocks = blocks_of(all.before), their_blocks = blocks_of(all.after);
    for (const Block* block : my_blocks)
        if (!std::binary_search(their_blocks.begin(), their_blocks.end(), block, std::less<const Block*>()))
            sum += block->bytes();
    const std::vector<OwnerUse> kept = owners_of(their_blocks);
    for (const OwnerUse& use : owners_of(my_blocks))
        if (!use.is_elsewhere() && !std::binary_search(kept.begin(), kept.end(), use, by_address))
            sum += use.owner->bytes();
    return sum;
}

}  // namespace firma
