// SPDX-License-Identifier: MIT
// Levels of boxes for tests of the solid, cuts in them, and worlds taken apart to have one thing changed.
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <vector>

#include "firma/carve.h"
#include "firma/solid.h"
#include "solid/append_faces.h"
#include "solid/boundary.h"
#include "solid/build_blocks.h"
#include "tests/reference/world_facets.h"
#include "world/world_data.h"

namespace firma::test {

inline Level empty_level() {
    Level level;
    level.materials = {"", "stone"};
    level.groups = {""};
    return level;
}

inline void add_polygon(Level& level, const std::vector<Vec3>& corners) {
    LevelFace face;
    face.first_corner = std::uint32_t(level.corners.size());
    face.corner_count = std::uint32_t(corners.size());
    face.source = level.source_faces++;
    for (const Vec3& corner : corners) {
        level.corners.push_back(std::uint32_t(level.vertices.size()));
        level.vertices.push_back(snap(corner).value());
    }
    level.faces.push_back(face);
}

/// Six squares that look out of the box, or into it.
inline void add_box(Level& level, const Vec3& low, const Vec3& high, bool inward = false) {
    for (int axis = 0; axis < 3; ++axis)
        for (const bool upper : {false, true}) {
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            std::vector<Vec3> corners;
            for (const auto& [at_u, at_v] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
                Vec3 p;
                p[axis] = upper ? high[axis] : low[axis];
                p[u] = at_u ? high[u] : low[u];
                p[v] = at_v ? high[v] : low[v];
                corners.push_back(p);
            }
            if (upper == inward) std::reverse(corners.begin(), corners.end());
            add_polygon(level, corners);
        }
}

inline Level box_level(const Vec3& low, const Vec3& high, bool inward = false) {
    Level level = empty_level();
    add_box(level, low, high, inward);
    return level;
}

inline Boundary boundary_of(const World& world) {
    return take_boundary(world.solid().data().faces.root.get());
}

/// A world as plain faces, each exact face copied so that it can be changed.
struct Parts {
    World from;
    FaceSet set;
    std::vector<Ref<SolidFace>> faces;

    explicit Parts(const World& world) : from(world) {
        append_all_faces(*world.data().faces_of(0).tree, set);
        std::vector<const FaceOwner*> known;
        for (FaceSet::Entry& entry : set.faces) {
            if (!entry.owner) continue;
            std::size_t k = std::size_t(std::find(known.begin(), known.end(), entry.owner) - known.begin());
            if (k == known.size()) {
                known.push_back(entry.owner);
                const auto& old = static_cast<const SolidFace&>(*entry.owner);
                Ref<SolidFace> copy(new SolidFace);
                copy->normal = old.normal;
                copy->box = old.box;
                copy->facets = old.facets;
                copy->plane = old.plane;
                copy->uses = old.uses;
                copy->set_loop_ends(old.loop_ends());
                faces.push_back(copy);
            }
            entry.owner = faces[k].get();
        }
    }
    /// The first facet of an exact face.
    FaceSet::Entry& facet_of(const SolidFace& face) {
        return *std::find_if(set.faces.begin(), set.faces.end(), [&](const auto& e) { return e.owner == &face; });
    }
    FaceSet::Entry& untouched() {
        return *std::find_if(set.faces.begin(), set.faces.end(), [](const auto& e) { return !e.owner && e.solid; });
    }
    SolidFace& with_holes(bool holes) {
        return **std::find_if(faces.begin(), faces.end(),
                              [&](const auto& face) { return (face->loop_ends().size() > 1) == holes; });
    }
    FaceStore store() const {
        FaceSet solid;
        for (const FaceSet::Entry& face : set.faces)
            if (face.solid) append_face(set, face, solid);
        return build_store(solid, from.data().tree_options).store;
    }
    World world() const { return reference::with_faces(from, set); }
};

}  // namespace firma::test
