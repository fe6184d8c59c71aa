// SPDX-License-Identifier: MIT
// The sides of a .map as points of the input grid.
#pragma once

#include <vector>

#include "brush/parse_map.h"
#include "firma/grid.h"

namespace firma {

struct MapPlane {
    GridPoint points[3];  ///< counter-clockwise seen from outside
    bool valid = false;   ///< false: the points lie on a line; of a plane, there is none such in the world
    double shift = 0;     ///< metres between a corner of the side's face, as the file has it, and the plane, at most
    double area = 0;      ///< of the face in square units, where asked for
};

struct MapPlanes {
    std::vector<MapPlane> of_side;  ///< by index in MapFile::sides
    bool complete = true;           ///< false: too many sides to look at all faces (kMostSidePairs)
};

/// Where a side's three points lie on the grid, they are its points. Else rounding them would turn the plane: editors
/// write points of turned brushes a unit apart. Then the points are chosen among the corners of the face, as
/// fit_plane() does, and so for sides given as planes that are not axial; once for all sides that were meant to be on
/// one plane. If that is also the plane of a side on the grid, its points are taken.
///
/// @param file        all its points are in the world
/// @param wants_area  by brush: whether its faces' areas are needed
MapPlanes make_map_planes(const MapFile& file, double scale, const std::vector<bool>& wants_area);

}  // namespace firma
