// SPDX-License-Identifier: MIT
// What an exchange of faces may break of a world. Sums over rooms were zero before: they stay so where what comes adds
// up to what goes.
#include "world/check_exchange.h"

#include <algorithm>
#include <vector>

#include "base/sort.h"
#include "solid/face_ids.h"
#include "world/check_rooms.h"

namespace firma {
namespace {

std::vector<std::uint32_t> sorted_ids(std::span<const FacetPlace> facets) {
    std::vector<std::uint32_t> ids;
    ids.reserve(facets.size());
    for (const FacetPlace& facet : facets) ids.push_back(facet.record().id.value);
    sort_range(ids);
    return ids;
}

bool has(const std::vector<std::uint32_t>& ids, std::uint32_t id) {
    return std::binary_search(ids.begin(), ids.end(), id);
}

/// Of all faces, those of before included where counters went back, or an id that comes may be one that stays.
std::optional<WorldFault> check_ids(const WorldData& before, const WorldData& after,
                                    std::span<const FacetPlace> removed, std::span<const FacetPlace> added) {
    const std::vector<std::uint32_t> come = sorted_ids(added), go = sorted_ids(removed);
    bool look = after.next_face() < before.next_face() || after.edits() < before.edits();
    for (std::size_t k = 0; k < come.size(); ++k) {
        if (k > 0 && come[k - 1] == come[k]) return WorldFault{"two faces have one id", {come[k]}};
        if (!was_given(come[k], after.next_face(), after.edits()))
            return WorldFault{"a face's id is not below the next one", {come[k]}};
        look |= was_given(come[k], before.next_face(), before.edits()) && !has(go, come[k]);
    }
    if (!look) return {};
    std::optional<WorldFault> fault;
    for_each_block_of(before, [&](const Block& block) {
        for (const FaceRecord& face : block.faces) {
            const std::uint32_t id = face.id.value;
            const bool given = was_given(id, after.next_face(), after.edits());
            if (fault || (given && !has(come, id)) || has(go, id)) continue;
            fault = WorldFault{given ? "two faces have one id" : "a face's id is not below the next one", face.id};
        }
    });
    return fault;
}

bool too_deep(const Node* root) {
    return root && root->depth > kDeepestTree;
}

}  // namespace

bool rooms_stay(const WorldData& before, const WorldData& after) {
    const Cells &was = before.cells, &is = after.cells;
    // Of rooms without a solid nothing is known to be closed.
    if (was.known() != is.known() || is.room_count() < was.room_count() || before.solid.face_count() == 0) return false;
    for (std::uint32_t k = 0; k < was.room_count(); ++k)
        if (is.current_room(k) != was.current_room(k)) return false;
    return true;
}

std::optional<WorldFault> check_exchange(const WorldData& before, const WorldData& after, bool cells_shared,
                                         std::span<const FacetPlace> removed, std::span<const FacetPlace> added) {
    for (const FacetPlace& facet : added)
        if (const char* fault = fault_of_face(*facet.block, facet.record(), facet.record().solid))
            return WorldFault{fault, facet.record().id};
    if (auto fault = check_ids(before, after, removed, added)) return fault;
    bool deep = too_deep(after.solid.data().faces.root.get()) || too_deep(after.castable.root.get());
    after.room_faces.for_each(
        [&](std::uint32_t, const Ref<const RoomFaces>& faces) { deep |= too_deep(faces->tree.get()); });
    if (deep) return WorldFault{"an index is deeper than traversals can go", {}};
    if (!cells_shared || before.rock_outside() != after.rock_outside())
        if (auto fault = check_cells(after)) return fault;
    if (!after.cells.known() || after.solid.face_count() == 0) return {};
    const auto of_solid = [](std::span<const FacetPlace> facets) {
        std::vector<FacetPlace> some;
        for (const FacetPlace& facet : facets)
            if (facet.record().solid) some.push_back(facet);
        return some;
    };
    return check_rooms_exchange(before, after, cells_shared, of_solid(removed), of_solid(added));
}

}  // namespace firma
