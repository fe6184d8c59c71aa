// SPDX-License-Identifier: MIT
// Covers a solid from inside with few spheres.
#include <algorithm>
#include <cmath>
#include <string>

#include "base/sort.h"
#include "body/choose_balls.h"
#include "body/cover_error.h"
#include "body/inner_ball.h"
#include "body/longest_axis.h"
#include "body/point_order.h"
#include "body/surface_points.h"
#include "firma/sphere_set.h"

namespace firma {
namespace {

/// Points of the surface that are to be covered, and balls to choose among, by how many spheres there may be.
constexpr double kPointsASphere = 24, kBallsASphere = 12, kMinPoints = 240, kMinBalls = 120;
constexpr double kMaxPoints = 2000, kMaxBalls = 800;
/// Of the error asked for, which part is left to what lies between points, and to measuring it.
constexpr double kMeasuredTo = 1.0 / 32;
/// Where points found are too far, they and balls near them are added, so many times.
constexpr int kRounds = 12;
/// A round that makes the error less by no more than this share was in vain.
constexpr double kGain = 1.0 / 16;
/// So many balls are made as large as they can become: one for two spheres, of many a dozen.
constexpr std::size_t kGrownEvery = 2, kMinGrown = 2, kMaxGrown = 12;
/// Of the distance between as many points as spheres, spread over the surface: what errors about come to.
constexpr double kErrorASpacing = 0.33;

struct Fitter {
    const Solid& solid;
    const FitOptions& options;
    const double error, reach;
    const int longest;  ///< axis of its box
    double area = 0;
    std::vector<SurfaceTriangle> triangles;
    BallChoice choice;
    PointCloud samples;  ///< of these: corners, and points within triangles

    /// Also one of those that balls are judged by.
    void add_sample(const Vec3& point) {
        choice.add_point(point);
        samples.add(point);
    }
    void add_ball(const SurfacePoint& at) {
        if (const std::optional<Sphere> ball = inner_ball(solid, samples, at, reach)) add_ball(*ball);
    }
    void add_ball(Sphere ball) {
        ball.radius -= options.margin;
        if (ball.radius > 0) choice.add_ball(ball);
    }

    /// Neighbours in the order are near each other then, so that whole rows of points can be passed over.
    static void sort_along(int axis, std::vector<Vec3>& points) {
        sort_range(points, [axis](const Vec3& a, const Vec3& b) {
            return a[axis] != b[axis] ? a[axis] < b[axis] : comes_before(a, b);
        });
    }

    void gather() {
        triangles = triangles_of(solid);
        for (const SurfaceTriangle& triangle : triangles) area += area_of(triangle);
        std::vector<Vec3> corners = corners_of(triangles);
        const double least = error / 2, count = double(options.max_spheres);
        const double some = std::clamp(kPointsASphere * count, kMinPoints, kMaxPoints);
        const double few = std::clamp(kBallsASphere * count, kMinBalls, kMaxBalls);
        const double spacing = std::max(least, std::sqrt(area / some));
        for (const SurfacePoint& point : surface_points(triangles, spacing)) corners.push_back(point.at);
        sort_along(longest, corners);
        for (const Vec3& point : corners) add_sample(point);
        std::vector<Vec3> sides = side_points(triangles, spacing / 2);
        sort_along(longest, sides);
        for (const Vec3& point : sides) choice.add_point(point);
        std::vector<Sphere> balls;
        for (const SurfacePoint& point : surface_points(triangles, std::max(least, std::sqrt(area / few))))
            if (const std::optional<Sphere> ball = inner_ball(solid, samples, point, reach)) balls.push_back(*ball);
        for (const Sphere& ball : grown_from(balls)) add_ball(ball);
        for (const Sphere& ball : balls) add_ball(ball);
    }

    /// The largest: balls from points of the surface seldom are.
    std::vector<Sphere> grown_from(std::vector<Sphere> largest) const {
        sort_range(largest, is_larger);
        const std::size_t most = std::clamp(options.max_spheres / kGrownEvery, kMinGrown, kMaxGrown);
        std::vector<Sphere> grown;
        for (const Sphere& ball : largest) {
            if (grown.size() == most) break;
            // One from within another comes to much the same.
            const auto holds = [&](const Sphere& other) {
                return length(other.centre - ball.centre) < 0.25 * other.radius;
            };
            if (std::none_of(grown.begin(), grown.end(), holds))
                grown.push_back(grown_ball(solid, samples, reach, ball));
        }
        return grown;
    }

    /// What is farther is too far: the error asked for, as long as there may be more spheres.
    double wanted(const BallChoice::Chosen& chosen) const {
        return chosen.balls.size() < options.max_spheres ? error * (1 - kMeasuredTo) : chosen.error;
    }

