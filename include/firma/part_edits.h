// SPDX-License-Identifier: MIT
// What edits and doors have to know of parts that move: a cutter's place in a part's frame, the portals a door closes.
#pragma once

#include <vector>

#include "firma/export.h"
#include "firma/hit.h"
#include "firma/moving_parts.h"
#include "firma/world.h"

namespace firma {

/// A pose of the world as a part sees it: where to carve(part.world(), cutter, pose), so that a blast takes of the part
/// what it reaches there. Its numbers are rounded as products of a turn are (some 1e-15 of them).
/// @param fraction  of the part's motion
/// Never allocates.
[[nodiscard]] FIRMA_EXPORT Pose pose_in_part(const MovingPart& part, double fraction, const Pose& pose);

/// The portals that a part closes where it stands at the start of its motion: of each of their polygons the middle, and
/// the corners a sixteenth of the way in from the rim, lie in the part's solid. For a door that is shut:
/// set_portal_open(world, portal, !at_first_stop(path, seconds)) for each of them.
/// @return ascending; none for a part whose motion cannot be used
/// Costs some casts through the part for each portal near it, and a look at each portal.
[[nodiscard]] FIRMA_EXPORT std::vector<PortalId> portals_closed_by(const World& world, const MovingPart& part);

}  // namespace firma
