// SPDX-License-Identifier: MIT
// Volumes by prisms.
#include "tests/reference/carve_oracle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "tests/reference/facet_corners.h"
#include "tests/reference/world_facets.h"
#include "world/world_data.h"

namespace firma::reference {
namespace {

template <class Number>
using Point = std::array<Number, 3>;  // input steps, from the middle of the cutter

template <class Number>
Number number(Int128 value) {
    const bool negative = value < 0;
    const auto size = negative ? Unsigned128(-value) : Unsigned128(value);
    Number result(std::uint64_t(size >> 64));
    result *= Number(4294967296ull);
    result *= Number(4294967296ull);
    result += Number(std::uint64_t(size));
    return negative ? Number(-result) : result;
}

/// By Cramer's rule; every numerator is a whole number.
template <class Number>
Point<Number> meet_of(const Plane& a, const Plane& b, const Plane& c) {
    const Plane* plane[3] = {&a, &b, &c};
    Number n[3][4];
    for (int i = 0; i < 3; ++i) {
        for (int axis = 0; axis < 3; ++axis) n[i][axis] = number<Number>(plane[i]->normal[axis]);
        n[i][3] = number<Number>(-plane[i]->offset());
    }
    const auto determinant = [&](int p, int q, int r) {
        return Number(n[0][p] * (n[1][q] * n[2][r] - n[1][r] * n[2][q]) -
                      n[0][q] * (n[1][p] * n[2][r] - n[1][r] * n[2][p]) +
                      n[0][r] * (n[1][p] * n[2][q] - n[1][q] * n[2][p]));
    };
    const Number w = determinant(0, 1, 2);
    return {Number(determinant(3, 1, 2) / w), Number(determinant(0, 3, 2) / w), Number(determinant(0, 1, 3) / w)};
}

template <class Number>
Point<Number> relative(const InputPoint& p, const InputPoint& origin) {
    Point<Number> result;
    for (int axis = 0; axis < 3; ++axis) result[std::size_t(axis)] = Number(std::int64_t(p[axis]) - origin[axis]);
    return result;
}

template <class Number>
Point<Number> relative(const ExactPoint& p, const InputPoint& origin) {
    if (p.on_grid()) return relative<Number>(p.grid(), origin);
    Point<Number> result = meet_of<Number>(*p.plane(0), *p.plane(1), *p.plane(2));
    for (int axis = 0; axis < 3; ++axis) result[std::size_t(axis)] -= Number(origin[axis]);
    return result;
}

InputPoint middle_of(const PlacedCutter& cutter) {
    InputPoint low = cutter.vertices[0], high = low;
    for (const InputPoint& p : cutter.vertices)
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], p[axis]);
            high[axis] = std::max(high[axis], p[axis]);
        }
    InputPoint middle;
    for (int axis = 0; axis < 3; ++axis) middle[axis] = std::int32_t((std::int64_t(low[axis]) + high[axis]) / 2);
    return middle;
}

/// height = a x + b y + c
template <class Number>
struct Heights {
    Number a, b, c;
    Number at(const Number& x, const Number& y) const { return a * x + b * y + c; }
};

/// The projection of a triangle, counter-clockwise, in doubles too.
template <class Number>
struct Prism {
    Number x[3], y[3];
    Heights<Number> top;
    int sign = 0;  ///< 1 below a face that looks up
    double dx[3], dy[3];
    double low[3], high[3];
};

