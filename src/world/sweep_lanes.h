// SPDX-License-Identifier: MIT
// A sweep through an index, eight boxes and eight triangles at a time, in float: what is certainly not met is left out,
// what is left is looked at by whoever asked, exactly.
//
// Lower bounds. Seen from a point near the triangles (`start` + the time at which their box is entered, less their
// origin; formed in double and rounded once) every length that matters is below S, the sum of the coordinates of that
// point, of the farthest corner, and of the radius. With u = 2^-24: a corner as seen from there is off by 2 u S at
// most, and so is the way along the direction until the sphere has met anything. So where a sphere touches the
// triangle, one that is larger by 8 u S touches the triangle that the floats say; that is the sphere, and the triangle,
// of all that follows. Its centre then is within a reach R of the triangle's plane, and in the triangle's box grown by
// R. Each says of a time t: a + b t <= g. By n = e1 x e2, which is off by 6 u E^2 where E is the longest side, a
// plane's a + b t is off by 16 u E^2 S: twice that is in g. Quotients are off by less than the 16 u by which times are
// lowered and raised.
//
// A side b of a node's box is a float, rounded outward once, when the node was made. With a the point that its distance
// counts from, it is passed at (b - a) v, v the inverse of the direction: off by 3 u of itself, which is in the 16 u by
// which times are lowered and raised, and by a's rounding, which is in `reach`.
//
// A one-sided facet is met by paths alone that run against its normal. Where a triangle's corners are off by up to h,
// out of the facet's plane or in it, n is off from a multiple of that normal, 0 or more, by 4 h E + 4 h^2: times the
// direction's length, below 3.5, that is less than 32 h E where E is above 9 h, and where it is below no n is as long.
//
// A capsule or a hull moves within its ShapeExtent: a ball added to segments from -a to a. By these its reach along n
// is larger by the sum of all |n.a|, each off by 6 u E^2 |a| for n, 3 u |n| |a| for the rounding of the product and as
// much for that of a: below 32 u E^2 S in all, with S above the sum of the lengths |a|. So it has 64 u E^2 S where a
// sphere has 32.
//
// One more plane says the same, a + b t <= g, whatever its normal n: where the extent touches the triangle, n.(d t) is
// not above the most of n.p of the corners p, its reach along n added. The plane taken is that which parts the
// triangle's rim from the extent where this is at the time known so far, at a right angle to the shortest way: so
// spheres that pass a corner or an edge are mostly left out, and of those that touch one it is known nearly when. b t
// is off by 5 u |n| S, as each n.p is, the reach by 5 u |n| S, their sum by 2 u |n| S, and of other extents by 32 u |n|
// S more: 32 u |n| S and 64 u |n| S are taken, with the lengths |a| in S. However n is rounded, it is a normal. Where
// several triangles are left that is asked twice, and times are lowered by 16 u each time.
//
// Where n and all that is made of it are 0, each of these says 0 <= 0, which is true at all times: g is larger by
// 2^-60. So it is where corners that a step parts, far from the lanes' origin, are one in float.
//
// A particle needs no normal, and is seen from its start. Along its path corners p and q have twice the area p x q with
// it, a positive factor of d.n in sum. With the projection a corner is off by 17 u S and by twice what else is in R,
// which is below 2.2 R. With L three times `size` of the lanes, above the sum of any of their triangles' extents, no
// side is longer than 2 L there, and an area is off by 24 u L^2 and the like: so where the particle meets the triangle,
// the three areas are not below -g or none is above g, with g = L (8 R
// + 64 u L).
//
// When: with depths z of the corners along the path, in its time, and areas A of the opposite sides with the path, of
// sum S, the line meets the triangle's plane at sum(A z) / S. Counted from the least depth, with D the difference of
// depths, an area that is off by g, and so S by 3 g, move that by 6 g D / |S| at most; 8 g D / max(|S|, g) is taken,
// and 16 u D for the rounding of these sums. Depths themselves are off by R and 4 u S: 2 R. Where nothing is met, all
// of that may be wrong. Where a facet is bent, by up to h, the point met lies before or behind the triangle by h (1
// + 2.5 G) with G the slope of depths over the projection, below 2 D 2 L / |S|: h is in R, and so 10 h L D / |S| is
// below 1.25 g D / |S|, which with the 6 g is below the 8 g; but it may lie beyond all corners by as much. With |S|
// below g nothing is known of that for a bent facet but 1,024 h, by which times are widened there.
//
// Surely inside an edge: where the line comes within 4 L of a corner, no corner is farther than 9 L from it, and areas
// are off by 8 g at most, S by 24 g. So with |S| above 32 g its sign is right, and an area of that sign above 16 g is
// more than 8 g, which is far more than double's rounding.
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
    bool particle = true;
    int axes = 0;       ///< of the extent
    const Sweep* path;  ///< lives longer
    Vec3 start;         ///< of the extent's middle
    Vec3 reach;         ///< of the extent along the world's axes, and more than the rounding of sides near the origin
    float axis[3][3];   ///< by axis of the extent and coordinate
    float radius;       ///< on top of these
    float extent[3];    ///< of all of it along the world's axes; of a ball not set
    float size;         ///< no point of the extent is farther from its middle
    float margin;       ///< more than the rounding of doubles on the way, metres

    /// What rounding adds to `reach` for each metre that the start lies from the origin, along an axis.
    static constexpr double kFartherRounding = 0x1p-21;
};

