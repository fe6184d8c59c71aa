// SPDX-License-Identifier: MIT
// Seeded cuts for a world made of a level with rooms: each kind is about one way in which carving there goes wrong.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "firma/world.h"
#include "scenes/cut_families.h"

namespace firma::scenes {

/// The first three are the families our_level_* of cut_families.h, on the walls of this world's rooms.
enum class LevelCuts : std::uint8_t {
    kSpread,
    kCorner,    ///< all in one corner of a room
    kSnapped,   ///< on round coordinates, as brushes are: vertices on planes, edges that meet
    kRepeated,  ///< in one place, or a step of the grid beside it; carved and filled again
    kPortals,   ///< in openings, at their rims and corners: rooms become one, or are walled up
    kRim,       ///< in the hull that looks outward
    kFilling,
    kLarge,  ///< up to 6 m: several rooms at once
};
inline constexpr std::array<std::string_view, 8> kLevelCutNames{"spread",  "corner", "snapped", "repeated",
                                                                "portals", "rim",    "filling", "large"};

/// Where cuts may go: the walls of a world's rooms and its portals.
struct CutPlaces {
    Level inside;   ///< faces of solids that look into rooms; into the exterior where there is no other room
    Level outside;  ///< those that look into the exterior; into rooms where there are none
    std::vector<std::vector<Vec3>> portals;  ///< their polygons
};
CutPlaces cut_places(const World& world);

/// About 24 cuts; in a world without portals kPortals is the same as kSpread.
std::vector<CutOrder> level_cuts(const CutPlaces& places, LevelCuts kind, std::uint64_t seed, std::uint64_t index);

}  // namespace firma::scenes
