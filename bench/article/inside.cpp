// SPDX-License-Identifier: MIT
// Is the hit point inside? The article's alpha and beta against signs of edges: what it costs, and what leaks at shared
// edges and vertices.
#include "article/questions.h"

#include <cmath>
#include <cstdio>

#include "cast/cast_particle_polygon.h"
#include "cast/sweep.h"
#include "firma/queries.h"
#include "naive/inside.h"
#include "scenes/closed_meshes.h"
#include "scenes/rng.h"
#include "scenes/room_grid.h"
#include "support/race.h"
#include "support/table.h"
#include "support/walk.h"

namespace firma::bench {
namespace {

using naive::PlainFace;
using naive::Vector;

template <class Real>
bool by_alpha_beta(const PlainFace<Real>& face, const Vector<Real>& pos, const Vector<Real>& path, Real time,
                   const naive::ViewAlong<Real>&) {
    return naive::alpha_beta_inside(face, path * time + pos);
}
template <class Real>
bool by_edge_signs(const PlainFace<Real>& face, const Vector<Real>& pos, const Vector<Real>& path, Real time,
                   const naive::ViewAlong<Real>&) {
    return naive::edge_signs_inside(face, path * time + pos);
}
template <class Real>
bool by_triple_products(const PlainFace<Real>& face, const Vector<Real>& pos, const Vector<Real>& path, Real,
                        const naive::ViewAlong<Real>&) {
    return naive::triple_product_inside(face, pos, path);
}
template <class Real>
bool by_projection(const PlainFace<Real>& face, const Vector<Real>& pos, const Vector<Real>&, Real,
                   const naive::ViewAlong<Real>& view) {
    return naive::line_meets_face(face, pos, view);
}

template <class Real>
using Inside = bool (*)(const PlainFace<Real>&, const Vector<Real>&, const Vector<Real>&, Real,
                        const naive::ViewAlong<Real>&);

constexpr std::size_t kWays = 6;
const char* const kWayNames[kWays] = {"alpha and beta, float (as printed)",  "alpha and beta, double",
                                      "edge signs on the hit point, double", "triple products, double",
                                      "projected along the ray, double",     "Firma: projected, exact when in doubt"};

// ------------------------------------------------------------------------------------------------------------- cost

/// A regular polygon with corners on the grid, on a plane that stays exact: z is a whole multiple of x plus one of y.
std::vector<Vec3> regular_polygon(int corners, int rise_x, int rise_y) {
    std::vector<Vec3> polygon;
    for (int k = 0; k < corners; ++k) {
        const double angle = 6.283185307179586 * k / corners;
        const double x = std::round(std::cos(angle) * kInputSteps) / kInputSteps;
        const double y = std::round(std::sin(angle) * kInputSteps) / kInputSteps;
        polygon.push_back({x, y, rise_x * x + rise_y * y});
    }
    return polygon;
}

/// Rays down through a polygon and beside it.
std::vector<scenes::CastQuery> rays_at(int rise_x, int rise_y, std::size_t count) {
    scenes::Rng rng(11);
    std::vector<scenes::CastQuery> rays(count);
    for (scenes::CastQuery& ray : rays) {
        const double x = rng.uniform(-1.2, 1.2), y = rng.uniform(-1.2, 1.2);
        const Vec3 target{x, y, rise_x * x + rise_y * y};
        ray.sphere.centre = target + Vec3{rng.uniform(-1, 1), rng.uniform(-1, 1), 8};
        ray.path = (target - ray.sphere.centre) * 1.5;
    }
    return rays;
}

/// One way, all rays at one face: plane and hit point are had already, as whoever asks has them.
template <class Real, Inside<Real> inside>
Contender plain_contender(const std::vector<Vec3>& corners, const std::vector<scenes::CastQuery>& rays) {
    struct Ray {
        Vector<Real> pos, path;
        Real time;
        naive::ViewAlong<Real> view;
    };
    const PlainFace<Real> face(corners);
    std::vector<Ray> ready;
    for (const scenes::CastQuery& ray : rays) {
        const Vector<Real> pos = naive::narrowed<Real>(ray.sphere.centre), path = naive::narrowed<Real>(ray.path);
        ready.push_back({pos, path, Real(1 / 1.5), naive::ViewAlong<Real>(path)});
    }
    return {"", [face, ready] {
                for (const Ray& ray : ready) keep(inside(face, ray.pos, ray.path, ray.time, ray.view));
            }};
}

Contender firma_contender(const std::vector<Vec3>& corners, const std::vector<scenes::CastQuery>& rays) {
    std::vector<Sweep> sweeps(rays.size());
    for (std::size_t k = 0; k < rays.size(); ++k) make_sweep(rays[k].sphere, rays[k].path, sweeps[k]);
    return {"", [&corners, sweeps] {
                const PolygonShape shape = make_shape(corners);
                for (const Sweep& sweep : sweeps) keep(line_meets_polygon(sweep, shape, -1));
            }};
}

bool measure_cost(const Settings& settings) {
    Table table("inside_cost",
                {"way", "corners 3, ns", "4", "6", "12", "3, ratio", "4, ratio", "6, ratio", "12, ratio"});
    const std::vector<scenes::CastQuery> rays = rays_at(1, -2, settings.few(20000));
    std::vector<std::vector<Lap>> laps;
    for (const int count : {3, 4, 6, 12}) {
        const std::vector<Vec3> corners = regular_polygon(count, 1, -2);
        const std::vector<Contender> contenders{plain_contender<float, &by_alpha_beta<float>>(corners, rays),
                                                plain_contender<double, &by_alpha_beta<double>>(corners, rays),
                                                plain_contender<double, &by_edge_signs<double>>(corners, rays),
                                                plain_contender<double, &by_triple_products<double>>(corners, rays),
                                                plain_contender<double, &by_projection<double>>(corners, rays),
                                                firma_contender(corners, rays)};
        laps.push_back(race(contenders, settings.rounds));
    }
    for (std::size_t k = 0; k < kWays; ++k) {
        std::vector<std::string> row{kWayNames[k]};
        for (const auto& of_count : laps) row.push_back(number(of_count[k].seconds / double(rays.size()) * 1e9));
        for (const auto& of_count : laps) row.push_back(times(of_count[k].ratio));
        table.add(row);
    }
    return table.finish(settings.csv);
}

// ------------------------------------------------------------------------------------------------------------- leaks

/// A ray from inside a closed room at a point that several faces share; it must not get past it.
struct AimedRay {
    scenes::CastQuery move;
    double target = 0;  ///< fraction at which the shared point lies
};

class Aim {
public:
    explicit Aim(const Level& level) : level_(level), faces_of_(level.vertices.size()) {
        for (std::uint32_t f = 0; f < level.faces.size(); ++f)
            for (std::uint32_t c = 0; c < level.faces[f].corner_count; ++c) faces_of_[corner(f, c)].push_back(f);
    }

