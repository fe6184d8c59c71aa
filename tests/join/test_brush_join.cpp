// SPDX-License-Identifier: MIT
// A join that is kept: after repairs and changes it is what joining from scratch gives, and only what was touched was
// done again.
#include "join/brush_join.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "firma/brush_world.h"
#include "scenes/brush_piles.h"
#include "scenes/rng.h"
#include "tests/join/same_join.h"
#include "tests/openarena_maps.h"
#include "tests/sample.h"

namespace firma {
namespace {

std::size_t whole_joins(const JoinedLevel& joined) {
    return std::size_t(
        std::count_if(joined.rounds.begin(), joined.rounds.end(), [](const JoinRound& round) { return round.whole; }));
}

/// Joins a level, and once more from scratch with the planes that came out.
std::unique_ptr<JoinedLevel> expect_same_from_scratch(const BrushLevel& level) {
    std::unique_ptr<JoinedLevel> joined = join_brushes(level).value();
    const std::unique_ptr<JoinedLevel> scratch = join_brushes(mended_level(level, *joined)).value();
    EXPECT_EQ(scratch->rounds.size(), 1u);
    EXPECT_EQ(scratch->planes_moved, 0u);
    EXPECT_EQ(JoinComparison(*joined, *scratch).difference(), "");
    return joined;
}

TEST(BrushJoin, RepairedPilesAreAsFromScratch) {
    std::size_t repaired = 0, worlds = 0;
    for (int pile = 0; pile < scenes::kBrushPiles; ++pile)
        for (std::uint64_t seed = 1; seed <= std::uint64_t(test::sample(20)); ++seed) {
            SCOPED_TRACE(testing::Message() << "pile " << pile << ", seed " << seed);
            const BrushLevel level = scenes::brush_pile(scenes::BrushPile(pile), seed, seed % 3 == 0 ? 60 : 12);
            const std::unique_ptr<JoinedLevel> joined = expect_same_from_scratch(level);
            if (joined->rounds.size() == 1) continue;
            ++repaired;
            if (!joined->left_out.empty()) continue;
            ++worlds;
            EXPECT_EQ(hash_world(make_world(level).value()),
                      hash_world(make_world(mended_level(level, *joined)).value()));
        }
    EXPECT_GE(repaired, std::size_t(test::sample(8)));
    EXPECT_GE(worlds, std::size_t(test::sample(2)));
}

TEST(BrushJoin, TheDepotIsAsFromScratch) {
    const BrushLevel level = read_brush_level(FIRMA_ROOT "/levels/depot.map").value();
    EXPECT_EQ(expect_same_from_scratch(level)->rounds.size(), 1u);
}

/// Of those in which planes are moved: all brushes are joined once, and repairs get smaller.
TEST(BrushJoin, MapsAreJoinedOnce) {
    const std::vector<std::string> some = test::sampled<std::string>(
        {"czest1dm", "czest1tourney", "czest2ctf", "delta", "islandctf", "oa_ctf4ish", "oa_koth1", "wrackdm17"});
    std::size_t seen = 0;
    for (const std::filesystem::path& path : openarena_maps()) {
        if (std::find(some.begin(), some.end(), path.stem().string()) == some.end()) continue;
        SCOPED_TRACE(path);
        ++seen;
        const std::unique_ptr<JoinedLevel> joined = expect_same_from_scratch(read_brush_level(path.string()).value());
        EXPECT_GE(joined->rounds.size(), 2u);
        EXPECT_TRUE(joined->rounds.front().whole);
        EXPECT_EQ(whole_joins(*joined), 1u);
        const JoinRound &first = joined->rounds.front(), &last = joined->rounds.back();
        EXPECT_LT(last.faces * 10, first.faces);
        EXPECT_LT(last.pieces * 4, first.pieces);
        EXPECT_LT(last.lines * 4, first.lines);
        EXPECT_LT(last.polygons * 4, first.polygons);
    }
    if (seen == 0) GTEST_SKIP() << kNoOpenArena;
    EXPECT_EQ(seen, some.size());
}

TEST(BrushJoin, AMapMendedIsTheSameWorld) {
    for (const std::filesystem::path& path : openarena_maps()) {
        if (path.stem() != "wrackdm17") continue;
        const BrushLevel level = read_brush_level(path.string()).value();
        const BrushLevel mended = mended_level(level, *join_brushes(level).value());
        EXPECT_EQ(hash_world(make_world(level).value()), hash_world(make_world(mended).value()));
        return;
    }
    GTEST_SKIP() << kNoOpenArena;
}

/// Brushes of every kind go and come back.
void expect_same_after_changes(const BrushLevel& level, std::uint64_t seed, int changes) {
    scenes::Rng rng(seed);
    BrushJoin kept(level);
    std::vector<bool> used(level.brushes.size(), true);
    kept.update();
    for (int change = 0; change < changes; ++change) {
        SCOPED_TRACE(testing::Message() << "change " << change);
        for (std::uint64_t k = 0; k <= rng.below(3); ++k) {
            const auto brush = std::uint32_t(rng.below(level.brushes.size()));
            used[brush] = !used[brush];
            kept.use(brush, used[brush]);
        }
        kept.update();
        const JoinedLevel& joined = kept.divide();
        for (const LeftOut& left : joined.left_out) used[left.brush] = false;
        BrushLevel scratch = mended_level(level, joined);
        for (std::size_t b = 0; b < used.size(); ++b)
            if (!used[b]) scratch.brushes[b].kind = BrushKind::kData;
        EXPECT_EQ(JoinComparison(joined, *join_brushes(scratch).value()).difference(), "");
    }
}

TEST(BrushJoin, ChangedPilesAreAsFromScratch) {
    for (int pile = 0; pile < scenes::kBrushPiles; ++pile)
        for (std::uint64_t seed = 1; seed <= std::uint64_t(test::sample(5)); ++seed) {
            SCOPED_TRACE(testing::Message() << "pile " << pile << ", seed " << seed);
            expect_same_after_changes(scenes::brush_pile(scenes::BrushPile(pile), seed, 30), seed, 12);
        }
}

/// Boxes, prisms that stand on an edge, and portals through each other and in one plane, all of one material and on a
/// lattice of metres: much merges, and what keeps it from merging often only touches it.
class Lattice {
public:
    Lattice() {
        level.name = "lattice";
        level.entities.resize(1);
        level.materials = {""};
    }

