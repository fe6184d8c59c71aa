// SPDX-License-Identifier: MIT
// check_gltf() of levels that no reader makes: each is refused with a reason.
#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "tests/gltf/read_text.h"
#include "tests/gltf/small_gltf.h"

namespace firma::gltf {
namespace {

/// Of a box of 12 triangles, changed.
Result<MeshCheck> check_of(const std::function<void(GltfLevel&)>& change) {
    GltfLevel gltf = read_good(box_file().text());
    gltf.level.name = "box.gltf";
    change(gltf);
    return check_gltf(gltf);
}

void expect_refused(const std::function<void(GltfLevel&)>& change, const std::string& reason) {
    const Result<MeshCheck> check = check_of(change);
    ASSERT_FALSE(check.ok()) << reason;
    EXPECT_EQ(check.error().code, ErrorCode::kInvalid);
    EXPECT_EQ(check.error().text(), "box.gltf: " + reason);
}

TEST(CheckGltf, LevelsThatAreNotSound) {
    expect_refused([](GltfLevel& gltf) { gltf.level.corners[3] = 4000000000u; }, "face 1: a corner names no vertex");
    expect_refused([](GltfLevel& gltf) { gltf.level.faces[2].first_corner = 4000000000u; },
                   "face 2: its corners are not there");
    expect_refused([](GltfLevel& gltf) { gltf.level.corners.clear(); }, "face 0: its corners are not there");
    expect_refused([](GltfLevel& gltf) { gltf.level.vertices.clear(); }, "face 0: a corner names no vertex");
    expect_refused([](GltfLevel& gltf) { gltf.level.faces[0].corner_count = 2; },
                   "face 0: it does not have 3 to 64 corners");
    expect_refused([](GltfLevel& gltf) { gltf.level.faces[0].corner_count = 0xFFFFFFFFu; },
                   "face 0: it does not have 3 to 64 corners");
    expect_refused([](GltfLevel& gltf) { gltf.level.corners[1] = gltf.level.corners[0]; },
                   "face 0: it is not convex and planar, with area");
    expect_refused([](GltfLevel& gltf) { gltf.level.faces[0].material = 7; },
                   "face 0: its material 7 is not there: there are 1");
}

TEST(CheckGltf, APlaceForEachNote) {
    expect_refused([](GltfLevel& gltf) { gltf.level.notes.push_back({FaceNote::kSplit, 3, 0}); },
                   "there are 1 notes, and places for 0");
    const Result<MeshCheck> check = check_of([](GltfLevel& gltf) {
        gltf.level.notes.push_back({FaceNote::kSplit, 3, 0});
        gltf.note_places.push_back({1, 2, 3});
    });
    ASSERT_TRUE(check.ok());
    ASSERT_EQ(check.value().notes.size(), 1u);
    EXPECT_EQ(check.value().notes[0].what, MeshNote::kDivided);
    EXPECT_EQ(check.value().notes[0].at, (Vec3{1, 2, 3}));
}

TEST(CheckGltf, CornersOfNoFaceAreNotRead) {
    const Result<MeshCheck> check = check_of([](GltfLevel& gltf) { gltf.level.corners.push_back(4000000000u); });
    ASSERT_TRUE(check.ok());
    EXPECT_TRUE(check.value().closed());
    EXPECT_EQ(check.value().vertices, 8u);
    EXPECT_TRUE(check_of([](GltfLevel& gltf) { gltf = {}; }).value().closed());
}

}  // namespace
}  // namespace firma::gltf