template <class Number>
Number twice_area(const Number* x, const Number* y) {
    return (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
}

template <class Number>
void add_prism(const Point<Number>& a, const Point<Number>& b, const Point<Number>& c,
               std::vector<Prism<Number>>& prisms) {
    Prism<Number> prism;
    const Point<Number>* corner[3] = {&a, &b, &c};
    for (int k = 0; k < 3; ++k) {
        prism.x[k] = (*corner[k])[0];
        prism.y[k] = (*corner[k])[1];
    }
    const Number area = twice_area(prism.x, prism.y);
    if (area == 0) return;
    prism.sign = area > 0 ? 1 : -1;
    // The plane through three points, solved for height.
    const Number z1 = b[2] - a[2], z2 = c[2] - a[2];
    const Number x1 = b[0] - a[0], x2 = c[0] - a[0], y1 = b[1] - a[1], y2 = c[1] - a[1];
    prism.top.a = (z1 * y2 - z2 * y1) / area;
    prism.top.b = (x1 * z2 - x2 * z1) / area;
    prism.top.c = a[2] - prism.top.a * a[0] - prism.top.b * a[1];
    if (prism.sign < 0) {
        std::swap(prism.x[1], prism.x[2]);
        std::swap(prism.y[1], prism.y[2]);
    }
    for (int axis = 0; axis < 3; ++axis) {
        prism.low[axis] = INFINITY;
        prism.high[axis] = -INFINITY;
        for (const Point<Number>* p : corner) {
            const double value = static_cast<double>((*p)[std::size_t(axis)]);
            prism.low[axis] = std::min(prism.low[axis], value - 1e-6);
            prism.high[axis] = std::max(prism.high[axis], value + 1e-6);
        }
    }
    for (int k = 0; k < 3; ++k) {
        prism.dx[k] = static_cast<double>(prism.x[k]);
        prism.dy[k] = static_cast<double>(prism.y[k]);
    }
    prisms.push_back(std::move(prism));
}

template <class Number>
std::vector<Prism<Number>> prisms_of(const PlacedCutter& cutter, const InputPoint& origin) {
    std::vector<Prism<Number>> prisms;
    const auto at = [&](std::uint32_t v) { return relative<Number>(cutter.vertices[v], origin); };
    for (const auto& [a, b, c] : cutter.triangles) add_prism(at(a), at(b), at(c), prisms);
    return prisms;
}

/// Calls use(a, b, c) for every triangle of the fans of an exact face's loops: their signed sum is the face.
template <class Number, class Use>
void fans(const SolidPatch& patch, const PatchFace& face, const InputPoint& origin, const Use& use) {
    const auto uses = patch.uses(face);
    std::size_t first = 0;
    for (const std::uint32_t end : patch.ends(face)) {
        std::vector<Point<Number>> corners;
        for (std::size_t k = first; k < end; ++k)
            corners.push_back(relative<Number>(patch.vertices[patch.from(uses[k])].point, origin));
        for (std::size_t k = 2; k < corners.size(); ++k) use(corners[0], corners[k - 1], corners[k]);
        first = end;
    }
}

/// Sides nearer than this are none: where surfaces coincide, rounding would have a line wind to and fro.
template <class Number>
const Number& negligible();
template <>
const Real& negligible() {
    static const Real steps("1e-35");
    return steps;
}
template <>
const Fraction& negligible() {
    static const Fraction none(0);
    return none;
}

template <class Number>
using Polygon = std::vector<std::array<Number, 2>>;

/// What of a convex polygon lies to the left of a function's zero line.
template <class Number, class Side>
Polygon<Number> clipped(const Polygon<Number>& polygon, const Side& side) {
    Polygon<Number> result;
    std::vector<Number> sides;
    for (const auto& p : polygon) {
        sides.push_back(side(p[0], p[1]));
        if (abs(sides.back()) < negligible<Number>()) sides.back() = 0;
    }
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const std::size_t next = k + 1 < polygon.size() ? k + 1 : 0;
        const Number &s = sides[k], &t = sides[next];
        if (s >= 0) result.push_back(polygon[k]);
        if ((s > 0 && t < 0) || (s < 0 && t > 0)) {
            const Number part = s / (s - t);
            result.push_back({Number(polygon[k][0] + part * (polygon[next][0] - polygon[k][0])),
                              Number(polygon[k][1] + part * (polygon[next][1] - polygon[k][1]))});
        }
    }
    return result;
}

