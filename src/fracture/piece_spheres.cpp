// SPDX-License-Identifier: MIT
// Spheres for pieces: balls from points of the surface, of these few that are near most of it.
#include "fracture/piece_spheres.h"

#include <algorithm>
#include <cmath>

#include "base/sort.h"
#include "body/choose_balls.h"
#include "body/inner_ball.h"
#include "body/point_order.h"
#include "body/surface_points.h"

namespace firma {
namespace {

/// Points that are to be covered and balls to choose among, for each sphere.
constexpr double kPiecePoints = 8, kPieceBalls = 4;
/// Of the longest side of its box: what is nearer to a sphere is near enough.
constexpr double kNearEnough = 1.0 / 20;

}  // namespace

SphereFit piece_spheres(const Solid& solid, std::size_t max_spheres) {
    const Box box = solid.bounds();
    const Vec3 size = box.high - box.low, middle = (box.low + box.high) * 0.5;
    const double reach = max_abs(size), count = double(max_spheres);
    const std::vector<SurfaceTriangle> triangles = triangles_of(solid);
    double area = 0;
    for (const SurfaceTriangle& triangle : triangles) area += area_of(triangle);
    if (!(area > 0)) return {};
    BallChoice choice(middle, length(size));
    PointCloud samples(middle);
    const auto add_sample = [&](const Vec3& point) {
        choice.add_point(point);
        samples.add(point);
    };
    for (const Vec3& corner : corners_of(triangles)) add_sample(corner);
    for (const SurfacePoint& point : surface_points(triangles, std::sqrt(area / (kPiecePoints * count))))
        add_sample(point.at);
    std::vector<Sphere> balls;
    for (const SurfacePoint& point : surface_points(triangles, std::sqrt(area / (kPieceBalls * count))))
        if (const std::optional<Sphere> ball = inner_ball(solid, samples, point, reach)) balls.push_back(*ball);
    if (balls.empty()) return {};
    choice.add_ball(grown_ball(solid, samples, reach, *std::min_element(balls.begin(), balls.end(), is_larger)));
    for (const Sphere& ball : balls) choice.add_ball(ball);
    const double error = reach * kNearEnough;
    const BallChoice::Chosen chosen = choice.choose(max_spheres, error, 2 * error);
    SphereFit fit;
    fit.error = chosen.error;
    for (const std::uint32_t ball : chosen.balls) fit.spheres.push_back(choice.balls()[ball]);
    sort_range(fit.spheres, is_larger);
    return fit;
}

}  // namespace firma
