// SPDX-License-Identifier: MIT
// Narrows of the sampled air become portals, and the exact model says which of them are any.
#include "brush/choose_portals.h"

#include <algorithm>
#include <optional>

#include "brush/choose_narrows.h"
#include "join/brush_join.h"

namespace firma {
namespace {

constexpr double kThick = 0.015625;  ///< metres: a portal's brush; any will do
constexpr int kMostRounds = 8;       ///< of choosing others in place of idle ones

/// A box as a brush; its portal is the side that looks along `axis`.
void add_portal(BrushLevel& level, int axis, const Vec3& low, const Vec3& high) {
    Brush brush;
    brush.kind = BrushKind::kPortal;
    brush.first_side = std::uint32_t(level.sides.size());
    brush.side_count = 6;
    for (int k = 0; k < 3; ++k)
        for (const bool positive : {true, false}) {
            const int along = (axis + k) % 3, u = (along + 1) % 3, v = (along + 2) % 3;
            Vec3 corners[3] = {low, low, low};
            corners[1][u] = corners[2][u] = high[u];
            corners[2][v] = high[v];
            BrushSide side;
            for (int c = 0; c < 3; ++c) {
                corners[c][along] = positive ? high[along] : low[along];
                side.points[positive ? c : 2 - c] = snap(corners[c]).value();
            }
            side.portal = positive && along == axis;
            level.sides.push_back(side);
        }
    level.brushes.push_back(brush);
}

/// A level with some narrows as portals, joined. Narrows that were tried stay in it, not in use.
class PortalTrial {
public:
    PortalTrial(const BrushLevel& level, const AirGrid& grid, std::span<const Narrow> narrows)
        : level_(level), grid_(grid), narrows_(narrows), brush_of_(narrows.size(), kNoBrush) {
        level_.surfaces = {};  // they divide nothing
    }

    /// @return which of the chosen ones divide two rooms
    Result<std::vector<bool>> try_portals(std::span<const std::uint32_t> chosen) {
        for (const std::uint32_t k : chosen) {
            if (brush_of_[k] != kNoBrush) continue;
            brush_of_[k] = std::uint32_t(level_.brushes.size());
            add_portal(level_, grid_, narrows_[k]);
        }
        if (!BrushJoin::fits(level_))
            return Error{ErrorCode::kTooLarge, level_.name, "a level has fewer than 2^20 brush sides"};
        if (join_) {
            join_->grow();
            join_->take_back();  // what kept brushes apart may be gone
            for (std::uint32_t k = 0; k < narrows_.size(); ++k)
                if (brush_of_[k] != kNoBrush)
                    join_->use(brush_of_[k], std::binary_search(chosen.begin(), chosen.end(), k));
        } else {
            join_.emplace(level_);
        }
        join_->update();
        const JoinedLevel& joined = join_->divide();
        rounds = joined.rounds;
        std::vector<bool> used_side(level_.sides.size()), used;
        for (const JoinPortal& portal : joined.portals) used_side[portal.source] = true;
        for (const std::uint32_t k : chosen) used.push_back(used_side[level_.brushes[brush_of_[k]].first_side]);
        return used;
    }

    std::vector<JoinRound> rounds;

private:
    BrushLevel level_;
    const AirGrid& grid_;
    const std::span<const Narrow> narrows_;
    std::vector<std::uint32_t> brush_of_;  ///< by narrow
    std::optional<BrushJoin> join_;
};

}  // namespace

void add_portal(BrushLevel& level, const AirGrid& grid, const Narrow& narrow) {
    constexpr double kRim = kWorldRim - 1;
    Vec3 low, high;
    high[narrow.axis] = std::clamp(grid.centre(narrow.axis, narrow.layer), -kRim, kRim);
    low[narrow.axis] = high[narrow.axis] - kThick;
    for (int k = 0; k < 2; ++k) {
        const int across = (narrow.axis + 1 + k) % 3;
        low[across] = std::clamp(narrow.low[k], -kRim, kRim);
        high[across] = std::clamp(narrow.high[k], -kRim, kRim);
    }
    add_portal(level, narrow.axis, low, high);
}

/// Leaving out an idle portal joins no rooms: what is left of a choice needs no second test.
Result<PortalChoice> choose_portals(const BrushLevel& level, const AirGrid& grid, std::span<const Narrow> narrows,
                                    const DivideOptions& options) {
    PortalChoice best;
    PortalTrial trial(level, grid, narrows);
    std::vector<bool> idle(narrows.size());
    for (int round = 0; round < kMostRounds; ++round) {
        const std::vector<std::uint32_t> chosen = choose_narrows(grid, narrows, idle, options);
        if (chosen.size() <= best.narrows.size()) break;
        const Result<std::vector<bool>> used = trial.try_portals(chosen);
        if (!used.ok()) return used.error();
        std::vector<std::uint32_t> good;
        for (std::size_t k = 0; k < chosen.size(); ++k) {
            if (used.value()[k])
                good.push_back(chosen[k]);
            else
                idle[chosen[k]] = true;
        }
        best.idle += chosen.size() - good.size();
        const bool all = good.size() == chosen.size();
        if (good.size() > best.narrows.size()) best.narrows = std::move(good);
        if (all) break;
    }
    best.rounds = std::move(trial.rounds);
    return best;
}

}  // namespace firma
