// SPDX-License-Identifier: MIT
// Outlines for tests: convex, star-shaped, of cells, and any at all; in the plane, and lifted into space exactly.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

#include "firma/grid.h"
#include "scenes/rng.h"

namespace firma::outlines {

struct Flat {
    std::int64_t u = 0, v = 0;
    friend auto operator<=>(const Flat&, const Flat&) = default;
};
using FlatOutline = std::vector<Flat>;

__extension__ using Wide = __int128;

inline Wide turn(const Flat& a, const Flat& b, const Flat& c) {
    return Wide(b.u - a.u) * (c.v - a.v) - Wide(b.v - a.v) * (c.u - a.u);
}

/// Counter-clockwise hull of random points, corners along its sides kept or not.
inline FlatOutline convex(scenes::Rng& rng, int points, std::int32_t size, bool keep_straight) {
    std::set<Flat> chosen;
    for (int k = 0; k < points; ++k)
        chosen.insert({std::int64_t(rng.below(std::uint32_t(size))), std::int64_t(rng.below(std::uint32_t(size)))});
    const FlatOutline sorted(chosen.begin(), chosen.end());
    const auto half = [&](auto begin, auto end) {
        FlatOutline chain;
        for (auto it = begin; it != end; ++it) {
            const auto bends_in = [&] {
                const Wide t = turn(chain[chain.size() - 2], chain.back(), *it);
                return t < 0 || (t == 0 && !keep_straight);
            };
            while (chain.size() >= 2 && bends_in()) chain.pop_back();
            chain.push_back(*it);
        }
        chain.pop_back();
        return chain;
    };
    FlatOutline outline = half(sorted.begin(), sorted.end());
    const FlatOutline upper = half(sorted.rbegin(), sorted.rend());
    outline.insert(outline.end(), upper.begin(), upper.end());
    return outline;
}

/// A convex polygon of about 2.4 size^2 corners, none along a side: all directions of up to `size` steps, one after the
/// other.
inline FlatOutline round(std::int64_t size) {
    const auto half = [](const Flat& p) { return p.v > 0 || (p.v == 0 && p.u > 0) ? 0 : 1; };
    FlatOutline steps;
    for (std::int64_t u = -size; u <= size; ++u)
        for (std::int64_t v = -size; v <= size; ++v)
            if (std::gcd(u, v) == 1) steps.push_back({u, v});
    std::sort(steps.begin(), steps.end(), [&](const Flat& a, const Flat& b) {
        return half(a) != half(b) ? half(a) < half(b) : turn({0, 0}, a, b) > 0;
    });
    FlatOutline outline;
    Flat at{0, 0};
    for (const Flat& step : steps) {
        outline.push_back(at);
        at = {at.u + step.u, at.v + step.v};
    }
    return outline;
}

/// A polygon whose corners are seen from (0, 0) in counter-clockwise order, each in another direction.
inline FlatOutline star(scenes::Rng& rng, int corners, std::int32_t size) {
    const auto half = [](const Flat& p) { return p.v > 0 || (p.v == 0 && p.u > 0) ? 0 : 1; };
    const auto before = [&](const Flat& a, const Flat& b) {
        if (half(a) != half(b)) return half(a) < half(b);
        return turn({0, 0}, a, b) > 0;
    };
    std::set<Flat, decltype(before)> chosen(before);
    const std::int32_t quarter = size / 4;
    chosen.insert({{quarter, 1}, {-quarter, quarter}, {-quarter, -quarter}});
    while (int(chosen.size()) < corners) {
        const Flat p{std::int64_t(rng.uniform(-size, size)), std::int64_t(rng.uniform(-size, size))};
        if (p != Flat{0, 0}) chosen.insert(p);
    }
    return {chosen.begin(), chosen.end()};
}

/// The rim of a region of square cells that hang together: many corners along sides, and corners where it meets itself.
inline FlatOutline cells(scenes::Rng& rng, int count, std::int64_t side) {
    std::set<Flat> filled{{0, 0}};
    const auto has = [&](std::int64_t u, std::int64_t v) { return filled.contains({u, v}); };
    while (int(filled.size()) < count) {
        auto it = filled.begin();
        std::advance(it, rng.below(std::uint32_t(filled.size())));
        constexpr std::array<Flat, 4> kSteps{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
        const Flat step = kSteps[rng.below(4)];
        filled.insert({it->u + step.u, it->v + step.v});
    }
    // From the lowest, leftmost cell's corner along the rim, the region on the left; at a corner shared by two cells
    // only, the turn is to the left, so that the rim touches itself without crossing.
    const auto inside = [&](const Flat& at, const Flat& d, bool left) {
        const std::int64_t u = at.u + (d.u + (left ? -d.v : d.v) - 1) / 2,
                           v = at.v + (d.v + (left ? d.u : -d.u) - 1) / 2;
        return has(u, v);
    };
    const Flat start{filled.begin()->u, filled.begin()->v};
    Flat at = start, d{0, -1};
    for (const Flat step : {Flat{1, 0}, Flat{0, 1}, Flat{-1, 0}, Flat{0, -1}})
        if (inside(at, step, true) && !inside(at, step, false)) d = step;
    const Flat first = d;
    FlatOutline outline;
    do {
        outline.push_back({at.u * side, at.v * side});
        at = {at.u + d.u, at.v + d.v};
        for (const Flat step : {Flat{-d.v, d.u}, d, Flat{d.v, -d.u}})
            if (inside(at, step, true) && !inside(at, step, false)) {
                d = step;
                break;
            }
    } while (at != start || d != first);
    return outline;
}

/// Twice the area.
inline Wide area(const FlatOutline& outline) {
    Wide sum = 0;
    for (std::size_t k = 1; k + 1 < outline.size(); ++k) sum += turn(outline[0], outline[k], outline[k + 1]);
    return sum;
}

/// Lifts a flat outline into space: w = p u + q v, and the three axes in some order. Exactly planar.
inline std::vector<GridPoint> lift(const FlatOutline& outline, std::int64_t p, std::int64_t q, int axis,
                                   bool mirrored) {
    std::vector<GridPoint> lifted;
    for (const Flat& f : outline) {
        GridPoint point;
        point[(axis + (mirrored ? 2 : 1)) % 3] = std::int32_t(f.u);
        point[(axis + (mirrored ? 1 : 2)) % 3] = std::int32_t(f.v);
        point[axis] = std::int32_t(p * f.u + q * f.v);
        lifted.push_back(point);
    }
    return lifted;
}

}  // namespace firma::outlines