/// Six times the integral.
template <class Number>
Number integral(const Polygon<Number>& polygon, const Heights<Number>& heights) {
    Number sum = 0;
    if (polygon.size() < 3) return sum;
    const Number first = heights.at(polygon[0][0], polygon[0][1]);
    Number last = heights.at(polygon[1][0], polygon[1][1]);
    for (std::size_t k = 2; k < polygon.size(); ++k) {
        const Number next = heights.at(polygon[k][0], polygon[k][1]);
        const Number x[3] = {polygon[0][0], polygon[k - 1][0], polygon[k][0]};
        const Number y[3] = {polygon[0][1], polygon[k - 1][1], polygon[k][1]};
        sum += twice_area(x, y) * (first + last + next);
        last = next;
    }
    return sum;
}

template <class Number>
bool apart(const Prism<Number>& p, const Prism<Number>& q) {
    for (int axis = 0; axis < 2; ++axis)
        if (p.high[axis] < q.low[axis] || q.high[axis] < p.low[axis]) return true;
    const auto all_right_of_one = [](const Prism<Number>& of, const Prism<Number>& other) {
        for (int k = 0; k < 3; ++k) {
            const int next = k < 2 ? k + 1 : 0;
            const double ux = of.dx[next] - of.dx[k], uy = of.dy[next] - of.dy[k];
            bool right = true;
            for (int c = 0; c < 3 && right; ++c) {
                const double vx = other.dx[c] - of.dx[k], vy = other.dy[c] - of.dy[k];
                right = ux * vy - uy * vx < -1e-6 * (std::fabs(ux) + std::fabs(uy));  // a millionth of a step
            }
            if (right) return true;
        }
        return false;
    };
    return all_right_of_one(p, q) || all_right_of_one(q, p);
}

/// Six times the integral of the lower of both heights over what the projections share, with the sign of both.
template <class Number>
Number in_common(const Prism<Number>& of_solid, const Prism<Number>& of_cutter) {
    Polygon<Number> shared;
    for (int k = 0; k < 3; ++k) shared.push_back({of_cutter.x[k], of_cutter.y[k]});
    for (int k = 0; k < 3; ++k) {
        const int next = k < 2 ? k + 1 : 0;
        const Number ux = of_solid.x[next] - of_solid.x[k], uy = of_solid.y[next] - of_solid.y[k];
        shared = clipped(shared, [&](const Number& x, const Number& y) {
            return Number(ux * (y - of_solid.y[k]) - uy * (x - of_solid.x[k]));
        });
        if (shared.size() < 3) return 0;
    }
    const Number sign = of_solid.sign * of_cutter.sign;
    if (of_solid.low[2] > of_cutter.high[2]) return sign * integral(shared, of_cutter.top);
    if (of_solid.high[2] < of_cutter.low[2]) return sign * integral(shared, of_solid.top);
    const auto above = [&](const Number& x, const Number& y) {
        return Number(of_solid.top.at(x, y) - of_cutter.top.at(x, y));
    };
    const auto below = [&](const Number& x, const Number& y) { return Number(-above(x, y)); };
    bool any_above = false, any_below = false;
    for (const auto& [x, y] : shared) {
        const Number gap = above(x, y);
        any_above = any_above || gap > negligible<Number>();
        any_below = any_below || -gap > negligible<Number>();
    }
    if (!any_above) return sign * integral(shared, of_solid.top);  // both in one plane, too
    if (!any_below) return sign * integral(shared, of_cutter.top);
    return sign * (integral(clipped(shared, above), of_cutter.top) + integral(clipped(shared, below), of_solid.top));
}

/// Of a facet's whole face.
GridBox box_of(const FacetPlace& place) {
    if (const FaceOwner* owner = place.block->owner_of(place.record())) return owner->box;
    GridBox box;
    for (const GridPoint& corner : grid_corners_of(place)) box.add(corner);
    return box;
}

bool overlap(const GridBox& p, const GridBox& q) {
    for (int axis = 0; axis < 3; ++axis)
        if (std::int64_t(p.high[axis]) + 2 < q.low[axis] || std::int64_t(q.high[axis]) + 2 < p.low[axis]) return false;
    return true;
}

