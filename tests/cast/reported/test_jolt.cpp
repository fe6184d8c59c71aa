// SPDX-License-Identifier: MIT
// What users of Jolt Physics reported, asked of Firma.
#include "tests/cast/reported/report.h"

namespace firma::reported {
namespace {

// Reported (Jolt #529): casts that start in overlap with a mesh lose normal and depth once "a tiny bit deeper".
// Right: every depth above the plane is touching with the face's normal, the plane itself included (the centre on the
// polygon and path . normal < 0); beyond it, going on is moving away.
TEST(Jolt529, StartsInOverlapAtAnyDepth) {
    const Scene scene{floor_at(0)};
    for (const double y : {0.5, kStep, 0.0})
        scene.expect_either({{0, y, 0}, 1}, {0, -1, 0}, {touching(kUp, Feature::kFace)});
    for (const double y : {-kStep, -0.5}) scene.expect_either({{0, y, 0}, 1}, {0, -1, 0}, {kNone});
}

// Reported (Jolt #529): an early-out at fraction 0 skipped the deeper polygons of the mesh.
// Right: each polygon by itself, then the lowest id; neither order of the polygons loses or changes an answer.
TEST(Jolt529, StartsInOverlapWithTwoFaces) {
    const Scene scene{floor_at(0), {{0, -4, -4}, {0, 4, -4}, {0, 4, 4}, {0, -4, 4}}};
    const Sphere sphere{{0.5, 0.25, 0}, 1};
    const Outcome floor = touching(kUp, Feature::kFace), wall = touching({1, 0, 0}, Feature::kFace);
    scene.expect_either(sphere, {0, -1, 0}, {floor, kNone});
    scene.expect_either(sphere, {-1, 0, 0}, {kNone, wall});
    scene.expect_either(sphere, {1, -1, 0}, {floor, kNone});
    scene.expect_either(sphere, {-1, -1, 0}, {floor, wall});
}

/// The top of a box of half extents (1.5, 0.5, 1.5).
Corners lid(double half_width = 1.5) {
    const double w = half_width;
    return {{-w, 0.5, -w}, {-w, 0.5, w}, {w, 0.5, w}, {w, 0.5, -w}};
}

// Reported (Jolt #2049): a cast that starts in overlap hits or not by the offset of its start and the scale of the box.
// Right: touching from the lid at every offset above it and at every scale.
TEST(Jolt2049, OverlapAtAnyOffsetAndScale) {
    const Scene scene{lid()};
    const Vec3 down{0, -0.5, 0};
    const double y = 3891 * kStep;
    for (const double x : {0.0, 41 * kStep, 1.0, 1.5}) scene.expect_either({{x, y, 0}, 0.5}, down, {touching(kUp)});
    scene.expect_either({{1.5 + kStep, y, 0}, 0.5}, down,
                        {touching({0.0005425935175236714791939, 0.9999998527961265361544, 0}, Feature::kEdge)});
    for (const double x : {0.0, 41 * kStep}) {
        for (const double scale : {4.0, 64.0})
            Scene{scaled(lid(), scale)}.expect_either({Vec3{x, y, 0} * scale, 0.5 * scale}, down * scale,
                                                      {touching(kUp, Feature::kFace)});
        for (const double half_width : {0.5, 1536.0})
            Scene{lid(half_width)}.expect_either({{x, y, 0}, 0.5}, down, {touching(kUp, Feature::kFace)});
    }
}

// Reported (Jolt #2049): a contact whose normal is exactly perpendicular to the path was culled as a back face.
// Right: as a later, exact graze it is a hit, one step farther out a miss.
TEST(Jolt2049, AGrazeWithAPerpendicularNormal) {
    const Scene scene{lid()};
    scene.expect_either({{17.0 / 8, 1.5, 0}, 0.625}, {0, -2, 0}, {hit_exactly(0.5, {1, 0, 0}, Feature::kEdge)});
    scene.expect_either({{17.0 / 8 + kStep, 1.5, 0}, 0.625}, {0, -2, 0}, {kNone});
    scene.expect_either({{15.0 / 8, 17.0 / 16, 0}, 0.625}, {0, -0.5, 0}, {hit(1.0 / 8, {0.6, 0.8, 0}, Feature::kEdge)});
}

// Reported (Jolt #886): a sphere that passes a line-like triangle 2.4 m away is told a hit.
// Right: none there; a twin aimed at its edge hits. (The report's numbers, rounded to the grid.)
TEST(Jolt886, ASliverHasNoGhost) {
    const Scene scene{scaled({{59612, 43407, -25}, {59612, 43405, -13051}, {59612, 43405, -21243}}, kStep)};
    const Vec3 path = Vec3{-405, 0, 3} * kStep;
    scene.expect_either({Vec3{60750, 33548, -17647} * kStep, 819 * kStep}, path, {kNone});
    scene.expect_either(
        {Vec3{60750, 43406, -13051} * kStep, 819 * kStep}, path,
        {hit(0.787654399075942153979596,
             {0.9999999613849126100589, 0.0002779031712711769061452, -2.619503923755084420258e-8}, Feature::kEdge)});
}

}  // namespace
}  // namespace firma::reported
