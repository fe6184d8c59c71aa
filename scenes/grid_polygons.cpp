// SPDX-License-Identifier: MIT
// Seeded polygons on the surface grid.
#include "scenes/grid_polygons.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace firma::scenes {

namespace {

constexpr std::int64_t kLow = -(std::int64_t(1) << 31), kHigh = (std::int64_t(1) << 31) - 1;

std::int64_t whole_steps(Rng& rng, std::int64_t low, std::int64_t high) {
    return low + std::int64_t(rng.uniform() * double(high - low + 1));
}

std::int64_t turn(const std::pair<std::int64_t, std::int64_t>& a, const std::pair<std::int64_t, std::int64_t>& b,
                  const std::pair<std::int64_t, std::int64_t>& c) {
    return (b.first - a.first) * (c.second - a.second) - (b.second - a.second) * (c.first - a.first);
}

std::int64_t round_down(std::int64_t value, std::int64_t step) {
    const std::int64_t rest = ((value % step) + step) % step;
    return value - rest;
}

}  // namespace

Steps random_steps(Rng& rng, std::int64_t reach) {
    return {whole_steps(rng, -reach, reach), whole_steps(rng, -reach, reach), whole_steps(rng, -reach, reach)};
}

GridPoint in_world(const Steps& s, std::int64_t step) {
    const auto one = [&](std::int64_t value) { return std::int32_t(round_down(std::clamp(value, kLow, kHigh), step)); };
    return {one(s.x), one(s.y), one(s.z)};
}

bool along_one_line(const Steps& a, const Steps& b) {
    using Wrapping = std::uint64_t;
    const auto same = [](std::int64_t p, std::int64_t q, std::int64_t r, std::int64_t s) {
        return Wrapping(p) * Wrapping(q) == Wrapping(r) * Wrapping(s);
    };
    return same(a.y, b.z, a.z, b.y) && same(a.z, b.x, a.x, b.z) && same(a.x, b.y, a.y, b.x);
}

bool all_in_world(std::span<const Steps> corners) {
    return std::all_of(corners.begin(), corners.end(), [](const Steps& s) {
        return std::min({s.x, s.y, s.z}) >= kLow && std::max({s.x, s.y, s.z}) <= kHigh;
    });
}

WholeFrame random_frame(Rng& rng, int most) {
    std::int64_t a = 0, b = 0, c = 0, d = 0;
    while (a * a + b * b + c * c + d * d == 0) {
        a = whole_steps(rng, -most, most);
        b = whole_steps(rng, -most, most);
        c = whole_steps(rng, -most, most);
        d = whole_steps(rng, -most, most);
    }
    WholeFrame frame;
    frame.x = {a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)};
    frame.y = {2 * (b * c - a * d), a * a - b * b + c * c - d * d, 2 * (c * d + a * b)};
    frame.z = {2 * (b * d + a * c), 2 * (c * d - a * b), a * a - b * b - c * c + d * d};
    frame.length = a * a + b * b + c * c + d * d;
    return frame;
}

