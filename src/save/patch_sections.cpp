// SPDX-License-Identifier: MIT
// What lists and patches are made of.
#include "save/patch_sections.h"

#include <algorithm>

#include "base/hasher.h"
#include "base/sort.h"
#include "carve/gather.h"
#include "save/face_packer.h"
#include "solid/hash_facet.h"
#include "solid/region.h"
#include "world/add_text.h"

namespace firma {
namespace {

/// Nothing for one outside the world.
bool cube_of(const Region& region, GridBox& cube) {
    constexpr std::int32_t kRim = 1 << (kRegionAxisBits - 1);
    const std::int32_t at[] = {region.x, region.y, region.z};
    for (int axis = 0; axis < 3; ++axis) {
        if (at[axis] < -kRim || at[axis] >= kRim) return false;
        cube.low[axis] = at[axis] * (1 << kRegionBits);
        cube.high[axis] = cube.low[axis] + ((1 << kRegionBits) - 1);
    }
    return true;
}

}  // namespace

std::uint64_t hash_cells(const Cells& cells) {
    Hasher hasher;
    hasher.add(cells.room_count(), cells.portal_count());
    hasher.add(std::uint32_t(cells.known()));
    for (std::uint32_t k = 0; k < cells.room_count(); ++k) {
        const RoomRecord& record = cells.room(k);
        hasher.add(record.merged_into, std::uint32_t(record.exterior));
        add_text(hasher, record.name);
    }
    hasher.add(cells.hash());
    // A world's hash knows corners of portals only as they are rounded.
    cells.portals().for_each([&](std::uint32_t, const PortalState& state) {
        for (std::size_t k = 0; k < state.portal->all_polygons().size(); ++k)
            if (const SolidFace* face = state.portal->exact(k)) hasher.add(face->hash);
    });
    return hasher.value();
}

std::vector<FacetPlace> facets_in(const WorldData& data, std::span<const Region> regions) {
    std::vector<FacetPlace> facets, near;
    for (const Region& region : regions) {
        GridBox cube;
        if (!cube_of(region, cube)) continue;
        const std::uint32_t wanted = region_of(cube.low);
        for (const Node* root : {data.solid.data().faces.root.get(), data.castable.root.get()}) {
            near.clear();
            if (root) gather_facets(root, cube, near);
            for (const FacetPlace& facet : near)
                if (region_of(lowest_corner(*facet.block, facet.record())) == wanted) facets.push_back(facet);
        }
    }
    sort_range(facets, [](const FacetPlace& a, const FacetPlace& b) { return a.record().id < b.record().id; });
    return facets;
}

std::uint64_t hash_listed(const WorldData& data, const FacetPlace& facet) {
    Hasher hasher;
    hasher.add(hash_facet(*facet.block, facet.record()));
    hasher.add(data.cells.current_room(facet.block->part));
    return hasher.value();
}

void put_regions(ByteWriter& out, std::span<const Region> regions) {
    for (const Region& region : regions)
        for (const std::int32_t at : {region.x, region.y, region.z}) out.i32(at);
}

Region region_at(const std::byte* at) {
    return {read_i32(at), read_i32(at + 4), read_i32(at + 8)};
}

}  // namespace firma
