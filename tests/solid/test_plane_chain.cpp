// SPDX-License-Identifier: MIT
// Edges in one plane cancel, or do not, whichever planes name their lines and points, however lines are divided.
#include "solid/plane_chain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <deque>
#include <numeric>
#include <optional>
#include <vector>

#include "scenes/rng.h"
#include "tests/sample.h"

namespace firma {
namespace {

/// n . p + d = 0, primitive; not valid() where that has no place in the world.
Plane plane_of(std::int64_t x, std::int64_t y, std::int64_t z, std::int64_t d) {
    const std::int64_t divisor = std::gcd(std::gcd(x, y), std::gcd(z, d));
    if (divisor == 0) return {};
    const std::int64_t normal[3] = {x / divisor, y / divisor, z / divisor};
    return plane_of_numbers(normal, d / divisor);
}

/// i a + k b + d, of small ones.
Plane sum(const Plane& a, std::int64_t i, const Plane& b, std::int64_t k, std::int64_t d = 0) {
    return plane_of(i * a.normal[0] + k * b.normal[0], i * a.normal[1] + k * b.normal[1],
                    i * a.normal[2] + k * b.normal[2], std::int64_t(i * a.offset() + k * b.offset()) + d);
}

/// a + k b: another plane through their line.
Plane combined(const Plane& a, const Plane& b, std::int64_t k) {
    return sum(a, 1, b, k);
}

/// A plane, lines in it as other planes, and what they bound, each time named anew.
class Lines {
public:
    explicit Lines(std::uint64_t seed) : rng_(seed), plane_(random_plane()) {}

    Plane random_plane() {
        for (;;) {
            const auto number = [&] { return std::int64_t(rng_.below(1 << 20)) - (1 << 19); };
            const Plane plane = plane_of(number(), number(), number(), number() * 1000);
            if (plane.valid()) return plane;
        }
    }
    const Plane& plane() const { return plane_; }

