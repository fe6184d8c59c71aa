// SPDX-License-Identifier: MIT
// Which sides of faces and portals bound the same room, where edges alone do not tell.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/disjoint_sets.h"
#include "firma/world.h"
#include "join/join_facets.h"

namespace firma::gltf {

/// Sides are numbered as an Arrangement has them; one more stands for infinity.
class RoomSides {
public:
    RoomSides(std::size_t faces, std::size_t portals, const JoinFacets& facets, bool rock_outside);

    /// A room for each side. A shell that nothing joins around an edge (a pillar that stands free) is hung by a ray to
    /// what it sees.
    /// @param count  gets how many rooms there are; the last reaches to infinity, unless rock does
    std::vector<std::uint32_t> rooms(DisjointSets seen_together, std::uint32_t& count) const;

    /// The room that a facet's middle lies in.
    std::uint32_t room_seen_from(std::span<const GridPoint> corners, std::span<const std::uint32_t> room_of_side,
                                 std::uint32_t count) const;

private:
    std::uint32_t polygon_of(std::uint32_t side) const;
    std::optional<std::uint32_t> seen_along(const Vec3& from, const Vec3& way) const;
    bool hang(std::uint32_t side, DisjointSets& sides) const;

    const std::size_t faces_, sides_;
    const JoinFacets& facets_;
    const bool rock_outside_;
    World probe_;  ///< all facets in one room, a polygon's number as source
};

}  // namespace firma::gltf
