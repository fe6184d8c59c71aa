// SPDX-License-Identifier: MIT
// Which two sides of faces meet in each edge of the result.
#include "arrange/pair_sides.h"

namespace firma {

SidePairer::SidePairer(KeptCells& in) : in_(in) {}

bool SidePairer::pair_around(std::uint32_t piece) {
    spokes_.clear();
    std::size_t edges = 0;
    for (const std::uint32_t use : in_.users.at(piece)) {
        if (!in_.is_kept(use)) continue;
        const std::uint32_t cell = in_.users.cell_of(use);
        const bool forward = in_.uses[use].forward;
        spokes_.push_back({use, cell, forward ? in_.plane_of(cell) : from_behind(in_.plane_of(cell)), forward, 0, 0});
        edges += !in_.dissolved[use];
    }
    if (edges == 0) return true;
    sort_around(in_.overlay.lines, in_.lines.piece(piece).line, spokes_);
    const auto after = [&](std::size_t k) { return k + 1 < spokes_.size() ? k + 1 : 0; };
    for (std::size_t k = 0; k < spokes_.size(); ++k) {
        const CellSpoke &here = spokes_[k], &next = spokes_[after(k)];
        if (here.air_after == next.air_after || here.half == next.half) return false;
        if (!here.air_after || in_.dissolved[here.use]) continue;
        std::size_t end = after(k);
        while (in_.dissolved[spokes_[end].use]) end = after(spoke_of(in_.across[spokes_[end].use]));
        const std::uint32_t other = spokes_[end].use;
        in_.partner[here.use] = other;
        in_.partner[other] = here.use;
        in_.crowded[here.use] = in_.crowded[other] = edges > 2;
    }
    return true;
}

void SidePairer::pair_by_edge(std::uint32_t piece) {
    for (const std::uint32_t use : in_.users.at(piece)) {
        if (!in_.is_kept(use) || in_.dissolved[use] || in_.partner[use] != KeptCells::kNone) continue;
        std::uint32_t other = in_.mate_of(use);
        while (other != KeptCells::kNone && in_.dissolved[other]) other = in_.mate_of(in_.across[other]);
        if (other == KeptCells::kNone || in_.partner[other] != KeptCells::kNone) continue;
        in_.partner[use] = other;
        in_.partner[other] = use;
    }
}

std::size_t SidePairer::spoke_of(std::uint32_t use) const {
    std::size_t k = 0;
    while (spokes_[k].use != use) ++k;
    return k;
}

}  // namespace firma
