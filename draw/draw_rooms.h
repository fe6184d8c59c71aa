// SPDX-License-Identifier: MIT
// On a plan: where each room is, by number and name, and the portals between them.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "draw/plan_raster.h"
#include "draw/svg_text.h"
#include "draw/view.h"
#include "firma/rooms.h"

namespace firma::draw {

/// Writes each room's number where most of it is seen around one place, and its name where that has room.
///
/// @param faces, rooms  of whose faces the raster was made, and the room of each
/// @return how many rooms have a label: not those that are hidden, or too small for one
std::size_t label_rooms(SvgText& svg, const World& world, const PlanRaster& raster, std::span<const RoomId> rooms);

/// Draws the polygons of portals, open and closed ones in looks of their own; faint where hidden. With a cut only what
/// lies beyond it and is not hidden.
/// @return how many portals
std::size_t draw_portals(SvgText& svg, const View& view, const World& world, const PlanRaster& raster,
                         const std::optional<double>& cut);

/// The styles that these use, for the head of the picture.
const char* room_styles();

}  // namespace firma::draw
