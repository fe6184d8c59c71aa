// SPDX-License-Identifier: MIT
// How much memory worlds hold: each node, block, room and owner once, by address. Only a sum comes out, so no order
// shows.
#include "firma/memory.h"

#include "base/flat_map.h"
#include "index/statistics.h"
#include "world/world_data.h"

namespace firma {
namespace {

class Counter {
public:
    void add(const World& world) {
        const WorldData& data = world.data();
        if (is_new(&data)) bytes_ += sizeof data;
        if (data.materials && is_new(data.materials.get())) add(*data.materials);
        if (data.textures && is_new(data.textures.get())) bytes_ += data.textures->bytes();
        if (data.anchors && is_new(data.anchors.get())) bytes_ += sizeof(Anchors) + data.anchors->bytes();
        if (data.matters && is_new(data.matters.get())) add(*data.matters);
        const SolidData& solid = data.solid.data();
        if (is_new(&solid)) bytes_ += sizeof solid;
        add(solid.points);
        for (const FaceStore* store : {&solid.faces, &data.castable}) {
            add(store->regions);
            if (store->root) add(*store->root);
        }
        add(data.cells);
        add(data.room_faces);
    }
    std::size_t bytes() const { return bytes_; }

private:
    bool is_new(const void* object) {
        std::uint32_t& known = seen_.at(reinterpret_cast<std::uintptr_t>(object));
        if (known != FlatMap::kNone) return false;
        known = 0;
        return true;
    }

    void add(const std::vector<std::string>& names) {
        bytes_ += sizeof names + names.capacity() * sizeof(std::string);
        const std::size_t inside = std::string().capacity();
        for (const std::string& name : names)
            if (name.capacity() > inside) bytes_ += name.capacity() + 1;
    }

    void add(const MatterPieces& matters) {
        bytes_ += matters.bytes();
        for (const MatterPiece& piece : matters.pieces)
            if (piece.mesh && piece.mesh->data().faces.root) add(*piece.mesh->data().faces.root);
    }

    void add(const PersistentMap<std::uint64_t>& sums) {
        bytes_ += sums.bytes([&](const void* page) { return is_new(page); });
    }

    void add(const Cells& cells) {
        const auto is_new_page = [&](const void* page) { return is_new(page); };
        bytes_ +=
            cells.rooms().bytes(is_new_page) + cells.portals().bytes(is_new_page) + cells.joined().bytes(is_new_page);
        if (cells.portal_index()) add_portals(*cells.portal_index());
        cells.rooms().for_each([&](std::uint32_t, const std::shared_ptr<const RoomRecord>& record) {
            if (!is_new(record.get())) return;
            bytes_ += bytes_of(*record);
            if (record->portal_index) add_portals(*record->portal_index);
        });
        cells.portals().for_each([&](std::uint32_t, const PortalState& state) {
            if (is_new(state.portal.get())) bytes_ += state.portal->bytes();
        });
    }

    void add(const RoomFacesMap& rooms) {
        bytes_ += rooms.bytes([&](const void* page) { return is_new(page); });
        rooms.for_each([&](std::uint32_t, const Ref<const RoomFaces>& room) {
            if (!is_new(room.get())) return;
            bytes_ += pool_size(sizeof(RoomFaces));
            if (room->tree) add(*room->tree);
        });
    }

    void add_portals(const Node& node) {
        if (!is_new(&node)) return;
        bytes_ += bytes_of(node);
        for (const Ref<const Node>& child : node.children) add_portals(*child);
        if (node.is_leaf() && is_new(node.facets.get())) bytes_ += node.facets->bytes();
    }

    void add(const Node& node) {
        if (!is_new(&node)) return;
        bytes_ += bytes_of(node);
        for (const Ref<const Node>& child : node.children) add(*child);
        if (!node.is_leaf() || !is_new(node.facets.get())) return;
        const Block& block = block_of(node);
        bytes_ += block.bytes();
        for (const Ref<const FaceOwner>& owner : block.owners)
            if (is_new(owner.get())) bytes_ += owner->bytes();
    }

    FlatMap seen_;  ///< by address
    std::size_t bytes_ = 0;
};

}  // namespace

std::size_t memory_used(std::span<const World> worlds) {
    Counter counter;
    for (const World& world : worlds) counter.add(world);
    return counter.bytes();
}

}  // namespace firma
