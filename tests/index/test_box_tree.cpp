// SPDX-License-Identifier: MIT
// The box tree finds what looking at every box finds, each once, and stops when told.
#include "index/box_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "scenes/rng.h"

namespace firma {
namespace {

GridBox random_box(scenes::Rng& rng, std::int32_t spread, std::int32_t size) {
    GridBox box;
    for (int axis = 0; axis < 3; ++axis) {
        const double low = rng.uniform(-spread, spread);
        const double extent = rng.uniform(0, size);
        box.low[axis] = std::int32_t(low);
        box.high[axis] = std::int32_t(low) + std::int32_t(extent);
    }
    return box;
}

std::vector<std::uint32_t> found_by(const BoxTree& tree, const GridBox& box) {
    std::vector<std::uint32_t> found;
    EXPECT_FALSE(tree.for_each_meeting(box, [&](std::uint32_t k) {
        found.push_back(k);
        return false;
    }));
    return found;
}

/// In the order that for_each_pair() says.
void expect_pairs(const BoxTree& tree) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> found, expected;
    EXPECT_FALSE(tree.for_each_pair([&](std::uint32_t one, std::uint32_t other) {
        found.emplace_back(one, other);
        return false;
    }));
    for (const BoxTree::Item& item : tree.items())
        for (const BoxTree::Item& other : tree.items())
            if (other.number > item.number && boxes_meet(item.box, other.box))
                expected.emplace_back(item.number, other.number);
    ASSERT_EQ(found, expected);
    std::size_t calls = 0;
    EXPECT_EQ(tree.for_each_pair([&](std::uint32_t, std::uint32_t) { return 2 * ++calls > expected.size(); }),
              !expected.empty());
    EXPECT_EQ(calls, expected.empty() ? 0 : expected.size() / 2 + 1);
}

void expect_same_as_looking(const std::vector<GridBox>& boxes, const std::vector<GridBox>& asked) {
    const BoxTree tree(boxes);
    ASSERT_EQ(tree.size(), boxes.size());
    expect_pairs(tree);
    for (const GridBox& box : asked) {
        std::vector<std::uint32_t> found = found_by(tree, box), expected;
        std::sort(found.begin(), found.end());
        for (std::uint32_t k = 0; k < boxes.size(); ++k)
            if (boxes_meet(box, boxes[k])) expected.push_back(k);
        ASSERT_EQ(found, expected);
    }
}

TEST(BoxTree, FindsWhatLookingAtAllFinds) {
    scenes::Rng rng(1);
    for (const std::uint32_t count : {0u, 1u, 2u, 4u, 5u, 17u, 180u, 3000u})
        for (const std::int32_t size : {0, 20, 3000}) {
            std::vector<GridBox> boxes, asked;
            for (std::uint32_t k = 0; k < count; ++k) boxes.push_back(random_box(rng, 1000, size));
            for (int k = 0; k < 40; ++k) asked.push_back(random_box(rng, 1000, 300));
            expect_same_as_looking(boxes, asked);
        }
}

TEST(BoxTree, BoxesInOnePlaceAndBoxesTouching) {
    const GridBox box{{1, 2, 3}, {4, 5, 6}};
    expect_same_as_looking(std::vector<GridBox>(1000, box), {box, {{4, 5, 6}, {9, 9, 9}}, {{5, 5, 6}, {9, 9, 9}}});
    std::vector<GridBox> row;
    for (int k = 0; k < 100; ++k) row.push_back({{k, 0, 0}, {k + 1, 1, 1}});
    expect_same_as_looking(row, {{{50, 1, 1}, {50, 2, 2}}, {{50, 2, 1}, {50, 2, 2}}, row[0], row[99]});
}

TEST(BoxTree, TheWholeWorldAndCentresThatHalveForever) {
    scenes::Rng rng(2);
    std::vector<GridBox> boxes{{{INT32_MIN, INT32_MIN, INT32_MIN}, {INT32_MAX, INT32_MAX, INT32_MAX}}};
    // Ever nearer to one corner: divisions through the middle take off one at a time.
    for (int axis = 0; axis < 3; ++axis)
        for (int k = 0; k < 32; ++k)
            for (int times = 0; times < 5; ++times) {
                GridPoint p{INT32_MIN, INT32_MIN, INT32_MIN};
                p[axis] = std::int32_t(std::int64_t(INT32_MIN) + (std::int64_t(1) << k));
                boxes.push_back({p, p});
            }
    std::vector<GridBox> asked = boxes;
    for (int k = 0; k < 50; ++k) asked.push_back(random_box(rng, INT32_MAX / 2, INT32_MAX / 2));
    expect_same_as_looking(boxes, asked);
}

TEST(BoxTree, StopsWhenTold) {
    scenes::Rng rng(3);
    std::vector<GridBox> boxes;
    for (int k = 0; k < 500; ++k) boxes.push_back(random_box(rng, 100, 50));
    const BoxTree tree(boxes);
    const std::vector<std::uint32_t> all = found_by(tree, tree.box());
    ASSERT_EQ(all.size(), 500u);
    std::vector<std::uint32_t> some;
    EXPECT_TRUE(tree.for_each_meeting(tree.box(), [&](std::uint32_t k) {
        some.push_back(k);
        return some.size() == 7;
    }));
    EXPECT_EQ(some, std::vector<std::uint32_t>(all.begin(), all.begin() + 7)) << "and in the same order each time";
}

TEST(BoxTree, AnswersOtherQuestions) {
    scenes::Rng rng(4);
    std::vector<GridBox> boxes;
    for (int k = 0; k < 500; ++k) boxes.push_back(random_box(rng, 1000, 50));
    // A line along z.
    const auto meets = [](const GridBox& box) {
        return box.low.x <= 10 && 10 <= box.high.x && box.low.y <= 20 && 20 <= box.high.y;
    };
    boxes.push_back({{10, 20, 900}, {10, 20, 900}});
    int found = 0;
    BoxTree(boxes).for_each_where(meets, [&](std::uint32_t k) {
        EXPECT_TRUE(meets(boxes[k]));
        ++found;
        return false;
    });
    EXPECT_EQ(found, std::count_if(boxes.begin(), boxes.end(), meets));
    EXPECT_GE(found, 1);
}

TEST(BoxTree, EmptyOne) {
    const BoxTree tree;
    EXPECT_EQ(tree.size(), 0u);
    EXPECT_GT(tree.box().low.x, tree.box().high.x);
    EXPECT_FALSE(tree.for_each_where([](const GridBox&) { return true; }, [](std::uint32_t) { return true; }));
}

}  // namespace
}  // namespace firma
