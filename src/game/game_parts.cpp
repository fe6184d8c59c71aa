// SPDX-License-Identifier: MIT
// Parts of a game by its ticks.
#include "game/game_parts.h"

#include <algorithm>
#include <utility>

#include "base/sort.h"
#include "firma/part_edits.h"

namespace firma {
namespace {

/// Of what was not set off: before time 0, by so little that nothing swings or spins on from there by a step of the
/// grid.
constexpr double kBeforeStart = -0x1p-40;

}  // namespace

double drive_seconds(const GameState& game, const PartDrive& drive, std::uint64_t tick) {
    if (drive.waits && drive.started > tick) return kBeforeStart;
    const std::uint64_t since = (drive.waits ? drive.started : 0) + drive.held;
    return double(std::int64_t(tick - since)) / game.rate + drive.ahead;
}

RigidMotion drive_motion(const GameState& game, const PartDrive& drive) {
    const double from = drive_seconds(game, drive, game.tick);
    const bool stands = drive.waits && drive.started > game.tick;
    return part_motion(drive.path, from, stands ? from : drive_seconds(game, drive, game.tick + 1));
}

std::vector<PortalWish> portal_wishes(const GameState& game) {
    std::vector<PortalWish> wishes;
    for (const PartDrive& drive : game.drives) {
        if (drive.portals.empty()) continue;
        const bool shut = at_first_stop(drive.path, drive_seconds(game, drive, game.tick)) &&
                          at_first_stop(drive.path, drive_seconds(game, drive, game.tick + 1));
        for (const PortalId portal : drive.portals) wishes.push_back({portal, !shut});
    }
    sort_range(wishes, [](const PortalWish& a, const PortalWish& b) {
        return a.portal != b.portal ? a.portal < b.portal : a.open > b.open;
    });
    const auto same = [](const PortalWish& a, const PortalWish& b) { return a.portal == b.portal; };
    wishes.erase(std::unique(wishes.begin(), wishes.end(), same), wishes.end());
    return wishes;
}

std::uint32_t add_part(GameState& game, MovingPart part, PartDrive drive, bool find_portals) {
    const double now = drive_seconds(game, drive, game.tick);
    part.motion = part_motion(drive.path, now, now);
    if (find_portals && drive.waits)
        for (const PortalId portal : portals_closed_by(game.world, part)) drive.portals.push_back(portal);
    game.parts.push_back(std::move(part));
    game.drives.push_back(std::move(drive));
    return std::uint32_t(game.parts.size() - 1);
}

}  // namespace firma
