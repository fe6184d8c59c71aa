// SPDX-License-Identifier: MIT
// What the families of casts share: choosing places on polygons, and casts that meet them.
#pragma once

#include "scenes/cast_families.h"

namespace firma::scenes {

inline constexpr int kCastsAScene = 48;

/// A place of a polygon to aim at.
struct Place {
    std::size_t polygon = 0;
    Feature feature = Feature::kFace;
    std::size_t corner = 0;  ///< of the vertex, or the edge's first
    Vec3 point;              ///< as near as double can say; exact for a vertex
};

class CastBuilder {
public:
    CastBuilder(Rng& random, CastScene& target) : rng(random), scene(target) {}

    Rng& rng;
    CastScene& scene;
    bool floats = false;  ///< casts are rounded to float

    std::vector<Vec3> corners(std::size_t polygon) const { return to_metres(scene.polygons[polygon]); }
    Vec3 normal(std::size_t polygon) const { return unit_normal(scene.polygons[polygon]); }

    Place place(Feature feature) {
        Place at;
        at.polygon = rng.below(std::uint32_t(scene.polygons.size()));
        at.feature = feature;
        const std::vector<Vec3> v = corners(at.polygon);
        at.corner = rng.below(std::uint32_t(v.size()));
        if (feature == Feature::kVertex) {
            at.point = v[at.corner];
        } else if (feature == Feature::kEdge) {
            const double part = rng.chance(0.3) ? 0.5 : rng.uniform();
            at.point = v[at.corner] + (v[(at.corner + 1) % v.size()] - v[at.corner]) * part;
        } else {
            double sum = 0;
            for (const Vec3& corner : v) {
                double weight = rng.uniform();
                weight *= rng.uniform();
                at.point = at.point + corner * weight;
                sum += weight;
            }
            at.point = at.point * (1 / sum);
        }
        return at;
    }
    Place any_place() {
        const double which = rng.uniform();
        return place(which < 0.5 ? Feature::kFace : which < 0.8 ? Feature::kEdge : Feature::kVertex);
    }
    /// Along the edge of the place, unit.
    Vec3 edge(const Place& at) const {
        const std::vector<Vec3> v = corners(at.polygon);
        const Vec3 e = v[(at.corner + 1) % v.size()] - v[at.corner];
        return e * (1 / length(e));
    }
    /// In the plane, out of the polygon at the place's edge or, at a vertex, between its edges.
    Vec3 outward(const Place& at) const {
        const std::vector<Vec3> v = corners(at.polygon);
        const Vec3 n = normal(at.polygon);
        const Vec3 here = cross(edge(at), n);
        if (at.feature != Feature::kVertex) return here;
        const Vec3 e = v[at.corner] - v[(at.corner + v.size() - 1) % v.size()];
        const Vec3 sum = here + cross(e * (1 / length(e)), n);
        return length(sum) > 0.1 ? sum * (1 / length(sum)) : here;
    }
    Vec3 perpendicular_to(const Vec3& unit) {
        for (;;) {
            const Vec3 v = cross(unit, rng.direction());
            if (length(v) > 0.1) return v * (1 / length(v));
        }
    }

    /// Evenly over the magnitudes, without a logarithm (they differ between machines).
    double magnitude(double low, double high) {
        int doublings = 0;
        while (std::ldexp(low, doublings + 1) <= high) ++doublings;
        double x = std::ldexp(low, int(rng.below(std::uint32_t(doublings + 1))));
        x *= rng.uniform(1, 2);
        return x < high ? x : high;
    }
    /// x moved by up to `most` units in the last place.
    double nudged(double x, int most) {
        const int count = int(rng.below(std::uint32_t(2 * most + 1))) - most;
        for (int k = 0; k < std::abs(count); ++k) x = std::nextafter(x, count < 0 ? -INFINITY : INFINITY);
        return x;
    }

    void add(Vec3 start, Vec3 path, double radius) {
        radius = std::fabs(radius);  // nudged below zero
        if (floats) {
            for (int axis = 0; axis < 3; ++axis) {
                start[axis] = rounded_to_float(start[axis]);
                path[axis] = rounded_to_float(path[axis]);
            }
            radius = rounded_to_float(radius);
        }
        scene.casts.push_back({{start, radius}, path});
    }
    /// Touches `contact` from the direction `away` (unit) with the centre at contact + away * radius, after `before`
    /// metres along `way` (unit), and goes on for `after`.
    void meet(const Vec3& contact, const Vec3& away, double radius, const Vec3& way, double before, double after) {
        add(contact + away * radius - way * before, way * (before + after), radius);
    }
    void triangles(int count, std::int64_t spread, std::int64_t reach, std::int64_t step, const Steps& centre = {}) {
        for (int k = 0; k < count; ++k)
            scene.polygons.push_back(random_triangle(rng, centre + random_steps(rng, spread), reach, step));
    }
    void ngons(int count, std::int64_t spread, std::int64_t reach, std::int64_t step, int points,
               bool collinear = false, const Steps& centre = {}) {
        for (int k = 0; k < count; ++k)
            scene.polygons.push_back(
                random_polygon(rng, centre + random_steps(rng, spread), reach, step, points, collinear));
    }
    void wild_casts(double radius_most, double reach) {
        for (int k = 0; k < kCastsAScene; ++k) wild(radius_most, reach);
    }
    /// Anything at all near the polygons.
    void wild(double radius_most, double reach) {
        const Place at = any_place();
        const double radius = rng.chance(0.4) ? 0 : magnitude(radius_most * 1e-3, radius_most);
        const Vec3 way = rng.direction();
        const Vec3 away = rng.chance(0.5) ? rng.direction() : way * -1;
        const double distance = radius * rng.uniform(0, 1.2);
        const double before = rng.uniform(0, reach);
        double after = rng.uniform(0, reach);
        after *= rng.uniform();
        meet(at.point, away, distance, way, before, after);
    }
};

}  // namespace firma::scenes
