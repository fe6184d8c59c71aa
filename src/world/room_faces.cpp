// SPDX-License-Identifier: MIT
// Faces by room.
#include "world/room_faces.h"

#include <map>
#include <utility>
#include <vector>

#include "base/hasher.h"
#include "index/join_nodes.h"
#include "index/traverse.h"
#include "solid/block.h"
#include "world/add_text.h"

namespace firma {

RoomFacesMap faces_of_rooms(const Cells& cells, std::initializer_list<const BuiltStore*> stores) {
    struct Contents {
        std::vector<Ref<const Node>> trees;
        std::size_t count = 0;
        std::uint64_t hash = 0;
    };
    std::vector<Contents> contents(cells.room_count());
    for (const BuiltStore* store : stores) {
        for (const PartIndex& part : store->parts) contents[cells.current_room(part.part)].trees.push_back(part.root);
        for (const PartChange& change : store->changes) {
            Contents& room = contents[cells.current_room(change.part)];
            room.count += std::size_t(change.faces);
            room.hash += change.hash;
        }
    }
    RoomFacesMap rooms;
    for (std::uint32_t k = 0; k < contents.size(); ++k) {
        Ref<RoomFaces> faces(new RoomFaces);
        faces->tree = join_opened(contents[k].trees);
        faces->count = contents[k].count;
        faces->hash = contents[k].hash;
        rooms.set(k, Ref<const RoomFaces>(faces.get()));
    }
    return rooms;
}

BuiltStore parts_of(const FaceStore& store) {
    BuiltStore built;
    built.store = store;
    if (!store.root) return built;
    std::map<std::uint32_t, std::vector<Ref<const Node>>> leaves;
    FaceSums sums;
    for_each_leaf(store.root, [&](const Ref<const Node>& leaf) {
        const Block& block = block_of(*leaf);
        leaves[block.part].push_back(leaf);
        for (const FaceRecord& face : block.faces) sums.add(block, face);
    });
    for (const auto& [part, its] : leaves)
        built.parts.push_back({part, leaves.size() == 1 ? store.root : join_nodes(its)});
    built.changes = sums.parts();
    return built;
}

std::uint64_t hash_room(std::uint32_t number, const RoomRecord& record, const RoomFaces& faces) {
    Hasher hasher;
    hasher.add(number, std::uint32_t(record.exterior));
    hasher.add(record.merged_into);
    add_text(hasher, record.name);
    hasher.add(faces.count);
    hasher.add(faces.hash);
    return hasher.value();
}

}  // namespace firma
