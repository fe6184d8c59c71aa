// SPDX-License-Identifier: MIT
// What an exact face is, for hashes and counts of memory.
#include "solid/solid_face.h"

#include "base/fetch_ahead.h"
#include "base/hasher.h"

namespace firma {
namespace {

void add_point(Hasher& hasher, const GridPoint& p) {
    hasher.add(std::uint64_t(std::uint32_t(p.x)) << 32 | std::uint32_t(p.y));
    hasher.add(std::uint32_t(p.z));
}

void add_plane(Hasher& hasher, const Plane& plane) {
    for (const std::int64_t n : plane.normal) hasher.add(std::uint64_t(n));
    hasher.add(std::uint64_t(plane.offset));
    hasher.add(std::uint64_t(plane.offset >> 64));
}

}  // namespace

/// Edges lie scattered, and each counts one user less.
SolidFace::~SolidFace() {
    for (const SolidUse& use : uses) fetch_ahead(use.edge.get());
}

void SolidFace::add_to(Hasher& hasher) const {
    add_plane(hasher, plane->plane);
    hasher.add(loop_ends.size());
    for (const std::uint32_t end : loop_ends) hasher.add(end);
    for (const SolidUse& use : uses) {
        add_point(hasher, use.from().point.rounded());
        hasher.add(use.reversed);
        for (const Ref<const SolidPlane>& edge_plane : use.edge->plane) add_plane(hasher, edge_plane->plane);
    }
}

std::size_t SolidFace::bytes() const {
    // Vertices, edges and planes are shared by the faces around them: two faces an edge, about three a vertex, and a
    // plane of its own for each face.
    std::size_t sum =
        pool_size(sizeof(SolidFace)) + pool_size(sizeof(SolidPlane)) + pool_size_of(uses) + pool_size_of(loop_ends);
    sum += uses.size() * (pool_size(sizeof(SolidEdge)) / 2 + pool_size(sizeof(SolidVertex)) / 3);
    return sum;
}

}  // namespace firma