    explicit Lattice(std::uint64_t seed) : Lattice() {
        scenes::Rng rng(seed);
        for (int k = 0; k < 40; ++k) {
            GridPoint low, high;
            for (int axis = 0; axis < 3; ++axis) {
                low[axis] = int(rng.below(4)) * kMetre;
                high[axis] = low[axis] + int(1 + rng.below(2)) * kMetre;
            }
            if (k < 20)
                add_box(low, high);
            else if (k < 28)
                add_prism(low, high);
            else
                add_portal(low, high, int(rng.below(3)));
        }
    }

    static constexpr std::int32_t kMetre = std::int32_t(kSurfaceSteps);

    BrushLevel level;

    void add_box(const GridPoint& low, const GridPoint& high) {
        add_brush(BrushKind::kSolid);
        add_sides(low, high);
    }

    /// Its lowest edge runs along x through `low`; it is a metre high and as wide.
    void add_prism(const GridPoint& low, const GridPoint& high) {
        add_brush(BrushKind::kSolid);
        const std::int32_t half = kMetre / 2;
        const GridPoint ends[2] = {low, {high.x, low.y, low.z}};
        const auto at = [](const GridPoint& p, std::int32_t dy, std::int32_t dz) {
            return GridPoint{p.x, p.y + dy, p.z + dz};
        };
        add_side(at(ends[0], 0, kMetre), at(ends[1], 0, kMetre), at(ends[0], half, kMetre));
        add_side(at(ends[0], -half, kMetre), ends[0], ends[1]);
        add_side(at(ends[0], half, kMetre), ends[1], ends[0]);
        add_side(ends[0], at(ends[0], -half, kMetre), at(ends[0], half, kMetre));
        add_side(ends[1], at(ends[1], half, kMetre), at(ends[1], -half, kMetre));
    }

    void add_portal(const GridPoint& low, GridPoint high, int axis) {
        GridPoint thin = low;
        high[axis] = low[axis];
        thin[axis] -= kMetre / 8;
        add_brush(BrushKind::kPortal);
        add_sides(thin, high, axis);
    }

private:
    void add_side(const GridPoint& a, const GridPoint& b, const GridPoint& c, bool portal = false) {
        BrushSide side;
        side.points[0] = a;
        side.points[1] = b;
        side.points[2] = c;
        side.mask = 1;
        side.portal = portal;
        level.sides.push_back(side);
        ++level.brushes.back().side_count;
    }

