// SPDX-License-Identifier: MIT
// Turns, and sine and cosine of our own.
// Source: W. J. Cody, W. Waite, Software Manual for the Elementary Functions, 1980 (how an angle is brought near zero).
#include "firma/turn.h"

#include <cmath>

namespace firma {
namespace {

// A quarter turn in three parts, the first two of 33 bits: a whole number of 20 bits times one of these is exact.
constexpr double kQuarter1 = 0x1.921fb544p+0, kQuarter2 = 0x1.0b4611a6p-34, kQuarter3 = 0x1.3198a2e037073p-69;
constexpr double kQuartersPerRadian = 0x1.45f306dc9c883p-1;

/// x + low, |x| at most an eighth of a turn, with low far below x.
struct SmallAngle {
    double x, low;
};

// Taylor's series, each up to a term below 2^-60.
double sine_of(const SmallAngle& angle) {
    constexpr double kTerms[] = {-0x1.ae7f3e733b81fp-41, 0x1.6124613a86d09p-33,  -0x1.ae64567f544e4p-26,
                                 0x1.71de3a556c734p-19,  -0x1.a01a01a01a01ap-13, 0x1.1111111111111p-7,
                                 -0x1.5555555555555p-3};
    const double square = angle.x * angle.x;
    double sum = 0x1.952c77030ad4ap-49;
    for (const double term : kTerms) sum = sum * square + term;
    return angle.x + (angle.low * (1 - square * 0.5) + angle.x * square * sum);
}

double cosine_of(const SmallAngle& angle) {
    // 1/16!, -1/14!, ... 1/4!
    constexpr double kTerms[] = {-0x1.93974a8c07c9dp-37, 0x1.1eed8eff8d898p-29,  -0x1.27e4fb7789f5cp-22,
                                 0x1.a01a01a01a01ap-16,  -0x1.6c16c16c16c17p-10, 0x1.5555555555555p-5};
    const double square = angle.x * angle.x;
    double sum = 0x1.ae7f3e733b81fp-45;
    for (const double term : kTerms) sum = sum * square + term;
    // 1 - square/2, with what its rounding leaves.
    const double half = square * 0.5, rough = 1 - half, rest = (1 - rough) - half;
    return rough + (rest + (square * square * sum - angle.x * angle.low));
}

}  // namespace

SineCosine sine_cosine(double radians) {
    if (!(std::fabs(radians) <= kMaxAngle)) return {NAN, NAN};
    const double quarters = std::floor(radians * kQuartersPerRadian + 0.5);
    const double first = radians - quarters * kQuarter1, second = quarters * kQuarter2;
    const double x = first - second;
    const SmallAngle angle{x, ((first - x) - second) - quarters * kQuarter3};
    const double sine = sine_of(angle), cosine = cosine_of(angle);
    switch (int(quarters - 4 * std::floor(quarters * 0.25))) {
        case 0:
            return {sine, cosine};
        case 1:
            return {cosine, -sine};
        case 2:
            return {-sine, -cosine};
        default:
            return {-cosine, sine};
    }
}

Quaternion turn_by(const Vec3& rotation) {
    const double angle = length(rotation);
    if (!(angle > 0 && angle <= kMaxAngle)) return {0, 0, 0, 1};
    const SineCosine half = sine_cosine(angle * 0.5);
    const Vec3 axis = rotation * (half.sine / angle);
    return {axis.x, axis.y, axis.z, half.cosine};
}

Quaternion compose(const Quaternion& a, const Quaternion& b) {
    const Vec3 u{a[0], a[1], a[2]}, v{b[0], b[1], b[2]};
    const Vec3 w = v * a[3] + u * b[3] + cross(u, v);
    return {w.x, w.y, w.z, a[3] * b[3] - dot(u, v)};
}

Quaternion normalised(const Quaternion& turn) {
    const Vec3 v{turn[0], turn[1], turn[2]};
    const double size = std::sqrt(dot(v, v) + turn[3] * turn[3]);
    if (!(size > 0) || !is_finite(size)) return {0, 0, 0, 1};
    return {turn[0] / size, turn[1] / size, turn[2] / size, turn[3] / size};
}

TurnMatrix matrix_of(const Quaternion& q) {
    const auto [x, y, z, w] = q;
    return {{{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
             {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
             {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}}};
}

Quaternion turn_of_axes(const Vec3& x, const Vec3& y, const Vec3& z) {
    // The largest of the four squares is at least 1, so its root divides well.
    const double squares[4] = {1 + x.x - y.y - z.z, 1 - x.x + y.y - z.z, 1 - x.x - y.y + z.z, 1 + x.x + y.y + z.z};
    int largest = 0;
    for (int k = 1; k < 4; ++k)
        if (squares[k] > squares[largest]) largest = k;
    const double s = squares[largest];
    const double xy = x.y + y.x, yz = y.z + z.y, zx = z.x + x.z, wx = y.z - z.y, wy = z.x - x.z, wz = x.y - y.x;
    switch (largest) {
        case 0:
            return normalised({s, xy, zx, wx});
        case 1:
            return normalised({xy, s, yz, wy});
        case 2:
            return normalised({zx, yz, s, wz});
        default:
            return normalised({wx, wy, wz, s});
    }
}

}  // namespace firma
