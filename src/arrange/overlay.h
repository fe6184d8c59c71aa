// SPDX-License-Identifier: MIT
// The faces of several solids laid over each other: points, edges and faces by number, equal points and planes once.
//
// A face's solid lies behind it. Each edge of a solid is used by two faces, once each way; where not all faces are
// here, some edges are used once.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "arrange/exact_tables.h"
#include "arrange/line_table.h"
#include "geometry/grid_box.h"

namespace firma {

/// How many solids are laid over each other.
inline constexpr std::size_t kOperands = 2;

struct OverlayEdge {
    std::uint32_t from = 0, to = 0;           ///< points
    PlaneId plane[2] = {kNoPlane, kNoPlane};  ///< that meet in it
    bool doubled = false;                     ///< there are others between the same points
};

/// How a loop uses an edge.
struct OverlaySide {
    std::uint32_t edge = 0;
    bool reversed = false;
};

struct OverlayFace {
    PlaneId plane = kNoPlane;
    std::uint8_t operand = 0;                      ///< whose it is
    std::uint32_t first_side = 0, side_count = 0;  ///< of all loops in a row
    std::uint32_t first_loop = 0, loop_count = 0;  ///< ends, counted from first_side; the first loop is the outer one
    GridBox box;                                   ///< of its corners, rounded
};

class Overlay {
public:
    std::uint32_t add_edge(const OverlayEdge& edge) {
        edges.push_back(edge);
        return std::uint32_t(edges.size()) - 1;
    }
    std::uint32_t add_face(PlaneId plane, std::uint8_t operand, std::span<const OverlaySide> sides,
                           std::span<const std::uint32_t> ends);

    std::span<const OverlaySide> sides(const OverlayFace& face) const {
        return {all_sides.data() + face.first_side, face.side_count};
    }
    std::span<const std::uint32_t> ends(const OverlayFace& face) const {
        return {loop_ends.data() + face.first_loop, face.loop_count};
    }
    std::uint32_t from(const OverlaySide& side) const {
        return side.reversed ? edges[side.edge].to : edges[side.edge].from;
    }
    std::uint32_t to(const OverlaySide& side) const {
        return side.reversed ? edges[side.edge].from : edges[side.edge].to;
    }
    const Plane& plane(PlaneId id) const { return tables.planes.plane(id); }
    const ExactPoint& point(std::uint32_t number) const { return tables.points.point(number); }

    ExactTables tables;
    LineTable lines{tables};
    std::vector<OverlayEdge> edges;
    std::vector<OverlayFace> faces;
    std::vector<OverlaySide> all_sides;
    std::vector<std::uint32_t> loop_ends;
};

}  // namespace firma
