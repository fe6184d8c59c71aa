// SPDX-License-Identifier: MIT
// What a World is a handle to. Nothing in it changes once published.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/pool.h"
#include "base/ref.h"
#include "firma/carve_rules.h"
#include "firma/tolerance.h"
#include "firma/tree_options.h"
#include "firma/world.h"
#include "tree/block.h"

namespace firma {

/// A volume of air: its faces, in a tree. Rooms name each other by id, never by pointer.
class Room : public RefCounted, public Pooled {
public:
    Ref<const Block> tree;  ///< null for a room without faces
};

struct WorldData {
    std::vector<Ref<const Room>> rooms;
    std::shared_ptr<const std::vector<std::string>> materials;
    Tolerance tolerance;
    TreeOptions tree_options;  ///< how trees are built, and rebuilt by edits
    std::uint64_t version = 0;
    std::size_t face_count = 0;
    std::uint32_t next_face = 0;              ///< the id that the next new face gets
    std::uint32_t edits = 0;                  ///< cuts so far: the next one's faces say they come from edit `edits + 1`
    bool rock_outside = false;                ///< whether what no face separates from infinity is solid
    std::shared_ptr<const CarveRules> rules;  ///< null: none
};

/// A copy to be filled by an edit: one version on, sharing every room until it is replaced. `face_count` and
/// `next_face` are for the edit to bring up to date.
inline std::shared_ptr<WorldData> next_version(const WorldData& data) {
    auto next = std::make_shared<WorldData>(data);
    ++next->version;
    return next;
}

}  // namespace firma