/// What is known of a triangle's plane before a particle looks at it.
struct TriangleCrossing {
    double t = 0;        ///< when the path crosses the plane, as cast_particle_polygon() has it
    bool known = false;  ///< else nothing is said
    bool away = false;   ///< whether the path runs along the normal
    /// A bit for each edge, bit k for that from corner k: its line may not pass on the inner side. Of an edge that is
    /// not open it surely does, farther from it than rounding.
    std::uint8_t open = 7;
    Vec3 normal;  ///< the facet's, exact but for a factor, a power of two; not set in WebAssembly
};

/// What a sweep asks for.
struct LaneQuery {
    /// Looks at a facet that may be met; true ends the sweep.
    using Look = bool (*)(LaneQuery& query, const FaceLanes& lanes, std::uint32_t lane);

    LaneQuery(const LaneSweep& of, bool front, double until, void* asker, Look looks, CastCounts* count = nullptr)
        : sweep(of), front_only(front), latest(until), whose(asker), look(looks), counts(count) {}

    const LaneSweep& sweep;
    bool front_only;  ///< one-sided faces that the path leaves behind are not met
    double latest;    ///< nothing after it is wanted; `look` may bring it forward
    void* whose;
    Look look;
    bool earliest_only = false;  ///< only the touch that is met first is wanted; of several at one time the lowest id
    bool met = false;            ///< set by `look` where the crossing was known: whether the facet was met
    bool through_edge = false;   ///< set by `look`: the line is known to run exactly through an edge of some facet
    CastCounts* counts;          ///< null: nothing is counted
    TriangleCrossing crossing;   ///< of the facet to look at
};

/// @param root  of an index over faces; the sweep must be usable
/// @return whether `look` ended it
bool sweep_lanes(const Node& root, LaneQuery& query);

/// What is to be looked into.
struct LaneWaiting {
    std::uintptr_t below;  ///< as of a WideNode
    float time;
};
/// How much of that there may be at once.
inline constexpr std::size_t kMostWaiting = (kDeepestTree + 1) * (WideNode::kLanes - 1) + 1;

/// Where sweeps come from that are on their way at one time: a processor goes on with others while one waits for
/// memory, or for one result after another.
class LaneSource {
public:
    static constexpr std::uint32_t kPlaces = 8;

    struct Next {
        const Node* index;  ///< null: nothing more
        LaneQuery* query;   ///< lives until the place is asked again
    };
    /// What to look into at a place: asked first for each, and then whenever it is through with what it had.
    /// @param ended  whether a look ended that
    virtual Next next(std::uint32_t place, bool ended) = 0;

    std::uint32_t places = kPlaces;  ///< how many are used
    /// Room for whoever makes the sweeps; not on the stack, of which some threads have little.
    LaneWaiting waiting[kPlaces][kMostWaiting];

protected:
    LaneSource() {}  // else all of that would be cleared
    ~LaneSource() = default;
};

/// The same compiled for one kind of processor. All look at the same boxes and facets, in the same order.
using LaneFunction = bool (*)(const Node& root, LaneQuery& query);
using LanesTogether = void (*)(LaneSource& source);
struct LaneKernel {
    const char* name;
    LaneFunction sweep;
    LanesTogether together;  ///< null in WebAssembly
};
/// Those that this processor runs, the one that sweep_lanes() takes first. None where Firma is compiled without lanes
/// (FIRMA_SIMD).
std::span<const LaneKernel> lane_kernels();
/// Whether sweeps may go by lanes.
bool lanes_in_use();
/// What makes sweeps together as sweep_lanes() makes one; null where nothing does.
LanesTogether together_in_use();
/// For tests: sweep_lanes() takes this one from now on; null makes no sweep usable, so that all go triangle by
/// triangle.
void take_lane_kernel(const LaneKernel* kernel);

}  // namespace firma
