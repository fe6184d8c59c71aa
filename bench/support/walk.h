// SPDX-License-Identifier: MIT
// The walk of a cast with any way of testing a face put in: what world/cast_world.cpp does, opened for comparisons.
#pragma once

#include "cast/cast_sphere_polygon.h"
#include "firma/level.h"
#include "firma/world.h"
#include "index/sweep_box.h"
#include "index/traverse.h"
#include "scenes/cast_families.h"
#include "world/block_faces.h"
#include "world/world_data.h"

namespace firma::bench {

/// The first touch so far.
struct First {
    double latest = 0;  ///< in the sweep's parameter
    Contact contact;
    std::uint32_t face = ~0u;  ///< id

    void offer(const Contact& other, std::uint32_t id) {
        if (!other.touched()) return;
        if (contact.touched() && (contact.t < other.t || (contact.t == other.t && face < id))) return;
        contact = other;
        face = id;
        latest = other.t;
    }
};

/// `Test` is told the sweep by `begin(sweep)`, then of each face in a box that is entered by
/// `face(block, slot, boxes, first)`.
template <class Test>
class Walk {
public:
    Walk(const Sweep& sweep, Test& test) : boxes_(sweep), test_(test) { first.latest = sweep.end; }

    bool enter(const BoxF& box, double& nearest) { return boxes_.enters(box, first.latest, nearest); }
    bool still(double nearest) const { return nearest <= first.latest; }
    bool facets(const IndexedFacets& facets, std::uint32_t from, std::uint32_t count) {
        const Block& block = as_block(facets);
        for (std::uint32_t slot = from; slot < from + count; ++slot) test_.face(block, slot, boxes_, first);
        return false;
    }

    First first;

private:
    const SweepBox boxes_;
    Test& test_;
};

/// The first touch in a world of one room.
template <class Test>
First walk(const World& world, const scenes::CastQuery& move, Test& test) {
    Sweep sweep;
    if (make_sweep(move.sphere, move.path, sweep) != Status::kHit) return {};
    test.begin(sweep);
    Walk<Test> walk(sweep, test);
    traverse(*world.data().faces_of(0).tree, walk);
    return walk.first;
}

/// A face's box from its corners, as world/cast_world.cpp computes it each time.
struct CornerBox {
    double low[3], high[3];

    CornerBox(const Block& block, const FaceRecord& face) {
        GridPoint lowest = block.corner(face, 0), highest = lowest;
        block.for_each_corner(face, [&](const GridPoint& p) {
            for (int axis = 0; axis < 3; ++axis) {
                if (p[axis] < lowest[axis]) lowest[axis] = p[axis];
                if (p[axis] > highest[axis]) highest[axis] = p[axis];
            }
        });
        const Vec3 a = to_metres(lowest), b = to_metres(highest);
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = a[axis];
            high[axis] = b[axis];
        }
    }
};

/// Puts a level's faces into the order in which its tree holds them, so that arrays by face id lie as the blocks do.
void sort_like_tree(Level& level, const TreeOptions& options = {});

/// The world of a level that is known to be good.
World world_of(const Level& level, const TreeOptions& options = {});

}  // namespace firma::bench
