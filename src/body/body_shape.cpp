// SPDX-License-Identifier: MIT
// Shapes of bodies: spheres put into the frame of the principal axes.
#include "body/body_shape.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "body/principal_axes.h"
#include "geometry/rounding.h"

namespace firma {
namespace {

Error invalid(std::string reason) {
    return {ErrorCode::kInvalid, {}, std::move(reason)};
}

bool all_finite(const MassProperties& mass) {
    return is_finite(mass.mass) && is_finite(mass.centre) && is_finite(mass.inertia[0]) && is_finite(mass.inertia[1]) &&
           is_finite(mass.inertia[2]);
}

}  // namespace

BodyShape::BodyShape(std::shared_ptr<const BodyShapeData> data) : data_(std::move(data)) {}
std::span<const Sphere> BodyShape::spheres() const {
    return data_->given;
}
double BodyShape::mass() const {
    return data_->mass;
}
const Vec3& BodyShape::centre() const {
    return data_->centre;
}
const Vec3& BodyShape::moments() const {
    return data_->moments;
}
const Quaternion& BodyShape::axes() const {
    return data_->axes;
}
double BodyShape::reach() const {
    return data_->reach;
}

Result<BodyShape> make_body_shape(std::span<const Sphere> spheres, const MassProperties& mass) {
    if (spheres.empty() || spheres.size() > kMaxSpheres)
        return invalid("a body has 1 to " + std::to_string(kMaxSpheres) + " spheres, not " +
                       std::to_string(spheres.size()));
    for (std::size_t k = 0; k < spheres.size(); ++k)
        if (!is_finite(spheres[k].centre) || !is_finite(spheres[k].radius) || !(spheres[k].radius > 0))
            return invalid("sphere " + std::to_string(k) + " is not finite or has no radius");
        else if (std::max(max_abs(spheres[k].centre), spheres[k].radius) > kLargestNumber)
            return invalid("sphere " + std::to_string(k) + " is too far out or too large");
    if (!all_finite(mass) || !(mass.mass > 0) || !is_finite(1 / mass.mass))
        return invalid("the mass is not finite or not above zero");
    if (max_abs(mass.centre) > kLargestNumber) return invalid("the centre of mass is too far out");
    const PrincipalAxes axes = principal_axes(mass.inertia);
    // Inertia so uneven is no solid's, and would make turns too fast to follow.
    if (!is_finite(axes.moments) || !(axes.moments.z > axes.moments.x * 0x1p-30) || !is_finite(1 / axes.moments.z))
        return invalid("the inertia is not that of a solid");
    auto data = std::make_shared<BodyShapeData>();
    data->mass = mass.mass;
    data->centre = mass.centre;
    data->moments = axes.moments;
    data->axes = axes.rotation;
    data->given.assign(spheres.begin(), spheres.end());
    data->given_mass = mass;
    data->thinnest = spheres[0].radius;
    const TurnMatrix turn = matrix_of(axes.rotation);
    for (const Sphere& sphere : spheres) {
        const Vec3 centre = turn.back(sphere.centre - mass.centre);
        data->spheres.push_back({centre, sphere.radius});
        data->reach = std::max(data->reach, length(centre) + sphere.radius);
        data->thinnest = std::min(data->thinnest, sphere.radius);
    }
    return BodyShape(std::move(data));
}

MassProperties mass_of_ball(double radius, double density) {
    constexpr double kVolume = 4.1887902047863910;  // 4/3 pi
    MassProperties mass;
    mass.volume = kVolume * radius * radius * radius;
    mass.mass = mass.volume * density;
    for (int axis = 0; axis < 3; ++axis) mass.inertia[std::size_t(axis)][axis] = 0.4 * mass.mass * radius * radius;
    return mass;
}

MassProperties mass_of_box(const Vec3& half, double density) {
    MassProperties mass;
    mass.volume = 8 * half.x * half.y * half.z;
    mass.mass = mass.volume * density;
    const Vec3 square{half.x * half.x, half.y * half.y, half.z * half.z};
    const double all = square.x + square.y + square.z;
    for (int axis = 0; axis < 3; ++axis) mass.inertia[std::size_t(axis)][axis] = mass.mass / 3 * (all - square[axis]);
    return mass;
}

}  // namespace firma
