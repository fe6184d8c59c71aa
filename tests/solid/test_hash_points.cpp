// SPDX-License-Identifier: MIT
// The hash of a set of points: blind to how a surface is divided, not to where it lies; kept by edits as taken anew.
#include "solid/hash_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>

#include "firma/carve.h"
#include "firma/level.h"
#include "geometry/exact_point.h"
#include "scenes/rng.h"
#include "scenes/room_grid.h"
#include "solid/solid_data.h"
#include "tests/sample.h"
#include "tests/solid/tiled_hall.h"

namespace firma {
namespace {

using Polygons = std::vector<std::vector<InputPoint>>;
using Sums = std::map<std::uint32_t, std::uint64_t>;

/// By region, without those that came to nothing.
Sums sums_of(const SumsByKey& sums) {
    Sums found;
    for (const auto& [key, sum] : sums.sums())
        if (sum != 0) found[key] = sum;
    return found;
}
Sums sums_of(const PersistentMap<std::uint64_t>& sums) {
    Sums found;
    sums.for_each([&](std::uint32_t key, std::uint64_t sum) {
        if (sum != 0) found[key] = sum;
    });
    return found;
}

Plane plane_of(const std::vector<InputPoint>& polygon) {
    for (std::size_t k = 2; k < polygon.size(); ++k) {
        const Plane plane = plane_through(polygon[0], polygon[k - 1], polygon[k]);
        if (plane.valid()) return plane;
    }
    ADD_FAILURE() << "corners on a line";
    return {};
}

void add(PointHash& hash, const std::vector<InputPoint>& polygon, int sign = 1) {
    hash.start_face(plane_of(polygon), sign);
    for (std::size_t k = 0; k < polygon.size(); ++k) {
        const GridPoint from = to_surface(polygon[k]), to = to_surface(polygon[(k + 1) % polygon.size()]);
        hash.add_edge(from, to, LineDirection::along(from, to));
    }
}

Sums hash_of(const Polygons& polygons, int sign = 1) {
    PointHash hash;
    for (const std::vector<InputPoint>& polygon : polygons) add(hash, polygon, sign);
    return sums_of(hash.finish());
}

// ---- the sum itself ----

InputPoint random_point(scenes::Rng& rng, std::int32_t reach) {
    InputPoint p;
    for (int axis = 0; axis < 3; ++axis) p[axis] = std::int32_t(rng.below(2 * std::uint32_t(reach))) - reach;
    return p;
}
InputPoint between(const InputPoint& a, const InputPoint& b, std::int32_t part, std::int32_t whole) {
    InputPoint p;
    for (int axis = 0; axis < 3; ++axis) p[axis] = a[axis] + (b[axis] - a[axis]) / whole * part;
    return p;
}

/// Corners of a parallelogram whose sides are divisible by `whole`.
struct Patch {
    InputPoint at, u, v;
    std::int32_t whole;