// Andrew's monotone chain; then points along the sides where wanted.
std::vector<std::pair<std::int64_t, std::int64_t>> lattice_polygon(Rng& rng, std::int64_t radius, int points,
                                                                   bool collinear) {
    using Point = std::pair<std::int64_t, std::int64_t>;
    std::vector<Point> hull;
    while (hull.size() < 3) {
        std::vector<Point> thrown;
        for (int k = 0; k < points; ++k) {
            double x = rng.uniform(-1, 1), y = rng.uniform(-1, 1);
            const double size = std::sqrt(x * x + y * y);
            if (points > 4 && size > 0.1) {  // toward the rim of a disc, for many corners
                const double out = (0.5 + 0.5 * std::sqrt(rng.uniform())) / size;
                x *= out;
                y *= out;
            }
            thrown.emplace_back(std::llround(x * double(radius)), std::llround(y * double(radius)));
        }
        std::sort(thrown.begin(), thrown.end());
        thrown.erase(std::unique(thrown.begin(), thrown.end()), thrown.end());
        hull.clear();
        for (int side = 0; side < 2; ++side) {
            const std::size_t base = hull.size();
            for (const Point& p : thrown) {
                while (hull.size() >= base + 2 && turn(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
                hull.push_back(p);
            }
            hull.pop_back();
            std::reverse(thrown.begin(), thrown.end());
        }
    }
    if (!collinear) return hull;
    std::vector<Point> more;
    for (std::size_t k = 0; k < hull.size(); ++k) {
        const Point &a = hull[k], &b = hull[(k + 1) % hull.size()];
        more.push_back(a);
        const std::int64_t parts = std::gcd(std::llabs(b.first - a.first), std::llabs(b.second - a.second));
        for (std::int64_t part = 1; part < std::min<std::int64_t>(parts, 4); ++part)
            if (rng.chance(0.5))
                more.emplace_back(a.first + (b.first - a.first) / parts * part,
                                  a.second + (b.second - a.second) / parts * part);
    }
    return more;
}

GridPolygon random_triangle(Rng& rng, const Steps& centre, std::int64_t reach, std::int64_t step) {
    for (;;) {
        GridPolygon corners;
        for (int k = 0; k < 3; ++k) corners.push_back(in_world(centre + random_steps(rng, reach), step));
        if (!along_one_line(steps(corners[1]) - steps(corners[0]), steps(corners[2]) - steps(corners[0])))
            return corners;
        reach += step;  // too tight
    }
}

GridPolygon random_polygon(Rng& rng, const Steps& centre, std::int64_t reach, std::int64_t step, int points,
                           bool collinear) {
    for (;;) {
        const int most = 1 + int(rng.below(reach / step < 40 ? 2 : 9));
        const Steps u = random_steps(rng, most) * step, v = random_steps(rng, most) * step;
        if (along_one_line(u, v)) continue;
        const std::int64_t longest = std::max(
            {std::llabs(u.x), std::llabs(u.y), std::llabs(u.z), std::llabs(v.x), std::llabs(v.y), std::llabs(v.z)});
        auto lattice = lattice_polygon(rng, std::max<std::int64_t>(1, reach / longest), points, collinear);
        while (lattice.size() > 64) lattice.erase(lattice.begin() + rng.below(std::uint32_t(lattice.size())));
        const GridPolygon polygon = on_plane(steps(in_world(centre, step)), u, v, lattice);
        if (!polygon.empty()) return polygon;
    }
}

GridPolygon on_plane(const Steps& origin, const Steps& u, const Steps& v,
                     std::span<const std::pair<std::int64_t, std::int64_t>> corners) {
    GridPolygon polygon;
    for (const auto& [i, j] : corners) {
        const Steps at = origin + u * i + v * j;
        if (!all_in_world({&at, 1})) return {};
        polygon.push_back(in_world(at));
    }
    return polygon;
}

GridPolygon turned_over(const GridPolygon& polygon) {
    return {polygon.rbegin(), polygon.rend()};
}

std::vector<Vec3> to_metres(const GridPolygon& polygon) {
    std::vector<Vec3> corners;
    for (const GridPoint& p : polygon) corners.push_back(firma::to_metres(p));
    return corners;
}

Vec3 unit_normal(const GridPolygon& polygon) {
    const std::vector<Vec3> v = to_metres(polygon);
    Vec3 normal;
    for (std::size_t k = 1; k + 1 < v.size(); ++k) normal = normal + cross(v[k] - v[0], v[k + 1] - v[0]);
    return normal * (1 / length(normal));
}

Level level_of(std::span<const GridPolygon> polygons, const std::vector<bool>& two_sided) {
    Level level;
    level.name = "seeded";
    level.materials = {""};
    level.groups = {""};
    std::map<GridPoint, std::uint32_t> index;
    for (const GridPolygon& polygon : polygons) {
        LevelFace face;
        face.first_corner = std::uint32_t(level.corners.size());
        face.corner_count = std::uint32_t(polygon.size());
        face.source = std::uint32_t(level.faces.size());
        face.two_sided = face.source < two_sided.size() && two_sided[face.source];
        for (const GridPoint& p : polygon) {
            const auto [entry, is_new] = index.try_emplace(p, std::uint32_t(level.vertices.size()));
            if (is_new) level.vertices.push_back(p);
            level.corners.push_back(entry->second);
        }
        level.faces.push_back(face);
    }
    level.source_faces = std::uint32_t(level.faces.size());
    return level;
}

}  // namespace firma::scenes
