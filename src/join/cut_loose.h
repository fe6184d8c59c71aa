// SPDX-License-Identifier: MIT
// What casts meet beside the solid, cut to the air and to its rooms.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "join/brush_bodies.h"
#include "join/loose_pieces.h"
#include "join/portal_cutter.h"

namespace firma {

/// Cuts glass, clips, liquids, brushes that could not be joined, and surfaces.
class LooseCutter {
public:
    LooseCutter(const BrushLevel& level, ExactTables& tables, BrushBodies& bodies, PortalCutter& cutter)
        : level_(level), tables_(tables), bodies_(bodies), cutter_(cutter) {}

    /// @param left_out  brushes that are not in use, but have bodies
    /// @return kind by kind what of the faces neither the solid nor their own kind hides; without rooms
    std::vector<LooseFacet> cut(std::span<const std::uint32_t> left_out);

private:
    void cut_brushes(std::span<const std::uint32_t> brushes);
    void cut_surfaces();

    const BrushLevel& level_;
    ExactTables& tables_;
    BrushBodies& bodies_;
    PortalCutter& cutter_;
    std::vector<LooseFacet> made_;
    std::vector<ConvexPiece> pieces_;
    std::vector<std::uint32_t> near_;
};

}  // namespace firma
