// SPDX-License-Identifier: MIT
// What an exact face is, for hashes and counts of memory.
#include "solid/solid_face.h"

#include <type_traits>

#include "base/assert.h"
#include "base/fetch_ahead.h"
#include "base/hasher.h"
#include "solid/hash_points.h"

namespace firma {
namespace {

static_assert(sizeof(void*) != 8 || (sizeof(SolidPlane) == 64 && sizeof(SolidVertex) == 64), "a line of a cache");

// A point looks at planes; those of a vertex are SolidPlanes', and the first thing in them.
static_assert(std::is_standard_layout_v<PlaneHolder>);

}  // namespace

SolidVertex::SolidVertex(const ExactPoint& p, const Ref<const SolidPlane> (&three)[3]) : SolidPoint{p} {
    for (int k = 0; k < 3; ++k) {
        FIRMA_ASSERT(p.plane(k) == (three[k] ? &three[k]->plane : nullptr), "a vertex keeps the planes of its point");
        if (three[k]) three[k]->take();
    }
}

SolidVertex::~SolidVertex() {
    for (int k = 0; k < 3; ++k)
        if (const SolidPlane* own = plane(k); own && own->drop()) delete own;
}

const SolidPlane* SolidVertex::plane(int k) const {
    return static_cast<const SolidPlane*>(reinterpret_cast<const PlaneHolder*>(point.plane(k)));
}

SolidUse::SolidUse(Ref<const SolidEdge> edge, bool reversed)
    : edge_(reinterpret_cast<std::uintptr_t>(edge.get()) | std::uintptr_t(reversed)) {
    if (edge) edge->take();
}

SolidUse::~SolidUse() {
    if (address() && address()->drop()) delete address();
}

void SolidFace::set_loop_ends(std::span<const std::uint32_t> ends) {
    only_end_ = ends.size() == 1 ? ends[0] : 0;
    ends_ = {};
    if (ends.size() > 1) ends_.assign(ends.begin(), ends.end());
}

/// Edges lie scattered, and each counts one user less.
SolidFace::~SolidFace() {
    for (const SolidUse& use : uses) fetch_ahead(use.address());
}

template <class HashOf>
void SolidFace::set_hash_by(const HashOf& hash_of) {
    Hasher hasher;
    hasher.add(hash_of(*plane));
    for (const std::uint32_t end : loop_ends()) hasher.add(end);
    for (const SolidUse& use : uses) {
        const GridPoint& p = use.from().point.rounded();
        hasher.add(p.x, p.y);
        hasher.add(std::uint32_t(p.z));
        // Whichever of an edge's planes is named first.
        hasher.add(hash_of(*use.edge().plane[0]) + hash_of(*use.edge().plane[1]));
    }
    hash = hasher.value();
}

void SolidFace::set_hash() {
    const std::uint64_t own = hash_plane(plane->plane);
    set_hash_by([&](const SolidPlane& of) { return &of == plane.get() ? own : hash_plane(of.plane); });
}

void SolidFace::set_hash(PlaneHashes& hashes) {
    set_hash_by([&](const SolidPlane& of) { return hashes.of(of); });
}

std::uint64_t PlaneHashes::of(const SolidPlane& plane) {
    Known& known = known_[reinterpret_cast<std::uintptr_t>(&plane) / sizeof(SolidPlane) % known_.size()];
    if (known.plane != &plane) known = {&plane, hash_plane(plane.plane)};
    return known.hash;
}

std::size_t SolidFace::bytes() const {
    // Vertices, edges and planes are shared by the faces around them: two faces an edge, about three a vertex, and a
    // plane of its own for each face.
    std::size_t sum =
        pool_size(sizeof(SolidFace)) + pool_size(sizeof(SolidPlane)) + pool_size_of(uses) + pool_size_of(ends_);
    sum += uses.size() * (pool_size(sizeof(SolidEdge)) / 2 + pool_size(sizeof(SolidVertex)) / 3);
    return sum;
}

}  // namespace firma
