// SPDX-License-Identifier: MIT
// Which bodies are near each other, and which of their spheres.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "body/mover.h"

namespace firma {

/// Where a body may be in a step.
struct BodyBall {
    Vec3 centre;
    double reach = 0;
    std::uint32_t slot = 0;
    std::uint32_t mask = ~0u;
    bool awake = false;
};

/// Pairs of balls that overlap, at least one of each awake and with a common bit: by slots, the lower one first, in
/// order. Sorts along one axis, and tests what overlaps there.
std::vector<std::pair<std::uint32_t, std::uint32_t>> near_pairs(std::vector<BodyBall> balls);

/// A body as contacts see it: a mover, or where one sleeps.
struct PlacedBody {
    Vec3 position;
    TurnMatrix matrix;
    const BodyShapeData* shape = nullptr;
    std::uint32_t mover = kFixed;
    std::uint32_t slot = 0;

    Vec3 centre_of(std::uint32_t sphere) const { return position + matrix * shape->spheres[sphere].centre; }
};

/// Of two bodies: all of those of up to 64 spheres each.
inline constexpr std::size_t kMaxPairContacts = 4096;

/// Adds the pairs of spheres within `margin` of each other; of more than kMaxPairContacts the deepest.
/// @param a  a mover
void find_pair_contacts(const PlacedBody& a, const PlacedBody& b, double margin, std::vector<NearContact>& found);

}  // namespace firma
