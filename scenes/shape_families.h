// SPDX-License-Identifier: MIT
// Families that are about the polygons: their shapes, sizes and places.
#pragma once

namespace firma::scenes {

class CastBuilder;

void generic_triangles(CastBuilder& b);  ///< anywhere
void generic_ngons(CastBuilder& b);      ///< of random whole planes
void surface_grid(CastBuilder& b);       ///< corners on single steps of the surface grid
void many_corners(CastBuilder& b);       ///< up to 64
void collinear_corners(CastBuilder& b);  ///< corners along the sides
void height_field(CastBuilder& b);       ///< a height field, in parts coplanar
void fans(CastBuilder& b);               ///< triangles around a hub, flat, a cone or a cup, aimed at where they meet
void slivers(CastBuilder& b);            ///< one step wide, up to 100 m long
void knife_edges(CastBuilder& b);        ///< closed wedges with a hair's angle, met at the edge and from behind a face
void thin_boxes(CastBuilder& b);         ///< a few steps thick, shot through at speed
void far_away(CastBuilder& b);           ///< 1, 4 and 8 km from the origin
void range_border(CastBuilder& b);       ///< corners on the very rim: -2^31 and 2^31 - 1 steps
void huge_polygons(CastBuilder& b);      ///< five kilometres and more across, and from rim to rim
void tiny_polygons(CastBuilder& b);      ///< a few steps across
void mixed_scales(CastBuilder& b);       ///< polygons, radii and paths of all sizes together
void repeated(CastBuilder& b);           ///< copies, some turned over, some two-sided: ties at every touch

}  // namespace firma::scenes
