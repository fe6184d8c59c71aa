// SPDX-License-Identifier: MIT
// Two scenes in our level, the depot: a bridge that comes loose, and a hole between two rooms.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "cli/json.h"
#include "draw/draw_view.h"
#include "firma/world.h"

namespace firma::cli {

/// What a cast through the hole met.
struct DemoSight {
    double distance = 0;  ///< metres
    std::string material, room;
};

/// The bridge across the hall, shot at both ends.
struct DemoBridge {
    std::size_t shots = 0;
    double seconds = 0;  ///< of the shots
    std::size_t chunks = 0, crumbs = 0;
    double volume = 0, mass = 0;  ///< of all chunks, cubic metres and kilograms
    /// Of the heaviest.
    double largest_volume = 0, largest_mass = 0;
    Vec3 centre;  ///< of mass, metres
};

/// A crater through the wall of 6 cm between two offices.
struct DemoHole {
    double seconds = 0;
    std::size_t portals = 0;  ///< that it made
    PortalId portal;          ///< the first of these, if any
    std::string rooms[2];     ///< that it joins
    double area = 0;          ///< of its polygons, square metres
    DemoSight before, after;
};

struct DemoDepot {
    World after;
    DemoBridge bridge;
    DemoHole hole;
};

/// Whether a world is that of levels/depot.map, by the names of the rooms and the bridge between its walls.
bool is_depot(const World& world);

/// Shoots at both, where is_depot(). Nothing for other worlds. Pieces that come loose leave; with_anchors() was called
/// before.
std::optional<DemoDepot> shoot_depot(const World& world);

/// Where the bridge is seen from, as long as it is there.
draw::Camera depot_camera();

/// Rows of the demo's table.
std::string depot_text(const DemoDepot& depot);
Json depot_json(const std::optional<DemoDepot>& depot);

}  // namespace firma::cli
