// SPDX-License-Identifier: MIT
// What users of PhysX reported, asked of Firma.
#include "tests/cast/reported/report.h"

namespace firma::reported {
namespace {

// Reported (PhysX #690): a sphere in touch with an edge of a mesh gets stuck: distance 0 and normal = -path, every way.
// Right: the normal leads from the edge to the centre whatever the path; leaving and sliding are no hits.
TEST(Physx690, TouchingAnEdgeIsNotBeingStuck) {
    const Scene scene{{{-4, 0, -4}, {-4, 0, 4}, {0, 0, 4}, {0, 0, -4}},
                      {{0, 0, -4}, {0, 0, 4}, {0, -4, 4}, {0, -4, -4}}};
    const Outcome edge = touching({0.6, 0.8, 0}, Feature::kEdge);
    for (const Vec3& start : {Vec3{0.75, 1, 0}, Vec3{0.375, 0.5, 0}}) {  // exact touch of the shared edge, and overlap
        const Sphere sphere{start, 1.25};
        for (const Vec3& path : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{-4, 3, 0}})
            scene.expect_either(sphere, path, {kNone, kNone});
        scene.expect(sphere, {-1, 0, 0}, Sides::kBoth, {edge, edge});
        scene.expect(sphere, {-1, 0, 0}, Sides::kFront, {kNone, edge});
        scene.expect(sphere, {0, -1, 0}, Sides::kBoth, {edge, edge});
        scene.expect(sphere, {0, -1, 0}, Sides::kFront, {edge, kNone});
        scene.expect_either(sphere, {-1, -1, 0}, {edge, edge});
    }
}

// Reported (PhysX #597): the lower end of a capsule, on an oblique path, misses an edge: only one feature was tried.
// Right: the edge v1-v2 is hit. (The report's numbers, moved by (-7, -80, 27) and rounded to the grid.)
TEST(Physx597, ObliqueEdge) {
    const Scene scene{scaled({{1364, -1594, 271}, {2517, 1054, -1232}, {1364, 1054, 271}}, kStep)};
    const Sphere sphere{Vec3{3036, 2105, -1063} * kStep, 1087 * kStep};
    scene.expect_either(sphere, Vec3{-569, -17, 225} * kStep,
                        {hit(0.6334758078389636638975703,
                             {0.2302314744783950269707, 0.9569741593990226473907, 0.1766180240010575290068},
                             Feature::kEdge, Digits::kMost)});
    const Corners triangle = scene.guises()[0].polygons[0];
    const PolygonHit got = cast_polygon(sphere, Vec3{-569, -17, 225} * kStep, triangle);
    EXPECT_EQ(got.feature_index, 1u);
}

// Reported (PhysX #600): a sweep parallel to a triangle is told "no hit" before any edge is looked at, even in overlap.
// Right: from outside it meets the edge; the report's own start, on the triangle and leaving, is ignored here.
TEST(Physx600, ParallelToTheFace) {
    const Scene scene{{{0, 0, 0}, {1, 0, 0}, {0, 0, -1}}};
    const auto expect = [&](const Sphere& sphere, const Vec3& path, const Outcome& two_sided,
                            std::source_location where = std::source_location::current()) {
        scene.expect(sphere, path, Sides::kBoth, {two_sided}, where);
        scene.expect(sphere, path, Sides::kFront, {kNone}, where);  // path . normal = 0
    };
    expect({{0, 0, 0}, 0.25}, {-1, 0, 0}, kNone);
    expect({{0, 0, 0}, 0.3}, {-1, 0, 0}, kNone);
    expect({{-2, 0, -0.25}, 0.25}, {4, 0, 0}, hit(7.0 / 16, {-1, 0, 0}, Feature::kEdge));
    expect({{-2, 3.0 / 16, -0.25}, 5.0 / 16}, {4, 0, 0}, hit(7.0 / 16, {-0.8, 0.6, 0}, Feature::kEdge));
    expect({{-2, 0.25, -0.25}, 0.25}, {4, 0, 0}, hit_exactly(0.5, kUp));
    expect({{-2, 0.25 + kStep, -0.25}, 0.25}, {4, 0, 0}, kNone);
    expect({{-0.125, 0, -0.25}, 0.25}, {1, 0, 0}, touching({-1, 0, 0}, Feature::kEdge));
    expect({{0.25, 0.125, -0.25}, 0.25}, {-1, 0, 0}, kNone);
    // A particle in the very plane meets the rim; there is no way from the rim to its centre, so the face's normal it
    // is.
    expect({{-2, 0, -0.25}, 0}, {4, 0, 0}, hit_exactly(0.5, kUp, Feature::kEdge));
}

// Reported (PhysX #600): the same early-out, a determinant below 1e-5, also swallows tiny triangles (so tinybvh #283).
// Right: a triangle of three grid steps is met like any other, and from behind it is not.
TEST(Physx600, TinyTriangleHeadOn) {
    const Corners tiny{{0, 0, 0}, {0, 3 * kStep, 0}, {3 * kStep, 0, 0}};
    const Sphere particle{{kStep, kStep, -1}, 0}, ball{{kStep, kStep, -1}, 0.25};
    const Scene scene{tiny}, turned{reversed(tiny)};
    scene.expect_either(particle, {0, 0, 2}, {hit_exactly(0.5, {0, 0, -1})});
    scene.expect_either(ball, {0, 0, 2}, {hit_exactly(0.375, {0, 0, -1})});
    turned.expect(particle, {0, 0, 2}, Sides::kFront, {kNone});
    turned.expect(ball, {0, 0, 2}, Sides::kFront, {kNone});
}

// Reported (PhysX #501): a capsule cast straight down stops about 0.06 m deep in a mesh, near an edge.
// Right: the first of face, edges and vertices; trying the one that looks likely finds a later one, here 9/16.
TEST(Physx501, DownOnAnEdgeNotLate) {
    const Scene scene{{{1, 1, 0}, {3, 0, -2}, {-3, 0, 3}}};
    scene.expect_either({{1.5, 10, 0}, 0.5}, {0, -16, 0},
                        {hit(35.0 / 64, {2.0 / 3, 2.0 / 3, 1.0 / 3}, Feature::kEdge)});
}

// Reported (PhysX #501): turning the mesh by a hundredth of a degree cured it.
// Right: these, which that choice of one feature misses altogether, are hits, exact grazes down an edge included.
TEST(Physx501, DownOnAnEdgeNotMissed) {
    const Vec3 path{0, -16, 0};
    Scene{{{-1, 2, 2}, {-1, -4, 3}, {0, 0, 0}}}.expect_either(
        {{-1, 10, 1}, 0.5}, path, {hit(17.0 / 32, {-2.0 / 3, 1.0 / 3, -2.0 / 3}, Feature::kEdge)});
    Scene{{{0, 0, 0}, {0, -4, 3}, {2, 0, -4}}}.expect_either({{-1, 10, 1.5}, 1.25}, path,
                                                             {hit(43.0 / 64, {-0.8, 0.36, 0.48}, Feature::kEdge)});
    Scene{{{1, 2, 0}, {4, 1, 3}, {0, 0, -2}}}.expect_either(
        {{0.5, 10, -1.5}, 1.25}, path, {hit(31.0 / 64, {-2.0 / 15, 11.0 / 15, -2.0 / 3}, Feature::kEdge)});
    Scene{{{0, 1, -1}, {-2, 0, -1}, {2, 0, 1}}}.expect_either({{-0.5, 10, -1.5}, 0.5}, path,
                                                              {hit(37.0 / 64, {0, 0, -1}, Feature::kEdge)});
    Scene{{{0, 2, 1}, {-1, 2, 0}, {0, -4, 2}}}.expect_either({{0.5, 10, 1.5}, 0.5}, path,
                                                             {hit(11.0 / 16, {1, 0, 0}, Feature::kEdge)});
}

// Reported (PhysX #610): two cubes, one swept straight down on the other: 2.9975 came back where 3 is right.
// Right: exactly 3 of 4, exactly the end for a path of 3, a miss for one step less.
TEST(Physx610, AxisAlignedDistanceIsExact) {
    const Corners top{{-1, 11, -1}, {-1, 11, 1}, {1, 11, 1}, {1, 11, -1}};
    const Scene scene{top};
    scene.expect_either({{0, 15, 0}, 1}, {0, -4, 0}, {hit_exactly(0.75, kUp, Feature::kFace)});
    scene.expect_either({{0, 15, 0}, 1}, {0, -3, 0}, {hit_exactly(1, kUp, Feature::kFace)});
    scene.expect_either({{0, 15, 0}, 1}, {0, -12287 * kStep, 0}, {kNone});
    scene.expect_either({{1.75, 15, 0}, 1.25}, {0, -4, 0}, {hit(0.75, {0.6, 0.8, 0}, Feature::kEdge)});
}

// Reported (PhysX #610): the distance comes out short by an amount tied to the size of the objects.
// Right: the same fraction at every scale. (1024 times as large it leaves the world, so that one stands at y = 0.)
TEST(Physx610, TheSameAtEveryScale) {
    const Corners top{{-1, 11, -1}, {-1, 11, 1}, {1, 11, 1}, {1, 11, -1}};
    for (const double scale : {1.0 / 256, 64.0, 512.0})
        Scene{scaled(top, scale)}.expect_either({Vec3{1.75, 15, 0} * scale, 1.25 * scale}, Vec3{0, -4, 0} * scale,
                                                {hit(0.75, {0.6, 0.8, 0}, Feature::kEdge)});
    const Corners low{{-1, 0, -1}, {-1, 0, 1}, {1, 0, 1}, {1, 0, -1}};
    for (const double scale : {1.0 / 256, 1.0, 64.0, 1024.0})
        Scene{scaled(low, scale)}.expect_either({Vec3{1.75, 4, 0} * scale, 1.25 * scale}, Vec3{0, -4, 0} * scale,
                                                {hit(0.75, {0.6, 0.8, 0}, Feature::kEdge)});
}

}  // namespace
}  // namespace firma::reported
