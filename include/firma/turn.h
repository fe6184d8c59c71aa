// SPDX-License-Identifier: MIT
// Turns of bodies: quaternions, and the sine and cosine that they need, the same bits on every machine.
#pragma once

#include "firma/cutter.h"
#include "firma/export.h"
#include "firma/vec.h"

namespace firma {

/// Radians.
inline constexpr double kMaxAngle = 0x1p20;

struct SineCosine {
    double sine = 0, cosine = 1;
};

/// Both of an angle, each within 2^-52 of the true value. Not from libm, which differs between platforms. NaN for what
/// is not finite or beyond kMaxAngle. Never allocates.
[[nodiscard]] FIRMA_EXPORT SineCosine sine_cosine(double radians);

/// A turn about an axis through the origin, right-handed.
/// @param rotation  the axis times the angle in radians; zero turns nothing, nor does what is not finite
///                  or beyond kMaxAngle
/// @return of length 1 but for rounding
[[nodiscard]] FIRMA_EXPORT Quaternion turn_by(const Vec3& rotation);

/// The turn that does `first`, then `second`. Not normalised.
[[nodiscard]] FIRMA_EXPORT Quaternion compose(const Quaternion& second, const Quaternion& first);

/// The turn back.
[[nodiscard]] inline Quaternion turn_back(const Quaternion& turn) {
    return {-turn[0], -turn[1], -turn[2], turn[3]};
}

/// Of length 1; no turn for zero and for what is not finite.
[[nodiscard]] FIRMA_EXPORT Quaternion normalised(const Quaternion& turn);

/// A turn as a matrix: its rows. Points are turned with three products each.
struct TurnMatrix {
    Vec3 rows[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

    FIRMA_INLINE Vec3 operator*(const Vec3& v) const { return {dot(rows[0], v), dot(rows[1], v), dot(rows[2], v)}; }
    /// By the turn back.
    FIRMA_INLINE Vec3 back(const Vec3& v) const { return rows[0] * v.x + rows[1] * v.y + rows[2] * v.z; }
    [[nodiscard]] Vec3 column(int axis) const { return {rows[0][axis], rows[1][axis], rows[2][axis]}; }
};

/// @param turn  of length 1
[[nodiscard]] FIRMA_EXPORT TurnMatrix matrix_of(const Quaternion& turn);

/// The turn of a right-handed frame: its axes as columns.
[[nodiscard]] FIRMA_EXPORT Quaternion turn_of_axes(const Vec3& x, const Vec3& y, const Vec3& z);

}  // namespace firma
