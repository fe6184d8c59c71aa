// SPDX-License-Identifier: MIT
// Contact points of hulls, beside the corners of the common part found another way: as all crossings of two of the
// lines that bound it that lie on the right side of all others; and of these the best four among all choices of four.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "firma/hull.h"
#include "scenes/grid_polygons.h"

namespace firma {
namespace {

using scenes::Rng;

struct PlanePoint {
    double x = 0, y = 0;
};

double spanned(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// x a + y b <= c
struct HalfPlane {
    double a, b, c;
};

/// By every pair of points that has all others on one side.
std::vector<HalfPlane> bounds_of(const std::vector<PlanePoint>& points) {
    std::vector<HalfPlane> bounds;
    for (const PlanePoint& p : points)
        for (const PlanePoint& q : points) {
            const double dx = q.x - p.x, dy = q.y - p.y;
            if (std::fabs(dx) + std::fabs(dy) < 1e-12) continue;
            if (std::all_of(points.begin(), points.end(),
                            [&](const PlanePoint& r) { return spanned(p, q, r) > -1e-12; }))
                bounds.push_back({dy, -dx, dy * p.x - dx * p.y});
        }
    return bounds;
}

std::vector<PlanePoint> common_corners(std::vector<HalfPlane> bounds, const std::vector<HalfPlane>& more) {
    bounds.insert(bounds.end(), more.begin(), more.end());
    std::vector<PlanePoint> corners;
    for (std::size_t i = 0; i < bounds.size(); ++i)
        for (std::size_t j = i + 1; j < bounds.size(); ++j) {
            const HalfPlane &f = bounds[i], &g = bounds[j];
            const double turn = f.a * g.b - f.b * g.a;
            if (std::fabs(turn) < 1e-12) continue;
            const PlanePoint p{(f.c * g.b - f.b * g.c) / turn, (f.a * g.c - f.c * g.a) / turn};
            const bool inside = std::all_of(bounds.begin(), bounds.end(),
                                            [&](const HalfPlane& h) { return h.a * p.x + h.b * p.y <= h.c + 1e-9; });
            const bool known = std::any_of(corners.begin(), corners.end(), [&](const PlanePoint& q) {
                return std::fabs(p.x - q.x) < 1e-7 && std::fabs(p.y - q.y) < 1e-7;
            });
            if (inside && !known) corners.push_back(p);
        }
    return corners;
}

/// Twice the area of the hull of four points: of the three ways round the largest.
double area_of_four(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c, const PlanePoint& d) {
    const auto around = [](const PlanePoint& p, const PlanePoint& q, const PlanePoint& r, const PlanePoint& s) {
        return std::fabs(spanned(p, q, r) + spanned(p, r, s));
    };
    double most = std::max({around(a, b, c, d), around(a, c, b, d), around(a, b, d, c)});
    return std::max({most, std::fabs(spanned(a, b, c)), std::fabs(spanned(a, b, d)), std::fabs(spanned(a, c, d)),
                     std::fabs(spanned(b, c, d))});
}

double widest_of(const std::vector<PlanePoint>& p) {
    double most = 0;
    for (std::size_t a = 0; a < p.size(); ++a)
        for (std::size_t b = a; b < p.size(); ++b)
            for (std::size_t c = b; c < p.size(); ++c)
                for (std::size_t d = c; d < p.size(); ++d) most = std::max(most, area_of_four(p[a], p[b], p[c], p[d]));
    return most;
}

std::string told(const std::vector<PlanePoint>& points) {
    std::string text;
    for (const PlanePoint& p : points) text += std::to_string(p.x) + " " + std::to_string(p.y) + "\n";
    return text;
}

TEST(ContactPoints, AreTheCornersOfWhatTouches) {
    Rng rng(4);
    int faces = 0, edges = 0, corners_only = 0, reduced = 0;
    for (int round = 0; round < 3000 && !HasFailure(); ++round) {
        const scenes::Steps middle = scenes::random_steps(rng, 100) * scenes::kMetre;
        const std::vector<Vec3> polygon = scenes::to_metres(
            scenes::random_polygon(rng, middle, 2 * scenes::kMetre, scenes::kMetre / 4, 8, rng.chance(0.2)));
        const PolygonFault fault = check_polygon(polygon);
        ASSERT_EQ(fault, PolygonFault::kNone);
        const Vec3 e = polygon[1] - polygon[0];
        Vec3 f, n;
        for (std::size_t k = 2; k < polygon.size() && length(n) == 0; ++k) n = cross(e, f = polygon[k] - polygon[0]);
        const Vec3 unit = n * (1 / length(n));
        // The hull's lowest corners lie in a plane beside the polygon's, exactly: sums of quarters of e and f.
        const std::uint32_t lowest = rng.chance(0.2) ? 1 : rng.chance(0.2) ? 2 : 3 + rng.below(6);
        std::vector<Vec3> points;
        for (std::uint32_t k = 0; k < lowest; ++k)
            points.push_back(e * (0.25 * (double(rng.below(9)) - 4)) + f * (0.25 * (double(rng.below(9)) - 4)));
        Vec3 inside = unit * 2;
        for (const Vec3& p : points) inside += p * (0.5 / lowest);
        for (const Vec3& way : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}, Vec3{-1, -1, -1}})
            points.push_back(unit * 4 + way);
        const auto near_to = [](double x) { return std::round(x * 1024) / 1024; };  // so that nothing below is rounded
        for (Vec3& p : points) p -= Vec3{near_to(inside.x), near_to(inside.y), near_to(inside.z)};
        const Result<Hull> hull = make_hull(points);
        if (!hull.ok()) continue;
        const Vec3 at = polygon[0] + unit * 6 + e * rng.uniform(-0.5, 1.2) + f * rng.uniform(-0.5, 1.2);
        const PolygonHit hit = cast_polygon(hull.value(), at, unit * -8.0, polygon);
        if (hit.status != Status::kHit) continue;
        const ContactPoints found = contact_points(hull.value(), hit, polygon);
        ASSERT_GE(found.count, 1u);
        ASSERT_LE(found.count, 4u);
        for (const Vec3& p : found.points()) {
            EXPECT_LT(closest_point(p, polygon).distance, 1e-9);
            EXPECT_LT(std::fabs(dot(unit, p - polygon[0])), 1e-9);
        }
        if (hit.feature != Feature::kFace) continue;

        // In the plane, by multiples of e and f.
        const double ee = dot(e, e), ff = dot(f, f), ef = dot(e, f), all = ee * ff - ef * ef;
        const auto seen = [&](const Vec3& p) {
            const Vec3 w = p - polygon[0];
            const double we = dot(w, e), wf = dot(w, f);
            return PlanePoint{(we * ff - wf * ef) / all, (wf * ee - we * ef) / all};
        };
        std::vector<PlanePoint> of_face, of_hull;
        for (const Vec3& v : polygon) of_face.push_back(seen(v));
        double low = INFINITY;
        for (const Vec3& o : hull.value().corners()) low = std::min(low, dot(unit, o));
        for (const Vec3& o : hull.value().corners())
            if (dot(unit, o) < low + 1e-9) of_hull.push_back(seen(hit.centre + o));
        const auto near = [](const PlanePoint& p, const PlanePoint& q) {
            return std::fabs(p.x - q.x) + std::fabs(p.y - q.y) < 1e-7;
        };
        std::vector<PlanePoint> got;
        for (const Vec3& p : found.points()) got.push_back(seen(p));
        if (of_hull.size() == 1) {
            ++corners_only;
            ASSERT_EQ(got.size(), 1u);
            EXPECT_TRUE(near(got[0], of_hull[0]));
            continue;
        }
        std::vector<HalfPlane> bounds = bounds_of(of_hull);
        const auto [first, last] = std::minmax_element(
            of_hull.begin(), of_hull.end(),
            [](const auto& p, const auto& q) { return std::fabs(p.x - q.x) > 1e-9 ? p.x < q.x : p.y < q.y; });
        const bool line = std::all_of(of_hull.begin(), of_hull.end(),
                                      [&](const PlanePoint& p) { return std::fabs(spanned(*first, *last, p)) < 1e-9; });
        if (line) {  // its ends bound it, too
            const double dx = last->x - first->x, dy = last->y - first->y;
            bounds.push_back({dx, dy, dx * last->x + dy * last->y});
            bounds.push_back({-dx, -dy, -dx * first->x - dy * first->y});
        }
        const std::vector<PlanePoint> corners = common_corners(bounds, bounds_of(of_face));
        for (const PlanePoint& p : got)
            EXPECT_TRUE(std::any_of(corners.begin(), corners.end(), [&](const PlanePoint& q) { return near(p, q); }))
                << told(got) << "of\n"
                << told(corners) << "hull\n"
                << told(of_hull) << "face\n"
                << told(of_face);
        EXPECT_EQ(got.size(), std::min<std::size_t>(corners.size(), 4)) << corners.size();
        EXPECT_NEAR(widest_of(got), widest_of(corners), 1e-7);
        (line ? edges : faces) += 1;
        reduced += corners.size() > 4;
    }
    EXPECT_GT(faces, 200);
    EXPECT_GT(edges, 50);
    EXPECT_GT(corners_only, 30);
    EXPECT_GT(reduced, 50);
}

const std::vector<Vec3> kGround{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};

TEST(ContactPoints, OfABoxAtRestAreItsCorners) {
    const Hull box = make_box({0.5, 0.5, 0.5}).value();
    const PolygonHit hit = cast_polygon(box, {2, 2, 3}, {0, 0, -4}, kGround);
    const ContactPoints found = contact_points(box, hit, kGround);
    ASSERT_EQ(found.count, 4u);
    for (const Vec3& p : found.points()) {
        EXPECT_EQ(p.z, 0);
        EXPECT_EQ(std::fabs(p.x - 2), 0.5);
        EXPECT_EQ(std::fabs(p.y - 2), 0.5);
    }
    const PolygonHit over = cast_polygon(box, {4, 2, 3}, {0, 0, -4}, kGround);  // half of it over the rim
    const ContactPoints half = contact_points(box, over, kGround);
    ASSERT_EQ(half.count, 4u);
    for (const Vec3& p : half.points()) EXPECT_TRUE(p.x == 3.5 || p.x == 4) << p.x;
}

TEST(ContactPoints, AcrossAnEdgeThereIsOne) {
    const Hull box = make_box({0.5, 0.5, 0.5}, {Vec3{0.8, 0, 0.6}, Vec3{0, 1, 0}, Vec3{-0.6, 0, 0.8}}).value();
    const PolygonHit hit = cast_polygon(box, {2, -3, 0.6}, {0, 8, 0}, kGround, Sides::kBoth);
    ASSERT_EQ(hit.status, Status::kHit);
    const ContactPoints found = contact_points(box, hit, kGround);
    ASSERT_GE(found.count, 1u);
    for (const Vec3& p : found.points()) EXPECT_EQ(p.y, 0);
}

TEST(ContactPoints, OfAMissAreNone) {
    const Hull box = make_box({0.5, 0.5, 0.5}).value();
    EXPECT_EQ(contact_points(box, cast_polygon(box, {2, 2, 3}, {0, 0, 4}, kGround), kGround).count, 0u);
    const PolygonHit hit = cast_polygon(box, {2, 2, 3}, {0, 0, -4}, kGround);
    EXPECT_EQ(contact_points(Hull(), hit, kGround).count, 0u);
    EXPECT_EQ(contact_points(box, hit, std::span(kGround).first(2)).count, 0u);
}

}  // namespace
}  // namespace firma
