// SPDX-License-Identifier: MIT
// Seeded blasts for a world with rooms and doors: each family is about one place where an edit of rooms goes wrong.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "firma/rooms.h"
#include "scenes/level_cuts.h"

namespace firma::scenes {

enum class BlastFamily : std::uint8_t {
    kWall,
    kAir,    ///< clear of the walls, or just touching them
    kSolid,  ///< behind the walls, clear of them or just touching
    kCorner,
    kDoorway,     ///< in the opening of a portal
    kRim,         ///< at an edge or a corner of a portal
    kOverPortal,  ///< in the wall over, under, beside a portal
    kClosedDoor,  ///< the same, of a closed one
    kLattice,  ///< boxes and craters with corners at quarters of a metre, boxes flush with walls, or as large as doors
    kAgain,    ///< where the one before was, or a step beside it
};
inline constexpr std::array<std::string_view, 10> kBlastNames{
    "wall", "air", "solid", "corner", "doorway", "rim", "over_portal", "closed_door", "lattice", "again"};

struct RoomBlast {
    CutOrder cut;
    std::optional<Vec3> from;  ///< CarveOptions::from
    BlastFamily family = BlastFamily::kWall;
};

/// Where blasts may go.
struct BlastPlaces {
    CutPlaces cuts;
    std::vector<std::vector<Vec3>> doors;  ///< polygons of closed portals
};
BlastPlaces blast_places(const World& world);

/// Blasts of 0.3 to 6 m from their middle to what they reach, small ones more often; about one in five fills. In a
/// world without portals those of portals are at walls.
std::vector<RoomBlast> room_blasts(const BlastPlaces& places, std::size_t count, Rng& rng);

/// The world with so large a share of its portals closed.
World with_closed_doors(const World& world, double share, Rng& rng);

}  // namespace firma::scenes
