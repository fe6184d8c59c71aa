// SPDX-License-Identifier: MIT
// All faces as part 0, in blocks and an index built anew.
#include "scenes/one_tree.h"

#include <algorithm>
#include <utility>

#include "solid/append_faces.h"
#include "solid/build_blocks.h"
#include "world/assemble_world.h"

namespace firma::scenes {

World in_one_tree(const World& world) {
    const WorldData& data = world.data();
    StoredWorld one;
    const auto in_one = [&](const FaceStore& store) {
        FaceSet faces;
        if (store.root) append_all_faces(*store.root, faces);
        for (FaceSet::Entry& face : faces.faces) face.part = 0;
        // In order of id: what comes out follows from the faces alone, not from the rooms that they were in.
        std::sort(faces.faces.begin(), faces.faces.end(),
                  [](const FaceSet::Entry& a, const FaceSet::Entry& b) { return a.id < b.id; });
        return build_store(faces, data.tree_options);
    };
    one.solid = in_one(data.solid.data().faces);
    one.castable = in_one(data.castable);
    one.records.resize(1);
    one.rock_outside = data.rock_outside();
    one.next_face = data.next_face();
    one.edits = data.edits();
    one.version = data.version;
    one.materials = data.materials;
    one.tolerance = data.tolerance;
    one.tree_options = data.tree_options;
    one.rules = data.rules;
    return world_of(std::move(one));
}

}  // namespace firma::scenes
