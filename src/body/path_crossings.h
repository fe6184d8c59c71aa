// SPDX-License-Identifier: MIT
// Where a path passes through the surface of a closed solid, and which stretches of it lie inside.
#pragma once

#include <cstdint>
#include <vector>

#include "body/body_tolerance.h"
#include "cast/sweep.h"
#include "firma/function_ref.h"
#include "firma/hit.h"
#include "geometry/polygon_shape.h"
#include "index/node.h"

namespace firma {

/// Two lines beside a path, moved by amounts smaller than any number: along x by e, along y by e^2, along z by e^3; and
/// the other way. Neither passes through an edge or a vertex. So each passes in and out of a closed surface in turn,
/// exactly. Both pass where the path does, but where that runs along a face, an edge or a vertex.
enum BesideLines : unsigned { kLineOneWay = 1, kLineOtherWay = 2 };

/// Which of them pass through a polygon.
/// @param facing  sign of direction . normal, not 0
unsigned lines_through(const Sweep& sweep, const PolygonShape& polygon, int facing);

struct PathCrossing {
    double t = 0;         ///< in the sweep's parameter
    int turn = 0;         ///< 1 into the solid, -1 out of it
    unsigned beside = 0;  ///< BesideLines that do so
    Vec3 normal;          ///< unit, of the face
    FaceRef face;
    std::uint32_t material = 0, mask = ~0u;
};

/// A stretch of the path that lies inside for both lines.
struct SolidStretch {
    static constexpr std::uint32_t kOpen = ~0u;

    double from = 0, to = 0;                ///< in the sweep's parameter
    std::uint32_t in = kOpen, out = kOpen;  ///< of the crossings; kOpen: it starts, or ends, in the solid
};

/// Which of the two lines start inside, where what they cross does not tell.
using StartInside = FunctionRef<unsigned()>;

/// Stretches between crossings, in order. Those shorter than kDistanceRounding are left out, and gaps that are shorter
/// do not count: rounding makes such where the path touches an edge.
/// @param crossings  put in order
/// @param found      replaced
void find_stretches(const Sweep& sweep, std::vector<PathCrossing>& crossings, StartInside start,
                    std::vector<SolidStretch>& found);

/// Which lines start inside, when all that they cross on their way to infinity is known.
unsigned starts_inside(const std::vector<PathCrossing>& crossings, bool rock_outside);

/// The sweep on its way to where nothing is any more.
Sweep far_on(const Sweep& sweep);

/// Of the facets of one index, which bound a solid.
/// @param crossings  replaced
void cross_facets(const Node* root, const Sweep& sweep, std::vector<PathCrossing>& crossings);

}  // namespace firma
