// SPDX-License-Identifier: MIT
// Dividing outlines: whole when sound; else triangles of exactly its area whose sides come to exactly its own.
#include "level/divide_polygon.h"

#include <gtest/gtest.h>

#include <chrono>
#include <limits>
#include <map>

#include "firma/polygon.h"
#include "tests/level/outlines.h"

namespace firma {
namespace {

using outlines::Flat;
using outlines::FlatOutline;
using outlines::Wide;
using What = Division::What;
using Outline = std::vector<GridPoint>;
using WideVector = std::array<Wide, 3>;

WideVector area_vector(const Outline& outline) {
    WideVector sum{};
    for (std::size_t k = 1; k + 1 < outline.size(); ++k) {
        std::array<std::int64_t, 3> a, b;
        for (int axis = 0; axis < 3; ++axis) {
            a[axis] = std::int64_t(outline[k][axis]) - outline[0][axis];
            b[axis] = std::int64_t(outline[k + 1][axis]) - outline[0][axis];
        }
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
            sum[axis] += Wide(a[u]) * b[v] - Wide(a[v]) * b[u];
        }
    }
    return sum;
}

/// Whether two normals point the same way along the axis that the second is longest along.
bool same_direction(const WideVector& a, const WideVector& b) {
    const auto size = [&](std::size_t axis) { return b[axis] < 0 ? -b[axis] : b[axis]; };
    const std::size_t axis = size(0) >= size(1) && size(0) >= size(2) ? 0 : size(1) >= size(2) ? 1 : 2;
    return (a[axis] > 0) == (b[axis] > 0) && (a[axis] < 0) == (b[axis] < 0);
}

/// How often each edge is used one way more than the other.
using SideCounts = std::map<std::pair<GridPoint, GridPoint>, int>;

void add_sides(SideCounts& sides, const Outline& outline, int sign) {
    for (std::size_t k = 0; k < outline.size(); ++k) {
        const GridPoint &a = outline[k], &b = outline[(k + 1) % outline.size()];
        if (a < b) sides[{a, b}] += sign;
        if (b < a) sides[{b, a}] -= sign;
    }
}

Outline corners_of(const Outline& outline, const std::array<std::uint32_t, 3>& triangle) {
    return {outline[triangle[0]], outline[triangle[1]], outline[triangle[2]]};
}

/// What holds for every division: each piece has area, and together they have the outline's.
void expect_area_kept(const Outline& outline, const Division& division) {
    WideVector sum{};
    for (const auto& triangle : division.triangles) {
        const WideVector piece = area_vector(corners_of(outline, triangle));
        EXPECT_NE(piece, WideVector{});
        for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += piece[axis];
    }
    EXPECT_LE(division.triangles.size() + 2, std::max<std::size_t>(outline.size(), 2));
    if (division.what == What::kSplit || division.what == What::kCrossing) {
        EXPECT_FALSE(division.triangles.empty());
        EXPECT_EQ(sum, area_vector(outline));
    } else {
        EXPECT_TRUE(division.triangles.empty());
    }
}

void expect_sides_kept(const Outline& outline, const Division& division) {
    SideCounts sides;
    add_sides(sides, outline, 1);
    for (const auto& triangle : division.triangles) add_sides(sides, corners_of(outline, triangle), -1);
    EXPECT_TRUE(std::all_of(sides.begin(), sides.end(), [](const auto& side) { return side.second == 0; }));
}

/// The whole of what a good division of a planar outline that does not cross itself is.
void expect_sound(const Outline& outline, const Division& division) {
    EXPECT_EQ(division.what, What::kSplit);
    expect_area_kept(outline, division);
    expect_sides_kept(outline, division);
    const WideVector whole = area_vector(outline);
    for (const auto& triangle : division.triangles)
        EXPECT_TRUE(same_direction(area_vector(corners_of(outline, triangle)), whole));
}

bool firma_takes(const Outline& outline) {
    std::vector<Vec3> corners;
    for (const GridPoint& point : outline) corners.push_back(to_metres(point));
    return check_polygon(corners) == PolygonFault::kNone;
}

TEST(DividePolygon, KeepsConvexPlanarOnesWhole) {
    const Outline square{{0, 0, 0}, {64, 0, 0}, {64, 64, 0}, {0, 64, 0}};
    EXPECT_EQ(divide_polygon(square).what, What::kWhole);
    const Outline with_straight_corners{{0, 0, 0}, {32, 0, 0}, {64, 0, 0}, {64, 64, 0}, {0, 64, 0}, {0, 1, 0}};
    EXPECT_EQ(divide_polygon(with_straight_corners).what, What::kWhole);
    constexpr std::int32_t kLow = std::numeric_limits<std::int32_t>::min(),
                           kHigh = std::numeric_limits<std::int32_t>::max();
    const Outline world{{kLow, kLow, kLow}, {kHigh, kLow, kLow}, {kHigh, kHigh, kHigh}, {kLow, kHigh, kHigh}};
    EXPECT_EQ(divide_polygon(world).what, What::kWhole);
}

TEST(DividePolygon, FindsThatThereIsNoArea) {
    EXPECT_EQ(divide_polygon({}).what, What::kNoArea);
    for (const Outline& outline :
         {Outline{{1, 2, 3}}, Outline{{0, 0, 0}, {1, 1, 1}}, Outline{{0, 0, 0}, {1, 2, 3}, {2, 4, 6}},
          Outline{{5, 5, 5}, {5, 5, 5}, {5, 5, 5}, {5, 5, 5}}, Outline{{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {7, 0, 0}},
          Outline{{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {9, 0, 0}},                         // out and back
          Outline{{0, 0, 0}, {9, 0, 0}, {9, 9, 1}, {3, 3, 3}, {9, 9, 1}, {9, 0, 0}}})  // the same, not in a plane
        EXPECT_EQ(divide_polygon(outline).what, What::kNoArea);
}

TEST(DividePolygon, DividesWhatIsOffItsPlaneByTheLeast) {
    const Outline bent{{0, 0, 0}, {1 << 30, 0, 0}, {1 << 30, 1 << 30, 1}, {0, 1 << 30, 0}};
    expect_sound(bent, divide_polygon(bent));
    EXPECT_EQ(divide_polygon(bent).triangles.size(), 2u);
}

TEST(DividePolygon, TellsCrossingOutlines) {
    const Outline bow_tie{{0, 0, 0}, {4, 4, 0}, {4, 0, 0}, {0, 6, 0}};
    EXPECT_EQ(divide_polygon(bow_tie).what, What::kCrossing);
    expect_sides_kept(bow_tie, divide_polygon(bow_tie));
    const Outline even_bow_tie{{0, 0, 0}, {4, 4, 0}, {4, 0, 0}, {0, 4, 0}};  // no area in sum
    EXPECT_EQ(divide_polygon(even_bow_tie).what, What::kCrossing);
    expect_sides_kept(even_bow_tie, divide_polygon(even_bow_tie));
    const Outline pentagram{{0, 10, 0}, {-6, -8, 0}, {10, 3, 0}, {-10, 3, 0}, {6, -8, 0}};
    EXPECT_EQ(divide_polygon(pentagram).what, What::kCrossing);
    const Outline twice_round{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    EXPECT_EQ(divide_polygon(twice_round).what, What::kCrossing);
    expect_sides_kept(twice_round, divide_polygon(twice_round));
}

/// A strip that runs round and over its own beginning: every piece faces the front, yet two lie over each other.
TEST(DividePolygon, TellsPiecesThatOverlap) {
    const Outline strip{{0, 0, 0},  {10, 0, 0}, {10, 10, 0}, {0, 10, 0}, {0, -5, 0},
                        {2, -5, 0}, {2, 8, 0},  {8, 8, 0},   {8, 2, 0},  {0, 2, 0}};
    const Division division = divide_polygon(strip);
    EXPECT_EQ(division.what, What::kCrossing);
    expect_sides_kept(strip, division);
}

TEST(DividePolygon, RemovesSpikesAndRepeatedCorners) {
    const Outline with_spike{{0, 0, 0}, {8, 0, 0}, {12, -5, 0}, {8, 0, 0}, {8, 8, 0}, {8, 8, 0}, {0, 8, 0}};
    const Division division = divide_polygon(with_spike);
    expect_sound(with_spike, division);
    EXPECT_EQ(division.triangles.size(), 2u);
}

/// A frame: its hole is reached by a cut that the outline follows there and back.
TEST(DividePolygon, DividesAnOutlineWithAHole) {
    for (const Outline& frame :
         {Outline{{0, 0, 0},
                  {9, 0, 0},
                  {9, 9, 0},
                  {0, 9, 0},
                  {0, 0, 0},
                  {3, 3, 0},
                  {3, 6, 0},
                  {6, 6, 0},
                  {6, 3, 0},
                  {3, 3, 0}},
          // the hole touches the rim in a corner, without a cut
          Outline{{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}, {0, 0, 0}, {3, 6, 0}, {6, 3, 0}}}) {
        const Division division = divide_polygon(frame);
        expect_sound(frame, division);
    }
}

/// Frames with random holes in cells of a lattice, each reached by a cut from the one before it.
TEST(DividePolygon, DividesOutlinesWithManyHoles) {
    scenes::Rng rng(11);
    for (int round = 0; round < 200; ++round) {
        const int holes = 1 + int(rng.below(12));
        const std::int64_t cell = 20, size = cell * holes;
        FlatOutline outline{{0, 0}, {size, 0}, {size, cell}, {0, cell}};
        // The cut runs along the bottoms: from (0, 0) to the first hole, from hole to hole, and all the way back.
        FlatOutline out{{0, 0}}, back;
        for (int k = 0; k < holes; ++k) {
            const FlatOutline hole = outlines::star(rng, 4 + int(rng.below(8)), 8);
            const Flat middle{cell * k + 10, 10};
            const std::size_t low = std::size_t(std::min_element(hole.begin(), hole.end()) - hole.begin());
            const auto at = [&](std::size_t i) {  // clockwise, from its leftmost corner
                const Flat& p = hole[(low + hole.size() - i) % hole.size()];
                return Flat{middle.u + p.u, middle.v + p.v};
            };
            std::size_t right = 0;
            for (std::size_t i = 0; i < hole.size(); ++i)
                if (at(i) > at(right)) right = i;
            for (std::size_t i = 0; i <= right; ++i) out.push_back(at(i));
            FlatOutline rest;
            for (std::size_t i = right; i <= hole.size(); ++i) rest.push_back(at(i));
            back.insert(back.begin(), rest.begin(), rest.end());
        }
        outline.insert(outline.end(), out.begin(), out.end());
        outline.insert(outline.end(), back.begin(), back.end());
        const Outline lifted = outlines::lift(outline, 3, -2, int(rng.below(3)), rng.chance(0.5));
        SCOPED_TRACE(round);
        expect_sound(lifted, divide_polygon(lifted));
    }
}

TEST(DividePolygon, AgreesOnConvexOutlinesWithCheckPolygon) {
    scenes::Rng rng(2);
    for (int round = 0; round < 3000; ++round) {
        const std::int32_t size = round % 2 ? 12 : 1 << 20;
        FlatOutline flat = outlines::convex(rng, 3 + int(rng.below(40)), size, rng.chance(0.5));
        if (flat.size() < 3 || outlines::area(flat) == 0) continue;
        if (rng.chance(0.3))
            std::swap(flat[rng.below(std::uint32_t(flat.size()))], flat[rng.below(std::uint32_t(flat.size()))]);
        const Outline outline =
            outlines::lift(flat, int(rng.below(9)) - 4, int(rng.below(9)) - 4, int(rng.below(3)), rng.chance(0.5));
        const Division division = divide_polygon(outline);
        EXPECT_EQ(division.what == What::kWhole, firma_takes(outline));
        expect_area_kept(outline, division);
    }
}

TEST(DividePolygon, DividesLargeConvexOutlines) {
    for (const int side : {17, 100, 1000}) {  // a square with many corners along its sides
        Outline outline;
        for (int k = 0; k < side; ++k) outline.push_back({k, 0, 0});
        for (int k = 0; k < side; ++k) outline.push_back({side, k, 0});
        for (int k = 0; k < side; ++k) outline.push_back({side - k, side, 0});
        for (int k = 0; k < side; ++k) outline.push_back({0, side - k, 0});
        const Division division = divide_polygon(outline);
        expect_sound(outline, division);
        EXPECT_EQ(division.triangles.size(), outline.size() - 2);
    }
    const Outline hull = outlines::lift(outlines::round(25), 2, 3, 0, false);
    ASSERT_GT(hull.size(), 64u);
    const Division division = divide_polygon(hull);
    expect_sound(hull, division);
    std::vector<std::size_t> uses(hull.size());  // no corner gathers the pieces
    for (const auto& triangle : division.triangles)
        for (const std::uint32_t corner : triangle) ++uses[corner];
    EXPECT_LT(*std::max_element(uses.begin(), uses.end()), hull.size() / 4);
}

TEST(DividePolygon, DividesStars) {
    scenes::Rng rng(4);
    for (int round = 0; round < 2000; ++round) {
        const bool small = round % 2;  // small ones have many corners on lines through others
        const FlatOutline flat = outlines::star(rng, 4 + int(rng.below(small ? 20 : 60)), small ? 12 : 1 << 20);
        const Outline outline =
            outlines::lift(flat, int(rng.below(9)) - 4, int(rng.below(9)) - 4, int(rng.below(3)), rng.chance(0.5));
        const Division division = divide_polygon(outline);
        SCOPED_TRACE(round);
        if (division.what == What::kWhole)
            EXPECT_TRUE(firma_takes(outline));
        else
            expect_sound(outline, division);
    }
}

TEST(DividePolygon, IsRightAcrossTheWholeWorld) {
    scenes::Rng rng(5);
    constexpr std::int32_t kHigh = std::numeric_limits<std::int32_t>::max();
    for (int round = 0; round < 500; ++round) {
        const Outline outline = outlines::lift(outlines::star(rng, 5 + int(rng.below(30)), kHigh), 0, 0,
                                               int(rng.below(3)), rng.chance(0.5));
        const Division division = divide_polygon(outline);
        if (division.what != What::kWhole) expect_sound(outline, division);
    }
}

TEST(DividePolygon, DividesRegionsOfCells) {
    scenes::Rng rng(6);
    for (int round = 0; round < 1500; ++round) {
        const FlatOutline flat = outlines::cells(rng, 1 + int(rng.below(round % 3 ? 12 : 120)), 64);
        const Outline outline = outlines::lift(flat, 1, 2, int(rng.below(3)), rng.chance(0.5));
        const Division division = divide_polygon(outline);
        SCOPED_TRACE(round);
        if (division.what == What::kWhole)
            EXPECT_TRUE(firma_takes(outline));
        else
            expect_sound(outline, division);
    }
}

TEST(DividePolygon, KeepsAreaOfAnyOutlineAtAll) {
    scenes::Rng rng(7);
    int crossing = 0, none = 0;
    for (int round = 0; round < 20'000; ++round) {
        const bool flat = rng.chance(0.5);
        const std::uint32_t size = 2 + rng.below(5);
        Outline outline(3 + rng.below(12));
        for (GridPoint& p : outline)
            p = {std::int32_t(rng.below(size)), std::int32_t(rng.below(size)),
                 flat ? 0 : std::int32_t(rng.below(size))};
        const Division division = divide_polygon(outline);
        expect_area_kept(outline, division);
        crossing += division.what == What::kCrossing;
        none += division.what == What::kNoArea;
        EXPECT_TRUE(division.what != What::kWhole || firma_takes(outline));
    }
    EXPECT_GT(crossing, 1000);
    EXPECT_GT(none, 100);
}

TEST(DividePolygon, KeepsTheSidesOfBentOutlines) {
    scenes::Rng rng(8);
    for (int round = 0; round < 2000; ++round) {
        Outline outline = outlines::lift(outlines::star(rng, 4 + int(rng.below(20)), 1 << 16), 1, -1, int(rng.below(3)),
                                         rng.chance(0.5));
        for (GridPoint& p : outline)
            for (int axis = 0; axis < 3; ++axis) p[axis] += std::int32_t(rng.below(5)) - 2;
        const Division division = divide_polygon(outline);
        expect_area_kept(outline, division);
        if (division.what != What::kWhole) expect_sides_kept(outline, division);
    }
}

/// The largest outlines that readers let through, and such that each of its corners is in the way of many ears.
TEST(DividePolygon, IsQuickOnTheLargestOutlines) {
    constexpr std::int32_t kCount = std::int32_t(kMaxOutlineCorners);
    scenes::Rng rng(9);
    Outline comb, anything, spiral;
    for (std::int32_t k = 0; k < kCount / 2; ++k) comb.push_back({k * 2, k % 2 ? 1'000'000 : 1, 0});
    for (std::int32_t k = kCount / 2; k-- > 0;) comb.push_back({k * 2, k % 2 ? 1'000'003 + k : -k, 0});
    for (std::int32_t k = 0; k < kCount; ++k)
        anything.push_back({std::int32_t(rng.next()), std::int32_t(rng.next()), std::int32_t(rng.next())});
    for (std::int32_t k = 0, r = 1; k < kCount / 2; ++k, r += 2) {
        constexpr std::int32_t kTurn[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
        spiral.push_back({kTurn[k % 4][0] * r * 2, kTurn[k % 4][1] * r * 2, 0});
    }
    for (std::int32_t k = kCount / 2; k-- > 0;)
        spiral.push_back({spiral[std::size_t(k)].x * 2 / 2, spiral[std::size_t(k)].y, 7});
    for (const Outline& outline : {comb, anything, spiral}) {
        const auto begin = std::chrono::steady_clock::now();
        const Division division = divide_polygon(outline);
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        expect_area_kept(outline, division);
        RecordProperty("seconds", std::to_string(seconds));
        EXPECT_LT(seconds, 20);  // about 0.1 s here; sanitizers and busy machines take their time
    }
}

}  // namespace
}  // namespace firma
