// SPDX-License-Identifier: MIT
// What a straight path goes through: chords of boxes in closed form, many points of levels by locate() and matter_at(),
// edges, vertices, faces that it runs along, panes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "firma/brush_world.h"
#include "firma/carve.h"
#include "firma/pierce.h"
#include "firma/queries.h"
#include "firma/rooms.h"
#include "scenes/rng.h"
#include "tests/body/simple_bodies.h"
#include "tests/carve/cutters.h"
#include "tests/openarena_maps.h"
#include "tests/random_vector.h"
#include "tests/sample.h"
#include "tests/solid/solid_levels.h"

namespace firma {
namespace {

using scenes::Rng;
using test::brush_world;

Piercing pierced(const World& world, const Vec3& start, const Vec3& path, const PierceOptions& options = {}) {
    Piercing found;
    pierce(world, {start, path}, found, options);
    return found;
}

/// Metres of a path in a box, by slabs.
double chord_of(const Box& box, const Vec3& start, const Vec3& path) {
    double from = 0, to = 1;
    for (int axis = 0; axis < 3; ++axis) {
        if (path[axis] == 0) {
            if (start[axis] < box.low[axis] || start[axis] > box.high[axis]) return 0;
            continue;
        }
        const double a = (box.low[axis] - start[axis]) / path[axis], b = (box.high[axis] - start[axis]) / path[axis];
        from = std::max(from, std::min(a, b));
        to = std::min(to, std::max(a, b));
    }
    return to > from ? (to - from) * length(path) : 0;
}

Vec3 point_in(const Box& box, Rng& rng) {
    Vec3 point;
    for (int axis = 0; axis < 3; ++axis) point[axis] = rng.uniform(box.low[axis], box.high[axis]);
    return point;
}

TEST(Pierce, ChordsOfBoxes) {
    const Box boxes[] = {{{0, 0, 0}, {4, 0.5, 3}}, {{0, 1, 0}, {4, 1.25, 3}}, {{-2, -3, 1}, {-1, 5, 2}}};
    std::string text;
    for (const Box& box : boxes) text += map_text::box(box.low, box.high, "stone");
    const World world = brush_world(text);
    Rng rng(1);
    int through = 0;
    Piercing found;
    for (int k = 0; k < test::sample(20000); ++k) {
        const Vec3 start = point_in({{-6, -6, -2}, {6, 7, 5}}, rng), path = test::random_vector(rng, 0, 14);
        pierce(world, {start, path}, found);
        double sum = 0;
        for (const Box& box : boxes) sum += chord_of(box, start, path);
        ASSERT_NEAR(found.thickness, sum, 4e-9);
        double of_spans = 0, of_matters = 0, last = -1;
        for (const PierceSpan& span : found.spans) {
            of_spans += span.thickness;
            EXPECT_GT(span.in.fraction, last);
            EXPECT_GT(span.out.fraction, span.in.fraction);
            last = span.out.fraction;
            EXPECT_NEAR(length(span.out.point - span.in.point), span.thickness, 1e-9);
            EXPECT_EQ(span.in.fraction == 0, span.starts_inside);
            EXPECT_EQ(span.out.fraction == 1, span.ends_inside);
            EXPECT_EQ(dot(span.in.normal, path) < 0, !span.starts_inside);
            EXPECT_EQ(dot(span.out.normal, path) > 0, !span.ends_inside);
            EXPECT_EQ(span.in.face.valid(), !span.starts_inside);
            EXPECT_EQ(span.out.face.valid(), !span.ends_inside);
        }
        for (const MatterLength& it : found.matters) of_matters += it.length;
        EXPECT_NEAR(of_spans, found.thickness, 1e-12);
        EXPECT_NEAR(of_matters, found.thickness, 1e-12);
        through += found.spans.size() > 1;
    }
    EXPECT_GT(through, test::sample(300));
}

TEST(Pierce, AWallAtAnAngle) {
    const World world = brush_world(map_text::box({0, 0, 0}, {8, 0.5, 4}, "stone"));
    const Piercing found = pierced(world, {4, -1, 2}, {3, 4, 0});
    ASSERT_EQ(found.spans.size(), 1u);
    const PierceSpan& wall = found.spans[0];
    EXPECT_EQ(wall.in.fraction, 0.25);
    EXPECT_EQ(wall.in.point, (Vec3{4.75, 0, 2}));
    EXPECT_EQ(wall.in.normal, (Vec3{0, -1, 0}));
    EXPECT_EQ(wall.out.fraction, 0.375);
    EXPECT_EQ(wall.out.point, (Vec3{5.125, 0.5, 2}));
    EXPECT_EQ(wall.out.normal, (Vec3{0, 1, 0}));
    EXPECT_EQ(wall.thickness, 0.625);
    EXPECT_EQ(wall.in.face, cast(world, Ray{{4, -1, 2}, {3, 4, 0}}).face);
    EXPECT_EQ(wall.out.face, cast(world, Ray{{7, 3, 2}, {-3, -4, 0}}).face);
}

TEST(Pierce, StartsAndEndsInTheSolid) {
    const World world = brush_world(map_text::box({0, 0, 0}, {8, 1, 4}, "stone"));
    Piercing found;
    EXPECT_EQ(pierce(world, {{4, 0.25, 2}, {0, 2, 0}}, found), Status::kInitialOverlap);
    ASSERT_EQ(found.spans.size(), 1u);
    EXPECT_TRUE(found.spans[0].starts_inside);
    EXPECT_FALSE(found.spans[0].ends_inside);
    EXPECT_EQ(found.thickness, 0.75);
    EXPECT_EQ(pierce(world, {{4, -1, 2}, {0, 1.5, 0}}, found), Status::kHit);
    ASSERT_EQ(found.spans.size(), 1u);
    EXPECT_TRUE(found.spans[0].ends_inside);
    EXPECT_EQ(found.thickness, 0.5);
    EXPECT_EQ(pierce(world, {{4, 0.25, 2}, {0, 0.5, 0}}, found), Status::kInitialOverlap);
    ASSERT_EQ(found.spans.size(), 1u);
    EXPECT_TRUE(found.spans[0].starts_inside && found.spans[0].ends_inside);
    EXPECT_EQ(found.spans[0].in.normal, Vec3{});
    EXPECT_EQ(found.thickness, 0.5);
    EXPECT_EQ(found.matters.size(), 1u);
    // On faces.
    EXPECT_EQ(pierce(world, {{4, 0, 2}, {0, 1, 0}}, found), Status::kHit);
    ASSERT_EQ(found.spans.size(), 1u);
    EXPECT_EQ(found.spans[0].in.fraction, 0);
    EXPECT_EQ(found.spans[0].out.fraction, 1);
    EXPECT_FALSE(found.spans[0].starts_inside || found.spans[0].ends_inside);
    EXPECT_EQ(pierce(world, {{4, 0, 2}, {0, -1, 0}}, found), Status::kMiss);
    EXPECT_EQ(pierce(world, {{4, -1, 2}, {0, 1, 0}}, found), Status::kMiss);
    EXPECT_EQ(pierce(world, {{4, 1, 2}, {0, 1, 0}}, found), Status::kMiss);
    // What is known of the start is taken as said.
    PierceOptions known;
    known.start = Where::kAir;
    EXPECT_EQ(pierce(world, {{4, 0.25, 2}, {0, 0.5, 0}}, found, known), Status::kMiss);
}

TEST(Pierce, AlongFacesAndEdgesIsInTheAir) {
    // A floor with a block on it, of two brushes.
    const World world =
        brush_world(map_text::box({-8, -8, -4}, {8, 8, 0}, "stone") + map_text::box({2, -1, 0}, {4, 1, 2}, "stone"));
    EXPECT_EQ(pierced(world, {-4, 3, 0}, {11, 0, 0}).spans.size(), 0u);   // along the floor, not to its end
    EXPECT_EQ(pierced(world, {-12, 3, 0}, {24, 0, 0}).spans.size(), 0u);  // all along it
    EXPECT_EQ(pierced(world, {-12, 8, 0}, {24, 0, 0}).spans.size(), 0u);  // along its edge
    EXPECT_EQ(pierced(world, {-4, 1, 0}, {11, 0, 0}).spans.size(), 0u);   // along the block's foot
    EXPECT_EQ(pierced(world, {0, -1, 1}, {6, 0, 0}).spans.size(), 0u);    // along a side of the block
    EXPECT_EQ(pierced(world, {0, -1, 2}, {6, 0, 0}).spans.size(), 0u);    // along its upper edge
    EXPECT_EQ(pierced(world, {1, -2, 2}, {2, 2, 0}).spans.size(), 0u);    // over an edge, in the plane above
    EXPECT_EQ(pierced(world, {1, -2, 1}, {2, 2, 0}).spans.size(), 1u);    // through an edge that stands
    EXPECT_EQ(pierced(world, {1, 0, 1}, {2, -2, 0}).spans.size(), 0u);    // past it, touching it
    EXPECT_EQ(pierced(world, {1, 0, 1}, {2, 0, 2}).spans.size(), 0u);     // past the upper edge, touching it
    for (const double start : {-4.0, -12.0}) {
        const Piercing block = pierced(world, {start, 0, 0}, {20, 0, 0});  // along the floor, and through the block
        ASSERT_EQ(block.spans.size(), 1u);
        EXPECT_NEAR(block.thickness, 2, 1e-12);
        EXPECT_EQ(block.spans[0].in.point, (Vec3{2, 0, 0}));
    }
    EXPECT_NEAR(pierced(world, {-4, 0, 0}, {7, 0, 0}).thickness, 1, 1e-12);  // ends in it
    EXPECT_NEAR(pierced(world, {3, 0, 0}, {5, 0, 0}).thickness, 1, 1e-12);   // starts in it, goes on along the floor
    EXPECT_NEAR(pierced(world, {-4, 0, -1}, {11, 0, 0}).thickness, 11, 1e-12);
}

TEST(Pierce, ThroughEdgesAndVertices) {
    // Three boxes that share edges and a vertex, and a diagonal through all of them.
    const World world =
        brush_world(map_text::box({0, 0, 0}, {2, 2, 2}, "stone") + map_text::box({2, 0, 0}, {4, 2, 2}, "stone") +
                    map_text::box({0, 2, 0}, {2, 4, 2}, "stone"));
    const Piercing diagonal = pierced(world, {-1, -1, -1}, {6, 6, 6});  // through the reflex edge
    ASSERT_EQ(diagonal.spans.size(), 1u);
    EXPECT_NEAR(diagonal.thickness, 2 * std::sqrt(3.0), 1e-12);
    const Piercing across = pierced(world, {5, -1, 1}, {-6, 6, 0});  // touches the reflex edge from inside
    ASSERT_EQ(across.spans.size(), 1u);
    EXPECT_NEAR(across.thickness, 4 * std::sqrt(2.0), 1e-12);
    const Piercing flat = pierced(world, {1, 5, 1}, {4, -4, 0});  // edges (2, 4) and (4, 2), air between
    EXPECT_EQ(flat.spans.size(), 0u);
    EXPECT_EQ(pierced(world, {5, 5, 3}, {-2, -2, -2}).spans.size(), 0u);
    EXPECT_EQ(pierced(world, {3, -1, 1}, {-2, 2, 2}).spans.size(), 0u) << "the vertex (2, 0, 2) alone";
}

/// Whether the stretches say that a point of the path is in solid; nothing near where one begins or ends.
std::optional<bool> told_inside(const Piercing& found, double fraction, double near) {
    bool inside = false;
    for (const PierceSpan& span : found.spans) {
        if (span.pane) continue;
        if (std::fabs(fraction - span.in.fraction) < near || std::fabs(fraction - span.out.fraction) < near)
            return std::nullopt;
        inside |= fraction > span.in.fraction && fraction < span.out.fraction;
    }
    return inside;
}

/// The matter that the stretches say; nothing near where it changes.
std::optional<std::uint32_t> told_matter(const Piercing& found, double fraction, double near) {
    for (const MatterLength& it : found.matters)
        if (fraction > it.from + near && fraction < it.to - near) return it.matter;
    return std::nullopt;
}

struct Judged {
    std::size_t paths = 0, points = 0, inside = 0, matters = 0, changes = 0, along = 0, odd = 0;
};

/// Of 64 points in a tenth of a millimetre around one.
int solid_around(const World& world, const Vec3& point, Rng& rng) {
    int solid = 0;
    for (int k = 0; k < 64; ++k) solid += locate(world, point + rng.direction() * 1e-4).where == Where::kSolid;
    return solid;
}

/// Whether a place is of one matter, as far as rounding to the grid may take it.
bool same_around(const World& world, const Vec3& point) {
    for (int k = 0; k < 8; ++k) {
        const Vec3 beside{k & 1 ? 1e-5 : -1e-5, k & 2 ? 1e-5 : -1e-5, k & 4 ? 1e-5 : -1e-5};
        if (matter_at(world, point + beside) != matter_at(world, point)) return false;
    }
    return true;
}

/// Points of a path, by locate() and matter_at().
void judge_path(const World& world, const Vec3& start, const Vec3& path, Rng& rng, Piercing& found, Judged& judged) {
    constexpr double kNear = 2e-5;  // metres: matter_at() rounds to the grid, cuts round corners to it
    pierce(world, {start, path}, found);
    ++judged.paths;
    for (const PierceSpan& span : found.spans) judged.changes += span.matter_count > 1;
    const double near = kNear / length(path);
    for (int k = 0; k < 8; ++k) {
        const double fraction = rng.uniform(0, 1);
        const Vec3 point = start + path * fraction;
        const std::optional<bool> inside = told_inside(found, fraction, near);
        const Where where = locate(world, point).where;
        if (!inside || where == Where::kUnknown) continue;
        if (where == Where::kSurface) {  // along a face, or an edge
            if (*inside) {
                EXPECT_GT(solid_around(world, point, rng), 20) << point.x << " " << point.y << " " << point.z;
            }
            ++judged.along;
            continue;
        }
        ++judged.points;
        judged.inside += *inside;
        if (*inside != (where == Where::kSolid)) {
            // Where it runs along a face a point of it, rounded, may be on either side; so may one in a fold.
            const double distance = closest(world, point).distance;
            judged.odd += distance > 1e-11;
            EXPECT_LT(distance, kNear) << "start " << start.x << " " << start.y << " " << start.z;
        }
        if (!*inside) continue;
        const auto matter = told_matter(found, fraction, near);
        if (matter && same_around(world, point)) {
            ++judged.matters;
            EXPECT_EQ(*matter, matter_at(world, point)) << point.x << " " << point.y << " " << point.z;
        }
    }
}

/// Random paths, and such that pass exactly through corners of faces, along edges and diagonals.
Judged judge_level(const World& world, int count, std::uint64_t seed) {
    Rng rng(seed);
    Judged judged;
    Piercing found;
    const Box box = world.bounds();
    for (int k = 0; k < count; ++k) {
        const Vec3 path = test::random_vector(rng, 1, 40);
        judge_path(world, point_in(box, rng), path, rng, found, judged);
    }
    const std::vector<Face> faces = world.faces();
    for (int k = 0; k < count; ++k) {
        const Face& face = faces[rng.next() % faces.size()];
        const Vec3 &a = face.corners[rng.next() % face.corners.size()],
                   &b = face.corners[rng.next() % face.corners.size()];
        // Dyadic ways, so that the corner lies on the path exactly.
        Vec3 way;
        for (int axis = 0; axis < 3; ++axis) way[axis] = double(int(rng.next() % 33) - 16) / 8;
        if (k % 2) way = b - a;
        if (length(way) < 0.01) continue;
        judge_path(world, a - way * 2, way * 4, rng, found, judged);
    }
    return judged;
}

TEST(Pierce, AsLocateSaysInTheDepot) {
    World world = test::depot_world();
    for (int cuts = 0; cuts < 3; ++cuts) {
        const Judged judged = judge_level(world, test::sample(4000), std::uint64_t(cuts) + 1);
        EXPECT_GT(judged.points, judged.paths * 6);
        EXPECT_GT(judged.inside, judged.points / 20);
        EXPECT_GT(judged.matters, judged.inside / 2);
        EXPECT_GT(judged.changes, judged.paths / 50);
        EXPECT_EQ(judged.odd, 0u);
        EXPECT_GT(judged.along, judged.paths / 20);
        Rng rng(std::uint64_t(cuts) + 5);
        for (int k = 0; k < 10; ++k) {
            const CarveResult cut = carve(world, make_crater(CutterShape::kRocky, rng.next()),
                                          {.position = point_in(world.bounds(), rng), .scale = 3});
            if (cut.done()) world = cut.world;
        }
    }
}

TEST(Pierce, AsLocateSaysInAMap) {
    const std::vector<std::filesystem::path> maps = openarena_maps();
    if (maps.empty()) GTEST_SKIP() << kNoOpenArena;
    for (const char* name : {"kaos2", "oa_koth1"}) {
        const auto map = std::find_if(maps.begin(), maps.end(), [&](const auto& path) { return path.stem() == name; });
        ASSERT_NE(map, maps.end());
        const World world = make_world(read_brush_level(map->string()).value()).value();
        const Judged judged = judge_level(world, test::sample(2000), 9);
        EXPECT_GT(judged.inside, judged.points / 20) << name;
        EXPECT_GT(judged.matters, judged.inside / 2) << name;
        EXPECT_EQ(judged.odd, 0u) << name;
    }
}

TEST(Pierce, MattersOneBehindTheOther) {
    const World world = brush_world(test::three_matters());
    const auto name = [&](const MatterLength& it) { return matter(world, it.matter).name; };
    const Piercing along = pierced(world, {-2, 2, 2}, {16, 0, 0});
    ASSERT_EQ(along.spans.size(), 1u);
    ASSERT_EQ(along.matters.size(), 3u);
    const char* names[] = {"brick", "wood", "steel"};
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(name(along.matters[k]), names[k]);
        EXPECT_EQ(along.matters[k].length, 4);
        EXPECT_EQ(along.matters[k].from, (2 + 4.0 * double(k)) / 16);
        EXPECT_EQ(along.matters[k].to, (6 + 4.0 * double(k)) / 16);
    }
    const Piercing slanted = pierced(world, {2, -1, 2}, {6, 8, 0});  // out through the back at y = 4
    ASSERT_EQ(slanted.matters.size(), 2u);
    EXPECT_EQ(name(slanted.matters[0]), "brick");
    EXPECT_NEAR(slanted.matters[0].length, (4 - 2.75) / 0.6, 1e-12);
    EXPECT_EQ(name(slanted.matters[1]), "wood");
    EXPECT_NEAR(slanted.thickness, 5, 1e-12);
    const Piercing between = pierced(world, {4, -1, 2}, {0, 6, 0});  // in the plane between: the first of the file
    ASSERT_EQ(between.matters.size(), 1u);
    EXPECT_EQ(name(between.matters[0]), "brick");
    PierceOptions options;
    options.matters = false;
    EXPECT_EQ(pierced(world, {-2, 2, 2}, {16, 0, 0}, options).matters.size(), 0u);
    EXPECT_EQ(pierced(world, {-2, 2, 2}, {16, 0, 0}, options).spans[0].matter_count, 0u);
}

TEST(Pierce, OfPiecesThatOverlapTheOneThatMayNotBeCarvedCounts) {
    const std::string walls = map_text::box({0, 0, 0}, {4, 1, 4}, "old_brick") +  //
                              map_text::box({2, 0, 0}, {6, 1, 4}, "steel");
    const auto lengths = [&](double hardness) {
        WorldOptions options;
        options.matters = default_matters();
        options.matters->matters[*matter_named(*options.matters, "steel")].hardness = hardness;
        const World world = brush_world(walls, options);
        const Piercing found = pierced(world, {-1, 0.5, 2}, {8, 0, 0});
        std::vector<std::pair<std::string, double>> all;
        for (const MatterLength& it : found.matters) all.emplace_back(matter(world, it.matter).name, it.length);
        return all;
    };
    using Lengths = std::vector<std::pair<std::string, double>>;
    EXPECT_EQ(lengths(0), (Lengths{{"brick", 4}, {"steel", 2}}));
    EXPECT_EQ(lengths(1), (Lengths{{"brick", 2}, {"steel", 4}}));
}

TEST(Pierce, WhatIsFilledInIsOfTheRest) {
    const World world = brush_world(map_text::box({0, 0, 0}, {1, 4, 4}, "steel"));
    const World filled = fill(world, make_crater(CutterShape::kBox, 0), test::pose_at(2, 2, 2, 1)).world;
    const Piercing found = pierced(filled, {-1, 2, 2}, {8, 0, 0});
    ASSERT_EQ(found.spans.size(), 1u);
    ASSERT_EQ(found.matters.size(), 2u);
    EXPECT_EQ(matter(filled, found.matters[0].matter).name, "steel");
    EXPECT_NEAR(found.matters[0].length, 1, 1e-12);
    EXPECT_EQ(found.matters[1].matter, count_matters(filled).rest);
    EXPECT_NEAR(found.matters[1].length, 2, 1e-12);
}

TEST(Pierce, MattersOfMeshes) {
    Level level = test::empty_level();
    level.materials = {"", "old_brick", "steel"};
    test::add_box(level, {0, 0, 0}, {2, 2, 2});
    test::add_box(level, {3, 0, 0}, {4, 2, 2});
    for (std::size_t k = 0; k < level.faces.size(); ++k) level.faces[k].material = k < 6 ? 1 : 2;
    const World world = make_world(level).value();
    const Piercing found = pierced(world, {-1, 1, 1}, {6, 0, 0});
    ASSERT_EQ(found.spans.size(), 2u);
    ASSERT_EQ(found.matters.size(), 2u);
    EXPECT_EQ(matter(world, found.matters[0].matter).name, "brick");
    EXPECT_NEAR(found.matters[0].length, 2, 1e-12);
    EXPECT_EQ(matter(world, found.matters[1].matter).name, "steel");
    EXPECT_NEAR(found.matters[1].length, 1, 1e-12);
    EXPECT_EQ(found.spans[1].first_matter, 1u);
}

TEST(Pierce, PanesHaveNoThickness) {
    Level level = test::empty_level();
    test::add_box(level, {0, 0, 0}, {1, 4, 4});
    test::add_polygon(level, {{3, 0, 0}, {3, 0, 4}, {3, 4, 4}, {3, 4, 0}});  // looks toward smaller x
    test::add_polygon(level, {{5, 0, 0}, {5, 4, 0}, {5, 4, 4}, {5, 0, 4}});  // toward greater x
    level.faces[6].mask = 2;
    const World world = make_world(level).value();
    const Vec3 start{-1, 2, 1}, path{8, 0, 0};
    const Piercing found = pierced(world, start, path);
    ASSERT_EQ(found.spans.size(), 2u);
    EXPECT_FALSE(found.spans[0].pane);
    EXPECT_TRUE(found.spans[1].pane);
    EXPECT_EQ(found.spans[1].in.fraction, 0.5);
    EXPECT_EQ(found.spans[1].out.fraction, 0.5);
    EXPECT_EQ(found.spans[1].thickness, 0);
    EXPECT_EQ(found.spans[1].in.normal, (Vec3{-1, 0, 0}));
    EXPECT_EQ(found.thickness, 1);
    PierceOptions options;
    options.sides = Sides::kBoth;
    EXPECT_EQ(pierced(world, start, path, options).spans.size(), 3u);
    EXPECT_EQ(pierced(world, start, path, options).spans[2].in.normal, (Vec3{-1, 0, 0}));
    options.mask = 1;
    EXPECT_EQ(pierced(world, start, path, options).spans.size(), 2u);
    options.panes = false;
    EXPECT_EQ(pierced(world, start, path, options).spans.size(), 1u);
}

TEST(Pierce, StretchesThatTheMaskLeavesOut) {
    Level level = test::empty_level();
    test::add_box(level, {0, 0, 0}, {1, 4, 4});
    test::add_box(level, {2, 0, 0}, {3, 4, 4});
    for (std::size_t k = 0; k < 6; ++k) level.faces[k].mask = 1;
    for (std::size_t k = 6; k < 12; ++k) level.faces[k].mask = 2;
    const World world = make_world(level).value();
    PierceOptions options;
    options.mask = 2;
    const Piercing found = pierced(world, {-1, 2, 1}, {8, 0, 0}, options);
    ASSERT_EQ(found.spans.size(), 1u);
    EXPECT_EQ(found.spans[0].in.point.x, 2);
    EXPECT_EQ(found.thickness, 1);
    EXPECT_EQ(pierced(world, {0.5, 2, 1}, {1, 0, 0}, options).spans.size(), 0u);
    EXPECT_EQ(pierced(world, {2.5, 2, 1}, {1, 0, 0}, options).spans.size(), 1u);
}

TEST(Pierce, ClosedPortalsArePanes) {
    LevelPortal hatch;
    hatch.polygons.emplace_back();
    for (const Vec3& corner : {Vec3{-2, -2, 0}, Vec3{2, -2, 0}, Vec3{2, 2, 0}, Vec3{-2, 2, 0}})
        hatch.polygons[0].push_back(*snap(corner));
    const World open = make_divided_world(test::box_level({-2, -2, -4}, {2, 2, 4}, true), {&hatch, 1}).value();
    const World shut = *set_portal_open(open, {0}, false);
    // From the rock into it: rock outside, so both ends are in the solid.
    const Piercing through = pierced(open, {0, 0.5, 6}, {0, 0, -12});
    ASSERT_EQ(through.spans.size(), 2u);
    EXPECT_TRUE(through.spans[0].starts_inside);
    EXPECT_TRUE(through.spans[1].ends_inside);
    EXPECT_NEAR(through.thickness, 4, 1e-12);
    const Piercing stopped = pierced(shut, {0, 0.5, 6}, {0, 0, -12});
    ASSERT_EQ(stopped.spans.size(), 3u);
    EXPECT_TRUE(stopped.spans[1].pane);
    EXPECT_EQ(stopped.spans[1].portal, PortalId{0});
    EXPECT_FALSE(stopped.spans[1].in.face.valid());
    EXPECT_EQ(stopped.spans[1].in.normal, (Vec3{0, 0, 1}));
    EXPECT_EQ(stopped.spans[1].in.fraction, 0.5);
}

TEST(Pierce, NothingAndBadNumbers) {
    const World world = test::depot_world();
    Piercing found = pierced(world, {0, 0, 0}, {100, 1, 1});
    const Piercing copy = found;
    EXPECT_EQ(copy.spans.size(), found.spans.size());
    EXPECT_EQ(pierce(world, {{0, 0, 0}, {0, 0, 0}}, found), Status::kMiss);
    EXPECT_TRUE(found.spans.empty() && found.matters.empty());
    EXPECT_EQ(found.thickness, 0);
    EXPECT_EQ(pierce(World(), {{0, 0, 0}, {1, 0, 0}}, found), Status::kMiss);
    EXPECT_EQ(pierce(world, {{NAN, 0, 0}, {1, 0, 0}}, found), Status::kInvalid);
    EXPECT_EQ(pierce(world, {{0, 0, 0}, {1, INFINITY, 0}}, found), Status::kInvalid);
    EXPECT_EQ(pierce(world, {{0, 0, 0}, {1, 1e70, 0}}, found), Status::kInvalid);
    EXPECT_TRUE(found.spans.empty());
    EXPECT_EQ(pierced(world, {1e6, 1e6, 1e6}, {1, 1, 1}).spans.size(), 0u);
}

}  // namespace
}  // namespace firma
