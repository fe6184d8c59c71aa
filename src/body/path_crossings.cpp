// SPDX-License-Identifier: MIT
// A path through the surface of a closed solid.
//
// Which polygons a line passes through is a matter of signs, one for each edge. Where the path touches an edge such a
// sign is 0, and faces on both sides of it are met. Moving the line by d changes the sign's number
// direction . ((a - start) x (b - start)) by -d . ((b - a) x direction), so for a move smaller than any number the
// first coordinate of (b - a) x direction that is not 0 decides. Source: H. Edelsbrunner, E. Muecke, Simulation of
// Simplicity, 1990.
#include "body/path_crossings.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/sort.h"
#include "cast/cast_sphere_polygon.h"
#include "geometry/double_double.h"
#include "geometry/exact_predicates.h"
#include "geometry/rounding.h"
#include "index/sweep_box.h"
#include "index/traverse.h"
#include "solid/face_shape.h"

namespace firma {
namespace {

/// Corners are rounded by up to 0.87 steps: what is thinner may have its faces the wrong way around, metres.
constexpr double kFoldWidth = 2 / kSurfaceSteps;

/// With sizes E, D and W of edge, direction and corner each part of the moment has at most 2 D W, off by four
/// roundoffs; three of them times E, and two sums.
constexpr double kMomentRounding = rounding(64);

/// Sign of direction . ((a - start) x (b - start)).
int side_of_edge(const Sweep& sweep, const Vec3& a, const Vec3& b) {
    const Vec3 w = a - sweep.start, edge = b - a;
    const double side = dot(edge, cross(sweep.direction, w));
    if (std::fabs(side) > kMomentRounding * max_abs(edge) * max_abs(sweep.direction) * max_abs(w))
        return side > 0 ? 1 : -1;
    return exact_edge_side(sweep.start, sweep.direction, a, b);
}

/// Sign of a b - c d, exactly: rounding keeps the order of products, and what it left out orders those that round
/// alike.
int sign_of_minor(double a, double b, double c, double d) {
    const DoubleDouble p = two_product(a, b), q = two_product(c, d);
    if (p.high != q.high) return p.high > q.high ? 1 : -1;
    return (p.low > q.low) - (p.low < q.low);
}

/// The sign that an edge which the path touches has for the line that is moved one way; 0 for one along the path.
int side_when_moved(const Sweep& sweep, const Vec3& a, const Vec3& b) {
    const Vec3 edge = b - a, &d = sweep.direction;  // exact: corners lie on the grid
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        if (const int sign = sign_of_minor(edge[u], d[v], edge[v], d[u])) return -sign;
    }
    return 0;
}

bool comes_first(const PathCrossing& a, const PathCrossing& b) {
    return std::tuple(a.t, -a.turn, a.face.id) < std::tuple(b.t, -b.turn, b.face.id);
}

/// How much of the path is where no winding can be, if a line starts inside so many times.
double impossible_length(const Sweep& sweep, const std::vector<PathCrossing>& crossings, unsigned line, int winding) {
    double length = 0, since = 0;
    for (const PathCrossing& it : crossings) {
        if (!(it.beside & line)) continue;
        if (winding < 0 || winding > 1) length += it.t - since;
        winding += it.turn;
        since = it.t;
    }
    if (winding < 0 || winding > 1) length += sweep.end - since;
    return length;
}

/// Whether each line starts inside: by what it crosses, else asked for.
unsigned start_of_lines(const Sweep& sweep, const std::vector<PathCrossing>& crossings, StartInside start) {
    unsigned inside = 0, open = 0;
    for (const unsigned line : {kLineOneWay, kLineOtherWay}) {
        const double in_air = impossible_length(sweep, crossings, line, 0);
        const double in_solid = impossible_length(sweep, crossings, line, 1);
        const double told = std::fabs(in_air - in_solid) * sweep.direction_length;
        if (!(told > kFoldWidth))
            open |= line;
        else if (in_solid < in_air)
            inside |= line;
    }
    return open ? inside | (start() & open) : inside;
}

/// Goes through an index.
class FacetCrossings {
public:
    FacetCrossings(const Sweep& sweep, std::vector<PathCrossing>& found)
        : sweep_(sweep), boxes_(sweep), found_(found) {}

