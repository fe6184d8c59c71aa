// SPDX-License-Identifier: MIT
// The faces that only one of two worlds has: those in blocks that are not shared, less those that are alike.
#include "world/changed_faces.h"

#include <cstddef>
#include <cstdint>

#include "base/sort.h"
#include "index/unshared_nodes.h"

namespace firma {
namespace {

/// The faces in blocks that only one of two worlds has, in order of id.
std::vector<ChangedFace> faces_in(const std::vector<const Node*>& nodes, const WorldData& data) {
    std::vector<ChangedFace> faces;
    for (const Node* node : nodes) {
        if (!node->is_leaf()) continue;
        const Block& block = block_of(*node);
        const RoomId room{data.cells.current_room(block.part)};
        for (std::uint32_t slot = 0; slot < block.faces.size(); ++slot) faces.push_back({{&block, slot}, room});
    }
    sort_range(faces, [](const ChangedFace& a, const ChangedFace& b) { return a.record().id < b.record().id; });
    return faces;
}

bool alike(const FacetPlace& a, const FacetPlace& b) {
    const FaceRecord &f = a.record(), &g = b.record();
    if (f.source != g.source || f.edit != g.edit || f.material != g.material || f.mask != g.mask ||
        f.two_sided != g.two_sided || f.solid != g.solid || f.corner_count != g.corner_count)
        return false;
    for (std::size_t k = 0; k < f.corner_count; ++k)
        if (a.block->corner(f, k) != b.block->corner(g, k)) return false;
    return true;
}

}  // namespace

ChangedFaces changed_faces(const WorldData& before, const WorldData& after) {
    std::vector<const Node*> old_roots, new_roots;
    const auto compare = [&](const FaceStore& one, const FaceStore& two) {
        if (one.root.get() == two.root.get()) return;
        if (one.root) old_roots.push_back(one.root.get());
        if (two.root) new_roots.push_back(two.root.get());
    };
    compare(before.solid.data().faces, after.solid.data().faces);
    compare(before.castable, after.castable);
    const UnsharedNodes nodes = unshared_nodes(old_roots, new_roots);
    const std::vector<ChangedFace> olds = faces_in(nodes.before, before), news = faces_in(nodes.after, after);
    ChangedFaces changed;
    auto added = news.begin();
    for (const ChangedFace& removed : olds) {
        while (added != news.end() && added->record().id < removed.record().id) changed.added.push_back(*added++);
        const bool match = added != news.end() && added->record().id == removed.record().id;
        if (match && alike(removed.place, added->place)) {
            ++added;
            continue;
        }
        changed.removed.push_back(removed);
        if (match) changed.added.push_back(*added++);
    }
    while (added != news.end()) changed.added.push_back(*added++);
    return changed;
}

}  // namespace firma
