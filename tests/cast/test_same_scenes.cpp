// SPDX-License-Identifier: MIT
// Scenes are the same on every compiler: a hash over every bit of some of each family of casts and of closed meshes. A
// family that was changed shows which by the properties that --gtest_output writes.
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>

#include "scenes/cast_families.h"
#include "scenes/closed_meshes.h"

namespace firma::scenes {
namespace {

/// FNV-1a over 64-bit words.
class Hash {
public:
    void add(std::uint64_t word) {
        for (int k = 0; k < 8; ++k) value_ = (value_ ^ (word >> (8 * k) & 0xff)) * 0x100000001b3ull;
    }
    void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
    void add(const GridPolygon& polygon) {
        for (const GridPoint& p : polygon)
            for (int axis = 0; axis < 3; ++axis) add(std::uint64_t(p[axis]));
    }
    void add(const CastQuery& cast) {
        for (int axis = 0; axis < 3; ++axis) add(cast.sphere.centre[axis]);
        for (int axis = 0; axis < 3; ++axis) add(cast.path[axis]);
        add(cast.sphere.radius);
    }
    std::uint64_t value() const { return value_; }

private:
    std::uint64_t value_ = 0xcbf29ce484222325ull;
};

TEST(SameScenes, OfCasts) {
    Hash all;
    for (const CastFamily& family : cast_families()) {
        Hash hash;
        for (std::uint64_t index = 0; index < 8; ++index) {
            const CastScene scene = make_cast_scene(family, 1, index);
            for (const GridPolygon& polygon : scene.polygons) hash.add(polygon);
            for (const CastQuery& cast : scene.casts) hash.add(cast);
        }
        RecordProperty(std::string(family.name), std::to_string(hash.value()));
        all.add(hash.value());
    }
    EXPECT_EQ(all.value(), 6202114992641559643u);
}

TEST(SameScenes, OfClosedMeshes) {
    Hash hash;
    Rng rng(1);
    for (int round = 0; round < 8; ++round)
        for (int kind = 0; kind < kMeshKinds; ++kind) {
            const ClosedMesh mesh = make_closed_mesh(MeshKind(kind), rng);
            for (const GridPolygon& face : mesh.faces) hash.add(face);
            for (int k = 0; k < 20; ++k) hash.add(escaping_cast(mesh, k % 2 == 0, rng));
        }
    EXPECT_EQ(hash.value(), 14873042289264356110u);
}

}  // namespace
}  // namespace firma::scenes