    void add_brush(BrushKind kind) {
        level.brushes.emplace_back();
        level.brushes.back().first_side = std::uint32_t(level.sides.size());
        level.brushes.back().kind = kind;
    }

    /// @param portal  the axis that the portal's side looks along; none: 3
    void add_sides(const GridPoint& low, const GridPoint& high, int portal = 3) {
        for (int axis = 0; axis < 3; ++axis) {
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            for (const bool up : {true, false}) {
                GridPoint a = up ? high : low, b = a, c = a;
                b[u] += kMetre;
                c[v] += kMetre;
                add_side(a, up ? b : c, up ? c : b, up && axis == portal);
            }
        }
    }
};

/// A prism that stands on the border of two boxes keeps their tops apart, though it takes nothing off them.
TEST(BrushJoin, WhatStandsOnABorderKeepsItThere) {
    constexpr std::int32_t m = Lattice::kMetre;
    Lattice lattice;
    lattice.add_box({0, 0, 0}, {m, m, m});
    lattice.add_box({0, m, 0}, {m, 2 * m, m});
    lattice.add_prism({0, m, m}, {m, m, m});
    BrushJoin kept(lattice.level);
    for (const bool there : {true, false, true, false}) {
        kept.use(2, there);
        kept.update();
        EXPECT_EQ(kept.divide().faces.size(), there ? 7u + 5u : 6u);
    }
}

/// Of two portals in one place the first counts.
TEST(BrushJoin, APortalTakesThePlaceOfOneBeforeIt) {
    constexpr std::int32_t m = Lattice::kMetre;
    Lattice lattice;
    lattice.add_portal({0, 0, 0}, {2 * m, 2 * m, 0}, 2);
    lattice.add_portal({0, 0, 0}, {2 * m, 3 * m, 0}, 2);
    lattice.add_portal({m, 0, -m}, {m, 3 * m, m}, 0);
    BrushJoin kept(lattice.level);
    const auto area = [&](std::uint32_t brush) {
        double sum = 0;
        const JoinedLevel& joined = kept.divide();
        for (std::size_t k = 0; k < joined.portal_pieces.size(); ++k) {
            const std::uint32_t source = joined.portal_pieces[k].source,
                                first = lattice.level.brushes[brush].first_side;
            if (source < first || source >= first + 6) continue;
            GridBox box;
            for (const auto& corner : joined.portal_pieces[k].piece.sides)
                box.add(joined.tables.points.point(corner.corner).rounded());
            sum += box.half_area();
        }
        return sum;
    };
    for (const bool there : {true, false, true}) {
        kept.use(0, there);
        kept.update();
        EXPECT_EQ(area(0), there ? 4.0 : 0.0);
        EXPECT_EQ(area(1), there ? 2.0 : 6.0);
        EXPECT_EQ(area(2), 6.0);
    }
}

TEST(BrushJoin, ChangedLatticesAreAsFromScratch) {
    for (std::uint64_t seed = 1; seed <= std::uint64_t(test::sample(40)); ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        const Lattice lattice(seed);
        const std::unique_ptr<JoinedLevel> joined = join_brushes(lattice.level).value();
        EXPECT_TRUE(joined->left_out.empty());
        expect_same_after_changes(lattice.level, seed, 24);
    }
}

TEST(BrushJoin, TheChangedDepotIsAsFromScratch) {
    const BrushLevel level = read_brush_level(FIRMA_ROOT "/levels/depot.map").value();
    expect_same_after_changes(level, 5, 6);
    // Portals alone: all of them away, then back one by one.
    BrushJoin kept(level);
    kept.update();
    const std::size_t rooms = kept.divide().rooms.count;
    std::vector<std::uint32_t> portals;
    for (std::uint32_t b = 0; b < level.brushes.size(); ++b)
        if (level.brushes[b].kind == BrushKind::kPortal) portals.push_back(b);
    for (const std::uint32_t b : portals) kept.use(b, false);
    kept.update();
    EXPECT_LT(kept.divide().rooms.count, rooms / 2);
    for (const std::uint32_t b : portals) {
        kept.use(b, true);
        kept.update();
        const JoinedLevel& joined = kept.divide();
        EXPECT_LT(joined.rounds.back().faces * 10, joined.rounds.front().faces);
    }
    EXPECT_EQ(kept.divide().rooms.count, rooms);
    EXPECT_EQ(JoinComparison(kept.divide(), *join_brushes(level).value()).difference(), "");
}

}  // namespace
}  // namespace firma
