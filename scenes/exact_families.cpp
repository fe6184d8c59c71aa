// SPDX-License-Identifier: MIT
// Families whose casts are whole numbers too.
#include "scenes/exact_families.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scenes/cast_builder.h"

namespace firma::scenes {

namespace {

std::int64_t whole(Rng& rng, std::int64_t low, std::int64_t high) {
    return low + std::int64_t(rng.below(std::uint32_t(high - low + 1)));
}

Steps small(Rng& rng, std::int64_t most) {
    return {whole(rng, -most, most), whole(rng, -most, most), whole(rng, -most, most)};
}

/// A scale that keeps numbers exact.
double power(Rng& rng, int low, int high) {
    return std::ldexp(1.0, int(whole(rng, low, high)));
}

/// Whole vectors of whole length.
constexpr std::array<std::array<int, 4>, 12> kWholeLengths = {{{0, 0, 1, 1},
                                                               {0, 3, 4, 5},
                                                               {1, 2, 2, 3},
                                                               {2, 3, 6, 7},
                                                               {1, 4, 8, 9},
                                                               {4, 4, 7, 9},
                                                               {2, 6, 9, 11},
                                                               {6, 6, 7, 11},
                                                               {3, 4, 12, 13},
                                                               {2, 5, 14, 15},
                                                               {8, 9, 12, 17},
                                                               {0, 5, 12, 13}}};

struct WholeVector {
    Steps v;
    std::int64_t length;
};
WholeVector whole_vector(Rng& rng) {
    const auto& q = kWholeLengths[rng.below(std::uint32_t(kWholeLengths.size()))];
    std::int64_t c[3] = {q[0], q[1], q[2]};
    for (int k = 2; k > 0; --k) std::swap(c[k], c[rng.below(std::uint32_t(k + 1))]);
    for (std::int64_t& x : c)
        if (rng.chance(0.5)) x = -x;
    return {{c[0], c[1], c[2]}, q[3]};
}

std::int64_t dot(const Steps& a, const Steps& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// A rectangle-cornered polygon in a whole frame: x and y of its plane, z its normal.
struct FramedPolygon {
    WholeFrame frame;
    Steps origin;
    std::int64_t unit = 1;  ///< steps a lattice step, times the frame's entries
    std::vector<std::pair<std::int64_t, std::int64_t>> lattice;

    Steps at(std::int64_t i, std::int64_t j, std::int64_t k) const { return origin + frame.at(i, j, k) * unit; }
    /// Metres of so many lattice steps.
    double metres(std::int64_t count) const { return double(count * frame.length * unit) / kSurfaceSteps; }
    Vec3 vector(std::int64_t i, std::int64_t j, std::int64_t k) const { return to_metres(frame.at(i, j, k) * unit); }
};

FramedPolygon framed_polygon(CastBuilder& b) {
    FramedPolygon p;
    for (;;) {
        p.frame = random_frame(b.rng, 1 + int(b.rng.below(4)));
        p.unit = b.rng.chance(0.5) ? kInput * whole(b.rng, 1, 40) : whole(b.rng, 1, 3000);
        p.origin = steps(in_world(random_steps(b.rng, b.rng.chance(0.8) ? 8 * kMetre : 8000 * kMetre), kInput));
        const int points = 4 + int(b.rng.below(6));
        const bool collinear = b.rng.chance(0.3);
        p.lattice = lattice_polygon(b.rng, 12, points, collinear);
        const GridPolygon polygon = on_plane(p.origin, p.frame.x * p.unit, p.frame.y * p.unit, p.lattice);
        if (polygon.empty()) continue;
        b.scene.polygons.push_back(polygon);
        return p;
    }
}

std::vector<FramedPolygon> framed_polygons(CastBuilder& b, int count) {
    std::vector<FramedPolygon> all;
    for (int k = 0; k < count; ++k) all.push_back(framed_polygon(b));
    return all;
}

const FramedPolygon& any(Rng& rng, const std::vector<FramedPolygon>& all) {
    return all[rng.below(std::uint32_t(all.size()))];
}

/// A contact in exact touch: where the centre is, how far from the polygon, and a direction that keeps the distance.
struct ExactContact {
    Vec3 centre;
    double radius = 0;
    Vec3 away;   ///< from the point toward the centre, exact, not unit
    Vec3 along;  ///< perpendicular to it, exact
};

/// At the polygon's face: the centre above a point within it.
ExactContact contact_with_face(Rng& rng, const FramedPolygon& p) {
    std::int64_t i = 0, j = 0;
    const std::size_t k = rng.below(std::uint32_t(p.lattice.size())),
                      l = (k + 1 + rng.below(std::uint32_t(p.lattice.size() - 1))) % p.lattice.size();
    i = p.lattice[k].first + p.lattice[l].first;  // twice a point between two corners
    j = p.lattice[k].second + p.lattice[l].second;
    std::int64_t height = whole(rng, 0, 12);
    if (rng.chance(0.2)) height = -height;
    const std::int64_t s = whole(rng, -5, 5), t = whole(rng, -5, 5);
    const Vec3 point = to_metres(p.origin) + p.vector(i, j, 0) * 0.5;
    return {point + p.vector(0, 0, height), p.metres(std::abs(height)), p.vector(0, 0, height == 0 ? 1 : height),
            p.vector(s, t, 0)};
}

/// At a corner, away from the polygon: the offset is a whole vector of whole length in the frame, outside both edges.
ExactContact contact_with_corner(Rng& rng, const FramedPolygon& p) {
    for (;;) {
        const std::size_t count = p.lattice.size(), k = rng.below(std::uint32_t(count));
        const auto &before = p.lattice[(k + count - 1) % count], &at = p.lattice[k],
                   &after = p.lattice[(k + 1) % count];
        const WholeVector offset = whole_vector(rng);
        const Steps to_before{before.first - at.first, before.second - at.second, 0},
            to_after{after.first - at.first, after.second - at.second, 0};
        if (dot(offset.v, to_before) > 0 || dot(offset.v, to_after) > 0) continue;
        const WholeVector other = whole_vector(rng);
        const Steps& o = offset.v;  // a direction across: o x other
        Steps along{o.y * other.v.z - o.z * other.v.y, o.z * other.v.x - o.x * other.v.z,
                    o.x * other.v.y - o.y * other.v.x};
        if (along == Steps{}) along = std::abs(o.x) + std::abs(o.y) > 0 ? Steps{-o.y, o.x, 0} : Steps{1, 0, 0};
        return {to_metres(p.origin) + p.vector(at.first, at.second, 0) + p.vector(o.x, o.y, o.z),
                p.metres(offset.length), p.vector(o.x, o.y, o.z), p.vector(along.x, along.y, along.z)};
    }
}

/// At an edge along the frame's x or y, or at a side of whole length: perpendicular to it, partly upward.
ExactContact contact_with_edge(Rng& rng, const FramedPolygon& p) {
    for (int tries = 0; tries < 60; ++tries) {
        const std::size_t count = p.lattice.size(), k = rng.below(std::uint32_t(count));
        const auto &at = p.lattice[k], &after = p.lattice[(k + 1) % count];
        const std::int64_t ex = after.first - at.first, ey = after.second - at.second;
        const auto length_of = std::int64_t(std::llround(std::sqrt(double(ex * ex + ey * ey))));
        if (length_of * length_of != ex * ex + ey * ey) continue;
        // Out of the polygon (ey, -ex), of length `length_of`; up is z. Offset (3, 4)-like in that pair.
        constexpr int kPairs[][3] = {{1, 0, 1}, {3, 4, 5}, {4, 3, 5}, {5, 12, 13}, {12, 5, 13}, {8, 15, 17}};
        const auto& pair = kPairs[rng.below(6)];
        const std::int64_t up = rng.chance(0.5) ? pair[1] : -pair[1];
        const Steps away{pair[0] * ey, -pair[0] * ex, up * length_of};
        const std::int64_t s = whole(rng, -4, 4), t = whole(rng, -4, 4);
        // Along: any mixture of the edge and what is perpendicular to both edge and offset.
        const Steps along{s * ex - t * up * ey, s * ey + t * up * ex, t * pair[0] * length_of};
        const Vec3 point =
            to_metres(p.origin) + (p.vector(at.first, at.second, 0) + p.vector(after.first, after.second, 0)) * 0.5;
        return {point + p.vector(away.x, away.y, away.z), p.metres(pair[2] * length_of),
                p.vector(away.x, away.y, away.z), p.vector(along.x, along.y, along.z)};
    }
    return contact_with_corner(rng, p);
}

ExactContact any_contact(Rng& rng, const FramedPolygon& p) {
    const double which = rng.uniform();
    return which < 0.35  ? contact_with_face(rng, p)
           : which < 0.7 ? contact_with_edge(rng, p)
                         : contact_with_corner(rng, p);
}

/// Leaves exact, or moves by a hair.
double maybe_nudged(CastBuilder& b, double x) {
    return b.rng.chance(0.6) ? x : b.nudged(x, 2);
}

void lattice_scene(CastBuilder& b, const Steps& origin, std::int64_t unit) {
    const int faces = 10 + int(b.rng.below(20));
    while (int(b.scene.polygons.size()) < faces) {
        const Steps o = small(b.rng, 3), u = small(b.rng, 2), v = small(b.rng, 2);
        if (along_one_line(u, v)) continue;
        const int points = 3 + int(b.rng.below(5));
        const bool collinear = b.rng.chance(0.3);
        const auto corners = lattice_polygon(b.rng, 2, points, collinear);
        const GridPolygon polygon = on_plane(origin + o * unit, u * unit, v * unit, corners);
        if (!polygon.empty()) b.scene.polygons.push_back(polygon);
    }
    const double metre = double(unit) / kSurfaceSteps;
    const double radii[] = {0, 0, 0, 1, 2, 3, 5, 0.5, 1.5, 7, 13};
    for (int k = 0; k < kCastsAScene; ++k) {
        const Vec3 start = to_metres(origin) + to_metres(small(b.rng, 12) * unit) * 0.5;
        Vec3 path = to_metres(small(b.rng, 3) * unit);
        path = path * power(b.rng, -1, 3);
        if (b.rng.chance(0.2)) path = path * 100;
        b.add(start, path, radii[b.rng.below(11)] * metre);
    }
}

}  // namespace

void axis_aligned(CastBuilder& b) {
    const auto quad = [&](const Steps& o, const Steps& u, const Steps& v) {
        b.scene.polygons.push_back({in_world(o), in_world(o + u), in_world(o + u + v), in_world(o + v)});
    };
    for (int k = 0; k < 4; ++k) {  // boxes and single squares
        const Steps o = small(b.rng, 5) * kMetre;
        const Steps u{whole(b.rng, 1, 4) * kMetre, 0, 0}, v{0, whole(b.rng, 1, 4) * kMetre, 0},
            w{0, 0, whole(b.rng, 1, 4) * kMetre};
        quad(o + w, u, v);
        quad(o, v, u);
        quad(o + u, v, w);
        quad(o, w, v);
        quad(o + v, w, u);
        quad(o, u, w);
        const Steps p = small(b.rng, 5) * kMetre;
        b.rng.chance(0.5) ? quad(p, u, v) : quad(p, w, v);
    }
    for (int k = 0; k < kCastsAScene; ++k) {
        const Vec3 start = to_metres(small(b.rng, 28) * (kMetre / 4));
        Vec3 path;
        path[int(b.rng.below(3))] = double(whole(b.rng, -20, 20));
        if (b.rng.chance(0.3)) path[int(b.rng.below(3))] = double(whole(b.rng, -20, 20));
        b.add(start, path, b.rng.chance(0.4) ? 0 : double(whole(b.rng, 1, 12)) / 4);
    }
}

void parallel(CastBuilder& b) {
    const std::vector<FramedPolygon> all = framed_polygons(b, 16);
    for (int k = 0; k < kCastsAScene; ++k) {
        const FramedPolygon& p = any(b.rng, all);
        const std::int64_t height = whole(b.rng, -6, 6);
        const std::int64_t i = whole(b.rng, -16, 16), j = whole(b.rng, -16, 16), s = whole(b.rng, -6, 6),
                           t = whole(b.rng, -6, 6);
        const Vec3 start = to_metres(p.origin) + p.vector(i, j, height);
        Vec3 path = p.vector(s, t, 0) * power(b.rng, -3, 4);
        if (b.rng.chance(0.3)) path[int(b.rng.below(3))] = b.nudged(path[0], 1);
        const double radius = b.rng.chance(0.3) ? 0 : p.metres(std::abs(height) + whole(b.rng, -1, 1));
        b.add(start, path, std::fabs(maybe_nudged(b, radius)));
    }
}

void coplanar(CastBuilder& b) {
    const std::vector<FramedPolygon> all = framed_polygons(b, 16);
    for (int k = 0; k < kCastsAScene; ++k) {
        const FramedPolygon& p = any(b.rng, all);
        const std::size_t count = p.lattice.size(), at = b.rng.below(std::uint32_t(count));
        const auto &v = p.lattice[at], &w = p.lattice[(at + 1) % count];
        const std::int64_t s = whole(b.rng, -5, 5), t = whole(b.rng, -5, 5), m = whole(b.rng, 1, 4);
        const double radius = b.rng.chance(0.6) ? 0 : maybe_nudged(b, p.metres(whole(b.rng, 1, 5)));
        const double which = b.rng.uniform();
        Vec3 from, way;
        if (which < 0.4) {  // through a corner, or up to it
            from = p.vector(v.first - s * m, v.second - t * m, 0);
            way = p.vector(s, t, 0) * double(m + whole(b.rng, -1, 3));
        } else if (which < 0.6) {  // along an edge
            from = p.vector(v.first - (w.first - v.first) * m, v.second - (w.second - v.second) * m, 0);
            way = p.vector(w.first - v.first, w.second - v.second, 0) * double(m + whole(b.rng, -1, 3));
        } else {
            const std::int64_t i = whole(b.rng, -30, 30), j = whole(b.rng, -30, 30);
            from = p.vector(i, j, 0);
            const std::int64_t along = whole(b.rng, -30, 30), across = whole(b.rng, -30, 30);
            way = p.vector(along, across, 0) * power(b.rng, -2, 2);
        }
        b.add(to_metres(p.origin) + from, way, radius);
    }
}

void lattice(CastBuilder& b) {
    lattice_scene(b, {}, kMetre);
}

void lattice_of_steps(CastBuilder& b) {
    const std::int64_t unit = b.rng.chance(0.3) ? 1 : b.rng.chance(0.5) ? kInput : kMetre / 16;
    lattice_scene(b, steps(in_world(random_steps(b.rng, 8000 * kMetre), unit)), unit);
}

void exact_touch(CastBuilder& b) {
    const std::vector<FramedPolygon> all = framed_polygons(b, 16);
    for (int k = 0; k < kCastsAScene; ++k) {
        const ExactContact c = any_contact(b.rng, any(b.rng, all));
        const double inward = double(whole(b.rng, -1, 1));  // in, along, out
        Vec3 path = c.along * double(whole(b.rng, 0, 2));
        path = path - c.away * (inward * power(b.rng, -6, 1));
        if (b.rng.chance(0.2)) path = b.rng.direction();
        path = path * power(b.rng, -8, 3);
        b.add(c.centre, path, maybe_nudged(b, c.radius));
    }
}

void exact_graze(CastBuilder& b) {
    const std::vector<FramedPolygon> all = framed_polygons(b, 16);
    for (int k = 0; k < kCastsAScene; ++k) {
        const FramedPolygon& p = any(b.rng, all);
        const ExactContact c = b.rng.chance(0.5) ? contact_with_edge(b.rng, p) : contact_with_corner(b.rng, p);
        const auto before = double(whole(b.rng, 0, 4)), after = double(whole(b.rng, 0, 4));
        b.add(c.centre - c.along * before, c.along * (before + after), maybe_nudged(b, c.radius));
    }
}

void exact_end(CastBuilder& b) {
    const std::vector<FramedPolygon> all = framed_polygons(b, 16);
    for (int k = 0; k < kCastsAScene; ++k) {
        const ExactContact c = any_contact(b.rng, any(b.rng, all));
        Vec3 path = c.along * double(whole(b.rng, -2, 2));
        path = path - c.away * double(whole(b.rng, 0, 3));
        const double far = power(b.rng, -2, 2);
        b.add(c.centre - path * far, path * far, maybe_nudged(b, c.radius));
    }
}

void sliding(CastBuilder& b) {
    const std::vector<FramedPolygon> all = framed_polygons(b, 16);
    for (int k = 0; k < kCastsAScene; ++k) {
        const FramedPolygon& p = any(b.rng, all);
        ExactContact c = contact_with_face(b.rng, p);
        Vec3 path = c.along * power(b.rng, -4, 3);
        if (b.rng.chance(0.5)) c.centre = c.centre - path * 0.5;
        if (b.rng.chance(0.2)) {
            const double hair = power(b.rng, -50, -20);
            path = path + c.away * (b.rng.chance(0.5) ? hair : -hair);
        }
        b.add(c.centre, path, maybe_nudged(b, c.radius));
    }
}

// A field of squares or triangles in one plane, aimed at where they meet, exactly.
void shared_flat(CastBuilder& b) {
    const WholeFrame frame = random_frame(b.rng, 2);
    const std::int64_t base = (b.rng.chance(0.5) ? kMetre : kMetre / 2) / 64, unit = base * (1 + b.rng.below(3));
    const Steps origin = steps(in_world(random_steps(b.rng, b.rng.chance(0.7) ? 8 * kMetre : 8000 * kMetre), kInput));
    const bool split = b.rng.chance(0.5);
    const auto at = [&](std::int64_t i, std::int64_t j) { return in_world(origin + frame.at(i, j, 0) * unit); };
    for (std::int64_t i = -3; i < 3; ++i)
        for (std::int64_t j = -3; j < 3; ++j) {
            if (split) {
                b.scene.polygons.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
                b.scene.polygons.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
            } else {
                b.scene.polygons.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
            }
        }
    const auto metres = [&](std::int64_t i, std::int64_t j, std::int64_t k) {
        return to_metres(frame.at(i, j, k) * unit) * 0.25;
    };
    for (int k = 0; k < kCastsAScene; ++k) {
        const std::int64_t i = whole(b.rng, -12, 12), j = b.rng.chance(0.6) ? 4 * whole(b.rng, -3, 3) : i;
        const std::int64_t radius = b.rng.chance(0.5) ? 0 : whole(b.rng, 1, 8);
        const Steps way{whole(b.rng, -8, 8), whole(b.rng, -8, 8), -whole(b.rng, 1, 8)};
        Vec3 path = metres(way.x, way.y, way.z);
        const Vec3 centre = to_metres(origin) + metres(i, j, radius);
        const double before = double(whole(b.rng, 0, 6)) / 2, after = double(whole(b.rng, 0, 6)) / 2;
        if (b.rng.chance(0.3)) path = path * b.rng.uniform(0.5, 2);  // no longer exact, but along the same line
        b.add(centre - path * before, path * (before + after),
              double(radius * frame.length * unit) / kSurfaceSteps / 4);
    }
}

// Roofs and gutters along whole lines, met at their edges and at the corners where several meet.
void shared_folded(CastBuilder& b) {
    const Steps origin = steps(in_world(random_steps(b.rng, b.rng.chance(0.7) ? 8 * kMetre : 8000 * kMetre), kInput));
    const std::int64_t unit = kMetre / 4;
    std::array<std::array<std::int64_t, 7>, 7> height{};
    const std::int64_t rise = b.rng.chance(0.5) ? 2 : 1;
    const double kind = b.rng.uniform();
    for (std::int64_t i = 0; i < 7; ++i)
        for (std::int64_t j = 0; j < 7; ++j) {
            const std::int64_t di = std::abs(i - 3), dj = std::abs(j - 3);
            const std::int64_t h = kind < 0.4 ? di : kind < 0.7 ? std::max(di, dj) : (i + j) % 2;
            height[std::size_t(i)][std::size_t(j)] = (b.rng.chance(0.5) || kind < 0.7 ? 1 : -1) * h * rise;
        }
    const std::int64_t sign = b.rng.chance(0.5) ? 1 : -1;  // bowl or pyramid
    const auto at = [&](std::int64_t i, std::int64_t j) {
        return in_world(origin + Steps{(i - 3) * 4, (j - 3) * 4, sign * height[std::size_t(i)][std::size_t(j)]} * unit);
    };
    for (std::int64_t i = 0; i < 6; ++i)
        for (std::int64_t j = 0; j < 6; ++j) {
            const bool other = b.rng.chance(0.5);
            const GridPoint p = at(i, j), q = at(i + 1, j), r = at(i + 1, j + 1), s = at(i, j + 1);
            b.scene.polygons.push_back(other ? GridPolygon{p, q, r} : GridPolygon{p, q, s});
            b.scene.polygons.push_back(other ? GridPolygon{p, r, s} : GridPolygon{q, r, s});
        }
    for (int k = 0; k < kCastsAScene; ++k) {
        const Place place = b.place(b.rng.chance(0.5) ? Feature::kVertex : Feature::kEdge);
        const std::vector<Vec3> v = b.corners(place.polygon);
        const double part = double(whole(b.rng, 0, 4)) / 4;
        const Vec3 point = place.feature == Feature::kVertex
                               ? place.point
                               : v[place.corner] + (v[(place.corner + 1) % v.size()] - v[place.corner]) * part;
        const double radius = b.rng.chance(0.5) ? 0 : double(whole(b.rng, 1, 8)) / 8;
        const Vec3 path{double(whole(b.rng, -8, 8)) / 4, double(whole(b.rng, -8, 8)) / 4,
                        -double(whole(b.rng, 1, 8)) / 4};
        const double before = double(whole(b.rng, 0, 8)) / 2, after = double(whole(b.rng, 0, 8)) / 2;
        b.add(point + Vec3{0, 0, radius} - path * before, path * (before + after), radius);
    }
}

// Contacts at 1/2, 3/4 and so on with faces of several planes at once.
void exact_fractions(CastBuilder& b) {
    const Steps hub = steps(in_world(random_steps(b.rng, 8 * kMetre), kMetre));
    while (b.scene.polygons.size() < 24) {  // triangles that all have the hub as a corner
        const Steps u = small(b.rng, 3), v = small(b.rng, 3);
        if (along_one_line(u, v)) continue;
        b.scene.polygons.push_back({in_world(hub), in_world(hub + u * kMetre), in_world(hub + v * kMetre)});
    }
    for (int k = 0; k < kCastsAScene; ++k) {
        const Steps way = small(b.rng, 4);
        const double before = double(whole(b.rng, 1, 7)), after = double(whole(b.rng, 0, 7));
        const WholeVector away = whole_vector(b.rng);
        const double radius = b.rng.chance(0.5) ? 0 : double(away.length);
        const Vec3 centre = to_metres(hub) + (radius > 0 ? to_metres(away.v * kMetre) : Vec3{});
        b.add(centre - to_metres(way * kMetre) * before, to_metres(way * kMetre) * (before + after), radius);
    }
}

}  // namespace firma::scenes
