// SPDX-License-Identifier: MIT
// Judges faces and their facets by brute force and exactly, apart from the code under test.
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "firma/polygon.h"
#include "solid/make_facets.h"
#include "tests/solid/face_samples.h"

namespace firma::samples {

__extension__ using Exact = __int128;

struct Flat {
    std::int64_t u = 0, v = 0;
    friend bool operator==(const Flat&, const Flat&) = default;
};

enum class Verdict { kSound, kInitialOverlap, kWrong };

inline std::vector<Flat> flatten(const SampleFace& face) {
    const int u = (face.axis + (face.flip ? 2 : 1)) % 3, v = (face.axis + (face.flip ? 1 : 2)) % 3;
    std::vector<Flat> flat;
    for (const GridPoint& point : face.points) flat.push_back({point[u], point[v]});
    return flat;
}

inline int sign(Exact value) {
    return (value > 0) - (value < 0);
}

inline int orientation(const Flat& a, const Flat& b, const Flat& c) {
    return sign(Exact(a.u - c.u) * (b.v - c.v) - Exact(a.v - c.v) * (b.u - c.u));
}

inline bool on_segment(const Flat& p, const Flat& a, const Flat& b) {
    return orientation(a, b, p) == 0 && Exact(a.u - p.u) * (b.u - p.u) + Exact(a.v - p.v) * (b.v - p.v) <= 0;
}

/// Twice the area.
inline Exact area(std::span<const Flat> loop) {
    Exact sum = 0;
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const Flat &a = loop[k], &b = loop[(k + 1) % loop.size()];
        sum += Exact(a.u) * b.v - Exact(a.v) * b.u;
    }
    return sum;
}

/// Even-odd; never asked about points on the loop.
inline bool inside(const Flat& p, std::span<const Flat> loop) {
    bool odd = false;
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const Flat &a = loop[k], &b = loop[(k + 1) % loop.size()];
        if ((a.v > p.v) == (b.v > p.v)) continue;
        if (orientation(a, b, p) * (b.v > a.v ? 1 : -1) > 0) odd = !odd;
    }
    return odd;
}

/// kWrong when edges cross properly or a loop runs or lies wrongly; kInitialOverlap when edges share a point otherwise.
inline Verdict judge(const SampleFace& face) {
    const std::vector<Flat> flat = flatten(face);
    struct Edge {
        Flat a, b;
        std::size_t loop, place, size;
    };
    std::vector<Edge> edges;
    std::vector<std::span<const Flat>> loops;
    for (std::size_t l = 0, begin = 0; l < face.ends.size(); begin = face.ends[l++]) {
        loops.push_back(std::span(flat).subspan(begin, face.ends[l] - begin));
        const auto& loop = loops.back();
        for (std::size_t k = 0; k < loop.size(); ++k)
            edges.push_back({loop[k], loop[(k + 1) % loop.size()], l, k, loop.size()});
    }
    bool touching = false;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const Edge& e = edges[i];
        touching |= e.a == e.b;
        for (std::size_t j = i + 1; j < edges.size(); ++j) {
            const Edge& f = edges[j];
            const int across_e = orientation(e.a, e.b, f.a) * orientation(e.a, e.b, f.b);
            const int across_f = orientation(f.a, f.b, e.a) * orientation(f.a, f.b, e.b);
            if (across_e < 0 && across_f < 0) return Verdict::kWrong;
            const bool e_first = e.loop == f.loop && (e.place + 1) % e.size == f.place;
            const bool f_first = e.loop == f.loop && (f.place + 1) % f.size == e.place;
            const auto shares = [&](const Flat& p, const Edge& g, bool common) {
                return !common && on_segment(p, g.a, g.b);
            };
            if (shares(e.a, f, f_first) || shares(e.b, f, e_first) || shares(f.a, e, e_first) ||
                shares(f.b, e, f_first))
                touching = true;
        }
    }
    if (touching) return Verdict::kInitialOverlap;
    for (std::size_t l = 0; l < loops.size(); ++l) {
        if (l == 0 ? area(loops[l]) <= 0 : area(loops[l]) >= 0) return Verdict::kWrong;
        for (std::size_t m = 0; m < loops.size(); ++m)
            if (l > 0 && m != l && inside(loops[l][0], loops[m]) != (m == 0)) return Verdict::kWrong;
    }
    return Verdict::kSound;
}

/// What is wrong with facets; empty when nothing is. Sides that cancel but for the loops' edges, and areas above zero,
/// mean that each point is covered as often as the loops wind around it: once.
inline std::string fault(const SampleFace& face, const Facets& facets) {
    const std::vector<Flat> flat = flatten(face);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
    Exact covered = 0, whole = 0;
    if (facets.first.size() < 2 || facets.first.front() != 0 || facets.first.back() != facets.corners.size())
        return "first";
    for (std::size_t f = 0; f < facets.count(); ++f) {
        const std::uint32_t begin = facets.first[f], end = facets.first[f + 1];
        if (end < begin + 3 || end - begin > 64) return "count of corners";
        std::vector<Vec3> corners;
        std::vector<Flat> seen;
        for (std::uint32_t k = begin; k < end; ++k) {
            const std::uint32_t a = facets.corners[k], b = facets.corners[k + 1 < end ? k + 1 : begin];
            if (a >= face.points.size()) return "no such corner";
            if (++sides[{a, b}] > 1) return "a side twice in one direction";
            corners.push_back(to_metres(face.points[a]));
            seen.push_back(flat[a]);
        }
        if (check_polygon(corners) != PolygonFault::kNone) return "check_polygon";
        if (area(seen) <= 0) return "turned over";
        covered += area(seen);
    }
    for (std::size_t l = 0, begin = 0; l < face.ends.size(); begin = face.ends[l++]) {
        whole += area(std::span(flat).subspan(begin, face.ends[l] - begin));
        for (std::size_t k = begin; k < face.ends[l]; ++k) {
            const auto a = std::uint32_t(k), b = std::uint32_t(k + 1 < face.ends[l] ? k + 1 : begin);
            if (sides.erase({a, b}) != 1) return "an edge without a facet";
            if (sides.count({b, a})) return "an edge with a facet beyond";
        }
    }
    for (const auto& [side, count] : sides)
        if (!sides.count({side.second, side.first})) return "a side on its own";
    return covered == whole ? "" : "area";
}

}  // namespace firma::samples
