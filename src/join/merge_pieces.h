// SPDX-License-Identifier: MIT
// Pieces of one plane side by side become one, as long as that is convex.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "firma/texture.h"
#include "join/sides_on_lines.h"

namespace firma {

/// A polygon of the level that is joined, and what it says of itself.
struct JoinPiece {
    ConvexPiece piece;
    std::uint32_t source = 0;  ///< the brush side that it was cut from; of pieces that were merged the lowest
    std::uint32_t material = 0;
    std::uint32_t mask = 0;
    std::uint32_t texture = kNoTexture;  ///< of the brush side
};

/// Whether two are the same polygon and say the same.
bool same_piece(const JoinPiece& a, const JoinPiece& b);

/// Says whether the side between two corners, of pieces in a plane, has to stay.
using KeepSide = std::function<bool(std::uint32_t from, std::uint32_t to, PlaneId plane)>;

/// Merges greedily, longest sides first, what has one plane, material, mask and texture; the result depends on the
/// pieces and their order alone. Pieces may be added and removed afterwards: then only those are merged anew that could
/// merge with what was added or removed, or with each other because of it.
class PieceMerger {
public:
    PieceMerger(const ExactTables& tables, LineTable& lines) : tables_(tables), sides_(lines) {}

    /// @param piece  overlaps no other in its plane
    /// @param order  a number that no other piece has
    /// @return its number, which is never used again
    std::uint32_t add(JoinPiece piece, std::uint64_t order);
    void remove(std::uint32_t piece);

    /// @param keep  says the same as before of pieces that were not added since
    /// @return the pieces of which merged() has changed, each once
    std::span<const std::uint32_t> merge(const KeepSide& keep);

    /// As it was added.
    const JoinPiece& piece(std::uint32_t piece) const { return entries_[piece].piece; }
    /// What a piece has become, together with others; without sides where it became part of another, or was removed.
    const JoinPiece& merged(std::uint32_t piece) const { return entries_[piece].merged; }
    std::uint64_t order(std::uint32_t piece) const { return entries_[piece].order; }

    /// Pieces merged so far, those that were merged anew counted again.
    std::size_t work() const { return work_; }

private:
    struct Entry {
        JoinPiece piece, merged;
        std::uint64_t order = 0;
        std::uint32_t first_side = 0;  ///< of `sides_`
        std::uint32_t next = 0;        ///< around all that became one with it
        bool live = true, again = false;
    };
    struct Shared {
        std::size_t side = 0;
        std::uint32_t other = FlatMap::kNone;
        std::size_t other_side = 0;
        double length = 0;
    };

    void merge_again(std::uint32_t piece);
    void find_again(const KeepSide& keep);
    void follow_sides(std::uint32_t piece, const KeepSide& keep);
    void merge_plane(std::span<const std::uint32_t> group, const KeepSide& keep);
    void enter(std::uint32_t index);
    bool merge_longest(std::uint32_t index, const KeepSide& keep);
    bool merge_over(std::uint32_t index, const Shared& shared);
    bool others_at(const ConvexPiece& piece, std::size_t side);
    int turn(const ConvexPiece& in, std::size_t a, const ConvexPiece& out, std::size_t b) const;
    double square_length(std::uint32_t from, std::uint32_t to) const;

    const ExactTables& tables_;
    SidesOnLines sides_;  ///< of pieces as they were added
    std::vector<Entry> entries_;
    std::vector<std::uint32_t> added_, removed_;  ///< since the last merge()
    std::size_t live_ = 0, work_ = 0;

    std::vector<std::uint32_t> again_, changed_;
    std::vector<JoinPiece> before_;
    FlatMap piece_of_;  ///< by a side's corners, from and to; may name one that has gone
    std::vector<Shared> tried_;
    std::vector<PieceSide> merged_;
};

/// PieceMerger for pieces that stay as they are, in the order in which they stand.
/// @param pieces  replaced by what they become
void merge_pieces(const ExactTables& tables, std::vector<JoinPiece>& pieces, const KeepSide& keep);

}  // namespace firma
