// SPDX-License-Identifier: MIT
// Sets of spheres fitted into solids: inside, as near as they say, no more than asked for.
#include <gtest/gtest.h>

#include <cmath>

#include "body/cover_error.h"
#include "body/surface_points.h"
#include "firma/cutter.h"
#include "firma/queries.h"
#include "firma/solid.h"
#include "scenes/rng.h"
#include "tests/body/simple_bodies.h"
#include "tests/fracture/rubble.h"
#include "tests/openarena_maps.h"
#include "tests/random_vector.h"
#include "tests/sample.h"

namespace firma {
namespace {

Solid box_solid(const Vec3& half) {
    return test::brush_world(map_text::box(-half, half, "rock")).solid();
}

Solid crater_solid(CutterShape shape, std::uint64_t seed) {
    const SolidResult made = unite(Solid(), make_crater(shape, seed), {});
    EXPECT_TRUE(made.done()) << made.error.text();
    return made.solid;
}

std::vector<Solid> solids() {
    std::vector<Solid> all{box_solid({1, 1, 1}), box_solid({2, 0.5, 0.25}), box_solid({4, 4, 0.125})};
    for (int k = 0; k < 5; ++k) all.push_back(crater_solid(CutterShape(k), std::uint64_t(k)));
    // A hollow one.
    const World shell = test::brush_world(map_text::box({-2, -2, -2}, {2, 2, 2}, "rock"));
    all.push_back(subtract(shell.solid(), make_crater(CutterShape::kRocky, 3), {}).solid);
    return all;
}

double gap_to(const SphereSet& spheres, const Vec3& point) {
    double least = INFINITY;
    for (const Sphere& sphere : spheres) least = std::min(least, length(point - sphere.centre) - sphere.radius);
    return least;
}

/// Inside, and no point of the surface farther than it says; nor much nearer.
void judge(const Solid& solid, const SphereFit& fit) {
    const World world = make_world(solid).value();
    for (const Sphere& sphere : fit.spheres) {
        EXPECT_EQ(locate(solid, sphere.centre), Where::kSolid);
        EXPECT_GE(closest(world, sphere.centre).distance, sphere.radius);
    }
    double farthest = 0;
    for (const SurfacePoint& point : surface_points(triangles_of(solid), fit.error / 4))
        farthest = std::max(farthest, gap_to(fit.spheres, point.at));
    for (const Face& face : world.faces())
        for (const Vec3& corner : face.corners) farthest = std::max(farthest, gap_to(fit.spheres, corner));
    EXPECT_LE(farthest, fit.error);
    EXPECT_GE(farthest, fit.error * 0.7);
}

TEST(FitSpheres, AreInsideAndAsNearAsTheySay) {
    for (const Solid& solid : test::sampled(solids())) {
        double before = INFINITY;
        for (const std::size_t count : {1, 4, 16, 64}) {
            FitOptions options;
            options.max_spheres = count;
            options.max_error = 1e-3;
            const Result<SphereFit> fit = fit_spheres(solid, options);
            ASSERT_TRUE(fit.ok()) << fit.error().text();
            EXPECT_LE(fit.value().spheres.size(), count);
            // Few more may do no better, many more do.
            EXPECT_LT(fit.value().error, before * 1.05);
            before = fit.value().error;
            judge(solid, fit.value());
        }
    }
}

// Their facets are bent by rounding; slivers among them look the other way.
void judge_rubble(const test::Rubble& rubble) {
    std::size_t spheres = 0;
    for (std::size_t k = 0; k < rubble.chunks.size(); ++k) {
        const Solid& solid = rubble.chunks[k].solid;
        const Result<SphereFit> fit = fit_spheres(solid, {.max_spheres = 12});
        if (!fit) continue;
        const World own = make_world(solid).value();
        for (const Sphere& sphere : fit.value().spheres) {
            EXPECT_EQ(locate(solid, sphere.centre), Where::kSolid) << k;
            EXPECT_GE(closest(own, sphere.centre).distance, sphere.radius) << k;
        }
        spheres += fit.value().spheres.size();
    }
    EXPECT_GT(spheres, rubble.chunks.size() * 6);
}

TEST(FitSpheres, AreInsideRubbleOfTheDepot) {
    judge_rubble(test::rubble_of(test::depot_world(), std::size_t(test::sample(100)), 0));
}

TEST(FitSpheres, AreInsideRubbleOfAMap) {
    if (openarena_maps().empty()) GTEST_SKIP() << kNoOpenArena;
    const test::Rubble rubble = test::rubble_of(test::openarena_world("kaos2"), std::size_t(test::sample(15)), 0.02);
    ASSERT_GE(rubble.chunks.size(), std::size_t(test::sample(15)));
    judge_rubble(rubble);
    // The error is proven as well.
    for (std::size_t k = 0; k < rubble.chunks.size(); k += 5) {
        const Result<SphereFit> fit = fit_spheres(rubble.chunks[k].solid, {.max_error = 1e-3, .max_spheres = 32});
        ASSERT_TRUE(fit.ok()) << fit.error().text();
        judge(rubble.chunks[k].solid, fit.value());
    }
}

TEST(FitSpheres, StopWhereTheErrorIsReached) {
    for (const double error : {0.4, 0.2, 0.1}) {
        const Result<SphereFit> fit = fit_spheres(box_solid({1, 1, 1}), {.max_error = error, .max_spheres = 500});
        ASSERT_TRUE(fit.ok());
        EXPECT_LE(fit.value().error, error);
        EXPECT_LT(fit.value().spheres.size(), 300u);
        judge(box_solid({1, 1, 1}), fit.value());
    }
    // One ball in a cube leaves its corners: sqrt(3) - 1 of them.
    const Result<SphereFit> one = fit_spheres(box_solid({1, 1, 1}), {.max_error = 0.8, .max_spheres = 500});
    EXPECT_EQ(one.value().spheres.size(), 1u);
    EXPECT_NEAR(one.value().spheres[0].radius, 1, 0.005);
}

TEST(FitSpheres, AMarginKeepsThemInside) {
    const Result<SphereFit> fit =
        fit_spheres(box_solid({1, 1, 1}), {.max_error = 0.3, .max_spheres = 100, .margin = 0.02});
    ASSERT_TRUE(fit.ok());
    const World world = make_world(box_solid({1, 1, 1})).value();
    for (const Sphere& sphere : fit.value().spheres)
        EXPECT_GE(closest(world, sphere.centre).distance, sphere.radius + 0.02 - 1e-9);
}

TEST(FitSpheres, AreTheSameEachTime) {
    const Solid solid = crater_solid(CutterShape::kRocky, 9);
    const SphereSet one = fit_spheres(solid).value().spheres, other = fit_spheres(solid).value().spheres;
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t k = 0; k < one.size(); ++k) {
        EXPECT_EQ(one[k].centre, other[k].centre);
        EXPECT_EQ(one[k].radius, other[k].radius);
    }
    EXPECT_TRUE(
        std::is_sorted(one.begin(), one.end(), [](const Sphere& a, const Sphere& b) { return a.radius > b.radius; }));
}

TEST(FitSpheres, WhatCannotBeCoveredIsSaid) {
    const auto reason = [](const Solid& solid, const FitOptions& options) {
        const Result<SphereFit> fit = fit_spheres(solid, options);
        return fit ? std::string("fine") : fit.error().text();
    };
    const Solid box = box_solid({1, 1, 1});
    EXPECT_EQ(reason(Solid(), {}), "the solid has no faces");
    EXPECT_EQ(reason(box, {}), "fine");
    EXPECT_EQ(reason(box, {.max_error = NAN}), "max_error is not finite or negative");
    EXPECT_EQ(reason(box, {.max_spheres = 0}), "max_spheres is not within 1 to 4096");
    EXPECT_EQ(reason(box, {.margin = -1}), "margin is not finite or negative");
    EXPECT_EQ(reason(box, {.margin = 5}), "the solid has no room for a sphere");
}

TEST(CoverError, IsProvenFromAboveAndNotFarFromTrue) {
    const std::vector<SurfaceTriangle> square{{Vec3{0, 0, 0}, Vec3{4, 0, 0}, Vec3{4, 4, 0}},
                                              {Vec3{0, 0, 0}, Vec3{4, 4, 0}, Vec3{0, 4, 0}}};
    const Sphere sphere{{1, 1, -1}, 0.5};
    const double truly = std::sqrt(19.0) - 0.5;  // at the far corner
    for (const double tolerance : {0.5, 0.1, 0.01, 0.001}) {
        const CoverError error = cover_error(square, {&sphere, 1}, 1, tolerance);
        EXPECT_GE(error.at_most, truly);
        EXPECT_LE(error.at_most, truly + 2 * tolerance);
        ASSERT_FALSE(error.too_far.empty());
    }
}

TEST(SphereAround, HoldsAll) {
    scenes::Rng rng(5);
    SphereSet spheres;
    for (int k = 0; k < 50; ++k) spheres.push_back({test::random_vector(rng, 0, 3), rng.uniform(0.01, 1)});
    const Sphere around = sphere_around(spheres);
    for (const Sphere& sphere : spheres)
        EXPECT_LE(length(sphere.centre - around.centre) + sphere.radius, around.radius * (1 + 1e-15));
    EXPECT_EQ(sphere_around({}).radius, 0);
}

}  // namespace
}  // namespace firma
