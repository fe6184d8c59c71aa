// SPDX-License-Identifier: MIT
// Planes against integers without end: far out, tiny, lying on a line, nearly parallel.
#include "geometry/exact_plane.h"

#include <gtest/gtest.h>

#include "tests/geometry/big_numbers.h"

namespace firma {
namespace {

Big common_divisor(const Plane& plane) {
    const BigPlane exact = big_plane(plane);
    return gcd(gcd(exact.normal[0], exact.normal[1]), gcd(exact.normal[2], exact.offset));
}

/// Integers with no common divisor, doubles that belong to them.
void expect_sound(const Plane& plane) {
    ASSERT_TRUE(plane.valid());
    ASSERT_EQ(common_divisor(plane), 1);
    Big size = 0;
    for (int axis = 0; axis < 3; ++axis) {
        ASSERT_EQ(big(plane.direction()[axis]), big(Int128(plane.normal[axis])));
        ASSERT_LE(std::abs(plane.normal[axis]), std::int64_t(1) << 52);
        size += abs(big(Int128(plane.normal[axis])));
    }
    ASSERT_TRUE(is_nearest(plane.d, big(plane.offset())));
    ASSERT_GE(big(plane.size), size);
    ASSERT_LE(big(plane.size), size + 1);
    ASSERT_LE(abs(big(plane.offset())), size << 25);
}

bool through(const Plane& plane, const InputPoint& p) {
    return side(big_plane(plane), big_point(p)) == 0;
}

class ExactPlane : public testing::TestWithParam<std::int32_t> {};  // how far apart points are, in input steps

TEST_P(ExactPlane, AgreesWithItsDefinition) {
    Points points(1, GetParam());
    int lines = 0;
    for (int i = 0; i < 3000; ++i) {
        if (i % 10 == 0) points.move();
        const InputPoint a = points.next(), b = points.next(), c = points.next();
        const Plane plane = plane_through(a, b, c);
        const BigPlane exact = big_plane(a, b, c);
        const bool on_a_line = exact.normal[0] == 0 && exact.normal[1] == 0 && exact.normal[2] == 0;
        ASSERT_EQ(plane.valid(), !on_a_line);
        lines += on_a_line;
        if (on_a_line) {
            ASSERT_EQ(plane, Plane());
            continue;
        }
        ASSERT_NO_FATAL_FAILURE(expect_sound(plane));
        // The same plane, and the same side of it in front.
        for (int axis = 0; axis < 3; ++axis) {
            const int next = (axis + 1) % 3;
            ASSERT_EQ(exact.normal[axis] * plane.normal[next], exact.normal[next] * plane.normal[axis]);
            ASSERT_EQ(sign_of(exact.normal[axis]), sign_of(big(Int128(plane.normal[axis]))));
        }
        ASSERT_TRUE(through(plane, a) && through(plane, b) && through(plane, c));
        // Turned about, or seen from behind.
        ASSERT_EQ(plane, plane_through(b, c, a));
        ASSERT_EQ(plane, plane_through(c, a, b));
        const Plane back = flipped(plane);
        ASSERT_NO_FATAL_FAILURE(expect_sound(back));
        ASSERT_EQ(back, plane_through(a, c, b));
        ASSERT_FALSE(back == plane);
        ASSERT_EQ(flipped(back), plane);
    }
    if (GetParam() <= 2) {
        EXPECT_GT(lines, 0);
    }
}

TEST_P(ExactPlane, IsTheSameForEveryTriangleOnIt) {
    Points points(2, GetParam());
    for (int i = 0; i < 1000; ++i) {
        points.move();
        const InputPoint a = points.near({0, 0, 0}, kRimSteps / 8);
        const std::int32_t span = GetParam() < kRimSteps / 32 ? GetParam() : kRimSteps / 32;
        const InputPoint u = points.near({0, 0, 0}, span), v = points.near({0, 0, 0}, span);
        const auto at = [&](int s, int t) {
            return InputPoint{a.x + s * u.x + t * v.x, a.y + s * u.y + t * v.y, a.z + s * u.z + t * v.z};
        };
        const Plane plane = plane_through(at(0, 0), at(1, 0), at(0, 1));
        if (!plane.valid()) continue;
        ASSERT_EQ(plane_through(at(1, 1), at(5, 2), at(3, 7)), plane);
        ASSERT_EQ(plane_through(at(-3, 0), at(-2, -5), at(0, 3)), plane);
        ASSERT_FALSE(plane_through(at(0, 0), at(2, 0), at(4, 0)).valid());
        ASSERT_FALSE(plane_through(at(0, 0), at(2, 1), at(-4, -2)).valid());
    }
}

TEST_P(ExactPlane, ThroughAnEdgeCrossesItsFace) {
    Points points(3, GetParam());
    for (int i = 0; i < 3000; ++i) {
        if (i % 10 == 0) points.move();
        const InputPoint a = points.next(), b = points.next(), c = points.next();
        const Plane face = plane_through(a, b, c);
        if (!face.valid()) continue;
        const Plane edge = edge_plane(a, b, face);
        ASSERT_NO_FATAL_FAILURE(expect_sound(edge));
        ASSERT_TRUE(through(edge, a) && through(edge, b));
        ASSERT_EQ(edge.normal[face.dominant_axis()], 0);
        ASSERT_FALSE(exact_parallel(edge, face));
        ASSERT_EQ(edge_plane(b, a, face), flipped(edge));
        ASSERT_TRUE(edge_plane(a, b, flipped(face)) == edge);
        InputPoint step = a;
        step[face.dominant_axis()] += 1;
        if (step[face.dominant_axis()] >= kRimSteps) continue;
        ASSERT_EQ(edge, plane_through(a, b, step));
    }
}

/// Three planes through the line p q, or (off > 0) nearly so.
void expect_turns_agree(Points& points, const InputPoint& p, const InputPoint& q, std::int32_t off) {
    const auto plane = [&] {
        const InputPoint first = points.near(p, off), second = points.near(q, off), third = points.next();
        return plane_through(first, second, third);
    };
    const Plane a = plane(), b = plane(), c = plane();
    if (!a.valid() || !b.valid() || !c.valid()) return;
    const BigPlane exact[3] = {big_plane(a), big_plane(b), big_plane(c)};
    const int turn = sign_of(determinant(exact[0].normal, exact[1].normal, exact[2].normal));
    if (off == 0) {
        ASSERT_EQ(turn, 0);
    }
    ASSERT_EQ(exact_turn(a, b, c), turn);
    ASSERT_EQ(exact_turn(b, c, a), turn);
    ASSERT_EQ(exact_turn(b, a, c), -turn);
    ASSERT_EQ(exact_turn(flipped(a), b, c), -turn);
    ASSERT_EQ(exact_turn(a, b, a), 0);
    ASSERT_EQ(exact_turn(a, flipped(b), b), 0);
}

TEST_P(ExactPlane, TurnsAgreeWithBigIntegers) {
    Points points(4, GetParam());
    for (int i = 0; i < 4000; ++i) {
        if (i % 10 == 0) points.move();
        const InputPoint p = points.next(), q = points.next();
        const std::int32_t offs[4] = {0, 1, 3, GetParam()};
        ASSERT_NO_FATAL_FAILURE(expect_turns_agree(points, p, q, offs[i % 4]));
    }
}

// A corner moved by a step turns a plane by as little as can be.
TEST_P(ExactPlane, ParallelAgreesWithBigIntegers) {
    Points points(5, GetParam());
    for (int i = 0; i < 3000; ++i) {
        if (i % 10 == 0) points.move();
        const InputPoint a = points.next(), b = points.next(), c = points.next();
        const InputPoint moved = points.near(c, 1);
        const Plane one = plane_through(a, b, c), other = plane_through(a, b, moved);
        if (!one.valid() || !other.valid()) continue;
        const BigPlane exact = big_plane(a, b, c), turned = big_plane(a, b, moved);
        bool parallel = true;
        for (int axis = 0; axis < 3; ++axis)
            parallel = parallel && exact.normal[axis] * turned.normal[(axis + 1) % 3] ==
                                       exact.normal[(axis + 1) % 3] * turned.normal[axis];
        ASSERT_EQ(exact_parallel(one, other), parallel);
        ASSERT_TRUE(exact_parallel(one, one));
        ASSERT_TRUE(exact_parallel(one, flipped(one)));
        Plane apart = one;
        apart.set_offset(apart.offset() + 1);
        ASSERT_TRUE(exact_parallel(one, apart));
    }
}

INSTANTIATE_TEST_SUITE_P(Spans, ExactPlane, testing::Values(1, 2, 50, 4096, 1 << 20, 1 << 26));

TEST(ExactPlanes, FrontIsWhereCornersRunCounterClockwise) {
    const Plane floor = plane_through({0, 0, 7}, {10, 0, 7}, {0, 10, 7});
    EXPECT_EQ(floor.normal[0], 0);
    EXPECT_EQ(floor.normal[1], 0);
    EXPECT_EQ(floor.normal[2], 1);
    EXPECT_EQ(floor.offset(), Int128(-7));
    EXPECT_EQ(floor, axis_plane(2, 7));
    EXPECT_EQ(side(big_plane(floor), big_point({3, 3, 8})), 1);
    EXPECT_EQ(side(big_plane(flipped(floor)), big_point({3, 3, 8})), -1);
    const Vec3 back = flipped(floor).direction();
    for (int axis = 0; axis < 3; ++axis) EXPECT_FALSE(back[axis] == 0 && std::signbit(back[axis]));
}

TEST(ExactPlanes, AxisPlanesLookTowardGreaterCoordinates) {
    for (int axis = 0; axis < 3; ++axis)
        for (const std::int32_t step : {-kRimSteps, -1, 0, 5, kRimSteps - 1, kRimSteps}) {
            const Plane plane = axis_plane(axis, step);
            ASSERT_NO_FATAL_FAILURE(expect_sound(plane));
            EXPECT_EQ(plane.dominant_axis(), axis);
            InputPoint p{3, -4, 5};
            for (int off = -1; off <= 1; ++off) {
                p[axis] = step + off;
                EXPECT_EQ(side(big_plane(plane), big_point(p)), off);
            }
        }
}

TEST(ExactPlanes, TheFirstOfEqualComponentsIsDominant) {
    const auto dominant = [](std::int64_t x, std::int64_t y, std::int64_t z) {
        Plane plane;
        plane.normal[0] = x;
        plane.normal[1] = y;
        plane.normal[2] = z;
        return plane.dominant_axis();
    };
    EXPECT_EQ(dominant(1, 1, 1), 0);
    EXPECT_EQ(dominant(1, -1, 1), 0);
    EXPECT_EQ(dominant(1, -2, 2), 1);
    EXPECT_EQ(dominant(1, 2, -3), 2);
    EXPECT_EQ(dominant(-3, 2, 3), 0);
    EXPECT_EQ(dominant(0, 0, -1), 2);
}

// The largest normal and offset there are: the bits that everything else is counted from.
TEST(ExactPlanes, HoldsTheLargestTriangles) {
    const std::int32_t low = -kRimSteps, high = kRimSteps - 1;
    const Plane face = plane_through({low, low, low}, {high, low, high}, {low, high, high});
    ASSERT_NO_FATAL_FAILURE(expect_sound(face));
    EXPECT_EQ(face.normal[2], 1);  // all three are equal but for the sign
    const Plane skew = plane_through({low, low, low}, {high, low, high - 1}, {low + 1, high, high});
    ASSERT_NO_FATAL_FAILURE(expect_sound(skew));
    EXPECT_GT(std::abs(skew.normal[2]), std::int64_t(1) << 51);
    EXPECT_GT(skew.size, 0x1p53);
}

}  // namespace
}  // namespace firma