    /// From `from` at a corner or a point of an edge, all of whose faces look at `from`. False when this one is no
    /// good.
    bool at(std::uint32_t vertex, bool at_edge, const Vec3& from, scenes::Rng& rng, AimedRay& ray) const {
        std::vector<std::uint32_t> around = faces_of_[vertex];
        Vec3 target = to_metres(level_.vertices[vertex]);
        if (at_edge) {
            const std::uint32_t face = around[rng.below(std::uint32_t(around.size()))];
            const std::uint32_t other = corner(face, rng.below(level_.faces[face].corner_count));
            if (other == vertex) return false;
            std::erase_if(around, [&](std::uint32_t f) { return !has(f, other); });
            target = target + (to_metres(level_.vertices[other]) - target) * rng.uniform();
        }
        for (const std::uint32_t face : around)
            if (!looks_at(face, from, target)) return false;
        const Vec3 way = target - from;
        const double scale = 256;  // a power of two: the direction is exactly the rounded difference
        ray = {{{from, 0}, way * scale}, 1 / scale};
        return true;
    }

    std::size_t vertices() const { return faces_of_.size(); }

private:
    std::uint32_t corner(std::uint32_t face, std::uint32_t c) const {
        return level_.corners[level_.faces[face].first_corner + c];
    }
    bool has(std::uint32_t face, std::uint32_t vertex) const {
        for (std::uint32_t c = 0; c < level_.faces[face].corner_count; ++c)
            if (corner(face, c) == vertex) return true;
        return false;
    }
    bool looks_at(std::uint32_t face, const Vec3& from, const Vec3& target) const {
        const Vec3 a = to_metres(level_.vertices[corner(face, 0)]), b = to_metres(level_.vertices[corner(face, 1)]),
                   c = to_metres(level_.vertices[corner(face, 2)]);
        const Vec3 normal = cross(b - a, c - a), to = from - target;
        return dot(normal, to) > 0.05 * length(normal) * length(to);
    }

