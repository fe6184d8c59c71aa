// SPDX-License-Identifier: MIT
// What is left when memory runs out, at every allocation in turn: a job in slices, a level's solids, an empty world. A
// program of its own, as operator new fails on demand. Under the address sanitizer it also shows that nothing leaks.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>

#include "firma/carve.h"
#include "firma/level.h"
#include "firma/solid.h"
#include "firma/world.h"
#include "tests/failing_new.h"

namespace firma {
namespace {

using tests::runs_out;

World room() {
    const char* text =
        "v -4 -4 -4\nv 4 -4 -4\nv 4 4 -4\nv -4 4 -4\nv -4 -4 4\nv 4 -4 4\nv 4 4 4\nv -4 4 4\n"
        "f 1 2 3 4\nf 8 7 6 5\nf 5 6 2 1\nf 6 7 3 2\nf 7 8 4 3\nf 8 5 1 4\n";
    return make_world(read_obj(text, "room").value()).value();
}

/// Runs a job until it is finished or out of memory; whether it was thrown out.
bool is_thrown_out(CarveJob& job, double microseconds) {
    try {
        while (!job.run(microseconds)) {
        }
    } catch (const std::bad_alloc&) {
        return true;
    }
    return false;
}

class CarveNoMemory : public testing::TestWithParam<double> {};

TEST_P(CarveNoMemory, AJobIsBrokenAndSaysSo) {
    const World before = room();
    const Cutter cutter = make_crater(CutterShape::kRocky, 1);
    Pose pose;
    pose.position = {4, 0, 0};
    const World after = carve(before, cutter, pose).world;
    for (long allocations = 0;; ++allocations) {
        CarveJob job(before, cutter, pose);
        bool thrown = false;
        if (!runs_out(allocations, [&] { thrown = is_thrown_out(job, GetParam()); })) {
            EXPECT_FALSE(thrown);
            EXPECT_FALSE(job.broken());
            EXPECT_EQ(hash_world(job.result().world), hash_world(after));
            EXPECT_GT(allocations, 100);
            break;
        }
        ASSERT_TRUE(thrown) << allocations;
        ASSERT_TRUE(job.broken()) << allocations;
        for (int again = 0; again < 2; ++again) {
            ASSERT_TRUE(job.finished()) << allocations;
            const CarveResult result = job.result();
            ASSERT_EQ(result.status, CarveStatus::kRefused) << allocations;
            ASSERT_EQ(result.error.code, ErrorCode::kNoMemory) << allocations;
            ASSERT_EQ(&result.world.data(), &before.data()) << allocations;
            ASSERT_TRUE(job.run(GetParam())) << allocations;
        }
    }
    EXPECT_FALSE(check_world(before));
}

INSTANTIATE_TEST_SUITE_P(Slices, CarveNoMemory, testing::Values(0.0, double(INFINITY)));

/// Calls something with ever more memory, until it is enough.
template <class Call>
void expect_enough_at_last(long at_least, const Call& call) {
    long allocations = 0;
    const auto guarded = [&] {
        try {
            call();
        } catch (const std::bad_alloc&) {
        }
    };
    while (runs_out(allocations, guarded)) ++allocations;
    EXPECT_GE(allocations, at_least);
}

TEST(NoMemory, AnEmptyWorldLeaksNothing) {
    expect_enough_at_last(3, [] { const World world; });
}

/// Two cubes that touch along an edge, whose faces need exact ones from the start.
TEST(NoMemory, ALevelThatTouchesItselfLeaksNothing) {
    std::string text;
    for (const int at : {0, 1})
        for (int corner = 0; corner < 8; ++corner) {
            const int x = at + (corner & 1), y = at + (corner >> 1 & 1), z = corner >> 2;
            text += "v";
            for (const int number : {x, y, z}) text.append(" ").append(std::to_string(number));
            text += "\n";
        }
    for (const int first : {1, 9})
        for (const auto& face : {"0231", "4576", "0154", "2673", "0462", "1375"}) {
            text += "f";
            for (int k = 0; k < 4; ++k) text.append(" ").append(std::to_string(first + face[k] - '0'));
            text += "\n";
        }
    const Level level = read_obj(text, "cubes").value();
    ASSERT_EQ(level_solidity(level).solid_faces, 12u);
    std::optional<World> made;
    expect_enough_at_last(50, [&] { made = make_world(level).value(); });
    EXPECT_FALSE(check_world(*made));
}

}  // namespace
}  // namespace firma
