// SPDX-License-Identifier: MIT
// What somebody in the world would see: in perspective, flat shaded, with a lamp's shadows.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "draw/picture.h"
#include "firma/world.h"

namespace firma::draw {

struct Camera {
    Vec3 eye, target;  ///< metres; they differ
    int up = 2;        ///< axis that points up
    double zoom = 1;   ///< 1 sees 90 degrees from left to right; 2 half as much of a wall
    int width = 640, height = 480;
};

/// Faces that an edit made are brown, others grey; edges stand where the surface turns or ends. Faces are seen from
/// their fronts, two-sided ones from both sides; where nothing is, it is black. Sky and the surface of liquids are
/// blue, glass and clips are looked through.
///
/// @param rooms  instead, faces have the colours of their rooms (room_colours.h), darker where an edit made them, and
///               portals are seen as panes: open ones greenish, closed ones red
Picture draw_view(const World& world, const Camera& camera, bool rooms = false);

/// How much of a picture new faces (Face::source_edit) would take, 0 .. 1, less what is nearer than two metres: for
/// choosing where to look from.
double share_of_new_faces(std::span<const Face> faces, const Camera& camera);

}  // namespace firma::draw
