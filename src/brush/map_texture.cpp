// SPDX-License-Identifier: MIT
// How a texture lies on a side of a .map.
//
// Source: the formulas that compilers of these games share, as in id Software, Quake III Arena source code, 2005,
// q3map/textures.c (Standard) and q3map/brush_primit.c, and Doom 3 source code, 2011, neo/idlib/MapFile.cpp (brush
// primitives).
#include "brush/map_texture.h"

#include <cmath>
#include <utility>

namespace firma {
namespace {

constexpr double kRightAngle = 1.57079632679489661923;
/// Normals at 45 degrees are as near to two axes: rounding must not choose.
constexpr double kNearer = 0.0001;
constexpr double kMostDegrees = 1e9;

struct Turn {
    double sine = 0, cosine = 1;
};

/// The same on every machine, and exact for right angles: the nearest one, and from there the series of sine and
/// cosine, to x^17 of an x of 0.79 at most.
Turn turn_by(double degrees) {
    const double whole = degrees - 360 * std::floor(degrees / 360);
    const int right_angles = int(std::floor((whole + 45) / 90));
    const double x = (whole - 90 * right_angles) / 90 * kRightAngle, square = x * x;
    double sine = 0, cosine = 0;
    for (int k = 17; k > 1; k -= 2) {
        sine = (1 + sine) * (-square / (k * (k - 1)));
        cosine = (1 + cosine) * (-square / ((k - 1) * (k - 2)));
    }
    sine = x * (1 + sine);
    cosine = 1 + cosine;
    switch (right_angles & 3) {
        case 1:
            return {cosine, -sine};
        case 2:
            return {-sine, -cosine};
        case 3:
            return {-cosine, sine};
        default:
            return {sine, cosine};
    }
}

struct Axes {
    Vec3 u, v;
};

/// The axes of the level that a texture lies along: those across the axis that is nearest to the normal; of equally
/// near ones z, then x.
Axes nearest_axes(const Vec3& normal) {
    const double x = std::fabs(normal.x), y = std::fabs(normal.y), z = std::fabs(normal.z);
    const bool along_x = x > z + kNearer;
    if (y > (along_x ? x : z) + kNearer) return {{1, 0, 0}, {0, 0, -1}};
    return along_x ? Axes{{0, 1, 0}, {0, 0, -1}} : Axes{{1, 0, 0}, {0, -1, 0}};
}

/// Turns the two axes of the level that they lie along into each other.
Axes turned(const Axes& axes, const Turn& turn) {
    const int s = axes.u.x != 0 ? 0 : 1, t = axes.v.y != 0 ? 1 : 2;
    Axes made;
    for (const auto& [from, to] : {std::pair(&axes.u, &made.u), std::pair(&axes.v, &made.v)}) {
        (*to)[s] = turn.cosine * (*from)[s] - turn.sine * (*from)[t];
        (*to)[t] = turn.sine * (*from)[s] + turn.cosine * (*from)[t];
    }
    return made;
}

/// Axes in a plane, by its normal alone: u level (z is up), v down along the slope.
Axes axes_in_plane(const Vec3& normal) {
    const double level = std::sqrt(normal.x * normal.x + normal.y * normal.y);
    constexpr double kUpright = 1e-6;  // of a normal 1 long: shorter is rounding
    const Vec3 ahead = level > kUpright ? Vec3{normal.x / level, normal.y / level, 0} : Vec3{1, 0, 0};
    return {{-ahead.y, ahead.x, 0}, {normal.z * ahead.x, normal.z * ahead.y, level > kUpright ? -level : 0}};
}

double or_one(double scale) {
    return scale == 0 ? 1 : scale;
}

}  // namespace

std::optional<TextureProjection> texture_of_side(const MapSide& side, double metres_a_unit) {
    // Clockwise seen from outside.
    const Vec3 across = cross(side.points[0] - side.points[1], side.points[2] - side.points[1]);
    const double size = length(across);
    if (!side.plane && (!(size > 0) || !is_finite(size))) return std::nullopt;
    const Vec3 normal = side.plane ? side.plane->normal : across * (1 / size);
    const MapAlignment& how = side.alignment;
    TextureProjection made;
    Axes axes;  // a unit
    if (how.form == MapAlignment::Form::kMatrix) {
        const Axes in_plane = axes_in_plane(normal);
        axes = {in_plane.u * how.u[0] + in_plane.v * how.u[1], in_plane.u * how.v[0] + in_plane.v * how.v[1]};
        made.u_offset = how.u[2];
        made.v_offset = how.v[2];
        made.unit = TextureUnit::kRepeats;
    } else {
        if (how.form == MapAlignment::Form::kAxes) {
            axes = {{how.u[0], how.u[1], how.u[2]}, {how.v[0], how.v[1], how.v[2]}};
        } else {
            if (!(std::fabs(how.rotation) <= kMostDegrees)) return std::nullopt;
            axes = turned(nearest_axes(normal), turn_by(how.rotation));
        }
        axes = {axes.u * (1 / or_one(how.scale[0])), axes.v * (1 / or_one(how.scale[1]))};
        made.u_offset = how.u[3];
        made.v_offset = how.v[3];
        made.unit = TextureUnit::kTexels;
    }
    made.u_axis = axes.u * (1 / metres_a_unit);
    made.v_axis = axes.v * (1 / metres_a_unit);
    return is_usable(made) ? std::optional(made) : std::nullopt;
}

}  // namespace firma
