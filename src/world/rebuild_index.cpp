// SPDX-License-Identifier: MIT
// Blocks and indices of a world anew.
#include <algorithm>

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
    after->set_faces(faces_of_rooms(before.cells, {&solid, &castable}));
    return World(std::move(after));
}

}  // namespace firma