    /// Balls that touch near a point which is too far from all: small ones, such as fit into corners.
    void add_around(const Vec3& far) {
        add_sample(far);
        const std::size_t before = choice.balls().size();
        for (const SurfaceTriangle& triangle : triangles) {
            if (choice.balls().size() > before + 8) break;
            if (distance_to(triangle, far) > error) continue;
            const Vec3 to_middle = (triangle[0] + triangle[1] + triangle[2]) * (1.0 / 3) - far;
            const Vec3 twice = cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
            const double distance = length(to_middle);
            if (!(distance > 0)) continue;
            for (const double step : {0.25, 0.5, 1.0, 2.0}) {
                const double go = std::min(step * error, distance * 0.75);
                add_ball({far + to_middle * (go / distance), twice * (1 / length(twice))});
            }
        }
    }

    static double distance_to(const SurfaceTriangle& triangle, const Vec3& point) {
        double least = INFINITY;
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3 a = triangle[k], side = triangle[(k + 1) % 3] - a;
            const double along = std::clamp(dot(point - a, side) / dot(side, side), 0.0, 1.0);
            least = std::min(least, length(point - (a + side * along)));
        }
        return least;
    }
};

std::optional<Error> fault_of(const Solid& solid, const FitOptions& options) {
    const auto invalid = [](std::string reason) { return Error{ErrorCode::kInvalid, {}, std::move(reason)}; };
    if (solid.rock_outside()) return invalid("the solid reaches to infinity: only bodies are covered");
    if (solid.face_count() == 0) return invalid("the solid has no faces");
    if (!is_finite(options.max_error) || options.max_error < 0) return invalid("max_error is not finite or negative");
    if (!is_finite(options.margin) || options.margin < 0) return invalid("margin is not finite or negative");
    if (options.max_spheres < 1 || options.max_spheres > kMaxSpheres)
        return invalid("max_spheres is not within 1 to " + std::to_string(kMaxSpheres));
    return std::nullopt;
}

}  // namespace

Result<SphereFit> fit_spheres(const Solid& solid, const FitOptions& options) {
    if (std::optional<Error> fault = fault_of(solid, options)) return *std::move(fault);
    const Box box = solid.bounds();
    const Vec3 size = box.high - box.low;
    const double error = options.max_error > 0 ? options.max_error : max_abs(size) / 20;
    const Vec3 middle = (box.low + box.high) * 0.5;
    Fitter fitter{solid,
                  options,
                  error,
                  max_abs(size),
                  longest_axis(size),
                  0,
                  {},
                  BallChoice(middle, length(size)),
                  PointCloud(middle)};
    fitter.gather();
    SphereFit best;
    best.error = INFINITY;
    const double target = error * (1 - kMeasuredTo);
    double guess = kErrorASpacing * std::sqrt(fitter.area / double(options.max_spheres)), before = INFINITY;
    for (int round = 0; round < kRounds && !fitter.choice.balls().empty(); ++round) {
        const BallChoice::Chosen chosen = fitter.choice.choose(options.max_spheres, target, guess);
        SphereSet spheres;
        for (const std::uint32_t ball : chosen.balls) spheres.push_back(fitter.choice.balls()[ball]);
        const CoverError far =
            cover_error(fitter.triangles, spheres, fitter.wanted(chosen), chosen.error * kMeasuredTo);
        const bool is_full = spheres.size() == options.max_spheres;
        if (far.at_most < best.error) best = {std::move(spheres), far.at_most};
        // Else points of the surface were missed, or there were no balls near enough to some; more of these may do.
        const bool is_right = far.at_most <= chosen.error * (1 + 2 * kMeasuredTo);
        const bool in_vain = chosen.error > target && chosen.error > before * (1 - kGain);
        if (far.at_most <= error || (is_right && (is_full || in_vain))) break;
        guess = before = chosen.error;
        // Where there are too few spheres smaller balls gain nothing.
        for (const Vec3& point : far.too_far)
            chosen.error > target ? fitter.add_sample(point) : fitter.add_around(point);
    }
    if (best.spheres.empty()) return Error{ErrorCode::kInvalid, {}, "the solid has no room for a sphere"};
    sort_range(best.spheres, is_larger);
    return best;
}

Sphere sphere_around(const SphereSet& spheres) {
    Box box;
    for (const Sphere& sphere : spheres) {
        const Vec3 reach{sphere.radius, sphere.radius, sphere.radius};
        box.add(sphere.centre - reach);
        box.add(sphere.centre + reach);
    }
    Sphere around;
    if (box.empty()) return around;
    around.centre = (box.low + box.high) * 0.5;
    for (const Sphere& sphere : spheres)
        around.radius = std::max(around.radius, length(sphere.centre - around.centre) + sphere.radius);
    return around;
}

}  // namespace firma
