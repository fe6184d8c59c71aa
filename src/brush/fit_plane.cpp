// SPDX-License-Identifier: MIT
// Chooses three points of the grid for a plane.
#include "brush/fit_plane.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "geometry/grid_orient.h"

namespace firma {
namespace {

constexpr std::size_t kMostCandidates = 10;  // 120 triples

struct Lattice {
    FittedPlane::Points kind;
    double step;     // units; 0: the input grid itself
    double nearest;  // units, at each axis: a corner farther from the lattice was not meant to lie there
    double accept;   // units: a plane that fits so well is taken before finer lattices are looked at
};

// Floats of a plane 4096 units out place a corner to a thousandth of a unit or so; less sharp where planes meet at
// small angles.
constexpr Lattice kLattices[] = {
    {FittedPlane::Points::kWhole, 1, 0.05, 0.012},
    {FittedPlane::Points::kEighths, 0.125, 0.005, 0.004},
    {FittedPlane::Points::kGrid, 0, 0, 0},
};

std::optional<GridPoint> lattice_point(const Vec3& corner, const Lattice& lattice, double scale) {
    if (lattice.step == 0) return snap(corner * scale);
    Vec3 rounded;
    for (int axis = 0; axis < 3; ++axis) {
        rounded[axis] = std::floor(corner[axis] / lattice.step + 0.5) * lattice.step;
        if (!(std::fabs(rounded[axis] - corner[axis]) <= lattice.nearest)) return std::nullopt;
    }
    return snap(rounded * scale);
}

// As far apart from each other as they come: the first corner, then each time the one farthest from all chosen.
std::vector<GridPoint> spread(const std::vector<GridPoint>& points) {
    std::vector<GridPoint> chosen;
    if (points.empty()) return chosen;
    std::vector<double> away(points.size(), INFINITY);
    std::size_t next = 0;
    while (chosen.size() < kMostCandidates) {
        chosen.push_back(points[next]);
        const Vec3 last = to_metres(points[next]);
        next = 0;
        for (std::size_t k = 0; k < points.size(); ++k) {
            const Vec3 d = to_metres(points[k]) - last;
            away[k] = std::min(away[k], dot(d, d));
            if (away[k] > away[next]) next = k;
        }
        if (away[next] == 0) break;
    }
    return chosen;
}

class PlaneFitter {
public:
    PlaneFitter(const FloatPlane& plane, std::span<const Vec3> corners, double scale)
        : plane_(plane), corners_(corners), scale_(scale) {}

    std::optional<FittedPlane> fit() {
        for (const Lattice& lattice : kLattices) {
            std::vector<GridPoint> points;
            for (const Vec3& corner : corners_)
                if (const auto point = lattice_point(corner, lattice, scale_)) points.push_back(*point);
            try_triples(spread(points), lattice.kind);
            if (best_ && best_->shift <= lattice.accept * scale_) break;
        }
        return best_;
    }

private:
    void try_triples(const std::vector<GridPoint>& points, FittedPlane::Points kind) {
        for (std::size_t a = 0; a < points.size(); ++a)
            for (std::size_t b = a + 1; b < points.size(); ++b)
                for (std::size_t c = b + 1; c < points.size(); ++c) try_triple(points[a], points[b], points[c], kind);
    }

    void try_triple(const GridPoint& a, GridPoint b, GridPoint c, FittedPlane::Points kind) {
        const AreaVector exact = area_vector(to_input(a), to_input(b), to_input(c));
        if (exact.x == 0 && exact.y == 0 && exact.z == 0) return;
        if (dot({double(exact.x), double(exact.y), double(exact.z)}, plane_.normal) < 0) std::swap(b, c);
        const auto through = float_plane(to_metres(a), to_metres(b), to_metres(c));
        if (!through) return;
        double shift = 0;
        for (const Vec3& corner : corners_) {
            if (max_abs(corner) * scale_ > kWorldRim) continue;  // of a face without an end
            shift = std::max(shift, std::fabs(dot(through->normal, corner * scale_) - through->distance));
            if (best_ && shift >= best_->shift) return;
        }
        best_ = FittedPlane{{a, b, c}, kind, shift};
    }

    const FloatPlane& plane_;
    std::span<const Vec3> corners_;
    double scale_;
    std::optional<FittedPlane> best_;
};

}  // namespace

std::optional<int> axis_of(const FloatPlane& plane) {
    for (int axis = 0; axis < 3; ++axis)
        if (plane.normal[(axis + 1) % 3] == 0 && plane.normal[(axis + 2) % 3] == 0) return axis;
    return std::nullopt;
}

std::optional<FittedPlane> fit_axial_plane(const FloatPlane& plane, int axis, double scale) {
    const double metres = plane.distance / plane.normal[axis] * scale;
    Vec3 points[3];
    for (Vec3& point : points) point[axis] = metres;
    const bool up = plane.normal[axis] > 0;
    points[up ? 1 : 2][(axis + 1) % 3] = 1;
    points[up ? 2 : 1][(axis + 2) % 3] = 1;
    FittedPlane fitted;
    fitted.kind = FittedPlane::Points::kAxial;
    for (int k = 0; k < 3; ++k) {
        const auto point = snap(points[k]);
        if (!point) return std::nullopt;
        fitted.points[k] = *point;
    }
    fitted.shift = std::fabs(to_metres(fitted.points[0])[axis] - metres);
    return fitted;
}

std::optional<FittedPlane> fit_plane(const FloatPlane& plane, std::span<const Vec3> corners, double scale) {
    return PlaneFitter(plane, corners, scale).fit();
}

std::optional<FittedPlane> fit_bare_plane(const FloatPlane& plane, double scale) {
    constexpr double kApart = 64;  // metres
    const FloatPlane lone[] = {plane};
    return fit_plane(plane, winding(lone, 0, kApart / scale), scale);
}

}  // namespace firma
