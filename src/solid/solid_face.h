// SPDX-License-Identifier: MIT
// The exact boundary that cuts leave behind: faces with loops of edges, edges with two planes, vertices with three.
//
// Only what a cut has touched is held like this. A face that no cut touched is its own facet, on the input grid, and
// its exact form follows from its corners (see SolidPatch). Nothing here changes once made, and everything is shared:
// a vertex or an edge is the same object in each face that uses it, and that is how neighbours know each other.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "base/pool.h"
#include "base/ref.h"
#include "geometry/exact_point.h"
#include "solid/block.h"

namespace firma {

// A world has millions of these, scattered: a plane, a vertex, an edge fill a line of a cache each at most.

struct PlaneHolder {
    const Plane plane;
};

class SolidPlane : public PlaneHolder, public RefCounted, public Pooled {
public:
    explicit SolidPlane(const Plane& p) : PlaneHolder{p} {}
};

/// Hashes of planes, kept for those who ask again: a face's plane is that of its neighbours' edges, too. The planes
/// live as long as this.
class PlaneHashes {
public:
    std::uint64_t of(const SolidPlane& plane);

private:
    struct Known {
        const SolidPlane* plane = nullptr;
        std::uint64_t hash = 0;
    };
    std::array<Known, 256> known_;  ///< by some bits of the address
};

/// Where a vertex lies. The point's last bytes are padding: without an address of its own it lends them to the count of
/// users that comes after it.
struct SolidPoint {
    [[no_unique_address]] const ExactPoint point;
};

class SolidVertex : public SolidPoint, public RefCounted, public Pooled {
public:
    /// On the input grid.
    explicit SolidVertex(const InputPoint& p) : SolidPoint{ExactPoint(p)} {}
    /// @param three  the planes that `p` looks at, which it keeps alive; null for a point of the grid
    SolidVertex(const ExactPoint& p, const Ref<const SolidPlane> (&three)[3]);
    ~SolidVertex();

    /// One of those; null for a point of the grid.
    const SolidPlane* plane(int k) const;
};

class SolidEdge : public RefCounted, public Pooled {
public:
    bool doubled = false;  ///< one of several between the same two vertices of the grid
    Ref<const SolidVertex> vertex[2];
    Ref<const SolidPlane> plane[2];  ///< that meet in it: those of its faces, or auxiliary ones
};

/// How a loop uses an edge: from vertex[0] to vertex[1], or back.
class SolidUse {
public:
    SolidUse() = default;
    SolidUse(Ref<const SolidEdge> edge, bool reversed);
    SolidUse(const SolidUse& other) : edge_(other.edge_) {
        if (address()) address()->take();
    }
    SolidUse(SolidUse&& other) noexcept : edge_(std::exchange(other.edge_, 0)) {}
    SolidUse& operator=(SolidUse other) noexcept {
        std::swap(edge_, other.edge_);
        return *this;
    }
    ~SolidUse();

    const SolidEdge& edge() const { return *address(); }
    /// Of the edge; null for one made by default, or moved from.
    const SolidEdge* address() const { return reinterpret_cast<const SolidEdge*>(edge_ & ~std::uintptr_t(1)); }
    bool reversed() const { return (edge_ & 1) != 0; }
    const SolidVertex& from() const { return *edge().vertex[reversed()]; }

private:
    std::uintptr_t edge_ = 0;  ///< its address, and whether reversed in the last bit
};

class SolidFace final : public FaceOwner {
public:
    Ref<const SolidPlane> plane;  ///< looks into the air
    PoolVector<SolidUse> uses;    ///< of all loops in a row

    /// Where in `uses` each loop ends: the first one is the outer one, holes follow.
    std::span<const std::uint32_t> loop_ends() const {
        return ends_.empty() ? std::span(&only_end_, only_end_ != 0) : std::span<const std::uint32_t>(ends_);
    }
    void set_loop_ends(std::span<const std::uint32_t> ends);

    ~SolidFace() override;
    std::size_t bytes() const override;

    /// Sets `hash`, once all else is set.
    void set_hash();
    /// The same, for many faces beside each other.
    void set_hash(PlaneHashes& hashes);

private:
    template <class HashOf>
    void set_hash_by(const HashOf& hash_of);

    std::uint32_t only_end_ = 0;      ///< of a face without holes
    PoolVector<std::uint32_t> ends_;  ///< of one with holes
};

}  // namespace firma
