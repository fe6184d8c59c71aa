// SPDX-License-Identifier: MIT
// What a World is a handle to: a solid, faces that are castable only, cells, rules; each replaceable alone
// (replace.h). Nothing in
// it changes once published.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "firma/grid.h"
#include "firma/solid.h"
#include "firma/tree_options.h"
#include "firma/world.h"
#include "solid/anchors.h"
#include "solid/face_store.h"
#include "solid/matter_pieces.h"
#include "solid/solid_data.h"
#include "world/cells.h"
#include "world/face_textures.h"
#include "world/room_faces.h"

namespace firma {

/// The part of a face (Block::part) is the room that it was put into; Cells::current_room() says which that is by now.
struct WorldData {
    Solid solid;
    FaceStore castable;  ///< faces that bound no solid
    Cells cells;
    RoomFacesMap room_faces;        ///< follows from the three above
    std::uint64_t room_hashes = 0;  ///< sum of hash_room()
    std::shared_ptr<const std::vector<std::string>> materials;
    Tolerance tolerance;
    TreeOptions tree_options;  ///< how indices are built, and rebuilt by edits
    std::uint64_t version = 0;
    std::shared_ptr<const CarveRules> rules;       ///< null: none
    std::shared_ptr<const Anchors> anchors;        ///< what holds pieces; null: not said yet. In no hash
    std::shared_ptr<const FaceTextures> textures;  ///< of the level's file; null: none. In no hash
    std::shared_ptr<const MatterPieces> matters;   ///< null: they would say nothing

    std::size_t face_count() const { return solid.face_count() + castable.count; }
    bool rock_outside() const { return solid.rock_outside(); }
    const RoomFaces& faces_of(std::uint32_t room) const { return *room_faces[room]; }
    std::uint32_t edits() const { return solid.edits(); }
    /// The id that the next new face gets.
    std::uint32_t next_face() const { return solid.data().next_face; }
    /// Of several rooms: whether rays from a point tell its room, as some face bounds the solid.
    bool knows_walls() const { return !cells.known() || cells.room_count() == 1 || solid.face_count() > 0; }

    void set_room(std::uint32_t number, std::shared_ptr<const RoomRecord> record, Ref<const RoomFaces> faces);
    /// Of all rooms that there are.
    void set_faces(RoomFacesMap faces);
};

/// Indices over all faces of all rooms: one, or one over the solid and one over what is castable only. Null for none.
inline std::array<const Node*, 2> indices_of(const WorldData& data) {
    if (data.cells.room_count() == 1) return {data.faces_of(0).tree.get(), nullptr};
    return {data.solid.data().faces.root.get(), data.castable.root.get()};
}

/// Calls `function(block)` for all blocks: those of the solid, then those that are castable only.
template <class Function>
void for_each_block_of(const WorldData& data, const Function& function) {
    for (const Node* root : {data.solid.data().faces.root.get(), data.castable.root.get()})
        if (root) for_each_block(*root, function);
}

/// A copy to be filled by an edit: one version on, sharing everything until it is replaced.
inline std::shared_ptr<WorldData> next_version(const WorldData& data) {
    auto next = std::make_shared<WorldData>(data);
    ++next->version;
    return next;
}

}  // namespace firma
