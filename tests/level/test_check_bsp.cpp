// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>

#include "firma/mesh.h"
#include "tests/level/bsp_writer.h"

namespace firma {
namespace {

using test::BspWriter;

MeshCheck check(const BspWriter& writer) {
    auto result = check_bsp(writer.bytes(), "map.bsp");
    EXPECT_TRUE(result.ok()) << result.error().text();
    return result.ok() ? std::move(result).value() : MeshCheck{};
}

// A tetrahedron of four planar faces, front outward; `tip` is where three of them meet.
BspWriter tetrahedron(const std::array<Vec3, 3>& tips) {
    const Vec3 a = {0, 0, 0}, b = {64, 0, 0}, c = {0, 64, 0};
    BspWriter writer;
    writer.polygon({a, c, b});
    writer.polygon({a, b, tips[0]});
    writer.polygon({b, c, tips[1]});
    writer.polygon({c, a, tips[2]});
    return writer;
}

TEST(CheckBsp, ClosedIsClosed) {
    const Vec3 tip = {0, 0, 64};
    const MeshCheck found = check(tetrahedron({tip, tip, tip}));
    EXPECT_TRUE(found.closed());
    EXPECT_TRUE(found.notes.empty());
    EXPECT_EQ(found.faces, 4u);
    EXPECT_EQ(found.vertices, 4u);
}

// The snap would close the gap; the floats do not.
TEST(CheckBsp, FloatsAreJudgedAsTheyAre) {
    const Vec3 tip = {0, 0, 64}, beside = {0, 0, double(std::nextafter(64.0f, 65.0f))};
    const MeshCheck found = check(tetrahedron({tip, beside, tip}));
    EXPECT_EQ(found.faults.size(), 4u);
    EXPECT_EQ(found.vertices, 5u);
}

TEST(CheckBsp, BothZerosAreOne) {
    const Vec3 tip = {0, 0, 64}, minus = {-0.0, -0.0, 64};
    EXPECT_TRUE(check(tetrahedron({tip, minus, tip})).closed());
}

TEST(CheckBsp, NamesTJoints) {
    BspWriter writer;
    writer.polygon({{0, 0, 0}, {64, 0, 0}, {64, 64, 0}, {0, 64, 0}});
    writer.polygon({{0, 0, 0}, {0, 0, -64}, {32, 0, -64}, {32, 0, 0}});
    writer.polygon({{32, 0, 0}, {32, 0, -64}, {64, 0, -64}, {64, 0, 0}});
    std::size_t joints = 0;
    for (const MeshFaultPlace& fault : check(writer).faults) joints += fault.t_joint;
    EXPECT_EQ(joints, 1u);
}

TEST(CheckBsp, NamesFacesWithoutArea) {
    const Vec3 tip = {0, 0, 64};
    BspWriter writer = tetrahedron({tip, tip, tip});
    writer.triangles(BspFace::kSoup, {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 1, 2}});
    const MeshCheck found = check(writer);
    ASSERT_EQ(found.notes.size(), 1u);
    EXPECT_EQ(found.notes[0].what, MeshNote::kNoArea);
    EXPECT_EQ(found.notes[0].source, 4u);
}

// Two quarters of a tube, back to back along two straight seams and over the same curves: open at the curved ends only.
TEST(CheckBsp, PatchesMeetAlongTheirRims) {
    BspWriter writer;
    for (const double side : {1.0, -1.0}) {
        std::vector<Vec3> control;
        for (const double z : {0.0, 32.0, 64.0}) {
            for (const Vec3& p : {Vec3{128, 0, z}, Vec3{128, 128 * side, z}, Vec3{0, 128 * side, z}})
                control.push_back(p);
        }
        if (side < 0) {
            for (std::size_t k = 0; k < 9; k += 3) std::swap(control[k], control[k + 2]);
        }
        writer.patch(3, 3, control);
    }
    const MeshCheck found = check(writer);
    EXPECT_TRUE(found.notes.empty());
    for (const MeshFaultPlace& fault : found.faults) {
        EXPECT_EQ(fault.what, MeshFault::kOpenEdge);
        EXPECT_FALSE(fault.from.y == 0 && fault.to.y == 0);
    }
}

TEST(CheckBsp, ErrorsAreThoseOfTheReader) {
    BspWriter writer;
    writer.version = 38;
    EXPECT_EQ(check_bsp(writer.bytes(), "map.bsp").error().code, ErrorCode::kUnsupported);
    writer.version = 46;
    EXPECT_EQ(check_bsp(writer.bytes(), "map.bsp", {.scale = -1}).error().code, ErrorCode::kInvalid);
}

}  // namespace
}  // namespace firma
