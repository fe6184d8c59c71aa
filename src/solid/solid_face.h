// SPDX-License-Identifier: MIT
// The exact boundary that cuts leave behind: faces with loops of edges, edges with two planes, vertices with three.
//
// Only what a cut has touched is held like this. A face that no cut touched is its own facet, on the input grid, and
// its exact form follows from its corners (see SolidPatch). Nothing here changes once made, and everything is shared:
// a vertex or an edge is the same object in each face that uses it, and that is how neighbours know each other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/pool.h"
#include "base/ref.h"
#include "geometry/exact_point.h"
#include "tree/block.h"

namespace firma {

class SolidPlane : public RefCounted, public Pooled {
public:
    explicit SolidPlane(const Plane& p) : plane(p) {}
    const Plane plane;
};

class SolidVertex : public RefCounted, public Pooled {
public:
    SolidVertex(const ExactPoint& p, const Ref<const SolidPlane> (&three)[3])
        : point(p), planes{three[0], three[1], three[2]} {}
    const ExactPoint point;
    const Ref<const SolidPlane> planes[3];  ///< what `point` looks at; null for a point of the grid
};

class SolidEdge : public RefCounted, public Pooled {
public:
    Ref<const SolidVertex> vertex[2];
    Ref<const SolidPlane> plane[2];  ///< that meet in it: those of its faces, or auxiliary ones
    bool doubled = false;            ///< one of several between the same two vertices of the grid
};

/// How a loop uses an edge: from vertex[0] to vertex[1], or back.
struct SolidUse {
    Ref<const SolidEdge> edge;
    bool reversed = false;

    const SolidVertex& from() const { return *edge->vertex[reversed]; }
};

class SolidFace final : public FaceOwner {
public:
    Ref<const SolidPlane> plane;                          ///< looks into the air
    std::vector<SolidUse, PoolAllocator<SolidUse>> uses;  ///< of all loops in a row
    std::vector<std::uint32_t, PoolAllocator<std::uint32_t>>
        loop_ends;  ///< the first loop is the outer one, holes follow

    ~SolidFace() override;
    void add_to(Hasher& hasher) const override;
    std::size_t bytes() const override;
};

}  // namespace firma