std::set<const Block*> blocks_of(std::span<const FacetPlace> facets) {
    std::set<const Block*> blocks;
    for (const FacetPlace& place : facets) blocks.insert(place.block);
    return blocks;
}

/// A patch of the exact faces that lie over or under, or within, a box from its bottom up.
SolidPatch column_of(const World& world, const GridBox& box) {
    SolidPatch patch;
    for (const FacetPlace& place : all_facets(world)) {
        if (!place.record().solid) continue;
        const GridBox own = box_of(place);
        bool far = std::int64_t(own.high[2]) + 4 < box.low[2];
        for (int axis = 0; axis < 2; ++axis)
            far = far || std::int64_t(own.high[axis]) + 4 < box.low[axis] ||
                  std::int64_t(own.low[axis]) - 4 > box.high[axis];
        if (!far) patch.add(place);
    }
    return patch;
}

template <class Number>
Number cubic_metres(const Number& six_times) {
    const Number steps(4096);
    return six_times / (6 * steps * steps * steps);
}

template <class Number>
Number six_times_volume_of(const PlacedCutter& cutter, const InputPoint& origin) {
    Number sum = 0;
    for (const Prism<Number>& prism : prisms_of<Number>(cutter, origin)) {
        Polygon<Number> all;
        for (int k = 0; k < 3; ++k) all.push_back({prism.x[k], prism.y[k]});
        sum += prism.sign * integral(all, prism.top);
    }
    return sum;
}

template <class Number>
Number volume_in_common(const World& world, const PlacedCutter& cutter) {
    const InputPoint origin = middle_of(cutter);
    GridBox box;
    for (const InputPoint& p : cutter.vertices) box.add(to_surface(p));
    const std::vector<Prism<Number>> of_cutter = prisms_of<Number>(cutter, origin);
    const SolidPatch patch = column_of(world, box);
    std::vector<Prism<Number>> of_solid;
    for (const PatchFace& face : patch.faces)
        fans<Number>(patch, face, origin,
                     [&](const auto& a, const auto& b, const auto& c) { add_prism<Number>(a, b, c, of_solid); });
    Number sum = world.data().rock_outside() ? six_times_volume_of<Number>(cutter, origin) : Number(0);
    for (const Prism<Number>& p : of_solid)
        for (const Prism<Number>& q : of_cutter)
            if (!apart(p, q)) sum += in_common(p, q);
    return cubic_metres(sum);
}

