// SPDX-License-Identifier: MIT
// Faces in a store that is edited as carving would, and beside it a plain list of what it must hold.
#pragma once

#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <vector>

#include "firma/level.h"
#include "index/traverse.h"
#include "join/join_facets.h"
#include "scenes/rng.h"
#include "solid/append_faces.h"
#include "solid/face_store.h"
#include "world/assemble_world.h"

namespace firma {

using Corners = std::vector<GridPoint>;

/// Faces of a level as make_world() numbers them.
inline FaceSet face_set_of(const Level& level) {
    FaceSet set;
    set.vertices = level.vertices;
    set.corners = level.corners;
    for (std::uint32_t k = 0; k < level.faces.size(); ++k) {
        FaceSet::Entry face;
        face.id = {k};
        face.source = level.faces[k].source;
        face.first_corner = level.faces[k].first_corner;
        face.corner_count = level.faces[k].corner_count;
        set.faces.push_back(face);
    }
    return set;
}

inline void append(FaceSet& set, FaceId id, const Corners& corners) {
    FaceSet::Entry face;
    face.id = id;
    face.source = id.value;
    add_facet(set, corners, face);
}

/// The bowl of a crater: `panels` x `panels` x 2 triangles on each side of a cube blown up to a ball, those of the half
/// that `away` points to; about 6 panels^2 of them.
inline std::vector<Corners> bowl(const Vec3& centre, double radius, int panels, const Vec3& away) {
    std::vector<Corners> triangles;
    const auto corner = [&](int side, int i, int j) {
        const int axis = side / 2;
        Vec3 d;
        d[axis] = side % 2 ? 1 : -1;
        d[(axis + 1) % 3] = 2.0 * i / panels - 1;
        d[(axis + 2) % 3] = 2.0 * j / panels - 1;
        d = d * (radius / length(d));
        GridPoint p;
        for (int k = 0; k < 3; ++k) p[k] = std::int32_t(std::floor((centre[k] + d[k]) * kSurfaceSteps));
        return p;
    };
    for (int side = 0; side < 6; ++side)
        for (int i = 0; i < panels; ++i)
            for (int j = 0; j < panels; ++j) {
                const GridPoint a = corner(side, i, j), b = corner(side, i + 1, j), c = corner(side, i + 1, j + 1),
                                d = corner(side, i, j + 1);
                if (dot(to_metres(a) - centre, away) < 0) continue;
                triangles.push_back({a, b, c});
                triangles.push_back({a, c, d});
            }
    return triangles;
}

/// Which faces reach into a box.
struct BoxVisitor {
    Vec3 low, high;
    std::vector<FacetPlace> found;

    bool enter(const BoxF& box, double& nearest) const {
        nearest = 0;
        for (int axis = 0; axis < 3; ++axis)
            if (high[axis] < double(box.low[axis]) || low[axis] > double(box.high[axis])) return false;
        return true;
    }
    bool still(double) const { return true; }
    bool facets(const IndexedFacets& facets, std::uint32_t first, std::uint32_t count) {
        const Block& block = as_block(facets);
        for (std::uint32_t slot = first; slot < first + count; ++slot) {
            const GridBox box = block.box_of(block.faces[slot]);
            const Vec3 from = to_metres(box.low), to = to_metres(box.high);
            bool apart = false;
            for (int axis = 0; axis < 3; ++axis) apart = apart || high[axis] < from[axis] || low[axis] > to[axis];
            if (!apart) found.push_back({&block, slot});
        }
        return false;
    }
};

class EditedTree {
public:
    explicit EditedTree(const FaceSet& faces, const TreeOptions& tree_options = {})
        : options(tree_options), store(build_store(faces, options).store) {
        for (const FaceSet::Entry& face : faces.faces) {
            Corners& corners = held[face.id.value];
            for (std::uint32_t c = 0; c < face.corner_count; ++c)
                corners.push_back(faces.vertices[faces.corners[face.first_corner + c]]);
            next_id = std::max(next_id, face.id.value + 1);
        }
    }

    /// Removes what reaches into a box around a point, half as wide as `reach` each way, and adds triangles.
    void edit(const Vec3& centre, double reach, const std::vector<Corners>& come) {
        StoreEdit edit(store, options);
        if (store.root) {
            const Vec3 half{reach, reach, reach};
            BoxVisitor visitor{centre - half, centre + half, {}};
            traverse(*store.root, visitor);
            for (const FacetPlace& facet : visitor.found) {
                edit.remove(facet);
                held.erase(facet.record().id.value);
            }
        }
        FaceSet set;
        for (const Corners& corners : come) {
            append(set, {next_id}, corners);
            held[next_id++] = corners;
        }
        edit.add(std::move(set));
        while (edit.step()) {
        }
        store = edit.result();
    }

    /// A crater: about 6 panels^2 new faces.
    void crater(const Vec3& centre, double radius, int panels, scenes::Rng& rng) {
        const Vec3 away = rng.direction();
        edit(centre, 0.75 * radius, bowl(centre, radius, panels, away));
    }

    /// What the store holds, in a set.
    FaceSet faces() const {
        FaceSet set;
        for (const auto& [id, corners] : held) append(set, {id}, corners);
        return set;
    }

    const Ref<const Node>& tree() const { return store.root; }
    World world_with(BuiltStore built) const {
        StoredWorld stored;
        stored.castable = std::move(built);
        stored.records.resize(1);
        stored.next_face = next_id;
        stored.materials = std::make_shared<std::vector<std::string>>(1);
        stored.tree_options = options;
        return world_of(std::move(stored));
    }
    /// With the hashes that edits kept.
    World world() const {
        BuiltStore built;
        built.store = store;
        if (store.root) built.parts.push_back({0, store.root});
        built.changes.push_back({0, std::int64_t(store.count), store.hash});
        return world_with(std::move(built));
    }
    World world_from_scratch() const { return world_with(build_store(faces(), options)); }

    TreeOptions options;
    FaceStore store;
    std::map<std::uint32_t, Corners> held;
    std::uint32_t next_id = 0;
};

}  // namespace firma
