// SPDX-License-Identifier: MIT
// Pieces of a part as bodies: where the part stands, as it moves there.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "firma/break_parts.h"

namespace firma {

/// The matter that most of a world's surface is of. Costs its faces.
std::uint32_t matter_of_surface(const World& world);

/// A part at a fraction of its motion, whose pieces become bodies.
class PartPieces {
public:
    PartPieces(const World& level, const MovingPart& part, const BreakOptions& options)
        : level_(level), part_(part), options_(options) {}

    /// @param piece  its solid, its matter, and where its frame lies in the part's (DebrisPiece::origin); `of_part` is
    ///               set
    /// @return nothing where it can be no body
    std::optional<BodyId> add(Bodies& bodies, Debris& debris, DebrisPiece piece, const MassProperties& mass) const;

private:
    const World& level_;
    const MovingPart& part_;
    const BreakOptions& options_;
};

}  // namespace firma
