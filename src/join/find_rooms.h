// SPDX-License-Identifier: MIT
// The rooms of a joined level: volumes of air, and which sides of polygons bound each.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "join/arrangement.h"
#include "join/join_facets.h"

namespace firma {

struct JoinRooms {
    std::vector<std::uint32_t> of_side;  ///< a room for each side of a polygon, as an Arrangement numbers them
    std::uint32_t count = 0;             ///< the last one is the exterior, unless rock reaches to infinity
    std::uint32_t lost = 0;  ///< shells for which no line that was tried told where they hang: rooms of their own
};

/// Asks lines through a level what they pass through.
class RoomFinder {
public:
    /// @param facets        of the faces [face_count] and, after them, of the portals
    /// @param rock_outside  what reaches to infinity is solid
    RoomFinder(std::size_t face_count, std::size_t portal_count, const JoinFacets& facets, bool rock_outside = false);

    /// Shells that nothing joins around an edge (a pillar that stands free, a cavity) are joined by lines: what follows
    /// each other on a line through air bounds the same air.
    JoinRooms find(DisjointSets seen_together) const;

    /// The room that the front of a polygon in the air looks into; the last one where nothing tells.
    std::uint32_t room_of(const JoinRooms& rooms, std::span<const GridPoint> corners) const;

    /// The room that a point lies in; kSolid in solid, kUnsure where no line told.
    std::uint32_t room_at(const JoinRooms& rooms, const Vec3& point) const;
    static constexpr std::uint32_t kSolid = ~0u, kUnsure = ~0u - 1;

private:
    struct Crossing {
        double t;
        std::uint32_t facet;
        bool front;
    };

    bool cross_level(const Vec3& through, const Vec3& way, std::vector<Crossing>& crossings, double& at) const;
    template <class Join>
    bool follow(std::span<const Crossing> crossings, const Join& join) const;
    bool hang(std::uint32_t polygon, DisjointSets& sides) const;

    const std::size_t faces_, portals_;
    const bool rock_outside_;
    const JoinFacets& facets_;
    std::vector<std::uint32_t> polygon_of_;  ///< a facet each
    Ref<const Node> tree_;
};

}  // namespace firma
