// SPDX-License-Identifier: MIT
// Families that are about the mover: its radius, its path, and where it starts and ends.
#pragma once

namespace firma::scenes {

class CastBuilder;

void radii(CastBuilder& b);          ///< a micrometre, a millimetre, a kilometre
void extreme_radii(CastBuilder& b);  ///< subnormal to beyond the world
void long_paths(CastBuilder& b);     ///< ten kilometres
void short_paths(CastBuilder& b);    ///< a micrometre or less, where touch begins
void odd_paths(CastBuilder& b);      ///< none, subnormal, components of very different sizes; often from overlap
void from_outside(CastBuilder& b);   ///< start or end far outside the world
void huge_paths(CastBuilder& b);     ///< up to where numbers end being valid
void overlapping(CastBuilder& b);    ///< at the start, going anywhere
void receding(CastBuilder& b);       ///< leaves, from just before to just after touch
void backface(CastBuilder& b);       ///< comes from behind
void straddling(CastBuilder& b);     ///< cuts the plane beside the polygon, meets an edge or a corner
void graze_edges(CastBuilder& b);    ///< past an edge at the radius give or take an ulp, up to a thousandth
void graze_corners(CastBuilder& b);  ///< past a corner, likewise
void shallow(CastBuilder& b);        ///< nearly parallel to the face, down to 1e-12
void end_of_path(CastBuilder& b);    ///< contact at, just before and just after the end
void starts_on(CastBuilder& b);      ///< on a face, an edge or a corner, or as near as double can say

}  // namespace firma::scenes
