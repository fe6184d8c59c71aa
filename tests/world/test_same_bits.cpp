// SPDX-License-Identifier: MIT
// Same answers everywhere: a hash over every bit of many casts through our level, the same for every compiler and its
// options.
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>

#include "firma/firma.h"
#include "scenes/rng.h"

namespace firma {
namespace {

/// FNV-1a over 64-bit words.
class Hash {
public:
    void add(std::uint64_t word) {
        for (int k = 0; k < 8; ++k) value_ = (value_ ^ (word >> (8 * k) & 0xff)) * 0x100000001b3ull;
    }
    void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
    void add(const Vec3& v) {
        add(v.x);
        add(v.y);
        add(v.z);
    }
    void add(const World& world, const Hit& hit) {
        add(std::uint64_t(hit.status) | std::uint64_t(hit.feature) << 8 | std::uint64_t(hit.feature_index) << 16);
        // A miss as it was before it had the end of its path, when the hash below was taken.
        add(hit.touched() ? hit.fraction : 0);
        add(hit.touched() ? hit.safe_fraction : 0);
        add(hit.touched() ? hit.centre : Vec3{});
        add(hit.point);
        add(hit.normal);
        add(hit.face_normal);
        const bool at_edge = hit.touched() && hit.feature == Feature::kEdge;
        const FaceId other = at_edge ? other_face(world, hit.face, hit.feature_index) : FaceId{};
        add(std::uint64_t(hit.face.id.value) << 32 | other.value);
        const std::optional<FaceInfo> face = world.face_info(hit.face);
        add(std::uint64_t(face ? face->source : 0) << 32 | hit.material);
    }
    std::uint64_t value() const { return value_; }

private:
    std::uint64_t value_ = 0xcbf29ce484222325ull;
};

TEST(SameBits, AThousandsOfCastsThroughOurLevel) {
    const Result<Level> level = read_level(FIRMA_ROOT "/levels/first.obj");
    ASSERT_TRUE(level) << level.error().text();
    const World world = make_world(level.value()).value();
    const Box bounds = world.bounds();
    scenes::Rng rng(7);
    Hash hash;
    int touched = 0;
    for (int k = 0; k < 20000; ++k) {
        Vec3 start;
        for (int axis = 0; axis < 3; ++axis) start[axis] = rng.uniform(bounds.low[axis], bounds.high[axis]);
        const double radius = rng.chance(0.3) ? 0 : rng.uniform(0.01, 1);
        const Vec3 direction = rng.direction();  // one draw a statement: compilers order operands as they like
        const double length = rng.uniform(0.1, k % 2 ? 2 : 100);
        const Sides sides = k % 3 ? Sides::kFront : Sides::kBoth;
        const Hit hit = cast(world, {start, radius}, direction * length, {.sides = sides});
        hash.add(world, hit);
        touched += hit.touched();
    }
    EXPECT_GT(touched, 5000);
    EXPECT_EQ(hash.value(), 1002329652177471125ull) << std::hex << hash.value();
}

}  // namespace
}  // namespace firma