    bool enter(const BoxF& box, double& nearest) const { return boxes_.enters(box, sweep_.end, nearest); }
    bool still(double) const { return true; }
    bool facets(const IndexedFacets& facets, std::uint32_t first, std::uint32_t count) {
        const Block& block = as_block(facets);
        for (std::uint32_t slot = first; slot < first + count; ++slot) {
            const FaceShape shape(block, block.faces[slot]);
            if (!shape.polygon.has_area()) continue;
            const Contact contact = cast_sweep_polygon(sweep_, shape.polygon, Sides::kBoth, sweep_.end, nullptr);
            if (!contact.touched()) continue;
            const int facing = exact_facing(sweep_.direction, shape.polygon);
            if (facing == 0) continue;
            PathCrossing crossing;
            crossing.t = contact.t;
            crossing.turn = -facing;
            crossing.beside = lines_through(sweep_, shape.polygon, facing);
            crossing.face.id = block.faces[slot].id;
            if (crossing.beside) found_.push_back(crossing);
        }
        return false;
    }

private:
    const Sweep& sweep_;
    const SweepBox boxes_;
    std::vector<PathCrossing>& found_;
};

}  // namespace

unsigned lines_through(const Sweep& sweep, const PolygonShape& polygon, int facing) {
    unsigned lines = kLineOneWay | kLineOtherWay;
    const Vec3* a = &polygon.corners.back();
    for (const Vec3& b : polygon.corners) {
        if (const int side = side_of_edge(sweep, *a, b)) {
            if (side * facing < 0) return 0;
        } else if (const int moved = side_when_moved(sweep, *a, b) * facing) {
            lines &= moved < 0 ? ~unsigned(kLineOneWay) : ~unsigned(kLineOtherWay);
        }
        a = &b;
    }
    return lines;
}

void find_stretches(const Sweep& sweep, std::vector<PathCrossing>& crossings, StartInside start,
                    std::vector<SolidStretch>& found) {
    sort_range(crossings, comes_first);
    found.clear();
    const double shortest = kDistanceRounding / sweep.direction_length;
    const unsigned inside = start_of_lines(sweep, crossings, start);
    int winding[2] = {(inside & kLineOneWay) != 0, (inside & kLineOtherWay) != 0};
    const auto is_inside = [&] { return winding[0] > 0 && winding[1] > 0; };
    bool was_inside = is_inside();
    if (was_inside) found.emplace_back();
    for (std::uint32_t k = 0; k < crossings.size(); ++k) {
        const PathCrossing& it = crossings[k];
        for (const unsigned line : {kLineOneWay, kLineOtherWay})
            if (it.beside & line) winding[line - 1] += it.turn;
        if (is_inside() == was_inside) continue;
        was_inside = !was_inside;
        if (!was_inside) {
            found.back().to = it.t;
            found.back().out = k;
        } else if (found.empty() || it.t - found.back().to > shortest) {
            found.push_back({it.t, 0, k});
        }
    }
    if (was_inside) {
        found.back().to = sweep.end;
        found.back().out = SolidStretch::kOpen;
    }
    std::erase_if(found, [&](const SolidStretch& it) { return !(it.to - it.from > shortest); });
}

unsigned starts_inside(const std::vector<PathCrossing>& crossings, bool rock_outside) {
    int winding[2] = {rock_outside, rock_outside};
    for (const PathCrossing& it : crossings)
        for (const unsigned line : {kLineOneWay, kLineOtherWay})
            if (it.beside & line) winding[line - 1] -= it.turn;
    return (winding[0] > 0 ? kLineOneWay : 0u) | (winding[1] > 0 ? kLineOtherWay : 0u);
}

Sweep far_on(const Sweep& sweep) {
    constexpr double kFar = 8 * kWorldRim;
    Sweep far = sweep;
    while (far.end < kFar + max_abs(sweep.start)) far.end *= 2;
    return far;
}

void cross_facets(const Node* root, const Sweep& sweep, std::vector<PathCrossing>& crossings) {
    crossings.clear();
    FacetCrossings visitor(sweep, crossings);
    if (root) traverse(*root, visitor);
}

}  // namespace firma
