// SPDX-License-Identifier: MIT
// A sweep through an index, eight boxes and eight triangles at a time, in float: what is certainly not met is left out,
// what is left is looked at by whoever asked, exactly.
//
// Lower bounds. Seen from a point near the triangles (`start` + the time at which their box is entered, less their
// origin; formed in double and rounded once) every length that matters is below S, the sum of the coordinates of that
// point, of the farthest corner, and of the radius. With u = 2^-24: a corner as seen from there is off by 2 u S at
// most, and so is the way along the direction until the sphere has met anything. So where a sphere touches the
// triangle, one that is larger by 8 u S touches the triangle that the floats say; that is the sphere, and the triangle,
// of all that follows. Its centre then is within a reach R of the triangle's plane and, along each side's normal in
// that plane, of the side; and in the triangle's box grown by R. Each says of a time t: a + b t <= g. By n = e1 x e2,
// which is off by 6 u E^2 where E is the longest side, and m = e x n, a plane's a + b t is off by 16 u E^2 S, a side's
// by as much times its length: twice that is in g. Quotients are off by less than the 16 u by which times are lowered
// and raised.
//
// Sides of nodes' boxes lie q steps of a size s from a corner b, rounded to float. With a the point that their distance
// counts from, a side is passed at q (s v) + (b - a) v, v the inverse of the direction. s is a power of two, so s v has
// no rounding; the product, the difference, its product and the sum are off by u each: in all by 3 u of the time, which
// is in the 16 u, and by 3 u 255 s |v|, below s |v| / 2^13, which is taken off. That the side itself was rounded is in
// `grown` as far as it lies near the start, and in the 16 u beyond.
//
// A one-sided facet is met by paths alone that run against its normal. Where a triangle's corners are off by up to h,
// out of the facet's plane or in it, n is off from a multiple of that normal, 0 or more, by 4 h E + 4 h^2: times the
// direction's length, below 3.5, that is less than 32 h E where E is above 9 h, and where it is below no n is as long.
//
// A capsule or a hull moves within its ShapeExtent: a ball added to segments from -a to a. By these its reach along n
// is larger by the sum of all |n.a|, each off by 6 u E^2 |a| for n, 3 u |n| |a| for the rounding of the product and as
// much for that of a: below 32 u E^2 S in all, with S above the sum of the lengths |a|; along m by the same times a
// side's length. So it has 64 u E^2 S where a sphere has 32.
//
// A particle needs no normal, and is seen from its start. Along its path corners p and q have twice the area p x q with
// it, a positive factor of d.n in sum. With the projection a corner is off by 17 u S and by twice what else is in R,
// which is below 2.2 R. With L three times `size` of the lanes, above the sum of any of their triangles' extents, no
// side is longer than 2 L there, and an area is off by 24 u L^2 and the like: so where the particle meets the triangle,
// the three areas are not below -g or none is above g, with g = L (8 R
// + 64 u L). Where a facet is bent, the point met lies before or behind its triangles by as much over the sine of the
// path's angle: times are widened by 1,024 times that. (A box around all corners, as casts one by one ask, is not
// widened so.)
#pragma once

#include <cstdint>
#include <span>

#include "cast/shape_extent.h"
#include "cast/sweep.h"
#include "firma/hit.h"
#include "index/node.h"
#include "solid/block.h"

namespace firma {

/// A sweep as the lanes want it.
struct LaneSweep {
    /// Of a particle or a sphere.
    explicit LaneSweep(const Sweep& sweep);
    /// @param extent  holds what moves, and lies near the sweep's sphere
    LaneSweep(const Sweep& sweep, const ShapeExtent& extent);

    /// Whether floats are good for it: else it starts, or leads, far beyond the world, or there are no lanes.
    bool usable = false;
    bool ready = false;  ///< whether what follows from the rest is set: a kernel does that, at its first look
    double start[4];     ///< of the extent's middle; of all these the fourth is not used
    double direction[4];
    double grown[4];        ///< the extent along the world's axes, and more than the rounding of boxes' sides
    int longest, aside[2];  ///< axes of the projection along the path, and its shear: as in Sweep
    float shear[2];
    bool particle = true;
    int axes = 0;      ///< of the extent
    float axis[3][3];  ///< by axis of the extent and coordinate
    float radius;      ///< on top of these
    float extent[3];   ///< of all of it along the world's axes; of a ball not set
    float size;        ///< no point of the extent is farther from its middle
    float margin;      ///< more than the rounding of doubles on the way, metres

    // Once it is ready:
    float along[4];             ///< the direction
    float inverse[4];           ///< of that
    float early[4], late[4];    ///< the same, less and more by what times are lowered and raised
    float ahead[4], behind[4];  ///< of the boxes' sides
    std::uint32_t turned[4];    ///< not 0 where the path runs down an axis

private:
    static void put(const Vec3& values, double (&into)[4]);
    void set_path(const Sweep& sweep, const Vec3& middle);
};

/// What a sweep asks for.
struct LaneQuery {
    LaneSweep& sweep;
    bool front_only = true;  ///< one-sided faces that the path leaves behind are not met
    double latest = 0;       ///< nothing after it is wanted; `look` may bring it forward
    void* whose = nullptr;
    /// Looks at a facet that may be met; true ends the sweep.
    bool (*look)(LaneQuery& query, const FaceLanes& lanes, std::uint32_t lane) = nullptr;
    CastCounts counts;
};

/// @param root  of an index over faces; the sweep must be usable
/// @return whether `look` ended it
bool sweep_lanes(const Node& root, LaneQuery& query);

/// The same compiled for one kind of processor. All look at the same boxes and facets, in the same order.
using LaneFunction = bool (*)(const Node& root, LaneQuery& query);
struct LaneKernel {
    const char* name;
    LaneFunction sweep;
};
/// Those that this processor runs, the one that sweep_lanes() takes first. None where Firma is compiled without lanes
/// (FIRMA_SIMD).
std::span<const LaneKernel> lane_kernels();
/// Whether sweeps may go by lanes.
bool lanes_in_use();
/// For tests: sweep_lanes() takes this one from now on; null makes no sweep usable, so that all go triangle by
/// triangle.
void take_lane_kernel(const LaneKernel* kernel);

}  // namespace firma
