// SPDX-License-Identifier: MIT
// Portals beside a level of faces, and the world in rooms that both make. For readers of meshes, and for programs that
// build a Level of their own.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "firma/export.h"
#include "firma/grid.h"
#include "firma/level.h"
#include "firma/result.h"
#include "firma/world.h"

namespace firma {

/// Where the air of a level is divided. A portal is no face: open, until set_portal_open() closes it.
struct LevelPortal {
    std::string name;  ///< UTF-8, may be empty; two may share one
    /// Convex, exactly planar, 3 to 64 corners on the input grid (snap()), counter-clockwise seen from the front. What
    /// is not flat once it is snapped is given as triangles.
    std::vector<std::vector<GridPoint>> polygons;
};

/// What became of portals.
struct PortalReport {
    std::vector<std::uint32_t> idle;  ///< indices of portals, ascending: with one room on both sides, or parts of it
    std::string undivided;            ///< why there is one room, though there are portals; empty where they divide it
};

/// The level as a world, its air divided into rooms by portals. Only faces that bound closed solids divide air
/// (level_solidity() says which). A portal that does not close its opening, with them and other portals, is idle.
///
/// A portal may be larger than its opening: it is cut where faces cross its plane, and what lies in the solid is left
/// out. Of portals in one place the first counts, from whichever side. Faces are cut where portals meet them and stay
/// carvable; faces that bound no solid are cut likewise, and each part is put into the room that its front looks into.
/// Shells that stand free, as pillars, are in the room that they see. Rooms have no names, but for the last one where
/// the air reaches to infinity: "exterior". A portal with parts between several pairs of rooms becomes a portal for
/// each pair, of the same name; the first of its rooms is the one that its front looks into.
///
/// Without portals this is make_world(level, options). It is that too, and the report says why, where no face bounds a
/// solid, a corner of a face lies off the input grid, portals are cut into more than 2^14 parts, or faces, once cut,
/// are too thin for the grid or bound no solid.
///
/// @param portals  in any number; one without polygons is nothing
/// @param report   replaced, when given
/// @return the world; the errors of make_world(level, options); kInvalid, naming the portal by its index, for a polygon
///         that is not as LevelPortal says
/// Takes some four times as long as make_world() where there are portals, as faces are put in order around edges
/// exactly; parts of portals are compared in pairs.
FIRMA_EXPORT Result<World> make_divided_world(const Level& level, std::span<const LevelPortal> portals,
                                              const WorldOptions& options = {}, PortalReport* report = nullptr);

}  // namespace firma
