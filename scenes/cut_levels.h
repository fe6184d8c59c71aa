// SPDX-License-Identifier: MIT
// Seeded closed levels to be carved: rooms in rock, solids in the open, blocks with cavities, pillars, thin walls.
#pragma once

#include <vector>

#include "scenes/grid_polygons.h"

namespace firma::scenes {

/// Adds the surface of a box, its sides cut into count[a] x count[b] panels of two triangles each (or into one
/// rectangle where all counts are 1 and there is no bump).
struct PanelBox {
    Steps low, high;
    int count[3] = {1, 1, 1};
    double bump = 0;             ///< metres that a panel's corners within a side are moved by, at most
    std::int64_t step = kInput;  ///< corners are multiples of this
    bool room = false;           ///< air within rather than a solid
    bool triangles = true;
};
void add_panel_box(std::vector<GridPolygon>& faces, const PanelBox& box, Rng& rng);

struct CutLevel {
    std::vector<GridPolygon> faces;  ///< wound so that fronts look into the air
    double size = 1;                 ///< metres, of what craters are to be scaled to: about a room's height
};

/// Rooms as separate cavities in a block with an outer hull, `rooms` each way, walls bumped, 1.5 m between rooms.
CutLevel bumpy_rooms(Rng& rng, int rooms, int panels, const Steps& place, std::int64_t step = kInput);
/// One room in endless rock, with pillars that stand free in its air.
CutLevel room_with_pillars(Rng& rng, const Steps& place, std::int64_t step = kInput);
/// A block in the open, with cavities.
CutLevel block_with_cavities(Rng& rng, const Steps& place, std::int64_t step = kInput);
/// Two rooms in rock, 1 to 200 steps of the input grid apart.
CutLevel thin_wall(Rng& rng, const Steps& place);
/// A room of up to 300 m, of a rectangle or two triangles a side: too large to be cut untiled.
CutLevel large_room(Rng& rng, const Steps& place);
/// Any mesh of closed_meshes.h on the input grid, as a room in rock or, turned over, a solid in the open.
CutLevel any_closed_mesh(Rng& rng);

}  // namespace firma::scenes
