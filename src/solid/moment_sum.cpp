// SPDX-License-Identifier: MIT
// Each triangle (a, b, c) makes a cone with the apex o, of six times the volume D = a . b x c about o. Over a cone
//   integral of 1 = D / 6,   of x = D / 24 (a + b + c),
//   of x_i x_j = D / 120 (a_i a_j + b_i b_j + c_i c_j + s_i s_j),   s = a + b + c.
// A face is a fan of triangles around the first corner of each loop, those that run against it negative. As in
// measure_boundary.cpp, D = -d S / n[k]: n . p + d = 0 is the face's plane about o, k its dominant axis, S twice the
// triangle's area as seen along k.
#include "solid/moment_sum.h"

#include <cmath>

#include "geometry/flat_point.h"
#include "solid/boundary.h"
#include "solid/measure_boundary.h"
#include "solid/solid_data.h"

namespace firma {

namespace {

/// Twice the area of a triangle, as seen along an axis that leaves u and v.
DoubleDouble twice_flat_area(const PointArm& a, const PointArm& b, const PointArm& c, int u, int v) {
    return (b.at[u] - a.at[u]) * (c.at[v] - a.at[v]) - (b.at[v] - a.at[v]) * (c.at[u] - a.at[u]);
}

/// -d / n[k].
DoubleDouble cone_factor(const Plane& plane, int k, const InputPoint& apex) {
    Int256 offset = plane.offset();
    for (int axis = 0; axis < 3; ++axis) offset = offset + product(plane.normal[axis], apex[axis]);
    return -to_double_double(offset) / DoubleDouble(double(plane.normal[k]));
}

}  // namespace

PointArm arm_of(const ExactPoint& point, const InputPoint& apex) {
    PointArm made;
    if (point.on_grid()) {
        const InputPoint grid = point.grid();
        for (int axis = 0; axis < 3; ++axis) made.at[axis] = double(std::int64_t(grid[axis]) - apex[axis]);
        return made;
    }
    const Meet m = meet(*point.plane(0), *point.plane(1), *point.plane(2));
    const Int256* const numerators[3] = {&m.x, &m.y, &m.z};
    const DoubleDouble w = to_double_double(m.w);
    for (int axis = 0; axis < 3; ++axis)
        made.at[axis] = to_double_double(*numerators[axis] - m.w * std::int64_t(apex[axis])) / w;
    return made;
}

void MomentSum::add_cones(const Plane& plane, std::span<const std::uint32_t> ends) {
    if (ends.empty() || !plane.valid()) return;  // a face without area
    const int k = plane.dominant_axis(), u = FlatView{k}.u(), v = FlatView{k}.v();
    Moments of_face{};
    std::uint32_t first = 0;
    for (const std::uint32_t end : ends) {
        const PointArm& a = arms_[first];
        for (std::uint32_t at = first + 1; at + 1 < end; ++at) {
            const PointArm &b = arms_[at], &c = arms_[at + 1];
            const DoubleDouble s = twice_flat_area(a, b, c, u, v);
            of_face.volume = of_face.volume + s;
            DoubleDouble sum[3];
            for (int i = 0; i < 3; ++i) {
                sum[i] = a.at[i] + b.at[i] + c.at[i];
                of_face.first[i] = of_face.first[i] + s * sum[i];
            }
            for (int i = 0; i < 3; ++i)
                for (int j = i; j < 3; ++j)
                    of_face.second[i][j] = of_face.second[i][j] + s * (a.at[i] * a.at[j] + b.at[i] * b.at[j] +
                                                                       c.at[i] * c.at[j] + sum[i] * sum[j]);
        }
        first = end;
    }
    const DoubleDouble factor = cone_factor(plane, k, apex_);
    sums_.volume = sums_.volume + factor * of_face.volume / DoubleDouble(6);
    for (int i = 0; i < 3; ++i) {
        sums_.first[i] = sums_.first[i] + factor * of_face.first[i] / DoubleDouble(24);
        for (int j = i; j < 3; ++j)
            sums_.second[i][j] = sums_.second[i][j] + factor * of_face.second[i][j] / DoubleDouble(120);
    }
}

void MomentSum::add_cone_volumes(const Plane& plane, std::span<const std::uint32_t> ends) {
    if (ends.empty() || !plane.valid()) return;
    const int k = plane.dominant_axis(), u = FlatView{k}.u(), v = FlatView{k}.v();
    DoubleDouble area;
    std::uint32_t first = 0;
    for (const std::uint32_t end : ends) {
        for (std::uint32_t at = first + 1; at + 1 < end; ++at)
            area = area + twice_flat_area(arms_[first], arms_[at], arms_[at + 1], u, v);
        first = end;
    }
    sums_.volume = sums_.volume + cone_factor(plane, k, apex_) * area / DoubleDouble(6);
}

void add_moments(Moments& to, const Moments& other, double factor) {
    const DoubleDouble times(factor);
    to.volume = to.volume + times * other.volume;
    for (int i = 0; i < 3; ++i) {
        to.first[i] = to.first[i] + times * other.first[i];
        for (int j = i; j < 3; ++j) to.second[i][j] = to.second[i][j] + times * other.second[i][j];
    }
}

MassProperties mass_of(const Moments& m, const InputPoint& apex, double density) {
    MassProperties mass;
    if (!(m.volume.high > 0) || !(density >= 0) || density == INFINITY) return mass;
    constexpr double kStep = 1 / kInputSteps, kCube = kStep * kStep * kStep;
    mass.volume = rounded(m.volume) * kCube;
    mass.mass = rounded(m.volume * DoubleDouble(density)) * kCube;
    DoubleDouble centre[3];
    for (int i = 0; i < 3; ++i) {
        centre[i] = m.first[i] / m.volume;
        mass.centre[i] = rounded(centre[i] + DoubleDouble(double(apex[i]))) * kStep;
    }
    DoubleDouble spread[3][3];  // second moments about the centre
    for (int i = 0; i < 3; ++i)
        for (int j = i; j < 3; ++j) spread[i][j] = spread[j][i] = m.second[i][j] - m.first[i] * centre[j];
    const DoubleDouble trace = spread[0][0] + spread[1][1] + spread[2][2];
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const DoubleDouble about = i == j ? trace - spread[i][i] : -spread[i][j];
            mass.inertia[std::size_t(i)][j] = rounded(about * DoubleDouble(density)) * kCube * kStep * kStep;
        }
    return mass;
}

Moments moments_of(const SolidPatch& patch, const InputPoint& apex) {
    std::vector<PointArm> arms;
    arms.reserve(patch.vertices.size());
    for (const PatchVertex& vertex : patch.vertices) arms.push_back(arm_of(vertex.point, apex));
    MomentSum sum(apex);
    for (const PatchFace& face : patch.faces) {
        const auto uses = patch.uses(face);
        sum.add_arms(face.plane->plane, patch.ends(face), [&](std::uint32_t k) { return arms[patch.from(uses[k])]; });
    }
    return sum.sums();
}

MassProperties mass_properties(const Solid& solid, double density) {
    if (solid.rock_outside() || solid.face_count() == 0) return {};
    const Boundary boundary = take_boundary(solid.data().faces.root.get());
    const SolidPatch& patch = boundary.patch;
    GridBox box;
    for (const PatchFace& face : patch.faces) box.add(face.box);
    const InputPoint apex = middle_of(box);
    return mass_of(moments_of(patch, apex), apex, density);
}

}  // namespace firma
