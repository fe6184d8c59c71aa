// SPDX-License-Identifier: MIT
// Blocks and indices of a world anew.
#include <algorithm>

#include "index/join_nodes.h"
#include "solid/append_faces.h"
#include "world/world_data.h"

namespace firma {
namespace {

BuiltStore built_anew(const FaceStore& store, const TreeOptions& options) {
    FaceSet faces;
    if (store.root) append_all_faces(*store.root, faces);
    // In order of id: what comes out follows from the faces alone.
    std::sort(faces.faces.begin(), faces.faces.end(),
              [](const FaceSet::Entry& a, const FaceSet::Entry& b) { return a.id < b.id; });
    return build_store(faces, options);
}

}  // namespace

World rebuild_index(const World& world, const TreeOptions& options) {
    const WorldData& before = world.data();
    auto after = std::make_shared<WorldData>(before);
    after->tree_options = options;
    const BuiltStore solid = built_anew(before.solid.data().faces, options);
    const BuiltStore castable = built_anew(before.castable, options);
    auto data = std::make_shared<SolidData>(before.solid.data());
    data->faces = solid.store;
    data->tree_options = options;
    after->solid = Solid(std::move(data));
    after->castable = castable.store;
    std::vector<std::vector<Ref<const Node>>> indices(before.cells.room_count());
    for (const BuiltStore* store : {&solid, &castable})
        for (const PartIndex& part : store->parts) indices[before.cells.current_room(part.part)].push_back(part.root);
    for (std::uint32_t k = 0; k < indices.size(); ++k) {
        const Room& room = before.cells.room(k);
        Ref<Room> made(new Room);
        made->record = room.record;
        made->faces = room.faces;
        made->face_hash = room.face_hash;
        made->tree = join_nodes(indices[k]);
        after->cells.set_room(k, Ref<const Room>(made.get()));
    }
    return World(std::move(after));
}

}  // namespace firma