    /// The line of a plane, by another one.
    const Plane& renamed(const Plane& line) {
        for (;;) {
            const Plane other = combined(line, plane_, std::int64_t(rng_.below(9)) - 4);
            if (other.valid()) return planes_.emplace_back(rng_.chance(0.5) ? other : flipped(other));
        }
    }
    /// Where two lines meet, by other planes; nothing outside the world.
    const ExactPoint* meet_of(const Plane& a, const Plane& b) {
        const Plane &p = renamed(a), &q = renamed(b);
        const Plane other = combined(plane_, p, 1);
        const Plane& r = rng_.chance(0.5) || !other.valid() ? plane_ : planes_.emplace_back(other);
        if (exact_turn(p, q, r) == 0 || !meet_in_world(p, q, r)) return nullptr;
        return &points_.emplace_back(p, q, r);
    }
    /// Around a convex polygon, given the lines of its sides in order.
    /// @return false when part of it is outside the world
    bool add_loop(const std::vector<Plane>& sides, bool back, PlaneChain& chain) {
        for (std::size_t k = 0; k < sides.size(); ++k) {
            const Plane& side = sides[k];
            const ExactPoint* from = meet_of(sides[k > 0 ? k - 1 : sides.size() - 1], side);
            const ExactPoint* to = meet_of(side, sides[(k + 1) % sides.size()]);
            if (!from || !to) return false;
            const Plane& across = renamed(side);
            const bool plane_first = rng_.chance(0.5);
            if (back) std::swap(from, to);
            chain.add(*from, *to, plane_first ? plane_ : across, plane_first ? across : plane_);
        }
        return true;
    }
    bool chance() { return rng_.chance(0.5); }
    std::uint32_t below(std::uint32_t count) { return rng_.below(count); }

private:
    scenes::Rng rng_;
    Plane plane_;
    std::deque<Plane> planes_;
    std::deque<ExactPoint> points_;
};

/// A triangle, cut from one corner to a point of the opposite side by a fourth line: two triangles.
struct Halves {
    std::vector<Plane> whole, one, two;
};

std::optional<Halves> halves(Lines& lines) {
    const Plane a = lines.random_plane(), b = lines.random_plane(), c = lines.random_plane();
    if (exact_turn(lines.plane(), a, b) == 0) return {};
    // A line through the corner of a and b: any sum of their planes.
    const Plane d = combined(a, b, lines.chance() ? 1 : -1);
    if (!d.valid()) return {};
    return Halves{{a, b, c}, {a, d, c}, {d, b, c}};
}

TEST(PlaneChain, LinesAndPointsByAnyPlanes) {
    int tried = 0;
    for (std::uint64_t seed = 0; tried < test::sample(300); ++seed) {
        ASSERT_LT(seed, 20'000u);
        Lines lines(seed);
        const std::optional<Halves> it = halves(lines);
        if (!it) continue;
        // Counted with sign along each line, one + two = whole, wherever the fourth line meets the third.
        PlaneChain chain;
        chain.start(lines.plane());
        if (!lines.add_loop(it->whole, false, chain) || !lines.add_loop(it->one, true, chain)) continue;
        EXPECT_FALSE(chain.cancels());
        if (!lines.add_loop(it->two, true, chain)) continue;
        EXPECT_TRUE(chain.cancels()) << seed;
        if (!lines.add_loop(it->two, false, chain)) continue;
        EXPECT_FALSE(chain.cancels());
        ++tried;
    }
}

/// Far less than what a double or the surface grid tells apart.
TEST(PlaneChain, PointsAndLinesNextToEachOther) {
    int tried = 0, rounded_alike = 0;
    for (std::uint64_t seed = 0; tried < test::sample(100); ++seed) {
        ASSERT_LT(seed, 20'000u);
        Lines lines(seed);
        const std::optional<Halves> it = halves(lines);
        if (!it) continue;
        // Through another point of the third line: off by the last bit of a sum of 2^13 planes.
        const Plane &a = it->whole[0], &b = it->whole[1];
        const Plane d = sum(a, 1 << 28, b, (1 << 28) + 1), e = sum(a, (1 << 28) + 1, b, (1 << 28) + 2);
        if (!d.valid() || !e.valid()) continue;
        const auto loops = [&](const Plane& first, const Plane& second) -> std::optional<bool> {
            PlaneChain chain;
            chain.start(lines.plane());
            if (!lines.add_loop(it->whole, false, chain) || !lines.add_loop({a, first, it->whole[2]}, true, chain) ||
                !lines.add_loop({second, b, it->whole[2]}, true, chain))
                return {};
            return chain.cancels();
        };
        const std::optional<bool> same = loops(d, d), other = loops(d, e);
        if (!same || !other) continue;
        EXPECT_TRUE(*same) << seed;
        EXPECT_FALSE(*other) << seed;
        const ExactPoint *p = lines.meet_of(d, it->whole[2]), *q = lines.meet_of(e, it->whole[2]);
        if (!p || !q) continue;
        rounded_alike += p->rounded() == q->rounded();
        ++tried;
    }
    EXPECT_GT(rounded_alike, 0);
}

/// Along one line from `start` to `end`, and back along another.
/// @return false when part of it is outside the world
bool expect_there_and_back(Lines& lines, const Plane& start, const Plane& first, const Plane& second, const Plane& end,
                           bool cancels) {
    for (const bool back : {false, true}) {
        const ExactPoint *from = lines.meet_of(start, first), *to = lines.meet_of(first, end);
        const ExactPoint *to_again = lines.meet_of(second, end), *from_again = lines.meet_of(second, start);
        if (!from || !to || !to_again || !from_again) return false;
        PlaneChain chain;
        chain.start(lines.plane());
        chain.add(back ? *to : *from, back ? *from : *to, lines.renamed(first), lines.plane());
        chain.add(back ? *from_again : *to_again, back ? *to_again : *from_again, lines.plane(), lines.renamed(second));
        EXPECT_EQ(chain.cancels(), cancels);
    }
    return true;
}

/// Lines through one point and to another line, nearly in one direction: there and back, they bound a triangle.
TEST(PlaneChain, DirectionsNextToEachOther) {
    int tried = 0;
    for (std::uint64_t seed = 0; tried < test::sample(100); ++seed) {
        ASSERT_LT(seed, 20'000u);
        Lines lines(seed);
        const Plane a = lines.random_plane(), b = lines.random_plane(), c = lines.random_plane();
        if (exact_turn(lines.plane(), a, b) == 0) continue;
        const Plane d = sum(a, 1 << 28, b, (1 << 28) + 1), e = sum(a, (1 << 28) + 1, b, (1 << 28) + 2);
        if (!d.valid() || !e.valid()) continue;
        if (!expect_there_and_back(lines, a, d, d, c, true) || !expect_there_and_back(lines, a, d, e, c, false))
            continue;
        ++tried;
    }
}

/// Strips between parallel lines, nearer to each other than doubles can tell: together they are one strip.
TEST(PlaneChain, ParallelLinesNextToEachOther) {
    int tried = 0;
    for (std::uint64_t seed = 0; tried < test::sample(100); ++seed) {
        ASSERT_LT(seed, 20'000u) << tried;
        Lines lines(seed);
        const Plane left = lines.random_plane(), right = lines.random_plane(), far = lines.random_plane();
        std::vector<Plane> levels;
        for (int k = 0; k < 12; ++k) {
            levels.push_back(sum(far, 1 << 26, lines.plane(), 12345 + 2 * k, k));  // but for the last k, one line
        }
        if (!std::all_of(levels.begin(), levels.end(), [](const Plane& level) { return level.valid(); })) continue;
        PlaneChain chain;
        chain.start(lines.plane());
        if (!lines.add_loop({left, levels.front(), right, levels.back()}, true, chain)) continue;
        std::vector<std::size_t> order(levels.size() - 1);
        std::iota(order.begin(), order.end(), 0u);
        for (std::size_t k = order.size(); k > 1; --k) std::swap(order[k - 1], order[lines.below(std::uint32_t(k))]);
        bool within = true;
        for (const std::size_t k : order) {
            EXPECT_FALSE(chain.cancels());
            within = within && lines.add_loop({left, levels[k], right, levels[k + 1]}, false, chain);
        }
        if (!within) continue;
        EXPECT_TRUE(chain.cancels()) << seed;
        if (!expect_there_and_back(lines, left, levels[3], levels[3], right, true) ||
            !expect_there_and_back(lines, left, levels[3], levels[4], right, false))
            continue;
        ++tried;
    }
}

TEST(PlaneChain, OnTheGrid) {
    const Plane floor = plane_through({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    const auto loop = [&](PlaneChain& chain, std::vector<InputPoint> corners, bool back) {
        if (back) std::reverse(corners.begin(), corners.end());
        for (std::size_t k = 0; k < corners.size(); ++k) chain.add(corners[k], corners[(k + 1) % corners.size()]);
    };
    PlaneChain chain;
    chain.start(floor);
    EXPECT_TRUE(chain.cancels()) << "nothing";
    loop(chain, {{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}}, false);
    EXPECT_FALSE(chain.cancels());
    loop(chain, {{0, 0, 0}, {4, 0, 0}, {4, 0, 0}, {4, 9, 0}, {0, 9, 0}, {0, 5, 0}}, true);
    EXPECT_FALSE(chain.cancels());
    loop(chain, {{4, 0, 0}, {9, 0, 0}, {9, 3, 0}, {4, 3, 0}}, true);
    EXPECT_FALSE(chain.cancels());
    loop(chain, {{4, 3, 0}, {9, 3, 0}, {9, 9, 0}, {4, 9, 0}}, true);
    EXPECT_TRUE(chain.cancels());
    // Edges that run to and fro are nothing; twice the same is something.
    chain.add(InputPoint{1, 1, 0}, InputPoint{5, 3, 0});
    chain.add(InputPoint{5, 3, 0}, InputPoint{3, 2, 0});
    EXPECT_FALSE(chain.cancels());
    chain.add(InputPoint{3, 2, 0}, InputPoint{1, 1, 0});
    EXPECT_TRUE(chain.cancels());
    chain.start(floor);
    loop(chain, {{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}}, false);
    loop(chain, {{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}}, false);
    EXPECT_FALSE(chain.cancels());
    // The same shape one step away, along an edge and across it.
    for (const auto& [x, y] : {std::pair{1, 0}, {0, 1}, {1, 1}}) {
        chain.start(floor);
        loop(chain, {{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}}, false);
        loop(chain, {{x, y, 0}, {9 + x, y, 0}, {9 + x, 9 + y, 0}, {x, 9 + y, 0}}, true);
        EXPECT_FALSE(chain.cancels());
    }
}

/// Points of the grid and meets on one line, in planes of every dominant axis, seen from both sides.
TEST(PlaneChain, GridPointsAndMeetsOnOneLine) {
    scenes::Rng rng(7);
    for (int k = 0; k < test::sample(300); ++k) {
        const auto point = [&] {
            const auto number = [&] { return std::int32_t(rng.below(1 << 24)) - (1 << 23); };
            return InputPoint{number(), number(), number()};
        };
        const InputPoint a = point(), b = point(), c = point(), d = point();
        const Plane plane = plane_through(a, b, c), across = plane_through(a, b, d);
        if (!plane.valid() || !across.valid() || exact_parallel(plane, across)) continue;
        // A meet on a b: with a plane through a point between.
        const Plane cut =
            axis_plane(plane.front_view().u(), (a[plane.front_view().u()] + b[plane.front_view().u()]) / 2);
        if (exact_turn(plane, across, cut) == 0 || !meet_in_world(plane, across, cut)) continue;
        const ExactPoint middle(plane, across, cut), on_a(a), on_b(b);
        PlaneChain chain;
        chain.start(plane);
        chain.add(a, b);
        chain.add(on_b, middle, plane, across);
        EXPECT_FALSE(chain.cancels());
        chain.add(middle, on_a, across, plane);
        EXPECT_TRUE(chain.cancels()) << k;
        const Plane third = plane_through(a, c, d);
        const ExactPoint again_a(plane, across, third);
        chain.add(a, b);
        chain.add(on_b, again_a, plane, across);
        EXPECT_TRUE(chain.cancels()) << "a by its planes, " << k;
    }
}

}  // namespace
}  // namespace firma
