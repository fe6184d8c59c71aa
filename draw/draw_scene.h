// SPDX-License-Identifier: MIT
// A level with what moves in it: pieces as the solids that they are, players, rockets, flashes, dust. In perspective,
// in the colours of what things are made of, with a lamp's shadows and with less light in corners.
#pragma once

#include <cstdint>
#include <vector>

#include "draw/draw_view.h"
#include "draw/picture.h"
#include "firma/capsule.h"
#include "firma/cutter.h"
#include "firma/solid.h"
#include "firma/tasks.h"
#include "firma/world.h"

namespace firma::draw {

/// A body: its facets where it lies.
struct DrawnSolid {
    Solid solid;
    Pose pose;  ///< scale 1
    std::uint32_t matter = 0;
};

/// Light, or dust: a ball without an edge.
struct DrawnPuff {
    Vec3 at;
    double radius = 1;  ///< metres
    Vec3 colour{1, 1, 1};
    double cover = 0;  ///< 0 .. 1: how much of what is behind its middle it hides
    double light = 0;  ///< how brightly it shines, on what is near it too; 0: not
};

/// What is in a level beside its faces.
struct DrawnThings {
    std::vector<DrawnSolid> solids;
    std::vector<Capsule> players;
    std::vector<DrawnPuff> puffs;
};

/// Draws level and things. Bodies throw shadows as the level does.
///
/// @param lamp   metres: where the light comes from
/// @param tasks  null: this thread does it all
/// Costs some twenty rays a pixel, through the level and through a world of the bodies' triangles, which is made for
/// it.
Picture draw_scene(const World& world, const DrawnThings& things, const Camera& camera, const Vec3& lamp,
                   const Tasks* tasks = nullptr);

}  // namespace firma::draw
