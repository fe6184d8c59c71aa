// SPDX-License-Identifier: MIT
// What an arrangement makes, and what its caller wants of it.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "arrange/label_cells.h"

namespace firma {

struct ArrangedEdge {
    std::uint32_t from = 0, to = 0;           ///< points
    PlaneId plane[2] = {kNoPlane, kNoPlane};  ///< that meet in it
    std::uint32_t edge = kNoEdge;             ///< the overlay's that it is, whole
    bool doubled = false;                     ///< there are, or may be, others between the same points
    static constexpr std::uint32_t kNoEdge = ~0u;
};

struct ArrangedFace {
    std::uint32_t face = 0;                        ///< the lowest of the overlay's that it is made of
    PlaneId plane = kNoPlane;                      ///< looks out of the result
    std::uint32_t first_use = 0, use_count = 0;    ///< of all loops in a row
    std::uint32_t first_loop = 0, loop_count = 0;  ///< ends, counted from first_use; the first loop is the outer one
};

struct Arranged {
    bool changes = true;  ///< else the result is the first operand, and nothing else is set
    std::vector<ArrangedEdge> edges;
    std::vector<ArrangedFace> faces;    ///< in order of `face`
    std::vector<OverlaySide> all_uses;  ///< of `edges`
    std::vector<std::uint32_t> loop_ends;
    std::vector<std::uint8_t> stays;  ///< of each of the overlay's faces: whether it is one of the result, as it was
    /// Of each use of the cells: the edge that it is a part of; kNoEdge where its cell, or the edge, is not kept.
    std::vector<std::uint32_t> edge_of_use;

    std::span<const OverlaySide> uses(const ArrangedFace& face) const {
        return {all_uses.data() + face.first_use, face.use_count};
    }
    std::span<const std::uint32_t> ends(const ArrangedFace& face) const {
        return {loop_ends.data() + face.first_loop, face.loop_count};
    }
};

/// What becomes of a cell.
enum class Kept : std::uint8_t { kNot, kAsItIs, kTurned };

struct Selection {
    /// Of a solid's cell with a label.
    std::function<Kept(std::uint8_t operand, CellLabel label)> keep;
    /// Whether faces that lie side by side in one plane may become one. Those of one face always do.
    std::function<bool(std::uint32_t face, std::uint32_t other)> alike;
    /// So long, along any axis, different faces may become at most: longer ones would be divided again. Metres.
    double longest = 0;
    /// Whether an edge of the overlay may be used again.
    std::function<bool(std::uint32_t edge)> reusable;
    /// Whether the ends of edges that may be used again stay, where they lie along a line, too: something else than
    /// these faces ends there.
    bool keeps_ends = false;
    /// With `keeps_ends`: whether ends stay, too, where a cell of the first operand that is not kept has a corner: such
    /// cells are wanted with the edges of those kept, see Arranged::edge_of_use.
    bool keeps_corners = false;
};

}  // namespace firma
