// SPDX-License-Identifier: MIT
// The faces of a scene, each with its paint, and a world of those that are not the level's.
#pragma once

#include <vector>

#include "draw/draw_scene.h"

namespace firma::draw {

struct SceneFaces {
    std::vector<Face> faces;   ///< the level's first
    std::vector<Vec3> paints;  ///< red, green and blue, 0 .. 1, of each
    World things;              ///< what rays to a lamp meet of bodies and players; no face: World()
};

SceneFaces scene_faces(const World& world, const DrawnThings& things);

}  // namespace firma::draw
