// SPDX-License-Identifier: MIT
// Every facet of a world, out of its blocks.
#include "tests/reference/world_facets.h"

#include <algorithm>
#include <bit>

#include "solid/append_faces.h"
#include "tests/reference/facet_corners.h"
#include "world/assemble_world.h"

namespace firma::reference {
namespace {

void collect(const Block& block, std::vector<FacetPlace>& facets) {
    for (std::uint32_t slot = 0; slot < block.faces.size(); ++slot) facets.push_back({&block, slot});
}

class Fnv {
public:
    void add(std::uint64_t word) {
        for (int k = 0; k < 8; ++k) value_ = (value_ ^ (word >> (8 * k) & 0xff)) * 0x100000001b3ull;
    }
    void add(const GridPoint& p) {
        add(std::uint64_t(std::uint32_t(p.x)) << 32 | std::uint32_t(p.y));
        add(std::uint64_t(std::uint32_t(p.z)));
    }
    std::uint64_t value() const { return value_; }

private:
    std::uint64_t value_ = 0xcbf29ce484222325ull;
};

bool same_facet(const FacetPlace& a, const FacetPlace& b) {
    if (a == b) return true;
    const FaceRecord &f = a.record(), &g = b.record();
    if (f.id != g.id || f.source != g.source || f.material != g.material || f.mask != g.mask || f.edit != g.edit ||
        f.two_sided != g.two_sided || f.solid != g.solid || a.block->owner_of(f) != b.block->owner_of(g))
        return false;
    return grid_corners_of(a) == grid_corners_of(b);
}

}  // namespace

std::vector<FacetPlace> all_facets(const World& world) {
    std::vector<FacetPlace> facets;
    for_each_block_of(world.data(), [&](const Block& block) { collect(block, facets); });
    std::sort(facets.begin(), facets.end(),
              [](const FacetPlace& a, const FacetPlace& b) { return a.record().id < b.record().id; });
    return facets;
}

std::vector<FacetPlace> facets_of_room(const World& world, std::uint32_t room) {
    std::vector<FacetPlace> facets;
    if (const Node* tree = world.data().faces_of(room).tree.get())
        for_each_block(*tree, [&](const Block& block) { collect(block, facets); });
    return facets;
}

FacetChange compare_facets(const World& before, const World& after) {
    FacetChange change;
    const std::vector<FacetPlace> a = all_facets(before), b = all_facets(after);
    std::size_t i = 0, k = 0;
    while (i < a.size() || k < b.size()) {
        if (k == b.size() || (i < a.size() && a[i].record().id < b[k].record().id)) {
            change.gone.push_back(a[i++]);
        } else if (i == a.size() || b[k].record().id < a[i].record().id) {
            change.come.push_back(b[k++]);
        } else {
            if (!same_facet(a[i++], b[k++])) change.untouched_kept = false;
        }
    }
    return change;
}

FaceSet set_of(const World& world) {
    FaceSet set;
    for_each_block_of(world.data(),
                      [&](const Block& block) { append_faces(block, set, [](std::uint32_t) { return true; }); });
    return set;
}

World with_faces(const World& world, const FaceSet& faces) {
    const WorldData& data = world.data();
    StoredWorld stored;
    FaceSet solid, castable;
    for (const FaceSet::Entry& face : faces.faces) append_face(faces, face, face.solid ? solid : castable);
    stored.solid = build_store(solid, data.tree_options);
    stored.castable = build_store(castable, data.tree_options);
    stored.records.resize(1);
    stored.rock_outside = data.rock_outside();
    stored.next_face = data.next_face() + 1;
    stored.edits = data.edits();
    stored.version = data.version;
    stored.materials = data.materials;
    stored.tolerance = data.tolerance;
    stored.tree_options = data.tree_options;
    stored.rules = data.rules;
    return world_of(std::move(stored));
}

World rebuilt(const World& world) {
    return rebuild_index(world, world.data().tree_options);
}

std::uint64_t hash_of_facets(const World& world) {
    Fnv hash;
    for (const FacetPlace& place : all_facets(world)) {
        const FaceRecord& face = place.record();
        hash.add(std::uint64_t(face.id.value) << 32 | face.source);
        hash.add(std::uint64_t(face.material) << 32 | face.edit);
        hash.add(std::uint64_t(face.mask) << 32 | std::uint64_t(face.corner_count) << 2 |
                 std::uint64_t(face.two_sided) << 1 | face.solid);
        place.block->for_each_corner(face, [&](const GridPoint& corner) { hash.add(corner); });
        const FaceOwner* owner = place.block->owner_of(face);
        if (!owner) continue;
        for (int axis = 0; axis < 3; ++axis) hash.add(std::bit_cast<std::uint64_t>(owner->normal[axis]));
    }
    hash.add(world.face_count());
    hash.add(world.version());
    return hash.value();
}

std::uint64_t hash_of_surface(const World& world) {
    std::uint64_t sum = 0;
    for (const FacetPlace& place : all_facets(world)) {
        std::vector<GridPoint> corners;
        for (const GridPoint& corner : grid_corners_of(place)) corners.push_back(corner);
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
        Fnv hash;
        for (const GridPoint& corner : corners) hash.add(corner);
        sum += mix_bits(hash.value());
    }
    return sum;
}

}  // namespace firma::reference
