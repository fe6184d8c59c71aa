// SPDX-License-Identifier: MIT
// What users of Box3D reported, asked of Firma.
#include "tests/cast/reported/report.h"

namespace firma::reported {
namespace {

// Reported (Box3D #32): a sweep that starts near a surface says fraction 0 whatever its direction: standing, one is
// stuck. Right: in touch or overlap a hit needs a decreasing distance; a gap, however small, is an ordinary cast
// without slop.
TEST(Box3d32, RestWithAGapInTouchAndInOverlap) {
    const Scene floor{floor_at(0)};
    const Sphere touch{{0, 0.5, 0}, 0.5}, gap{{0, 0.5 + 16 * kStep, 0}, 0.5}, overlap{{0, 0.5 - 16 * kStep, 0}, 0.5};
    for (const Vec3& path : {Vec3{0, 1, 0}, Vec3{1, 0, 0}, Vec3{1, kStep, 0}}) {
        floor.expect_either(touch, path, {kNone});
        floor.expect_either(overlap, path, {kNone});
    }
    for (const Vec3& path : {Vec3{0, -1, 0}, Vec3{1, -kStep, 0}}) floor.expect_either(touch, path, {touching(kUp)});
    for (const Vec3& path : {Vec3{0, -kStep, 0}, Vec3{1, -kStep, 0}})
        floor.expect_either(overlap, path, {touching(kUp)});

    for (const Vec3& path :
         {Vec3{0, 1, 0}, Vec3{1, 0, 0}, Vec3{1, -kStep, 0}, Vec3{0, -15 * kStep, 0}, Vec3{3, -15 * kStep, 0}})
        floor.expect_either(gap, path, {kNone});
    floor.expect_either(gap, {0, -16 * kStep, 0}, {hit_exactly(1, kUp)});
    floor.expect_either(gap, {3, -16 * kStep, 0}, {hit_exactly(1, kUp)});
    floor.expect_either(gap, {0, -32 * kStep, 0}, {hit_exactly(0.5, kUp)});
    floor.expect_either(gap, {0, -1, 0}, {hit_exactly(1.0 / 256, kUp)});
}

// Reported (Box3D #32): every trace of a player who stands on something "cannot move in any direction".
// Right: the floor that is slid along must not shadow the wall ahead.
TEST(Box3d32, RestThenAWall) {
    const Scene scene{floor_at(0), {{3, 0, -4}, {3, 0, 4}, {3, 4, 4}, {3, 4, -4}}};
    for (const double y : {0.5, 0.5 - 16 * kStep})
        scene.expect_either({{0, y, 0}, 0.5}, {4, 0, 0}, {kNone, hit(5.0 / 8, {-1, 0, 0})});
}

}  // namespace
}  // namespace firma::reported