    Patch(scenes::Rng& rng, std::int32_t parts) : at(random_point(rng, 1 << 23)), whole(parts) {
        do {
            u = random_point(rng, 1 << 15);
            v = random_point(rng, 1 << 15);
        } while (!plane_through({}, u, v).valid());
    }
    InputPoint corner(std::int32_t i, std::int32_t j) const {
        InputPoint p = at;
        for (int axis = 0; axis < 3; ++axis) p[axis] += i * u[axis] + j * v[axis];
        return p;
    }
    std::vector<InputPoint> rectangle(std::int32_t i, std::int32_t j, std::int32_t to_i, std::int32_t to_j) const {
        return {corner(i, j), corner(to_i, j), corner(to_i, to_j), corner(i, to_j)};
    }
    std::vector<InputPoint> whole_one() const { return rectangle(0, 0, whole, whole); }
};

TEST(PointHash, SeamsBetweenFacesInOnePlaneDoNotCount) {
    scenes::Rng rng(1);
    for (int k = 0; k < 300; ++k) {
        const Patch patch(rng, 16);
        const Sums whole = hash_of({patch.whole_one()});
        EXPECT_FALSE(whole.empty());
        // Squares, as a grid and as pieces of all sizes whose corners lie on others' edges.
        Polygons squares, pieces;
        for (std::int32_t i = 0; i < 16; ++i)
            for (std::int32_t j = 0; j < 16; ++j) squares.push_back(patch.rectangle(i, j, i + 1, j + 1));
        const auto divide = [&](const auto& self, std::int32_t i, std::int32_t j, std::int32_t to_i,
                                std::int32_t to_j) -> void {
            if (rng.chance(0.2) || (to_i - i < 2 && to_j - j < 2))
                return pieces.push_back(patch.rectangle(i, j, to_i, to_j));
            if (to_j - j < 2 || (to_i - i >= 2 && rng.chance(0.5))) {
                const std::int32_t at = i + 1 + std::int32_t(rng.below(std::uint32_t(to_i - i - 1)));
                self(self, i, j, at, to_j);
                self(self, at, j, to_i, to_j);
            } else {
                const std::int32_t at = j + 1 + std::int32_t(rng.below(std::uint32_t(to_j - j - 1)));
                self(self, i, j, to_i, at);
                self(self, i, at, to_i, to_j);
            }
        };
        divide(divide, 0, 0, 16, 16);
        EXPECT_EQ(hash_of(squares), whole);
        EXPECT_EQ(hash_of(pieces), whole);
        // A fan of triangles around a point inside.
        Polygons fan;
        const auto rim = patch.whole_one();
        const InputPoint middle = patch.corner(1 + std::int32_t(rng.below(15)), 1 + std::int32_t(rng.below(15)));
        for (std::size_t e = 0; e < 4; ++e) fan.push_back({middle, rim[e], rim[(e + 1) % 4]});
        EXPECT_EQ(hash_of(fan), whole);
        // One piece missing, or turned over, shows.
        squares.pop_back();
        EXPECT_NE(hash_of(squares), whole);
        squares.push_back(patch.rectangle(15, 15, 16, 16));
        std::reverse(squares.back().begin(), squares.back().end());
        EXPECT_NE(hash_of(squares), whole);
    }
}

TEST(PointHash, CollinearSplitsOfEdgesDoNotCount) {
    scenes::Rng rng(2);
    for (int k = 0; k < 500; ++k) {
        const Patch patch(rng, 8);
        std::vector<InputPoint> split;
        const auto rim = patch.whole_one();
        for (std::size_t e = 0; e < 4; ++e) {
            split.push_back(rim[e]);
            for (std::int32_t part = 1; part < 8; ++part)
                if (rng.chance(0.3)) split.push_back(between(rim[e], rim[(e + 1) % 4], part, 8));
        }
        std::rotate(split.begin(), split.begin() + std::ptrdiff_t(rng.below(std::uint32_t(split.size()))), split.end());
        EXPECT_EQ(hash_of({split}), hash_of({patch.whole_one()}));
        // A corner off the line is one of the surface.
        const std::size_t at = rng.below(4);
        auto bent = patch.whole_one();
        bent.insert(bent.begin() + std::ptrdiff_t(at) + 1, between(rim[at], rim[(at + 1) % 4], 3, 8));
        for (int axis = 0; axis < 3; ++axis) bent[at + 1][axis] += patch.u[axis] + patch.v[axis];
        EXPECT_NE(hash_of({bent}), hash_of({patch.whole_one()}));
    }
}

TEST(PointHash, HolesRimsAndWhatFillsThem) {
    scenes::Rng rng(3);
    for (int k = 0; k < 200; ++k) {
        const Patch patch(rng, 8);
        const auto inner = patch.rectangle(2, 3, 5, 7);
        auto hole = inner;
        std::reverse(hole.begin(), hole.end());
        PointHash exact;
        exact.start_face(plane_of(patch.whole_one()), 1);
        for (const auto& loop : {patch.whole_one(), hole})
            for (std::size_t c = 0; c < loop.size(); ++c) {
                const GridPoint from = to_surface(loop[c]), to = to_surface(loop[(c + 1) % loop.size()]);
                exact.add_edge(from, to, LineDirection::along(from, to));
            }
        add(exact, inner);  // filled
        EXPECT_EQ(sums_of(exact.finish()), hash_of({patch.whole_one()}));
    }
}

TEST(PointHash, WhatComesAndGoesCancelsHoweverMuchInWhateverOrder) {
    scenes::Rng rng(4);
    Polygons polygons;
    for (int k = 0; k < 3000; ++k) {  // several times what is taken together
        const Patch patch(rng, 4);
        polygons.push_back(patch.whole_one());
    }
    const Sums all = hash_of(polygons);
    Polygons turned(polygons.rbegin(), polygons.rend());
    EXPECT_EQ(hash_of(turned), all);
    PointHash hash;
    for (const auto& polygon : polygons) add(hash, polygon);
    for (std::size_t k = 0; k + 1 < turned.size(); ++k) add(hash, turned[k], -1);
    EXPECT_EQ(sums_of(hash.finish()), hash_of({polygons[0]}));
    const Sums gone = hash_of(polygons, -1);
    ASSERT_EQ(gone.size(), all.size());
    for (const auto& [key, sum] : all) EXPECT_EQ(gone.at(key), std::uint64_t(0) - sum);
    std::uint64_t total = 0;
    for (const auto& [key, sum] : all) total += sum;
    PointHash again;
    for (const auto& polygon : polygons) add(again, polygon);
    EXPECT_EQ(again.finish().total(), total);
}

TEST(PointHash, EachCornerCountsInItsRegion) {
    const std::int32_t region = std::int32_t(32 * kInputSteps);
    const std::vector<InputPoint> large = {
        {0, 0, 0}, {3 * region, 0, 0}, {3 * region, 5 * region, 0}, {0, 5 * region, 0}};
    const Sums sums = hash_of({large});
    ASSERT_EQ(sums.size(), 4u) << "and not where only an edge passes";
    for (const InputPoint& corner : large) EXPECT_TRUE(sums.contains(region_of(to_surface(corner))));
    auto moved = large;
    moved[2].y -= 1;
    const Sums other = hash_of({{large[0], large[1], moved[2], large[3]}});
    EXPECT_NE(other, sums);
    EXPECT_EQ(place_of_region(region_of(to_surface(large[2]))), (Region{3, 5, 0}));
    EXPECT_EQ(place_of_region(region_of({-1, -1, -1})), (Region{-1, -1, -1}));
}

TEST(PointHash, EachMovedCornerShows) {
    scenes::Rng rng(5);
    std::set<Sums> seen;
    for (int k = 0; k < 200; ++k) {
        const Patch patch(rng, 4);
        EXPECT_TRUE(seen.insert(hash_of({patch.whole_one()})).second);
        for (std::size_t at = 0; at < 4; ++at)
            for (const InputPoint& by : {patch.u, patch.v}) {  // in its plane
                auto moved = patch.whole_one();
                for (int axis = 0; axis < 3; ++axis) moved[at][axis] += by[axis];
                EXPECT_TRUE(seen.insert(hash_of({moved})).second);
            }
        for (int axis = 0; axis < 3; ++axis) {  // out of it
            auto moved = patch.whole_one();
            for (InputPoint& corner : moved) ++corner[axis];
            EXPECT_TRUE(seen.insert(hash_of({moved})).second || plane_of(moved) == plane_of(patch.whole_one()));
        }
        auto behind = patch.whole_one();
        std::reverse(behind.begin(), behind.end());
        EXPECT_TRUE(seen.insert(hash_of({behind})).second);
    }
}

// ---- directions of lines ----

/// Whether two names of a direction are one in a plane: whether an edge of the one cancels an edge of the other.
bool are_one(const Plane& plane, const LineDirection& a, const LineDirection& b) {
    PointHash hash;
    hash.start_face(plane, 1);
    hash.add_edge({1, 2, 3}, {40, 50, 60}, a);
    hash.start_face(plane, -1);
    hash.add_edge({1, 2, 3}, {40, 50, 60}, b);
    return sums_of(hash.finish()).empty();
}

/// A whole direction as a fraction in lowest terms would be: divided by its greatest common divisor, without sign.
using Lowest = std::array<Int128, 3>;
Lowest lowest(Lowest d) {
    Int128 divisor = 0;
    for (Int128 a : d) {
        Int128 b = divisor;
        if (a < 0) a = -a;
        while (b != 0) {
            const Int128 rest = a % b;
            a = b;
            b = rest;
        }
        divisor = a;
    }
    EXPECT_TRUE(divisor != 0);
    bool turn = false;
    for (const Int128 a : d)
        if (a != 0) {
            turn = a < 0;
            break;
        }
    for (Int128& a : d) a = a / divisor * (turn ? -1 : 1);
    return d;
}
Lowest lowest_of(const Plane& a, const Plane& b) {
    return lowest({normal_minor(a, b, 1, 2), normal_minor(a, b, 2, 0), normal_minor(a, b, 0, 1)});
}
Lowest lowest_of(const InputPoint& from, const InputPoint& to) {
    return lowest({Int128(to.x) - from.x, Int128(to.y) - from.y, Int128(to.z) - from.z});
}

Plane random_plane(scenes::Rng& rng, std::int32_t reach) {
    for (;;) {
        const Plane plane = plane_through(random_point(rng, reach), random_point(rng, reach), random_point(rng, reach));
        if (plane.valid()) return plane;
    }
}

/// Against greatest common divisors: equal exactly where fractions in lowest terms are.
TEST(LineDirection, IsEqualExactlyForParallelLinesOfAPlane) {
    scenes::Rng rng(6);
    int equal = 0, compared = 0;
    for (const std::int32_t reach : {2, 4, 64, 1 << 12, 1 << 24})
        for (int k = 0; k < 800; ++k) {
            const Plane plane = random_plane(rng, reach);
            std::vector<std::pair<LineDirection, Lowest>> lines;
            while (lines.size() < 6) {
                const Plane other = random_plane(rng, reach);
                if (exact_parallel(plane, other)) continue;
                const Lowest exact = lowest_of(plane, other);
                lines.push_back({LineDirection::of(plane, other), exact});
                lines.push_back({LineDirection::of(other, plane), exact});
                lines.push_back({LineDirection::of(flipped(plane), other), exact});
                lines.push_back({LineDirection::of(plane, flipped(other)), exact});
            }
            for (const auto& [a, exact_a] : lines)
                for (const auto& [b, exact_b] : lines) {
                    ASSERT_EQ(are_one(plane, a, b), exact_a == exact_b);
                    equal += exact_a == exact_b;
                    ++compared;
                }
        }
    EXPECT_GT(equal, compared / 4);
    EXPECT_LT(equal, compared);
}

/// Many planes through one line of the grid, and points along it.
TEST(LineDirection, DoesNotDependOnWhichPlanesOrPointsNameTheLine) {
    scenes::Rng rng(7);
    for (const std::int32_t reach : {4, 1 << 10, 1 << 20, 1 << 24})
        for (int k = 0; k < test::sample(75); ++k) {
            InputPoint a = random_point(rng, reach / 2), step = random_point(rng, reach / 2 + 1), b = a;
            if (step == InputPoint{}) continue;
            for (int axis = 0; axis < 3; ++axis) b[axis] += step[axis];
            std::vector<Plane> planes;
            for (int tries = 0; tries < 40 && planes.size() < 5; ++tries) {
                const Plane plane = plane_through(a, b, random_point(rng, reach));
                if (plane.valid()) planes.push_back(plane);
            }
            ASSERT_GE(planes.size(), 2u);
            planes.push_back(edge_plane(a, b, planes[0]));
            const Lowest exact = lowest_of(a, b);
            for (const Plane& plane : planes) {
                std::vector<LineDirection> names = {LineDirection::along(to_surface(a), to_surface(b)),
                                                    LineDirection::along(to_surface(b), to_surface(a))};
                for (const Plane& other : planes) {
                    if (exact_parallel(plane, other)) continue;
                    EXPECT_EQ(lowest_of(plane, other), exact);
                    names.push_back(LineDirection::of(plane, other));
                    names.push_back(LineDirection::of(other, plane));
                    for (const Plane& third : planes)
                        if (!exact_parallel(other, third)) names.push_back(LineDirection::of(other, third));
                }
                // A parallel line elsewhere, and another length of it.
                const InputPoint c = random_point(rng, reach / 2);
                InputPoint d = c;
                for (int axis = 0; axis < 3; ++axis) d[axis] += step[axis] / 2 * 2;
                if (d != c && lowest_of(c, d) == exact)
                    names.push_back(LineDirection::along(to_surface(c), to_surface(d)));
                for (const LineDirection& one : names)
                    for (const LineDirection& two : names) ASSERT_TRUE(are_one(plane, one, two));
                // A line that is off by one step is another one, where the plane tells.
                for (int axis = 0; axis < 3; ++axis) {
                    InputPoint near = b;
                    ++near[axis];
                    if (near == a || exact_side(plane, ExactPoint(near)) != 0) continue;
                    const bool same = lowest_of(a, near) == exact;
                    EXPECT_EQ(are_one(plane, names[0], LineDirection::along(to_surface(a), to_surface(near))), same);
                }
            }
        }
}

// ---- solids ----

void add_polygon(Level& level, const std::vector<GridPoint>& corners) {
    LevelFace face;
    face.first_corner = std::uint32_t(level.corners.size());
    face.corner_count = std::uint32_t(corners.size());
    face.source = level.source_faces++;
    for (const GridPoint& corner : corners) {
        level.corners.push_back(std::uint32_t(level.vertices.size()));
        level.vertices.push_back(corner);
    }
    level.faces.push_back(face);
}

Level level_of(const std::vector<std::vector<GridPoint>>& polygons) {
    Level level;
    level.materials = {"", "stone"};
    level.groups = {""};
    for (const auto& polygon : polygons) add_polygon(level, polygon);
    return level;
}

/// A box whose sides are `count` x `count` squares each, or as many squares as two triangles, or with rims split only.
enum class Division { kSquares, kTriangles, kRims };
std::vector<std::vector<GridPoint>> box_of(const Vec3& low, const Vec3& high, int count, Division division,
                                           bool inward = false) {
    std::vector<std::vector<GridPoint>> polygons;
    for (int axis = 0; axis < 3; ++axis)
        for (const bool upper : {false, true}) {
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            const auto corner = [&](int i, int j) {
                Vec3 p;
                p[axis] = upper ? high[axis] : low[axis];
                p[u] = low[u] + (high[u] - low[u]) * i / count;
                p[v] = low[v] + (high[v] - low[v]) * j / count;
                return snap(p).value();
            };
            const std::size_t first = polygons.size();
            if (division == Division::kRims) {
                std::vector<GridPoint> rim;
                for (int k = 0; k < count; ++k) rim.push_back(corner(k, 0));
                for (int k = 0; k < count; ++k) rim.push_back(corner(count, k));
                for (int k = count; k > 0; --k) rim.push_back(corner(k, count));
                for (int k = count; k > 0; --k) rim.push_back(corner(0, k));
                polygons.push_back(rim);
            } else {
                for (int i = 0; i < count; ++i)
                    for (int j = 0; j < count; ++j) {
                        const GridPoint a = corner(i, j), b = corner(i + 1, j), c = corner(i + 1, j + 1),
                                        d = corner(i, j + 1);
                        if (division == Division::kSquares) {
                            polygons.push_back({a, b, c, d});
                        } else if ((i + j) % 2) {
                            polygons.push_back({a, b, c});
                            polygons.push_back({a, c, d});
                        } else {
                            polygons.push_back({a, b, d});
                            polygons.push_back({b, c, d});
                        }
                    }
            }
            if (upper == inward)
                for (std::size_t k = first; k < polygons.size(); ++k)
                    std::reverse(polygons[k].begin(), polygons[k].end());
        }
    return polygons;
}

Solid solid_from(const std::vector<std::vector<GridPoint>>& polygons) {
    const Level level = level_of(polygons);
    const Result<Solid> solid = make_solid(level);
    EXPECT_TRUE(solid.ok());
    EXPECT_EQ(solid.value().face_count(), polygons.size()) << "all of it is solid";
    EXPECT_FALSE(check_solid(solid.value()));
    return solid.value();
}

struct Cut {
    CutterShape shape = CutterShape::kRocky;
    std::uint64_t seed = 0;
    Pose pose;
    bool fills = false;
};

SolidResult cut(const Solid& solid, const Cut& it) {
    const Cutter cutter = make_crater(it.shape, it.seed);
    return it.fills ? unite(solid, cutter, it.pose) : subtract(solid, cutter, it.pose);
}

Solid after(Solid solid, std::initializer_list<Cut> cuts) {
    for (const Cut& it : cuts) {
        const SolidResult result = cut(solid, it);
        EXPECT_EQ(result.status, CarveStatus::kDone) << result.error.reason;
        solid = result.solid;
    }
    return solid;
}

TEST(HashSolid, HowASurfaceIsDividedDoesNotCount) {
    const Vec3 low{-40, -24, -8}, high{40, 32, 16};  // several regions
    const Solid plain = solid_from(box_of(low, high, 1, Division::kSquares));
    std::vector<Solid> others;
    for (const int count : {1, 2, 4, 8})
        for (const Division division : {Division::kSquares, Division::kTriangles, Division::kRims})
            others.push_back(solid_from(box_of(low, high, count, division)));
    for (const Solid& other : others) {
        EXPECT_EQ(hash_solid(other), hash_solid(plain));
        EXPECT_EQ(sums_of(other.data().points), sums_of(plain.data().points));
    }
    // The same cuts of each: what is looked at differs, and what comes out.
    scenes::Rng rng(8);
    for (int k = 0; k < 12; ++k) {
        Cut it{k % 2 ? CutterShape::kSpiky : CutterShape::kRocky, rng.next(), {}, k % 3 == 2};
        it.pose = {{rng.uniform(-38, 38), rng.uniform(-22, 30), rng.chance(0.5) ? 16.0 : -8.0},
                   random_turn(rng.next()),
                   rng.uniform(0.5, 2.5)};
        if (k % 4 == 3) it.pose.position.x = 40;  // at a rim
        const Solid expected = after(plain, {it});
        EXPECT_NE(hash_solid(expected), hash_solid(plain));
        for (const Solid& other : others) EXPECT_EQ(hash_solid(after(other, {it})), hash_solid(expected)) << k;
    }
}

TEST(HashSolid, MovedVerticesAndInsideOutShow) {
    const Vec3 low{-4, -4, -4}, high{4, 4, 4};
    const auto box = box_of(low, high, 1, Division::kTriangles);
    std::set<std::uint64_t> hashes{hash_solid(solid_from(box)), hash_solid(Solid())};
    std::set<GridPoint> corners;
    for (const auto& polygon : box) corners.insert(polygon.begin(), polygon.end());
    ASSERT_EQ(corners.size(), 8u);
    for (const GridPoint& corner : corners)
        for (int axis = 0; axis < 3; ++axis)
            for (const std::int32_t by : {-kSurfacePerInput, kSurfacePerInput}) {
                auto moved = box;
                for (auto& polygon : moved)
                    for (GridPoint& at : polygon)
                        if (at == corner) at[axis] += by;
                EXPECT_TRUE(hashes.insert(hash_solid(solid_from(moved))).second) << "by a step of the grid";
            }
    EXPECT_TRUE(hashes.insert(hash_solid(solid_from(box_of(low, high, 1, Division::kSquares, true)))).second);
    // All of it moved.
    auto shifted = box;
    for (auto& polygon : shifted)
        for (GridPoint& at : polygon) at.y += kSurfacePerInput;
    EXPECT_TRUE(hashes.insert(hash_solid(solid_from(shifted))).second);
    EXPECT_EQ(hashes.size(), 2u + 48 + 2);
}

TEST(HashSolid, IdsSourcesMaterialsAndBlocksDoNotCount) {
    const auto polygons = box_of({-4, -4, -4}, {4, 4, 4}, 2, Division::kTriangles);
    const Solid plain = solid_from(polygons);
    Level level = level_of({polygons.rbegin(), polygons.rend()});
    for (LevelFace& face : level.faces) face.material = 1;
    EXPECT_EQ(hash_solid(make_solid(level, {.faces_per_leaf = 1}).value()), hash_solid(plain));
    SolidResult stone = subtract(plain, make_crater(CutterShape::kRocky, 1), {.position = {0, 0, 4}}, {.material = 1});
    SolidResult air = subtract(plain, make_crater(CutterShape::kRocky, 1), {.position = {0, 0, 4}});
    ASSERT_TRUE(stone.done() && air.done());
    EXPECT_EQ(hash_solid(stone.solid), hash_solid(air.solid));
}

/// What edits kept is what is taken from all faces.
void expect_kept_as_anew(const Solid& solid) {
    SolidData anew = solid.data();
    hash_points_anew(anew);
    ASSERT_EQ(solid.data().point_sum, anew.point_sum);
    ASSERT_EQ(sums_of(solid.data().points), sums_of(anew.points));
    std::uint64_t total = 0;
    for (const RegionHash& region : hash_regions(solid)) total += region.points;
    ASSERT_EQ(total, anew.point_sum);
}

Pose random_pose(const Box& bounds, double scale, scenes::Rng& rng) {
    Pose pose;
    for (int axis = 0; axis < 3; ++axis) pose.position[axis] = rng.uniform(bounds.low[axis], bounds.high[axis]);
    pose.rotation = random_turn(rng.next());
    pose.scale = scale;
    return pose;
}

TEST(HashSolid, KeptByRandomCutsItIsThatTakenAnew) {
    scenes::Rng rng(9);
    std::vector<Solid> solids = {make_solid(test::tiled_hall()).value(),
                                 make_solid(scenes::room_grid({2, 2, 1})).value(),
                                 solid_from(box_of({-100, -100, -20}, {100, 100, 0}, 1, Division::kSquares)),
                                 solid_from(box_of({-3, -3, -3}, {3, 3, 3}, 3, Division::kTriangles))};
    for (Solid& solid : solids) {
        const Box bounds = solid.bounds();
        int done = 0;
        for (int k = 0; k < 100; ++k) {
            const CutterShape shapes[] = {CutterShape::kRocky, CutterShape::kSpiky, CutterShape::kDrill,
                                          CutterShape::kWedge, CutterShape::kBox};
            Cut it{shapes[rng.below(5)], rng.next(), random_pose(bounds, rng.uniform(0.2, 3), rng), rng.chance(0.3)};
            if (it.shape == CutterShape::kBox && rng.chance(0.5)) {
                // Straight and on round numbers: touches faces and seams, and is moved.
                it.pose.rotation = {0, 0, 0, 1};
                it.pose.scale = 1;
                for (int axis = 0; axis < 3; ++axis) it.pose.position[axis] = std::floor(it.pose.position[axis]);
            }
            const SolidResult result = cut(solid, it);
            ASSERT_NE(result.status, CarveStatus::kRefused) << result.error.reason;
            done += result.done();
            if (!result.done()) {
                ASSERT_EQ(hash_solid(result.solid), hash_solid(solid));
                continue;
            }
            ASSERT_NE(hash_solid(result.solid), hash_solid(solid));
            solid = result.solid;
            expect_kept_as_anew(solid);
            if (HasFatalFailure()) return;
        }
        EXPECT_GT(done, 30);
        EXPECT_FALSE(check_solid(solid));
    }
}

/// Facets that no cutter made: more of them once faces are tiled.
std::size_t facets_of_level(const Solid& solid) {
    std::size_t count = 0;
    for_each_block(*solid.data().faces.root, [&](const Block& block) {
        for (const FaceRecord& face : block.faces) count += face.edit == 0;
    });
    return count;
}

/// The surface of the rock: a face of 320 m, far larger than tiles; and walls of a room, slanted.
TEST(HashSolid, DisjointCutsInAnyOrderAreEqualThoughFacesAreTiled) {
    scenes::Rng rng(10);
    const std::vector<Solid> solids = {
        make_solid(test::tiled_hall()).value(),
        solid_from(box_of({-160, -160, -40}, {160, 160, 0}, 1, Division::kSquares)),
        solid_from(box_of({-160, -160, -40}, {160, 160, 0}, 1, Division::kTriangles)),
    };
    int compared = 0;
    for (const Solid& solid : solids) {
        const Box bounds = solid.bounds();
        int of_this = 0, tiled = 0;
        std::set<std::uint64_t> hashes;
        for (int tries = 0; tries < 5000 && of_this < 60; ++tries) {
            Cut cuts[2];
            for (Cut& it : cuts) {
                it.shape = rng.chance(0.5) ? CutterShape::kRocky : CutterShape::kSpiky;
                it.seed = rng.next();
                it.pose = random_pose(bounds, rng.uniform(1, 3), rng);
                if (solid.face_count() < 16 && bounds.high.x > 100) {  // on the large faces, not deep in the rock
                    it.pose.position.z = rng.chance(0.5) ? 0 : -40;
                    if (rng.chance(0.2)) it.pose.position.x = 160;
                }
                it.fills = rng.chance(0.2);
                if (bounds.high.x > 100 && rng.chance(0.3)) {  // a box along the axes, its sides where tiles may end
                    it.shape = CutterShape::kBox;
                    it.pose.rotation = {};
                    it.pose.scale = rng.chance(0.5) ? 1 : 0.625;
                    const double lattice = rng.chance(0.5) ? 5 : 0.625;
                    for (int axis = 0; axis < 2; ++axis)
                        it.pose.position[axis] = std::floor(it.pose.position[axis] / lattice) * lattice +
                                                 it.pose.scale * (rng.chance(0.5) ? 1 : -1);
                }
            }
            // Near each other too, so that both cut the same face, or the same tile.
            if (rng.chance(0.5)) {
                const double turn = rng.uniform(-1, 1);
                cuts[1].pose.position = cuts[0].pose.position + Vec3{13, 13 * turn, 0};
            }
            // Spikes reach up to twice the scale.
            const double reach = 2.2 * (cuts[0].pose.scale + cuts[1].pose.scale);
            if (length(cuts[0].pose.position - cuts[1].pose.position) < reach) continue;
            const SolidResult first = cut(solid, cuts[0]), second = cut(solid, cuts[1]);
            if (!first.done() || !second.done()) continue;
            const SolidResult there = cut(first.solid, cuts[1]), back = cut(second.solid, cuts[0]);
            ASSERT_TRUE(there.done() && back.done());
            ++of_this;
            tiled += facets_of_level(first.solid) > facets_of_level(solid) + 6;
            ASSERT_EQ(hash_solid(there.solid), hash_solid(back.solid)) << tries;
            ASSERT_EQ(sums_of(there.solid.data().points), sums_of(back.solid.data().points));
            // Sums of what each does: the two do not know of each other.
            ASSERT_EQ(there.solid.data().point_sum - first.solid.data().point_sum,
                      second.solid.data().point_sum - solid.data().point_sum);
            EXPECT_TRUE(hashes.insert(hash_solid(there.solid)).second);
            expect_kept_as_anew(there.solid);
            expect_kept_as_anew(back.solid);
            if (HasFatalFailure()) return;
        }
        EXPECT_EQ(of_this, 60);
        compared += of_this;
        EXPECT_GT(tiled, 30);
    }
    EXPECT_GE(compared, 100);
}

/// Three and more at once, in every order.
TEST(HashSolid, AllOrdersOfFourCuts) {
    const Solid solid = make_solid(test::tiled_hall()).value();
    const Cut cuts[4] = {{CutterShape::kRocky, 1, {.position = {20, 20, 0.3}, .scale = 1.5}},
                         {CutterShape::kSpiky, 2, {.position = {45, 30, 0.4}, .scale = 1.2}},
                         {CutterShape::kWedge, 3, {.position = {30, 2, 0.4}, .scale = 2}},
                         {CutterShape::kRocky, 4, {.position = {0.5, 0.5, 0.2}}}};
    std::array<int, 4> order{0, 1, 2, 3};
    std::set<std::uint64_t> hashes;
    do {
        hashes.insert(hash_solid(after(solid, {cuts[order[0]], cuts[order[1]], cuts[order[2]], cuts[order[3]]})));
    } while (std::next_permutation(order.begin(), order.end()));
    EXPECT_EQ(hashes.size(), 1u);
}

TEST(HashSolid, CarvedAndFilledAgainByTheSameShapeItIsAsBefore) {
    const Solid solid = solid_from(box_of({-30, -30, -30}, {30, 30, 30}, 1, Division::kSquares));
    scenes::Rng rng(11);
    for (int k = 0; k < 20; ++k) {
        // Inside the rock: a cavity, and then it is filled by a larger one.
        const Vec3 at{rng.uniform(-20, 20), rng.uniform(-20, 20), rng.uniform(-20, 20)};
        const Cut cavity{CutterShape::kRocky, rng.next(), {.position = at}};
        const Cut plug{CutterShape::kRocky, rng.next(), {.position = at, .scale = 2}, true};
        EXPECT_EQ(hash_solid(after(solid, {cavity, plug})), hash_solid(solid));
    }
}

/// Planes whose cross product is 2^61 - 1 times the line's direction, and others through the same line.
TEST(HashPoints, DirectionsThatThePrimeDivides) {
    const auto plane = [](std::int64_t x, std::int64_t y, std::int64_t z) {
        Plane made;
        made.normal[0] = x;
        made.normal[1] = y;
        made.normal[2] = z;
        return made;
    };
    const Plane p = plane(std::int64_t(1) << 31, 1, -1), q = plane(1, std::int64_t(1) << 30, -(std::int64_t(1) << 30));
    const auto hash = [&](const LineDirection& direction) {
        PointHash sums;
        sums.start_face(p, 1);
        sums.add_edge({0, 0, 0}, {0, 64, 64}, direction);
        return sums_of(sums.finish());
    };
    const Sums expected = hash(LineDirection::of(plane(0, 1, -1), plane(1, 1, -1)));
    EXPECT_EQ(hash(LineDirection::along({0, 0, 0}, {0, 64, 64})), expected);
    EXPECT_EQ(hash(LineDirection::of(p, q)), expected);
    EXPECT_EQ(hash(LineDirection::of(q, p)), expected);
}

}  // namespace
}  // namespace firma