    const Level& level_;
    std::vector<std::vector<std::uint32_t>> faces_of_;
};

std::vector<AimedRay> aimed_rays(const Level& level, const scenes::RoomGrid& grid, const Vec3& shift,
                                 std::size_t count) {
    using namespace scenes;
    const Aim aim(level);
    Rng rng(5);
    const std::vector<CastQuery> starts = casts_in_rooms(grid, {0.05, 0.05, 1, 1}, count, 6);
    std::vector<AimedRay> rays;
    for (std::size_t k = 0; rays.size() < count; ++k) {
        const Vec3 from = starts[k % count].sphere.centre + shift;
        AimedRay ray;
        if (aim.at(rng.below(std::uint32_t(aim.vertices())), k & 1, from, rng, ray)) rays.push_back(ray);
    }
    return rays;
}

/// Lost: no face is met up to the shared point and a millimetre more.
bool lost(bool met, double fraction, const AimedRay& ray) {
    return !met || fraction > ray.target + 1e-3 / length(ray.move.path);
}

/// A closed place and rays in it.
struct Place {
    Level level;
    std::vector<AimedRay> rays;
};

Place room(double away, std::size_t count) {
    const scenes::RoomGrid grid{1, 1, 1, 0.15, 1};
    Place place{room_grid(grid), {}};
    const Vec3 shift{away, -away, away};
    for (GridPoint& vertex : place.level.vertices)
        for (int axis = 0; axis < 3; ++axis) vertex[axis] += std::int32_t(shift[axis] * kSurfaceSteps);
    place.rays = aimed_rays(place.level, grid, shift, count);
    return place;
}

/// Closed meshes of a kind, anywhere in the world, with rays that must not get out at all.
std::vector<Place> closed_places(scenes::MeshKind kind, std::size_t count) {
    scenes::Rng rng(41);
    std::vector<Place> places;
    for (std::size_t rays = 0; rays < count;) {
        const scenes::ClosedMesh mesh = make_closed_mesh(kind, rng);
        Place place{scenes::level_of(mesh.faces), {}};
        for (int k = 0; k < 400; ++k, ++rays) place.rays.push_back({escaping_cast(mesh, false, rng), 1});
        places.push_back(std::move(place));
    }
    return places;
}

template <class Real>
std::size_t lost_by(Inside<Real> inside, const Place& place) {
    std::vector<PlainFace<Real>> faces;
    for (const LevelFace& face : place.level.faces) {
        std::vector<Vec3> corners;
        for (std::uint32_t c = 0; c < face.corner_count; ++c)
            corners.push_back(to_metres(place.level.vertices[place.level.corners[face.first_corner + c]]));
        faces.emplace_back(corners);
    }
    std::size_t count = 0;
    for (const AimedRay& ray : place.rays) {
        const Vector<Real> pos = naive::narrowed<Real>(ray.move.sphere.centre),
                           path = naive::narrowed<Real>(ray.move.path);
        const naive::ViewAlong<Real> view(path);
        Real first = 2;
        for (const PlainFace<Real>& face : faces) {
            Real time;
            if (!naive::collide_line_plane(pos, path, face.plane, time) || !(time < first)) continue;
            if (inside(face, pos, path, time, view)) first = time;
        }
        count += lost(first <= 1, double(first), ray);
    }
    return count;
}

std::size_t lost_by_firma(const Place& place) {
    const World world = world_of(place.level);
    std::size_t count = 0;
    for (const AimedRay& ray : place.rays) {
        const Hit hit = cast(world, ray.move.sphere, ray.move.path);
        count += lost(hit.touched(), hit.fraction, ray);
    }
    return count;
}

/// Rays lost of a million, by way.
std::vector<double> lost_of_a_million(const std::vector<Place>& places) {
    std::vector<double> lost(kWays, 0);
    std::size_t rays = 0;
    for (const Place& place : places) {
        rays += place.rays.size();
        lost[0] += double(lost_by<float>(&by_alpha_beta<float>, place));
        lost[1] += double(lost_by<double>(&by_alpha_beta<double>, place));
        lost[2] += double(lost_by<double>(&by_edge_signs<double>, place));
        lost[3] += double(lost_by<double>(&by_triple_products<double>, place));
        lost[4] += double(lost_by<double>(&by_projection<double>, place));
        lost[5] += double(lost_by_firma(place));
    }
    for (double& count : lost) count *= 1e6 / double(rays);
    return lost;
}

bool measure_leaks(const Settings& settings) {
    Table table("inside_leaks", {"lost of a million", "room at the origin", "room 8 km away", "fans of 3 to 64",
                                 "jittered voxels", "icospheres"});
    const std::size_t count = settings.few(200000);
    const std::vector<std::vector<double>> columns{
        lost_of_a_million({room(0, count)}), lost_of_a_million({room(8000, count)}),
        lost_of_a_million(closed_places(scenes::MeshKind::kBipyramid, count)),
        lost_of_a_million(closed_places(scenes::MeshKind::kJitteredRoom, count)),
        lost_of_a_million(closed_places(scenes::MeshKind::kIcosphere, count))};
    double firma = 0;
    for (std::size_t way = 0; way < kWays; ++way) {
        std::vector<std::string> row{kWayNames[way]};
        for (const auto& column : columns) row.push_back(number(column[way]));
        table.add(row);
    }
    for (const auto& column : columns) firma += column[kWays - 1];
    const bool written = table.finish(settings.csv);
    std::printf("\n%s rays from inside to each place, aimed at vertices, at edges, and (the last three) at faces\n",
                bench::count(count).c_str());
    return written && firma == 0;
}

}  // namespace

int measure_inside(const Settings& settings) {
    const bool cost = measure_cost(settings);
    return measure_leaks(settings) && cost ? 0 : 1;
}

}  // namespace firma::bench
