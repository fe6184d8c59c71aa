// SPDX-License-Identifier: MIT
// Families whose casts are whole numbers too: parallel, coplanar, in touch and grazing exactly, not just nearly.
#pragma once

namespace firma::scenes {

class CastBuilder;

void axis_aligned(CastBuilder& b);      ///< squares and boxes on whole metres, casts along the axes and their diagonals
void parallel(CastBuilder& b);          ///< along a plane, at any height, in touch or tilted by an ulp
void coplanar(CastBuilder& b);          ///< within the polygon's plane: particles and spheres meet the rim
void lattice(CastBuilder& b);           ///< everything in small whole numbers: all coincidences there are
void lattice_of_steps(CastBuilder& b);  ///< the same in grid steps, anywhere in the world
void exact_touch(CastBuilder& b);       ///< starts in exact touch with a face, an edge or a corner
void exact_graze(CastBuilder& b);       ///< passes in exact touch, or an ulp nearer or farther
void exact_end(CastBuilder& b);         ///< ends in exact touch
void sliding(CastBuilder& b);           ///< in exact touch all along
void shared_flat(CastBuilder& b);       ///< at edges and corners that coplanar faces share
void shared_folded(CastBuilder& b);     ///< at edges and corners of ridges and valleys
void exact_fractions(CastBuilder& b);   ///< contact at a fraction with few bits, of several faces at once

}  // namespace firma::scenes
