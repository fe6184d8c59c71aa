// SPDX-License-Identifier: MIT
// What faces stop: bits of Face::mask and CastOptions::mask.
#pragma once

#include <cstdint>

namespace firma {

inline constexpr std::uint32_t kStopsWalk = 1;    ///< bodies that walk: walls, glass, clip brushes
inline constexpr std::uint32_t kStopsShots = 2;   ///< walls, glass
inline constexpr std::uint32_t kStopsSight = 4;   ///< walls, but no glass
inline constexpr std::uint32_t kStopsLiquid = 8;  ///< the surface of water, slime, lava
inline constexpr std::uint32_t kIsSky = 16;       ///< in addition to what a wall stops: the sky is painted on it

/// What a wall stops. Faces of formats that know no contents stop everything.
inline constexpr std::uint32_t kStopsSolid = kStopsWalk | kStopsShots | kStopsSight;

}  // namespace firma
