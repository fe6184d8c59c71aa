// SPDX-License-Identifier: MIT
// From cells and their edges to the loops of faces.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "arrange/kept_cells.h"
#include "arrange/loops_by_outline.h"
#include "base/flat_map.h"

namespace firma {

class CellWriter {
public:
    CellWriter(KeptCells& in, Arranged& made);

    /// One that may be used again.
    void know_edge(std::uint32_t edge);
    /// Groups in order of their lowest cell, and the cells of each.
    void gather_groups();
    /// Sets what follows each use of the group.
    bool trace(std::uint32_t group);
    /// Its faces.
    bool write(std::uint32_t group);
    std::size_t group_count() const { return members_first_.size() - 1; }
    /// See Arranged::edge_of_use. Once: they are moved out.
    std::vector<std::uint32_t> take_edges() { return std::move(chain_); }
    /// Of the group traced or written last.
    std::size_t uses_traced() const { return group_uses_.size(); }
    std::size_t uses_written() const { return loops_.size(); }

private:
    std::span<const std::uint32_t> members(std::uint32_t group) const;
    /// Nothing was taken off a single cell, nor is it turned: its loops are what they were.
    bool is_whole(std::uint32_t group) const;
    void follow_cell(const Cell& cell);
    /// Whether the point between a use and the next one is none of the result's: only their line passes there, between
    /// the same two faces.
    bool passes_through(std::uint32_t use);
    /// Whether it came with an edge that may be used again.
    bool may_stay(std::uint32_t use) const;
    /// With Selection::keeps_ends: whether the point between a use and the next one is an end all the same, that of any
    /// face's edge that may be used again, kept or not, or of the line along which the solids touch: then all edges end
    /// there.
    bool ends_stay(std::uint32_t use, std::uint32_t after) const;
    bool has_ending(std::uint32_t piece, std::uint32_t next) const;
    /// Whether a cell that is not kept lies at one of two pieces of a line and does not go on along the other one.
    bool has_corner(std::uint32_t piece, std::uint32_t next) const;
    bool goes_on(std::uint32_t use, std::uint32_t next) const;
    /// The number of the edge that a chain of uses makes, which begins with `first` and ends before a point that stays.
    std::uint32_t edge_of(std::uint32_t first, std::uint32_t last);
    bool is_doubled(std::uint32_t first, std::uint32_t last) const;
    /// Whether another edge that may be used again, or one made before, runs between the same points.
    bool has_twin(std::uint32_t first, std::uint32_t last);
    static std::uint64_t pair_key(std::uint32_t a, std::uint32_t b);
    /// The overlay's edge that a chain is, if it is one.
    std::uint32_t whole_edge(std::uint32_t first, std::uint32_t last) const;
    /// Whether the face is the overlay's, with the same edges.
    bool stays_whole(std::uint32_t index, std::span<const OverlaySide> sides, std::span<const std::uint32_t> cells);
    bool add_faces(const ArrangedFace& like);
    /// The loops of the group at hand, piece by piece.
    void find_whole_loops();

    KeptCells& in_;
    Arranged& made_;
    FlatMap edge_between_;              ///< of two points: one that may be used again, or kMadeEdge
    std::vector<std::uint32_t> next_;   ///< of each use: what follows in its loop
    std::vector<std::uint32_t> chain_;  ///< of each use: its edge
    std::vector<std::uint8_t> seen_;
    std::vector<std::uint32_t> members_first_, members_;
    std::vector<PieceUse> group_uses_, loops_, whole_loops_;
    std::vector<std::uint32_t> ends_, piece_ends_, wanted_;  ///< of loops_, of whole_loops_
    std::vector<OverlaySide> sides_;
    LoopsByOutline outlines_;
};

}  // namespace firma
