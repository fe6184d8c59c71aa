// SPDX-License-Identifier: MIT
// What is on the page, in numbers; how it looks is for eyes.
#include <gtest/gtest.h>

#include <string>

#include "draw/draw_plan.h"
#include "firma/firma.h"

namespace firma::draw {
namespace {

/// Two rooms: 8 x 6 x 4 m wound into the air, and one of 2 m apart from it.
World two_rooms() {
    std::string text;
    const auto add_box = [&](double x, double y, double z, double sx, double sy, double sz) {
        for (int k = 0; k < 8; ++k)
            text += "v " + std::to_string(x + sx * (k & 1)) + " " + std::to_string(y + sy * (k >> 1 & 1)) + " " +
                    std::to_string(z + sz * (k >> 2 & 1)) + "\n";
        for (const char* face :
             {"-8 -7 -5 -6", "-4 -2 -1 -3", "-8 -4 -3 -7", "-6 -5 -1 -2", "-8 -6 -2 -4", "-7 -3 -1 -5"})
            text += std::string("f ") + face + "\n";
    };
    add_box(0, 0, 0, 8, 6, 4);
    add_box(20, 10, 0, 2, 2, 2);
    return make_world(read_obj(text, "two_rooms").value()).value();
}

std::size_t count(const std::string& text, const std::string& what) {
    std::size_t found = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++found;
    return found;
}

TEST(DrawPlan, ShowsFloorsAndTheFarWalls) {
    const Plan plan = draw_plan(two_rooms(), {}, {.at = 3.0});
    EXPECT_EQ(plan.faces_in_plan, 2u);     // the floors, through the ceilings
    EXPECT_EQ(plan.faces_in_section, 2u);  // the walls at y = 6 and at y = 12
    EXPECT_EQ(plan.faces_cut, 4u);         // of the larger room
    EXPECT_EQ(plan.faces_left_out, 0u);
    EXPECT_EQ(plan.cut_axis, 1);
    EXPECT_EQ(count(plan.svg, "<svg "), 1u);
    EXPECT_EQ(count(plan.svg, "</svg>"), 1u);
}

TEST(DrawPlan, CutsWhereMostIsSeen) {
    const Plan plan = draw_plan(two_rooms(), {});
    EXPECT_GT(plan.at, 0);
    EXPECT_LT(plan.at, 6);  // through the wide room, though the middle of the whole lies beyond it
    EXPECT_EQ(plan.faces_cut, 4u);
}

TEST(DrawPlan, DrawsSomeOfManyCasts) {
    std::vector<DrawnCast> casts(1000, DrawnCast{{1, 1, 1}, {5, 0, 0}, 0.5, Status::kMiss, {}, {}, {}});
    casts[0] = {{1, 1, 1}, {9, 0, 0}, 0.5, Status::kHit, {7.5, 1, 1}, {8, 1, 1}, {-1, 0, 0}};
    const Plan plan = draw_plan(two_rooms(), casts, {.most_casts = 10});
    EXPECT_EQ(plan.casts_drawn, 10u);
    EXPECT_NE(plan.svg.find("miss (999)"), std::string::npos);
    EXPECT_NE(plan.svg.find("hit (1)"), std::string::npos);
    EXPECT_EQ(draw_plan(two_rooms(), casts, {.most_casts = 0}).casts_drawn, 0u);
}

TEST(DrawPlan, TheSectionShowsCastsNearItsCut) {
    const std::vector<DrawnCast> casts{{{1, 3, 1}, {5, 0, 0}, 0, Status::kMiss, {}, {}, {}},
                                       {{1, 5, 1}, {5, 0, 0}, 0, Status::kMiss, {}, {}, {}}};
    const Plan plan = draw_plan(two_rooms(), casts, {.at = 3.0});
    EXPECT_EQ(count(plan.svg, "class=\"way miss\" d=\"M"), 2u + 1u + 1u);  // plan, section, legend
}

TEST(DrawPlan, EveryAxisCanBeUp) {
    for (int up = 0; up < 3; ++up) {
        const Plan plan = draw_plan(two_rooms(), {}, {.up = up});
        EXPECT_EQ(plan.cut_axis, (up + 2) % 3);
        EXPECT_EQ(plan.faces_in_plan, 2u);
    }
}

TEST(DrawPlan, WorldsWithoutFaces) {
    const Plan plan = draw_plan(World(), {});
    EXPECT_EQ(plan.faces_in_plan, 0u);
    EXPECT_NE(plan.svg.find("0 faces"), std::string::npos);
}

TEST(DrawPlan, ATwoSidedFaceIsSeenFromBehind) {
    Level level = read_obj("v 0 0 0\nv 4 0 0\nv 0 4 0\nf 1 3 2\n", "sheet").value();
    EXPECT_EQ(draw_plan(make_world(level).value(), {}).faces_in_plan, 0u);
    level.faces[0].two_sided = true;
    EXPECT_EQ(draw_plan(make_world(level).value(), {}).faces_in_plan, 1u);
}

}  // namespace
}  // namespace firma::draw
