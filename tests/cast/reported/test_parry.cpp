// SPDX-License-Identifier: MIT
// What users of parry, rapier and ncollide reported, asked of Firma.
#include "firma/queries.h"
#include "tests/cast/reported/report.h"
#include "tests/source_of.h"

namespace firma::reported {
namespace {

const double kHalfRoot = std::sqrt(0.5);

/// Two triangles of one floor, seam x = z: A where x >= z, B where x <= z; and a step that faces -x.
const Corners kA{{-4, 0, -4}, {4, 0, 4}, {4, 0, -4}}, kB{{-4, 0, -4}, {-4, 0, 4}, {4, 0, 4}};
const Corners kStepUp{{2, 0, -4}, {2, 0, 4}, {2, 1, 4}, {2, 1, -4}};

// Reported (parry #95, rapier #266): a character that slides along what it touches is stopped, unless it keeps 1 cm
// off. Right: one-sided, or on one quad, sliding is free and the step ahead is met.
TEST(Parry95, SlidesOverASeamToTheStep) {
    const Scene floor{kA, kB}, with_step{kA, kB, kStepUp}, quad{floor_at(0), kStepUp};
    const Sphere touch{{-1, 0.5, 1}, 0.5}, overlap{{-1, 0.5 - 1.0 / 64, 1}, 0.5};
    const Vec3 along{6, 0, 0};
    const Outcome step = hit(5.0 / 12, {-1, 0, 0}, Feature::kFace);
    floor.expect(touch, along, Sides::kFront, {kNone, kNone});
    floor.expect(overlap, along, Sides::kFront, {kNone, kNone});
    with_step.expect(touch, along, Sides::kFront, {kNone, kNone, step});
    quad.expect_either(touch, along, {kNone, step});
}

// Reported (parry #95): moving parallel to touched surfaces is what characters do most.
// Right by the contract, polygon by polygon: a two-sided floor of triangles is left by one and grazed anew at the next,
// which the sphere did not touch at its start; in overlap it meets that one's seam. Make floors one-sided or of one
// face.
TEST(Parry95, TwoSidedTrianglesAreEachMetAnew) {
    const Scene floor{kA, kB}, with_step{kA, kB, kStepUp}, b_alone{kB};
    const Sphere touch{{-1, 0.5, 1}, 0.5}, overlap{{-1, 0.5 - 1.0 / 64, 1}, 0.5};
    const Vec3 along{6, 0, 0};
    const Outcome graze = hit(1.0 / 3, kUp), step = hit(5.0 / 12, {-1, 0, 0}, Feature::kFace);
    floor.expect(touch, along, Sides::kBoth, {graze, kNone});
    with_step.expect(touch, along, Sides::kBoth, {graze, kNone, step});
    b_alone.expect(touch, along, Sides::kBoth, {kNone});

    const Vec3 tilted{-0.1753901900050285024492, 0.96875, 0.1753901900050285024492};
    floor.expect(overlap, along, Sides::kBoth, {hit(0.3041016349991619162584603, tilted, Feature::kEdge), kNone});
    b_alone.expect(overlap, along, Sides::kBoth, {kNone});
}

// Reported (parry #95): the cast stops at once even when the path leads out of the penetration.
// Right: leaving is no hit; coming through from below is touching for two-sided faces alone.
TEST(Parry95, LeavesAPenetration) {
    const Scene floor{kA, kB};
    floor.expect_either({{-1, 0.5 - 1.0 / 64, 1}, 0.5}, {0, 1, 0}, {kNone, kNone});
    const Sphere below{{-1, -0.25, 1}, 0.5};
    floor.expect(below, {0, 1, 0}, Sides::kBoth, {kNone, touching({0, -1, 0}, Feature::kFace)});
    floor.expect(below, {0, 1, 0}, Sides::kFront, {kNone, kNone});
    floor.expect_either(below, {0, -1, 0}, {kNone, kNone});
}

// Reported (parry #206): two balls that overlap and separate are told a hit at 0.
// Right: none when the distance grows or stays (exactly tangential), touching when it shrinks; here ball and vertex.
TEST(Parry206, OverlapThatSeparatesFromAVertex) {
    const Scene scene{{{0, 0, 0}, {-1, 0, -1}, {-1, 0, 1}}};
    const Sphere sphere{{1, 1, 0}, 3};
    scene.expect_either(sphere, {1, 2, 0}, {kNone});
    scene.expect_either(sphere, {1, -2, 0}, {touching({kHalfRoot, kHalfRoot, 0}, Feature::kVertex)});
    scene.expect_either(sphere, {1, -1, 0}, {kNone});
    scene.expect_either(sphere, {-1, 2, 0}, {kNone});
}

// Reported (parry #444): a mesh cast by rays is littered with holes of one pixel.
// Right: a ray through the seam hits both polygons, and each alone, at exactly the same fraction.
TEST(Parry444, ARayThroughASeam) {
    const Corners low{{-5, -5, 0}, {5, -5, 0}, {5, 5, 0}}, high{{-5, -5, 0}, {5, 5, 0}, {-5, 5, 0}};
    const Outcome seam = hit_exactly(0.5, {0, 0, 1});
    const Sphere particle{{0, 0, 10}, 0};
    const Vec3 path{6.75, 6.75, -20};
    Scene{low, high}.expect_either(particle, path, {seam, seam});
    Scene{low}.expect_either(particle, path, {seam});
    Scene{high}.expect_either(particle, path, {seam});
}

// Reported (parry #123, kept from ncollide #123): a ball against a triangle in its own plane never returns.
// Right: it returns at once; touching when it sinks in, none when far off, however short the path.
TEST(Parry123, BallAndTriangleTerminate) {
    const Scene scene{{{12, 5, 0}, {11, 5, 0}, {11, 6, 0}}};
    const Vec3 slope{kHalfRoot, kHalfRoot, 0};
    const double radius = 0.375;
    const auto expect = [&](const Vec3& start, const Vec3& path, const Outcome& two_sided,
                            std::source_location where = std::source_location::current()) {
        scene.expect({start, radius}, path, Sides::kBoth, {two_sided}, where);
        scene.expect({start, radius}, path, Sides::kFront, {kNone}, where);  // path . normal = 0
    };
    expect({11.5 + 371 * kStep, 5.5 + 1751 * kStep, 0}, {0, -68 * kStep, 0}, touching(slope, Feature::kEdge));
    expect({0, 0, 0}, {0, kStep, 0}, kNone);
    expect({0, 0, 0}, {0, 6.925e-42, 0}, kNone);
    expect({0, 0, 0}, {0, 0, 0}, kNone);
    expect({11.5, 6.5, 0}, {0, -1, 0}, hit(0.4696699141100893566993667, slope, Feature::kEdge));
}

/// Faces without area: a repeated corner, three in a line, three in a point.
const Corners kDegenerate[] = {
    {{0, 0, 0}, {4, 0, 0}, {4, 0, 0}}, {{0, 0, 0}, {2, 0, 0}, {4, 0, 0}}, {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}};

// Reported (parry #123, #76, #310, #31): degenerate triangles hang, answer NaN, or wrong distances.
// Right: a face without area is called so and answers kInvalid, an error and not a miss; no world takes it.
TEST(Parry123, FacesWithoutAreaAreRefused) {
    for (const Corners& corners : kDegenerate) {
        for (std::size_t first = 0; first < 3; ++first) {
            const Corners turned = begun_at(corners, first);
            EXPECT_EQ(check_polygon(turned), PolygonFault::kNoArea);
            for (const Sides sides : {Sides::kFront, Sides::kBoth}) {
                for (const double radius : {0.0, 0.5}) {
                    const PolygonHit hit = cast_polygon({{2, 2, 0}, radius}, {0, -2, 0}, turned, sides);
                    EXPECT_EQ(hit.status, Status::kInvalid);
                    EXPECT_FALSE(hit.touched());
                }
            }
            for (const bool first_in_level : {true, false}) {
                const Corners floor = floor_at(-0.25);
                const auto world =
                    make_world(level_of(first_in_level ? std::vector{turned, floor} : std::vector{floor, turned}));
                ASSERT_FALSE(world);
                EXPECT_EQ(world.error().code, ErrorCode::kInvalid);
            }
        }
    }
}

// Reported (parry #123, #76, #310, #31): as above, in files of real levels.
// Right: the reader drops such faces and says so; what is left answers as if they had never been there.
TEST(Parry123, ReadersDropFacesWithoutArea) {
    const auto level = read_obj(
        "v 0 0 0\nv 4 0 0\nv 2 0 0\nv 4 0 0.0001\n"
        "v -4 -0.25 -4\nv -4 -0.25 4\nv 4 -0.25 4\nv 4 -0.25 -4\n"
        "f 1 2 2\nf 1 3 2\nf 5 6 7 8\nf 1 1 1\nf 1 2 4\n",
        "degenerate.obj");
    ASSERT_TRUE(level) << level.error().text();
    EXPECT_EQ(level.value().faces.size(), 1u);
    EXPECT_EQ(level.value().count(FaceNote::kNoArea), 4u) << "one of them only without area once snapped";
    const World world = make_world(level.value()).value();
    for (const Sides sides : {Sides::kFront, Sides::kBoth}) {
        const Hit got = cast(world, {{2, 2, 0}, 0.5}, {0, -2, 0}, {.sides = sides});
        expect_outcome(got, hit_exactly(7.0 / 8, kUp, Feature::kFace), 0.5);
        EXPECT_EQ(source_of(world, got), 2u) << "dropped faces are counted";
    }
}

// Reported (parry #123, by its kind): thin triangles treated as degenerate.
// Right: a sliver one grid step wide has area, a face and a rim, and answers as such.
TEST(Parry123, ASliverIsNotDegenerate) {
    const Scene scene{{{0, 0, 0}, {2, 0, kStep}, {4, 0, 0}}};
    scene.expect_either({{2, 2, 0}, 0.5}, {0, -2, 0}, {hit_exactly(0.75, kUp)});
    scene.expect_either({{2, 2, kStep}, 0}, {0, -2, 0}, {hit_exactly(1, kUp)});
    scene.expect_either({{1, 2, 0}, 0}, {0, -2, 0}, {hit_exactly(1, kUp)});
    scene.expect_either({{1, 2, kStep}, 0}, {0, -2, 0}, {kNone});
}

/// A wall 10 x 5 m, half of a tenth of a metre (to the grid) in front of z = 0.
constexpr double kWallZ = 205 * kStep;
const Corners kWall{{-5, -2.5, kWallZ}, {5, -2.5, kWallZ}, {5, 2.5, kWallZ}, {-5, 2.5, kWallZ}};

// Reported (parry #193): along walls on the grid, at a shallow angle, normals are not of unit length and wrong.
// Right: a face contact has exactly the face's normal, whatever the angle.
TEST(Parry193, ShallowAlongAWall) {
    const Scene scene{kWall};
    const struct {
        Sphere sphere;
        Vec3 path;
    } rows[] = {{{{-4, 0, kWallZ + 0.5 + 1.0 / 64}, 0.5}, {8, 0, -1.0 / 32}},
                {{{-4, 0, kWallZ + 0.5 + kStep}, 0.5}, {8, 0, -2 * kStep}}};
    for (const auto& row : rows) {
        scene.expect_either(row.sphere, row.path, {hit_exactly(0.5, {0, 0, 1}, Feature::kFace)});
        for (const Guise& guise : scene.guises())
            EXPECT_EQ(cast(guise.world, row.sphere, row.path).normal, (Vec3{0, 0, 1})) << "to the bit";
    }
}

// Reported (parry #193): on a face slightly entered, small changes of depth turn the normal.
// Right: exactly the face's normal at every depth; sliding and leaving are no hits.
TEST(Parry193, DepthDoesNotTurnTheNormal) {
    const Scene scene{{{-1.5, 0.5, -1.5}, {-1.5, 0.5, 1.5}, {1.5, 0.5, 1.5}, {1.5, 0.5, -1.5}}};
    for (const int depth : {1, 4, 41, 410}) {
        const Sphere sphere{{0.25, 1 - depth * kStep, 0}, 0.5};
        scene.expect_either(sphere, {1, -kStep, 0}, {touching(kUp, Feature::kFace)});
        scene.expect_either(sphere, {1, 0, 0}, {kNone});
        scene.expect_either(sphere, {1, kStep, 0}, {kNone});
        for (const Guise& guise : scene.guises())
            EXPECT_EQ(cast(guise.world, sphere, {1, -kStep, 0}).normal, kUp) << "to the bit";
    }
}

// Reported (parry #429): the time of impact on a floor is short by up to 0.14 m, more the larger the floor is.
// Right: exactly half way, on a floor a kilometre wide.
TEST(Parry429, ABigFace) {
    const Scene scene{{{-512, 0, -512}, {-512, 0, 512}, {512, 0, 512}, {512, 0, -512}}};
    const double radius = 2116 * kStep;
    scene.expect_either({{1234567 * kStep, 2 + radius, -777777 * kStep}, radius}, {0.75, -4, 0.25},
                        {hit_exactly(0.5, kUp, Feature::kFace)});
}

}  // namespace
}  // namespace firma::reported