template <class Number>
Number six_times_volume(const Point<Number>& a, const Point<Number>& b, const Point<Number>& c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

Real six_times_volume_of(std::span<const FacetPlace> facets, const InputPoint& origin) {
    SolidPatch patch;
    for (const FacetPlace& place : facets)
        if (place.record().solid) patch.add(place);
    Real sum = 0;
    for (const PatchFace& face : patch.faces)
        fans<Real>(patch, face, origin,
                   [&](const auto& a, const auto& b, const auto& c) { sum += six_times_volume<Real>(a, b, c); });
    return sum;
}

using PlaneKey = std::array<std::string, 4>;

/// @param both_ways  planes that look opposite ways have the same key
PlaneKey key_of(const Plane& plane, bool both_ways) {
    const std::int64_t* n = plane.normal;
    const bool turned = both_ways && (n[0] != 0 ? n[0] < 0 : n[1] != 0 ? n[1] < 0 : n[2] < 0);
    PlaneKey key;
    for (std::size_t axis = 0; axis < 3; ++axis) key[axis] = std::to_string(turned ? -n[axis] : n[axis]);
    key[3] = number<Real>(turned ? -plane.offset() : plane.offset()).str(0, std::ios_base::fixed);
    return key;
}

/// A triangle of a face's fans, as seen along an axis: counter-clockwise, and how it counts.
struct FlatTriangle {
    Real x[3], y[3];
    int sign = 0;
};

std::vector<FlatTriangle> flat_fans(const SolidPatch& patch, const PatchFace& face, std::size_t along,
                                    const InputPoint& origin) {
    const std::size_t u = (along + 1) % 3, v = (along + 2) % 3;
    std::vector<FlatTriangle> flat;
    fans<Real>(patch, face, origin, [&](const auto& a, const auto& b, const auto& c) {
        FlatTriangle t{{a[u], b[u], c[u]}, {a[v], b[v], c[v]}, 0};
        const Real area = twice_area(t.x, t.y);
        if (abs(area) < negligible<Real>()) return;
        t.sign = area > 0 ? 1 : -1;
        if (t.sign < 0) {
            std::swap(t.x[1], t.x[2]);
            std::swap(t.y[1], t.y[2]);
        }
        flat.push_back(std::move(t));
    });
    return flat;
}

/// Twice the area that two faces of one plane, whichever way they look, have in common; square steps, projected.
Real shared_area(const SolidPatch& patch, const PatchFace& p, const PatchFace& q) {
    const std::size_t along = std::size_t(p.plane->plane.dominant_axis());
    const InputPoint origin = to_input(p.box.low);
    Real sum = 0;
    const std::vector<FlatTriangle> of_p = flat_fans(patch, p, along, origin),
                                    of_q = flat_fans(patch, q, along, origin);
    for (const FlatTriangle& s : of_p)
        for (const FlatTriangle& t : of_q) {
            Polygon<Real> shared;
            for (int k = 0; k < 3; ++k) shared.push_back({s.x[k], s.y[k]});
            for (int k = 0; k < 3 && shared.size() > 2; ++k) {
                const int next = k < 2 ? k + 1 : 0;
                const Real ux = t.x[next] - t.x[k], uy = t.y[next] - t.y[k];
                shared = clipped(
                    shared, [&](const Real& x, const Real& y) { return Real(ux * (y - t.y[k]) - uy * (x - t.x[k])); });
            }
            sum += s.sign * t.sign * integral(shared, Heights<Real>{0, 0, Real(1) / 3});
        }
    return abs(sum);
}

/// Of a triangle, in half turns around a full sphere's two.
double solid_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double la = length(a), lb = length(b), lc = length(c);
    return 2 * std::atan2(dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
}
constexpr double kFullSphere = 12.566370614359172;

}  // namespace

Real volume_within(const World& world, const PlacedCutter& cutter) {
    return volume_in_common<Real>(world, cutter);
}
Fraction exact_volume_within(const World& world, const PlacedCutter& cutter) {
    return volume_in_common<Fraction>(world, cutter);
}
Real volume_of(const PlacedCutter& cutter) {
    return cubic_metres(six_times_volume_of<Real>(cutter, middle_of(cutter)));
}

Real volume_lost(std::span<const FacetPlace> gone, std::span<const FacetPlace> come, const PlacedCutter& near) {
    const InputPoint origin = middle_of(near);
    return cubic_metres(Real(six_times_volume_of(gone, origin) - six_times_volume_of(come, origin)));
}

bool same_solid(const World& a, const World& b) {
    // Area, moments along both axes of the projection along the dominant one, and second moments.
    using Measures = std::array<Real, 6>;
    std::map<PlaneKey, Measures> sums;
    const std::vector<FacetPlace> of_a = all_facets(a), of_b = all_facets(b);
    // Versions share blocks; of a face that only one of them has no facet lies in a block of both.
    const std::set<const Block*> blocks_a = blocks_of(of_a), blocks_b = blocks_of(of_b);
    const auto add = [&](const std::vector<FacetPlace>& facets, const std::set<const Block*>& of_other, int sign) {
        SolidPatch patch;
        for (const FacetPlace& place : facets)
            if (place.record().solid && !of_other.contains(place.block)) patch.add(place);
        for (const PatchFace& face : patch.faces) {
            const Plane& plane = face.plane->plane;
            const std::size_t along = std::size_t(plane.dominant_axis()), u = (along + 1) % 3, v = (along + 2) % 3;
            Measures& sum = sums[key_of(plane, false)];
            fans<Real>(patch, face, {}, [&](const auto& p, const auto& q, const auto& r) {
                const Real area = sign * ((q[u] - p[u]) * (r[v] - p[v]) - (r[u] - p[u]) * (q[v] - p[v]));
                const Real x[3] = {p[u], q[u], r[u]}, y[3] = {p[v], q[v], r[v]};
                const Real all_x = x[0] + x[1] + x[2], all_y = y[0] + y[1] + y[2];
                sum[0] += area;
                sum[1] += area * all_x;
                sum[2] += area * all_y;
                for (int k = 0; k < 3; ++k) {
                    sum[3] += area * x[k] * (all_x + x[k]);
                    sum[4] += area * y[k] * (all_y + y[k]);
                    sum[5] += area * (x[k] * all_y + x[k] * y[k]);
                }
            });
        }
    };
    add(of_a, blocks_b, 1);
    add(of_b, blocks_a, -1);
    const Real least("1e-20");
    return std::all_of(sums.begin(), sums.end(), [&](const auto& entry) {
        return std::all_of(entry.second.begin(), entry.second.end(), [&](const Real& x) { return abs(x) < least; });
    });
}

