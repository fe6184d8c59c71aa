// SPDX-License-Identifier: MIT
// A loose piece as a solid in a frame of its own, with what it weighs.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "carve/cut_job.h"
#include "carve/matter_shares.h"
#include "firma/chunk.h"

namespace firma {

/// What chunks are made of.
struct ChunkMatters {
    const MatterPieces* pieces = nullptr;  ///< null: all is of the first matter of the built-in table
    const CarveRules* rules = nullptr;     ///< may be null
    std::function<std::optional<Solid>(const MatterPiece&)> solid_of;
    std::function<std::uint32_t(std::uint32_t)> material_of;  ///< of what the cut made: its number in the world's names
};

/// A loose piece as a solid where it lies.
/// @param solid  that it came off, before the cut
Solid solid_of_cut_piece(const CutPiece& piece, const Solid& solid);

/// Works in pieces of some ten microseconds, and one that grows with the chunk.
class ChunkMaker {
public:
    /// @param solid    that the piece came off, before the cut
    /// @param density  as ChunkOptions::density
    /// @param matters  what it points to lives as long as this
    ChunkMaker(const CutPiece& piece, const Solid& solid, double density, const ChunkMatters& matters);

    /// Does one piece of work; false once there is none left.
    bool step();
    /// Once step() said false. Once: it is moved out.
    Chunk take() { return std::move(chunk_); }

private:
    const double density_;
    const ChunkMatters matters_;
    Chunk chunk_;
    std::unique_ptr<MatterShares> shares_;  ///< where several matters may be in it
};

}  // namespace firma
