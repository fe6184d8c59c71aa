// SPDX-License-Identifier: MIT
// Asks a reported sweep in every guise: by polygon and by world, from each corner on, polygons in both orders.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <source_location>
#include <vector>

#include "firma/level.h"
#include "firma/polygon.h"
#include "firma/queries.h"
#include "firma/world.h"

namespace firma::reported {

/// One step of the input grid, the `u` of the tables.
inline constexpr double kStep = 1 / kInputSteps;

using Corners = std::vector<Vec3>;

/// How near a fraction has to be: to the bit, to 4 units in the last place, or, for roots of roots, to 1e-15.
enum class Digits : std::uint8_t { kAll, kNearlyAll, kMost };

/// What one polygon, by itself, has to answer.
struct Outcome {
    Status status = Status::kMiss;
    double fraction = 0;
    Vec3 normal;
    std::optional<Feature> feature;  ///< where a report turns on it
    Digits digits = Digits::kAll;    ///< of the fraction

    bool touched() const { return status != Status::kMiss; }
};

inline const Outcome kNone;

inline Outcome hit(double fraction, const Vec3& normal, std::optional<Feature> feature = {},
                   Digits digits = Digits::kNearlyAll) {
    return {Status::kHit, fraction, normal, feature, digits};
}

inline Outcome hit_exactly(double fraction, const Vec3& normal, std::optional<Feature> feature = {}) {
    return hit(fraction, normal, feature, Digits::kAll);
}

inline Outcome touching(const Vec3& normal, std::optional<Feature> feature = {}) {
    return {Status::kInitialOverlap, 0, normal, feature, Digits::kAll};
}

/// A level with one face a polygon, in order; all corners on the surface grid.
inline Level level_of(const std::vector<Corners>& polygons, bool two_sided = false) {
    Level level;
    level.name = "report";
    level.materials = {""};
    level.groups = {""};
    for (const Corners& polygon : polygons) {
        LevelFace face;
        face.first_corner = std::uint32_t(level.corners.size());
        face.corner_count = std::uint32_t(polygon.size());
        face.source = std::uint32_t(level.faces.size());
        face.two_sided = two_sided;
        for (const Vec3& p : polygon) {
            level.corners.push_back(std::uint32_t(level.vertices.size()));
            level.vertices.push_back({std::int32_t(p.x * kSurfaceSteps), std::int32_t(p.y * kSurfaceSteps),
                                      std::int32_t(p.z * kSurfaceSteps)});
        }
        level.faces.push_back(face);
    }
    level.source_faces = std::uint32_t(level.faces.size());
    return level;
}

inline Corners begun_at(Corners corners, std::size_t first) {
    std::rotate(corners.begin(), corners.begin() + std::ptrdiff_t(first % corners.size()), corners.end());
    return corners;
}

inline Corners reversed(Corners corners) {
    std::reverse(corners.begin(), corners.end());
    return corners;
}

inline Corners scaled(Corners corners, double by) {
    for (Vec3& p : corners) p = p * by;
    return corners;
}

/// The same polygons begun at other corners, in one of the two orders, as polygons and as worlds.
struct Guise {
    std::vector<Corners> polygons;
    std::vector<std::size_t> original;  ///< which of the report's polygons each is
    World world, two_sided, deep;       ///< deep: one face a bin, by surface area
};

inline std::vector<Guise> all_guises(const std::vector<Corners>& polygons) {
    std::size_t max_corners = 0;
    for (const Corners& polygon : polygons) max_corners = std::max(max_corners, polygon.size());
    std::vector<Guise> guises;
    for (std::size_t first = 0; first < max_corners; ++first) {
        for (const bool backward : {false, true}) {
            if (backward && polygons.size() == 1) continue;
            Guise guise;
            for (std::size_t k = 0; k < polygons.size(); ++k) {
                guise.original.push_back(backward ? polygons.size() - 1 - k : k);
                guise.polygons.push_back(begun_at(polygons[guise.original.back()], first));
            }
            guise.world = make_world(level_of(guise.polygons)).value();
            guise.two_sided = make_world(level_of(guise.polygons, true)).value();
            guise.deep =
                make_world(level_of(guise.polygons),
                           {.tree = {.split = Split::kSurfaceArea, .faces_per_leaf = 1}, .tolerance = {}, .rules = {}})
                    .value();
            guises.push_back(std::move(guise));
        }
    }
    return guises;
}

inline void expect_outcome(const PolygonHit& got, const Outcome& wanted, double radius) {
    ASSERT_EQ(got.status, wanted.status);
    if (!wanted.touched()) return;
    if (wanted.digits == Digits::kAll) {
        EXPECT_EQ(got.fraction, wanted.fraction);
    } else if (wanted.digits == Digits::kNearlyAll) {
        EXPECT_DOUBLE_EQ(got.fraction, wanted.fraction);
    } else {
        EXPECT_NEAR(got.fraction, wanted.fraction, 1e-15);
    }
    for (int axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(got.normal[axis], wanted.normal[axis], 1e-12) << "axis " << axis << " of the normal";
    EXPECT_NEAR(length(got.normal), 1, 1e-15);
    if (got.status == Status::kHit) {
        const Vec3 rim = got.centre - got.normal * radius - got.point;
        EXPECT_LE(length(rim), 1e-14 * (1 + max_abs(got.centre) + radius)) << "the point lies on the sphere";
    }
    if (wanted.feature) {
        EXPECT_EQ(got.feature, *wanted.feature);
    }
}

/// The polygons of a report.
class Scene {
public:
    Scene(std::initializer_list<Corners> polygons) : guises_(all_guises({polygons})) {}
    explicit Scene(const std::vector<Corners>& polygons) : guises_(all_guises(polygons)) {}

    const std::vector<Guise>& guises() const { return guises_; }

    /// Asks each polygon and the worlds of all of them. A world has to answer as the first of its polygons: by
    /// fraction, then by order.
    void expect(const Sphere& sphere, const Vec3& path, Sides sides, const std::vector<Outcome>& outcomes,
                std::source_location where = std::source_location::current()) const {
        const ::testing::ScopedTrace row(where.file_name(), int(where.line()),
                                         sides == Sides::kBoth ? "two-sided" : "one-sided");
        for (std::size_t g = 0; g < guises_.size(); ++g) {
            SCOPED_TRACE(::testing::Message() << "guise " << g);
            const Guise& guise = guises_[g];
            ASSERT_EQ(outcomes.size(), guise.polygons.size());
            expect_polygons(guise, sphere, path, sides, outcomes);
            expect_world(guise.world, guise, sphere, path, sides, outcomes);
            expect_world(guise.deep, guise, sphere, path, sides, outcomes);
            if (sides == Sides::kBoth) expect_world(guise.two_sided, guise, sphere, path, Sides::kFront, outcomes);
        }
    }

    /// For what is the same one-sided and two-sided.
    void expect_either(const Sphere& sphere, const Vec3& path, const std::vector<Outcome>& outcomes,
                       std::source_location where = std::source_location::current()) const {
        expect(sphere, path, Sides::kFront, outcomes, where);
        expect(sphere, path, Sides::kBoth, outcomes, where);
    }

private:
    static void expect_polygons(const Guise& guise, const Sphere& sphere, const Vec3& path, Sides sides,
                                const std::vector<Outcome>& outcomes) {
        for (std::size_t k = 0; k < guise.polygons.size(); ++k) {
            SCOPED_TRACE(::testing::Message() << "polygon " << guise.original[k]);
            ASSERT_EQ(check_polygon(guise.polygons[k]), PolygonFault::kNone);
            const PolygonHit got = cast_polygon(sphere, path, guise.polygons[k], sides);
            expect_outcome(got, outcomes[guise.original[k]], sphere.radius);
        }
    }

    static void expect_world(const World& world, const Guise& guise, const Sphere& sphere, const Vec3& path,
                             Sides sides, const std::vector<Outcome>& outcomes) {
        SCOPED_TRACE("world");
        const Outcome* first = &kNone;
        std::uint32_t face = 0;
        std::size_t touched = 0;
        for (std::uint32_t k = 0; k < guise.polygons.size(); ++k) {
            const Outcome& outcome = outcomes[guise.original[k]];
            touched += outcome.touched();
            if (!outcome.touched() || (first->touched() && first->fraction <= outcome.fraction)) continue;
            first = &outcome;
            face = k;
        }
        const CastOptions options{.sides = sides};
        const Hit got = cast(world, sphere, path, options);
        expect_outcome(got, *first, sphere.radius);
        if (first->touched()) {
            EXPECT_EQ(got.face.id, FaceId{face}) << "of several at one fraction the first";
        }
        EXPECT_EQ(cast_any(world, sphere, path, options) != Status::kMiss, first->touched());
        std::vector<Hit> hits;
        EXPECT_EQ(cast_all(world, sphere, path, hits, options), first->status);
        EXPECT_EQ(hits.size(), touched);
    }

    std::vector<Guise> guises_;
};

/// A floor of 8 x 8 m at height y, facing up.
inline Corners floor_at(double y) {
    return {{-4, y, -4}, {-4, y, 4}, {4, y, 4}, {4, y, -4}};
}

inline const Vec3 kUp{0, 1, 0};

}  // namespace firma::reported