std::string doubled_face(const World& world, std::span<const FacetPlace> facets) {
    SolidPatch patch;
    for (const FacetPlace& place : facets)
        if (place.record().solid) patch.add(place);
    const auto first_other = std::uint32_t(patch.faces.size());
    std::map<PlaneKey, std::vector<std::uint32_t>> in_plane;
    for (std::uint32_t f = 0; f < first_other; ++f) in_plane[key_of(patch.faces[f].plane->plane, true)];
    GridBox near;
    for (const PatchFace& face : patch.faces) near.add(face.box);
    for (const FacetPlace& place : all_facets(world))
        if (place.record().solid && overlap(box_of(place), near)) patch.add(place);
    for (std::uint32_t f = 0; f < patch.faces.size(); ++f) {
        const auto found = in_plane.find(key_of(patch.faces[f].plane->plane, true));
        if (found != in_plane.end()) found->second.push_back(f);
    }
    for (const auto& [key, faces] : in_plane)
        for (std::size_t i = 0; i < faces.size() && faces[i] < first_other; ++i)
            for (std::size_t k = i + 1; k < faces.size(); ++k)
                if (overlap(patch.faces[faces[i]].box, patch.faces[faces[k]].box) &&
                    shared_area(patch, patch.faces[faces[i]], patch.faces[faces[k]]) > Real("1e-12")) {
                    const PatchFace& face = patch.faces[faces[i]];
                    const auto at = patch.vertices[patch.from(patch.uses(face)[0])].point;
                    const Point<Real> corner = relative<Real>(at, {});
                    std::string text = "a face lies on another one, near (";
                    for (std::size_t axis = 0; axis < 3; ++axis)
                        text += (axis ? ", " : "") + Real(corner[axis] / 4096).str(12);
                    return text + ")";
                }
    return "";
}

double winding(std::span<const FacetPlace> facets, const Vec3& point) {
    double sum = 0;
    for (const FacetPlace& place : facets) {
        if (!place.record().solid) continue;
        const auto corners = grid_corners_of(place);
        const auto at = [&](std::size_t k) { return to_metres(corners[k]) - point; };
        for (std::size_t k = 2; k < corners.size(); ++k) sum += solid_angle(at(0), at(k - 1), at(k));
    }
    return sum / kFullSphere;
}

double winding(const PlacedCutter& cutter, const Vec3& point) {
    double sum = 0;
    const auto at = [&](std::uint32_t v) { return to_metres(to_surface(cutter.vertices[v])) - point; };
    for (const auto& [a, b, c] : cutter.triangles) sum += solid_angle(at(a), at(b), at(c));
    return sum / kFullSphere;
}

double winding(std::span<const Vec3> polygon, const Vec3& point) {
    double sum = 0;
    for (std::size_t k = 2; k < polygon.size(); ++k)
        sum += solid_angle(polygon[0] - point, polygon[k - 1] - point, polygon[k] - point);
    return sum / kFullSphere;
}

}  // namespace firma::reference
