// SPDX-License-Identifier: MIT
// What users of tinybvh reported, asked of Firma.
#include <map>

#include "tests/cast/reported/report.h"

namespace firma::reported {
namespace {

/// Heights on a 4 x 4 field, whole numbers 0..3.
int height(int i, int j) {
    return (3 * i * j + 5 * i + 7 * j) % 4;
}

Vec3 vertex(int i, int j) {
    return {double(i), double(height(i, j)), double(j)};
}

std::vector<Corners> field() {
    std::vector<Corners> triangles;
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) {
            triangles.push_back({vertex(i, j), vertex(i, j + 1), vertex(i + 1, j + 1)});
            triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i + 1, j)});
        }
    }
    return triangles;
}

/// Every vertex, and the middle of every edge.
std::vector<Vec3> targets() {
    std::vector<Vec3> all;
    for (int i = 0; i <= 4; ++i) {
        for (int j = 0; j <= 4; ++j) {
            all.push_back(vertex(i, j));
            if (i < 4) all.push_back((vertex(i, j) + vertex(i + 1, j)) * 0.5);
            if (j < 4) all.push_back((vertex(i, j) + vertex(i, j + 1)) * 0.5);
            if (i < 4 && j < 4) all.push_back((vertex(i, j) + vertex(i + 1, j + 1)) * 0.5);
        }
    }
    return all;
}

const Vec3 kPaths[] = {{0, -16, 0}, {1, -16, 2}, {-3, -32, 1}};

// Reported (tinybvh #168): on a mesh of whole-number vertices, rays at its vertices and edges get through.
// Right: no ray is lost, the first hit is at exactly 1/2, and every triangle around the target says so.
TEST(Tinybvh168, RaysAtVerticesAndEdgesOfAnIntegerField) {
    const Scene scene(field());
    const std::vector<Vec3> all = targets();
    ASSERT_EQ(all.size(), 81u);
    for (const Guise& guise : scene.guises()) {
        for (const Vec3& path : kPaths) {
            std::map<std::size_t, int> targets_by_faces;
            for (const Vec3& target : all) {
                const Sphere particle{target - path * 0.5, 0};
                std::size_t faces = 0;
                std::uint32_t first = ~0u;
                for (std::uint32_t k = 0; k < guise.polygons.size(); ++k) {
                    const PolygonHit hit = cast_polygon(particle, path, guise.polygons[k]);
                    if (hit.status == Status::kMiss) continue;
                    ASSERT_EQ(hit.status, Status::kHit);
                    ASSERT_EQ(hit.fraction, 0.5) << "the field is met once";
                    ++faces;
                    first = std::min(first, k);
                }
                ++targets_by_faces[faces];
                for (const World* world : {&guise.world, &guise.two_sided, &guise.deep}) {
                    const Hit hit = cast(*world, particle, path);
                    ASSERT_EQ(hit.status, Status::kHit);
                    ASSERT_EQ(hit.fraction, 0.5);
                    ASSERT_EQ(hit.point, target);
                    ASSERT_EQ(hit.face.id, FaceId{first}) << "of several at one fraction the first";
                }
            }
            EXPECT_EQ(targets_by_faces, (std::map<std::size_t, int>{{1, 18}, {2, 42}, {3, 12}, {6, 9}}));
        }
    }
}

// Reported (tinybvh #168): as above.
// Right: a sphere does not get through where its centre's ray does not, and hits no later.
TEST(Tinybvh168, SpheresAtVerticesAndEdgesOfAnIntegerField) {
    const Scene scene(field());
    for (const Guise& guise : scene.guises()) {
        for (const Vec3& path : kPaths) {
            for (const Vec3& target : targets()) {
                for (const double radius : {kStep, 0.25}) {
                    for (const World* world : {&guise.world, &guise.two_sided, &guise.deep}) {
                        const Hit hit = cast(*world, {target - path * 0.5, radius}, path);
                        ASSERT_EQ(hit.status, Status::kHit);
                        ASSERT_LE(hit.fraction, 0.5);
                    }
                }
            }
        }
    }
}

// Reported (tinybvh #168): rays that run exactly along a face of a bounding box, the 0/0 of slab tests, get through.
// Right: from the very top of the field's box straight down, every vertex is met; those at the top are touched.
TEST(Tinybvh168, RaysFromTheTopOfTheBox) {
    const Scene scene(field());
    const Vec3 down{0, -4, 0};
    for (const Guise& guise : scene.guises()) {
        ASSERT_EQ(guise.world.bounds(), (Box{{0, 0, 0}, {4, 3, 4}}));
        for (const World* world : {&guise.world, &guise.two_sided, &guise.deep}) {
            for (int i = 0; i <= 4; ++i) {
                for (int j = 0; j <= 4; ++j) {
                    const Hit hit = cast(*world, {{double(i), 3, double(j)}, 0}, down);
                    EXPECT_EQ(hit.status, height(i, j) == 3 ? Status::kInitialOverlap : Status::kHit);
                    EXPECT_DOUBLE_EQ(hit.fraction, (3 - height(i, j)) / 4.0);
                }
            }
            const Hit hit = cast(*world, {{1, 3, 0}, 0}, down);
            EXPECT_EQ(hit.fraction, 0.5);
            EXPECT_EQ(hit.point, (Vec3{1, 1, 0}));
        }
    }
}

}  // namespace
}  // namespace firma::reported
