// SPDX-License-Identifier: MIT
// Points where planes meet against rational numbers: anywhere, on a plane, a hair off it, at the world's rim.
#include "geometry/exact_point.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>
#include <vector>

#include "base/assert.h"
#include "tests/geometry/big_numbers.h"

namespace firma {
namespace {

/// The nearest surface coordinate to x / w input steps: halves to even, and the far rim held back.
std::int32_t nearest_on_surface(const Big& x, const Big& w) {
    const Big top = 2 * kSurfacePerInput * x + w, bottom = 2 * w;  // floor(64 x / w + 1/2)
    Big nearest = top / bottom;
    if (nearest * bottom > top) --nearest;
    if (nearest * bottom == top && nearest % 2 != 0) --nearest;
    return nearest > INT32_MAX ? INT32_MAX : std::int32_t(nearest);
}

/// |value - x / w| <= kApproximation
bool approximates(double value, const Big& x, const Big& w) {
    const Big scaled = big(value * 0x1p60);  // a whole number, unless value is tiny: then it is cut off
    return abs(scaled * w - (x << 60)) <= (w << 60 >> 26) + w;
}

void expect_point(const ExactPoint& point, const BigPoint& exact) {
    for (int axis = 0; axis < 3; ++axis) {
        ASSERT_TRUE(approximates(point.approximate()[axis], exact.x[axis], exact.w));
        ASSERT_EQ(point.rounded()[axis], nearest_on_surface(exact.x[axis], exact.w));
    }
}

void expect_meet(const Meet& m, const BigPoint& exact) {
    ASSERT_EQ(m.w.sign(), 1);
    const Big w = big(m.w);
    ASSERT_LT(w, Big(1) << 159);
    const Int256* coordinates[3] = {&m.x, &m.y, &m.z};
    for (int axis = 0; axis < 3; ++axis) {
        const Big x = big(*coordinates[axis]);
        ASSERT_LT(abs(x), Big(1) << 184);
        ASSERT_EQ(x * exact.w, exact.x[axis] * w);
    }
}

/// The point of three planes, checked; nothing where there is none within the world.
struct Corner {
    std::array<Plane, 3> planes;
    BigPoint exact;
    bool exists = false;

