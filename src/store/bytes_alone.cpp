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

/// Each once, in order of address.
template <class Object>
void sort_once(std::vector<const Object*>& objects) {
    std::sort(objects.begin(), objects.end(), std::less<const Object*>());
    objects.erase(std::unique(objects.begin(), objects.end()), objects.end());
}

/// Roots of indices that only one of two worlds has.
struct Roots {
    std::vector<const Node*> mine, theirs;
    void add(const Ref<const Node>& own, const Ref<const Node>& other) {
        if (own.get() == other.get()) return;
        if (own) mine.push_back(own.get());
        if (other) theirs.push_back(other.get());
    }
};

/// Of what is beside the faces.
std::size_t bytes_of_cells_alone(const Cells& mine, const Cells& theirs) {
    std::size_t sum = mine.rooms().bytes_unshared(theirs.rooms()) + mine.portals().bytes_unshared(theirs.portals()) +
                      mine.joined().bytes_unshared(theirs.joined());
    Roots portals;
    portals.add(mine.portal_index(), theirs.portal_index());
    mine.rooms().for_each_unshared(theirs.rooms(), [&](std::uint32_t, const auto* own, const auto* other) {
        if (own && (!other || *own != *other)) sum += bytes_of(**own);
        portals.add(own ? (*own)->portal_index : Ref<const Node>(), other ? (*other)->portal_index : Ref<const Node>());
    });
    std::vector<const Node*> nodes = unshared_nodes(portals.mine, portals.theirs).before;
    sort_once(nodes);
    for (const Node* node : nodes) sum += bytes_of(*node) + (node->is_leaf() ? node->facets->bytes() : 0);
    mine.portals().for_each_unshared(theirs.portals(),
                                     [&](std::uint32_t, const PortalState* own, const PortalState* other) {
                                         if (own && (!other || own->portal.get() != other->portal.get()))
                                             sum += own->portal->bytes();
                                     });
    return sum;
}

std::size_t bytes_of_room_faces_alone(const RoomFacesMap& mine, const RoomFacesMap& theirs) {
    std::size_t sum = mine.bytes_unshared(theirs);
    mine.for_each_unshared(theirs, [&](std::uint32_t, const auto* own, const auto* other) {
        if (own && (!other || own->get() != other->get())) sum += pool_size(sizeof(RoomFaces));
    });
    return sum;
}

/// Whether an index has a node, by its boxes.
bool has_node(const Node* root, const Node& wanted) {
    if (!root || root->facets_below < wanted.facets_below) return false;
    if (root == &wanted) return true;
    if (root->is_leaf()) return false;
    const auto below = [&](const auto& self, const WideNode& wide) -> bool {
        const unsigned around = lanes_around(wide, wanted.box);
        for (std::uint32_t lane = 0; around >> lane; ++lane) {
            if (!(around >> lane & 1)) continue;
            const Node* const child = root->node_below(wide, lane);
            if (child ? has_node(child, wanted) : self(self, *wide.wide(lane))) return true;
        }
        return false;
    };
    return below(below, root->wide[0]);
}

std::uint32_t part_below(const Node& node) {
    return node.is_leaf() ? block_of(node).part : part_below(*node.children[0]);
}

/// Nodes of indices over rooms may be nodes of the solid's index too, or of what is castable only: each once.
std::vector<const Node*> nodes_alone(const WorldData& mine, const WorldData& theirs, UnsharedNodes& of_stores) {
    Roots stores, rooms;
    stores.add(mine.solid.data().faces.root, theirs.solid.data().faces.root);
    stores.add(mine.castable.root, theirs.castable.root);
    mine.room_faces.for_each_unshared(
        theirs.room_faces, [&](std::uint32_t, const Ref<const RoomFaces>* own, const Ref<const RoomFaces>* other) {
            rooms.add(own ? (*own)->tree : Ref<const Node>(), other ? (*other)->tree : Ref<const Node>());
        });
    of_stores = unshared_nodes(stores.mine, stores.theirs);
    const auto in_their_rooms = [&](const Node& node) {
        const std::uint32_t part = part_below(node);
        if (part >= theirs.cells.room_count()) return false;
        return has_node(theirs.faces_of(theirs.cells.current_room(part)).tree.get(), node);
    };
    std::vector<const Node*> alone;
    for (const Node* node : of_stores.before)
        if (node->is_leaf() || !in_their_rooms(*node)) alone.push_back(node);
    for (const Node* node : unshared_nodes(rooms.mine, rooms.theirs).before)
        if (!node->is_leaf() && !has_node(theirs.solid.data().faces.root.get(), *node) &&
            !has_node(theirs.castable.root.get(), *node))
            alone.push_back(node);
    sort_once(alone);
    return alone;
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
    if (mine.textures && mine.textures != theirs.textures) sum += mine.textures->bytes();
    if (mine.matters && mine.matters != theirs.matters) sum += mine.matters->bytes();
    sum += bytes_of_cells_alone(mine.cells, theirs.cells);
    sum += bytes_of_room_faces_alone(mine.room_faces, theirs.room_faces);
    const SolidData &my_solid = mine.solid.data(), &their_solid = theirs.solid.data();
    sum += my_solid.points.bytes_unshared(their_solid.points) +
           my_solid.faces.regions.bytes_unshared(their_solid.faces.regions) +
           mine.castable.regions.bytes_unshared(theirs.castable.regions);
    UnsharedNodes of_stores;
    for (const Node* node : nodes_alone(mine, theirs, of_stores)) sum += bytes_of(*node);
    const std::vector<const Block*> my_blocks = blocks_of(of_stores.before), their_blocks = blocks_of(of_stores.after);
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
