// SPDX-License-Identifier: MIT
// How long a body that spins freely takes from one tumble to the next: Euler's equations have a closed form.
#pragma once

#include <cmath>
#include <numbers>
#include <utility>

#include "firma/bodies.h"

namespace firma::test {

/// The complete elliptic integral of the first kind, by the arithmetic-geometric mean.
/// @param m  the square of the modulus, below 1
inline double complete_elliptic(double m) {
    double a = 1, b = std::sqrt(1 - m);
    for (int k = 0; k < 40 && std::fabs(a - b) > 1e-15 * a; ++k) {
        const double mean = (a + b) / 2;
        b = std::sqrt(a * b);
        a = mean;
    }
    return std::numbers::pi / (2 * a);
}

/// Of the spin in the principal axes, largest moment first: axes times moments as BodyShape has them.
inline Vec3 principal_spin(const Body& body) {
    return matrix_of(body.shape.axes()).back(matrix_of(normalised(body.rotation)).back(body.spin));
}

/// Seconds between two times at which the spin about the middle axis is zero.
inline double half_period(const Vec3& moments, const Vec3& spin) {
    double squared = 0, twice_energy = 0;
    for (int axis = 0; axis < 3; ++axis) {
        squared += moments[axis] * moments[axis] * spin[axis] * spin[axis];
        twice_energy += moments[axis] * spin[axis] * spin[axis];
    }
    double large = moments.x, small = moments.z;
    const double middle = moments.y;
    if (squared < twice_energy * middle) std::swap(large, small);
    const double ahead = squared - twice_energy * small, behind = twice_energy * large - squared;
    const double rate = std::sqrt((large - middle) * ahead / (moments.x * moments.y * moments.z));
    return 2 * complete_elliptic((middle - small) * behind / ((large - middle) * ahead)) / rate;
}

}  // namespace firma::test
