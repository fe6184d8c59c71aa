// SPDX-License-Identifier: MIT
// What a ray from a point sees first, of the solid's faces and of portals: this is what tells where the point is.
#pragma once

#include "firma/rooms.h"
#include "world/world_data.h"

namespace firma {

/// Whether portals are looked at; without them a point is in the air or in the solid.
enum class SeePortals : std::uint8_t { kNo, kYes };

/// Where a point is, by rays in ways that hardly graze anything.
/// @return kRoom with kAnyRoom for air in which the first ray that tells met nothing
Location see_where(const World& world, const Vec3& point, SeePortals portals);

}  // namespace firma
