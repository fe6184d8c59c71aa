// SPDX-License-Identifier: MIT
// Where portals end faces, and each other: so that each face lies in one room.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "index/box_tree.h"
#include "join/merge_pieces.h"

namespace firma {

class PortalCutter {
public:
    explicit PortalCutter(ExactTables& tables) : tables_(tables) {}

    /// @param portals  polygons in the air, from now on
    void set_portals(std::span<const JoinPiece> portals);

    /// Divides what reaches through a portal, or past one nearby, by its plane. Parts are added at the end.
    void divide_at_portals(std::vector<JoinPiece>& pieces);

    /// merge_pieces(), but not over a side for which ends_at_portal().
    void merge_between_portals(std::vector<JoinPiece>& pieces) const;

    /// Whether a side between two corners, of pieces in a plane, lies on a portal of another plane.
    bool ends_at_portal(std::uint32_t from, std::uint32_t to, PlaneId plane) const;

private:
    ExactTables& tables_;
    std::vector<PlaneId> planes_;  ///< of each portal
    BoxTree tree_;                 ///< of the same
    std::vector<std::uint32_t> near_;
};

}  // namespace firma