    Corner(const Plane& a, const Plane& b, const Plane& c) : planes{a, b, c} {
        if (!a.valid() || !b.valid() || !c.valid()) return;
        exact = big_meet(big_plane(a), big_plane(b), big_plane(c));
        exists = in_world(exact);
    }
    ExactPoint point() const { return {planes[0], planes[1], planes[2]}; }
};

Plane random_plane(Points& points) {
    const InputPoint a = points.next(), b = points.next(), c = points.next();
    return plane_through(a, b, c);
}

Plane random_plane_through(Points& points, const InputPoint& a) {
    const InputPoint b = points.next(), c = points.next();
    return plane_through(a, b, c);
}

/// A small triangle near a point: its plane passes as close as the input grid lets it.
Plane plane_near(Points& points, const ExactPoint& point, std::int32_t span) {
    const GridPoint& at = point.rounded();
    const InputPoint center{at.x >> 6, at.y >> 6, at.z >> 6};
    const InputPoint a = points.near(center, span), b = points.near(center, span), c = points.near(center, 1);
    return plane_through(a, b, c);
}

class ExactPoints : public testing::TestWithParam<std::int32_t> {};  // how far apart points are, in input steps

TEST_P(ExactPoints, MeetWhereThePlanesDo) {
    Points points(1, GetParam());
    int met = 0;
    for (int i = 0; i < 3000; ++i) {
        if (i % 10 == 0) points.move();
        const Plane a = random_plane(points), b = random_plane(points), c = random_plane(points);
        if (!a.valid() || !b.valid() || !c.valid() || exact_turn(a, b, c) == 0) continue;
        const Corner corner(a, b, c);
        ASSERT_NO_FATAL_FAILURE(expect_meet(meet(a, b, c), corner.exact));
        ASSERT_NO_FATAL_FAILURE(expect_meet(meet(c, b, a), corner.exact));
        ASSERT_NO_FATAL_FAILURE(expect_meet(meet(a, flipped(b), c), corner.exact));
        if (!corner.exists) continue;
        ++met;
        const ExactPoint point = corner.point();
        ASSERT_FALSE(point.on_grid());
        ASSERT_NO_FATAL_FAILURE(expect_point(point, corner.exact));
        for (int k = 0; k < 3; ++k) ASSERT_EQ(exact_side(corner.planes[k], point), 0);
        ASSERT_EQ(exact_side(flipped(b), point), 0);
    }
    EXPECT_GT(met, 300);
}

TEST_P(ExactPoints, SidesAgreeWithRationals) {
    Points points(2, GetParam());
    int counts[3] = {0, 0, 0};
    for (int i = 0; i < 3000; ++i) {
        if (i % 10 == 0) points.move();
        const Plane a = random_plane(points), b = random_plane(points), c = random_plane(points);
        const Corner corner(a, b, c);
        if (!corner.exists) continue;
        const ExactPoint point = corner.point();
        const std::int32_t spans[4] = {1, 3, 100, 1 << 26};
        for (const std::int32_t span : spans) {
            const Plane plane = plane_near(points, point, span);
            if (!plane.valid()) continue;
            const int expected = side(big_plane(plane), corner.exact);
            ++counts[expected + 1];
            ASSERT_EQ(exact_side(plane, point), expected);
            ASSERT_EQ(exact_side(flipped(plane), point), -expected);
            ASSERT_EQ(exact_side_by_integers(plane, point), expected);
        }
    }
    EXPECT_GT(counts[0], 300);
    EXPECT_GT(counts[2], 300);
}

// Planes through one point of the grid, which they all meet in; and the same planes with the corner moved by a step.
TEST_P(ExactPoints, SidesOfPlanesThroughThePoint) {
    Points points(3, GetParam());
    int zeros = 0, others = 0;
    for (int i = 0; i < 3000; ++i) {
        if (i % 10 == 0) points.move();
        const InputPoint center = points.next();
        const Plane a = random_plane_through(points, center), b = random_plane_through(points, center);
        const Plane c = random_plane_through(points, center);
        const Corner corner(a, b, c);
        if (!corner.exists) continue;
        const ExactPoint point = corner.point(), grid(center);
        ASSERT_NO_FATAL_FAILURE(expect_point(point, big_point(center)));
        ASSERT_EQ(point.rounded(), to_surface(center));

        const InputPoint q = points.next(), r = points.next(), moved = points.near(center, 1);
        const Plane through = plane_through(center, q, r), beside = plane_through(moved, q, r);
        if (through.valid()) {
            ++zeros;
            ASSERT_EQ(exact_side(through, point), 0);
            ASSERT_EQ(exact_side(through, grid), 0);
        }
        if (beside.valid()) {
            const int expected = side(big_plane(beside), corner.exact);
            others += expected != 0;
            ASSERT_EQ(exact_side(beside, point), expected);
            ASSERT_EQ(exact_side(beside, grid), expected);
            ASSERT_EQ(exact_side_by_integers(beside, grid), expected);
        }
    }
    EXPECT_GT(zeros, 300);
    EXPECT_GT(others, 300);
}

// A point on an edge lies on every plane through that edge, and a step beside none of them.
TEST_P(ExactPoints, SidesOfPlanesThroughAnEdge) {
    Points points(4, GetParam());
    int zeros = 0, others = 0;
    for (int i = 0; i < 3000; ++i) {
        if (i % 10 == 0) points.move();
        const InputPoint p = points.next(), q = points.next();
        const Plane face = random_plane_through(points, p);
        const Plane other = plane_through(p, q, points.next());
        const Plane cut = random_plane(points);
        if (!other.valid() || !cut.valid()) continue;
        const Plane edge = edge_plane(p, q, other);
        const Corner corner(other, edge, cut);
        if (!corner.exists) continue;
        const ExactPoint point = corner.point();
        ASSERT_NO_FATAL_FAILURE(expect_point(point, corner.exact));

        const InputPoint r = points.next(), moved = points.near(q, 1);
        const Plane third = plane_through(p, q, r), beside = plane_through(p, moved, r);
        if (third.valid()) {
            ++zeros;
            ASSERT_EQ(exact_side(third, point), 0);
        }
        if (beside.valid()) {
            const int expected = side(big_plane(beside), corner.exact);
            others += expected != 0;
            ASSERT_EQ(exact_side(beside, point), expected);
        }
        if (face.valid()) {
            ASSERT_EQ(exact_side(face, point), side(big_plane(face), corner.exact));
        }
    }
    EXPECT_GT(zeros, 200);
    EXPECT_GT(others, 200);
}

TEST_P(ExactPoints, GridPointsAgreeWithIntegers) {
    Points points(5, GetParam());
    for (int i = 0; i < 3000; ++i) {
        if (i % 10 == 0) points.move();
        const InputPoint a = points.next(), b = points.next(), c = points.next();
        const Plane plane = plane_through(a, b, c);
        if (!plane.valid()) continue;
        const InputPoint near_a = points.near(a, 1), any = points.next();
        for (const InputPoint& p : {a, b, c, near_a, any}) {
            const ExactPoint point(p);
            ASSERT_TRUE(point.on_grid());
            ASSERT_EQ(point.grid(), p);
            ASSERT_EQ(point.rounded(), to_surface(p));
            ASSERT_NO_FATAL_FAILURE(expect_point(point, big_point(p)));
            const int expected = side(big_plane(plane), big_point(p));
            ASSERT_EQ(exact_side(plane, point), expected);
            ASSERT_EQ(exact_side_by_integers(plane, point), expected);
        }
    }
}

/// The sign of (b - a) . (f x t), by its definition.
int order(const Plane& f, const Plane& t, const BigPoint& a, const BigPoint& b) {
    const BigPlane bf = big_plane(f), bt = big_plane(t);
    Big along = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const int i = (axis + 1) % 3, j = (axis + 2) % 3;
        const Big direction = bf.normal[i] * bt.normal[j] - bf.normal[j] * bt.normal[i];
        along += direction * (b.x[axis] * a.w - a.x[axis] * b.w);
    }
    return sign_of(along);
}

void expect_order(const Plane& f, const Plane& t, const Corner& a, const Corner& b, int expected) {
    const ExactPoint pa = a.point(), pb = b.point();
    ASSERT_EQ(exact_order(f, t, pa, a.planes[2], pb), expected);
    ASSERT_EQ(exact_order(f, t, pb, b.planes[2], pa), -expected);
    ASSERT_EQ(exact_order(t, f, pa, a.planes[2], pb), -expected);
    ASSERT_EQ(exact_order(f, t, pa, flipped(a.planes[2]), pb), expected);
    ASSERT_EQ(exact_order(flipped(f), t, pa, a.planes[2], pb), -expected);
    ASSERT_EQ(exact_order(f, t, pa, a.planes[2], pa), 0);
}

// Where two planes cross the line: anywhere, in one point, or a step apart.
TEST_P(ExactPoints, OrderAgreesWithRationals) {
    Points points(6, GetParam());
    int counts[3] = {0, 0, 0};
    for (int i = 0; i < 4000; ++i) {
        if (i % 10 == 0) points.move();
        const InputPoint center = points.next();
        const bool anywhere = i % 4 == 3;
        const auto plane = [&](std::int32_t off) {
            const InputPoint at = anywhere ? points.next() : points.near(center, off);
            return random_plane_through(points, at);
        };
        const Plane f = plane(0), t = plane(0), q = plane(0), r = plane(i % 4);
        const Corner a(f, t, q), b(f, t, r);
        if (!a.exists || !b.exists) continue;
        const int expected = order(f, t, a.exact, b.exact);
        ++counts[expected + 1];
        ASSERT_NO_FATAL_FAILURE(expect_order(f, t, a, b, expected));
    }
    for (const int count : counts) EXPECT_GT(count, 100);
}

// Along an edge between points of the grid, with cuts between them.
TEST_P(ExactPoints, OrderAlongAnEdge) {
    Points points(7, GetParam());
    int ordered = 0;
    for (int i = 0; i < 3000; ++i) {
        if (i % 10 == 0) points.move();
        const InputPoint p = points.next(), q = points.next(), r = points.next(), s = points.next();
        const Plane f = plane_through(p, q, r), t = plane_through(q, p, s), cut = random_plane(points);
        const Plane across = random_plane_through(points, p);
        const Corner start(f, t, across), b(f, t, cut);
        if (!start.exists || !b.exists) continue;
        ++ordered;
        const ExactPoint from(p), to(q), between = b.point();
        const int way = order(f, t, big_point(p), big_point(q));
        ASSERT_NE(way, 0);
        ASSERT_EQ(exact_order(f, t, from, across, to), way);
        ASSERT_EQ(exact_order(f, t, from, across, from), 0);
        ASSERT_EQ(exact_order(f, t, from, across, start.point()), 0);
        ASSERT_EQ(exact_order(f, t, from, across, between), order(f, t, big_point(p), b.exact));
        ASSERT_EQ(exact_order(f, t, between, cut, to), order(f, t, b.exact, big_point(q)));
    }
    EXPECT_GT(ordered, 200);
}

// Two of the planes differ by one corner moved a step or two: their line is badly determined in double.
TEST_P(ExactPoints, NearlyParallelPlanesMeetExactly) {
    Points points(10, GetParam());
    int met = 0;
    for (int i = 0; i < 3000; ++i) {
        if (i % 10 == 0) points.move();
        const InputPoint p = points.next(), q = points.next(), r = points.next();
        const InputPoint p1 = points.near(p, 1), q1 = points.near(q, i % 3);
        const Plane f = plane_through(p, q, r), t = plane_through(p1, q1, r);
        const InputPoint at = points.near(r, 2);
        const Plane across = random_plane_through(points, at);
        const Plane second = random_plane_through(points, i % 2 == 0 ? at : q);
        const Corner a(f, t, across), b(f, t, second);
        if (!a.exists || !b.exists) continue;
        ++met;
        const ExactPoint point = a.point();
        ASSERT_NO_FATAL_FAILURE(expect_meet(meet(f, t, across), a.exact));
        ASSERT_NO_FATAL_FAILURE(expect_point(point, a.exact));
        ASSERT_EQ(exact_side(second, point), side(big_plane(second), a.exact));
        const Plane third = plane_through(q1, p, r);
        if (third.valid()) {
            ASSERT_EQ(exact_side(third, point), side(big_plane(third), a.exact));
        }
        ASSERT_NO_FATAL_FAILURE(expect_order(f, t, a, b, order(f, t, a.exact, b.exact)));
    }
    EXPECT_GT(met, 300);
}

// Between 2^16 and 10^5 the determinants of three planes outgrow 128 bits.
INSTANTIATE_TEST_SUITE_P(Spans, ExactPoints, testing::Values(3, 50, 4096, 1 << 16, 100000, 1 << 20, 1 << 26));

/// The plane that holds x = `x` + (y - `y`) * dy / dx, whatever z; with the axes turned by `turn`.
Plane slope(int turn, std::int32_t x, std::int32_t y, std::int32_t dx, std::int32_t dy) {
    const auto at = [&](std::int32_t px, std::int32_t py, std::int32_t pz) {
        InputPoint p;
        p[turn] = px;
        p[(turn + 1) % 3] = py;
        p[(turn + 2) % 3] = pz;
        return p;
    };
    return plane_through(at(x, y, 0), at(x + dy, y + dx, 0), at(x, y, 1));
}

// x = odd / 128 lies between two surface steps. A slope upon a slope moves it by far less than doubles can tell.
TEST(ExactPoint, RoundsHalvesToEven) {
    scenes::Rng rng(8);
    int ties = 0, close = 0;
    for (int i = 0; i < 4000; ++i) {
        const int turn = int(rng.below(3));
        const std::int32_t x = std::int32_t(rng.below((1u << 26) - 2)) - kRimSteps;
        const std::int32_t y = std::int32_t(rng.below(1u << 20));
        const std::int32_t steep = 1 + std::int32_t(rng.below(1u << 15));
        const std::int32_t steeper = 1 + std::int32_t(rng.below(1u << 20));
        const std::int32_t half = std::int32_t(rng.below(64)) * 2 + 1;  // of 128
        const std::int32_t off = std::int32_t(rng.below(3)) - 1;        // of 128 * steep * steeper
        const Plane a = slope(turn, x, y, 128 * steep, 1);
        const Plane b = slope((turn + 1) % 3, y + half * steep, 77, steeper, 1);
        const Plane c = axis_plane((turn + 2) % 3, 77 + off);
        const Corner corner(a, b, c);
        ASSERT_TRUE(corner.exists);
        const ExactPoint point = corner.point();
        ASSERT_NO_FATAL_FAILURE(expect_point(point, corner.exact));
        ties += off == 0;
        close += off != 0;
        const std::int64_t below = std::int64_t(x) * 64 + half / 2;  // the half lies at below + 1/2
        const std::int64_t even = below + (below & 1);
        ASSERT_EQ(point.rounded()[turn], off < 0 ? below : off > 0 ? below + 1 : even);
    }
    EXPECT_GT(ties, 1000);
    EXPECT_GT(close, 2000);
}

TEST(ExactPoint, TheFarRimIsHeldBack) {
    constexpr std::int32_t kLast = std::numeric_limits<std::int32_t>::max();
    for (int turn = 0; turn < 3; ++turn)
        for (int part = 0; part < 256; ++part) {
            // x = 2^25 - 1 + part / 256: past 250 / 256 it rounds to the last coordinate, from 254 / 256 to the rim.
            const Plane a = slope(turn, kRimSteps - 2, 0, 256, 1);
            const Plane b = axis_plane((turn + 1) % 3, 256 + part), c = axis_plane((turn + 2) % 3, -5);
            const Corner corner(a, b, c);
            ASSERT_TRUE(corner.exists);
            const ExactPoint point = corner.point();
            ASSERT_NO_FATAL_FAILURE(expect_point(point, corner.exact));
            ASSERT_EQ(point.rounded()[turn] == kLast, part >= 251) << part;
            // And the near one, which there is a coordinate for.
            const Plane low = slope(turn, -kRimSteps, 0, 256, 1);
            const Plane at = axis_plane((turn + 1) % 3, part);
            const ExactPoint near_rim(low, at, c);
            ASSERT_EQ(near_rim.rounded()[turn], nearest_on_surface(Big(-kRimSteps) * 256 + part, 256));
        }
    const Plane x = axis_plane(0, kRimSteps), y = axis_plane(1, -kRimSteps), z = axis_plane(2, 3);
    EXPECT_EQ(ExactPoint(x, y, z).rounded(), (GridPoint{kLast, std::numeric_limits<std::int32_t>::min(), 192}));
}

// The filter answers nearly always: not one of these points, metres apart, needs integers.
TEST(ExactPoint, PointsApartNeedNoIntegers) {
    Points points(9, 40000);
    int asked = 0;
    const std::uint64_t before = exact_fallbacks();
    for (int i = 0; i < 3000; ++i) {
        if (i % 10 == 0) points.move();
        const Plane a = random_plane(points), b = random_plane(points), c = random_plane(points);
        const Plane plane = random_plane(points);
        const Corner corner(a, b, c);
        if (!corner.exists || !plane.valid()) continue;
        const ExactPoint point = corner.point();
        const Vec3& p = point.approximate();
        const double distance = (dot(plane.direction(), p) + plane.d) / plane.size;
        if (std::fabs(distance) < 1e-6) continue;  // input steps: 0.25 nanometres
        ++asked;
        exact_side(plane, point);
    }
    EXPECT_GT(asked, 1000);
    EXPECT_EQ(exact_fallbacks(), before);
    const Plane x = axis_plane(0, 1);
    exact_side(x, ExactPoint(InputPoint{1, 2, 3}));
    EXPECT_EQ(exact_fallbacks(), before + 1);
}

int assertions = 0;

TEST(ExactPoint, AssertsThatPlanesMeetInTheWorld) {
    assertions = 0;
    set_assert_handler([](const char*, const char*, const char*, int) { ++assertions; });
    const Plane x = axis_plane(0, 1), y = axis_plane(1, 2), z = axis_plane(2, 3), other = axis_plane(1, 5);
    const ExactPoint inside(x, y, z);
    const int none = assertions;
    const ExactPoint nowhere(x, y, other);
    const int parallel = assertions;
    const Plane far = slope(0, 0, 0, 1, 10), high = axis_plane(1, kRimSteps - 1);
    const ExactPoint outside(far, high, z);
    set_assert_handler(nullptr);
    EXPECT_EQ(none, 0);
#if defined(FIRMA_ASSERTIONS) && FIRMA_ASSERTIONS
    EXPECT_GT(parallel, none);
    EXPECT_GT(assertions, parallel);
#else
    EXPECT_EQ(parallel, none);
#endif
}

}  // namespace
}  // namespace firma
