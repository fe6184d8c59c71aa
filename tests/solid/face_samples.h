// SPDX-License-Identifier: MIT
// Faces to try facets on: loops drawn in a plane, put on a slanted one, and rounded to the surface grid.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <numbers>
#include <random>
#include <vector>

#include "firma/grid.h"

namespace firma::samples {

struct SampleFace {
    std::vector<GridPoint> points;
    std::vector<std::uint32_t> ends;
    int axis = 2;
    bool flip = false;
};

struct Spot {
    double u = 0, v = 0;
};
using Loop = std::vector<Spot>;

class Rng {
public:
    explicit Rng(std::uint32_t seed) : engine_(seed) {}
    double real(double low, double high) { return low + (high - low) * (engine_() * 0x1p-32); }
    int whole(int low, int high) { return low + int(engine_() % std::uint32_t(high - low + 1)); }

private:
    std::mt19937 engine_;
};

/// A plane whose normal has components of at most 1 beside the one along its axis: third = a u + b v.
struct SamplePlane {
    int axis = 2;
    bool flip = false;
    double a = 0, b = 0;
};

inline SamplePlane sample_axis_plane(int axis, bool flip) {
    return {axis, flip, 0, 0};
}

inline SamplePlane any_plane(Rng& rng) {
    SamplePlane plane;
    plane.axis = rng.whole(0, 2);
    plane.flip = rng.whole(0, 1) == 1;
    plane.a = rng.real(-1, 1);
    plane.b = rng.real(-1, 1);
    return plane;
}

/// Loops counter-clockwise in (u, v) come out so in the plane's projection.
inline SampleFace put(const SamplePlane& plane, const std::vector<Loop>& loops) {
    SampleFace face;
    face.axis = plane.axis;
    face.flip = plane.flip;
    const int u = (plane.axis + (plane.flip ? 2 : 1)) % 3, v = (plane.axis + (plane.flip ? 1 : 2)) % 3;
    for (const Loop& loop : loops) {
        for (const Spot& spot : loop) {
            GridPoint point;
            point[u] = std::int32_t(std::nearbyint(spot.u));
            point[v] = std::int32_t(std::nearbyint(spot.v));
            point[plane.axis] = std::int32_t(std::nearbyint(plane.a * spot.u + plane.b * spot.v));
            face.points.push_back(point);
        }
        face.ends.push_back(std::uint32_t(face.points.size()));
    }
    return face;
}

inline Loop reversed(Loop loop) {
    std::reverse(loop.begin(), loop.end());
    return loop;
}

/// Corners around a centre at radii between two bounds: a star, or a circle when they are equal.
inline Loop star(Rng& rng, int count, Spot centre, double low, double high) {
    Loop loop;
    for (int k = 0; k < count; ++k) {
        const double angle = 2 * std::numbers::pi * (k + rng.real(0, 0.8)) / count;
        const double radius = rng.real(low, high);
        loop.push_back({centre.u + radius * std::cos(angle), centre.v + radius * std::sin(angle)});
    }
    return loop;
}

inline Loop circle(int count, Spot centre, double radius) {
    Loop loop;
    for (int k = 0; k < count; ++k) {
        const double angle = 2 * std::numbers::pi * k / count;
        loop.push_back({centre.u + radius * std::cos(angle), centre.v + radius * std::sin(angle)});
    }
    return loop;
}

inline Loop rectangle(double low_u, double low_v, double high_u, double high_v) {
    return {{low_u, low_v}, {high_u, low_v}, {high_u, high_v}, {low_u, high_v}};
}

/// Puts corners on edges: once rounded, they are up to a step off to either side.
inline Loop with_runs(Rng& rng, const Loop& loop, int most) {
    Loop out;
    for (std::size_t k = 0; k < loop.size(); ++k) {
        const Spot &a = loop[k], &b = loop[(k + 1) % loop.size()];
        std::vector<double> places;
        const int count = rng.whole(0, most);
        for (int i = 0; i < count; ++i) places.push_back(rng.real(0.01, 0.99));
        std::sort(places.begin(), places.end());
        out.push_back(a);
        for (const double t : places) out.push_back({a.u + t * (b.u - a.u), a.v + t * (b.v - a.v)});
    }
    return out;
}

inline Loop comb(int teeth, double pitch, double height) {
    Loop loop{{0, 0}, {pitch * teeth, 0}};
    for (int k = teeth; k-- > 0;) {
        loop.push_back({pitch * (k + 0.75), height});
        if (k) loop.push_back({pitch * (k + 0.1), pitch * 0.5});
    }
    return loop;
}

/// Out along one side, and back along the other.
inline Loop spiral(int count, double step) {
    Loop loop;
    const auto at = [&](int k, double width) {
        const double angle = 0.35 * k, radius = step * (angle + 3 + width);
        return Spot{radius * std::cos(angle), radius * std::sin(angle)};
    };
    for (int k = 0; k < count; ++k) loop.push_back(at(k, 2.5));
    for (int k = count; k-- > 0;) loop.push_back(at(k, 0));
    return loop;
}

/// A large rectangle with a jagged hole.
inline std::vector<Loop> crater(Rng& rng, int corners, double size) {
    return {rectangle(-size, -size * 0.7, size, size * 0.7),
            reversed(star(rng, corners, {0.1 * size, 0.05 * size}, 0.2 * size, 0.4 * size))};
}

/// A star with holes in the cells of a grid.
inline std::vector<Loop> sieve(Rng& rng, int holes, int corners, double size) {
    std::vector<Loop> loops{with_runs(rng, rectangle(0, 0, 4 * size, 3 * size), 6)};
    for (int k = 0; k < holes; ++k)
        loops.push_back(reversed(
            star(rng, rng.whole(3, corners), {(k % 4 + 0.5) * size, (k / 4 + 0.5) * size}, 0.1 * size, 0.49 * size)));
    return loops;
}

}  // namespace firma::samples
