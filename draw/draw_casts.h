// SPDX-License-Identifier: MIT
// Casts as lines to their hits, with contact points, normals, and the sphere at start and contact.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "draw/svg_text.h"
#include "draw/view.h"
#include "firma/hit.h"

namespace firma::draw {

/// A cast that was made, as much of it as a picture needs.
struct DrawnCast {
    Vec3 start, path;
    double radius = 0;
    Status status = Status::kMiss;
    Vec3 centre, point, normal;  ///< as in PolygonHit; only when it hit or touches
};

/// Draws casts over a view.
///
/// @param slab  when given, only casts that come within this many metres of the plane at slab->first are drawn
/// @return how many were drawn
struct Slab {
    double at = 0, reach = 0;  ///< metres along the view's depth axis
};
std::size_t draw_casts(SvgText& svg, const View& view, std::span<const DrawnCast> casts,
                       const std::optional<Slab>& slab = {});

/// Adds where a cast begins and ends to a box.
void add_to(Box& box, const DrawnCast& cast);

/// The styles that draw_casts() uses, for the head of the picture.
const char* cast_styles();

}  // namespace firma::draw
