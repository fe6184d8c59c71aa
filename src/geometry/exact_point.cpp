// SPDX-License-Identifier: MIT
// Points where planes meet, and the signs asked of them.
#include "geometry/exact_point.h"

#include <cmath>
#include <limits>

#include "base/assert.h"

namespace firma {
namespace {

thread_local std::uint64_t fallbacks = 0;

struct Cross {
    Int128 x, y, z;
};

/// Of the normals: components of at most 2^105.
Cross cross(const Plane& a, const Plane& b) {
    return {normal_minor(a, b, 1, 2), normal_minor(a, b, 2, 0), normal_minor(a, b, 0, 1)};
}

/// The nearest surface coordinate to numerator / denominator input steps, of which `estimate` is an approximation.
std::int32_t round_to_surface(double estimate, const Int256& numerator, const Int256& denominator) {
    constexpr std::int64_t kLast = std::numeric_limits<std::int32_t>::max();
    if (!(std::fabs(estimate) <= kRimSteps + kApproximation)) return estimate < 0 ? std::int32_t(-kLast - 1) : kLast;

    const double scaled = estimate * kSurfacePerInput;  // exact, and off by at most 64 * kApproximation
    std::int64_t nearest = std::int64_t(scaled + (scaled < 0 ? -0.5 : 0.5));
    // Twice that error leaves room for the rounding of the difference itself.
    if (!(std::fabs(scaled - double(nearest)) < 0.5 - 2 * kSurfacePerInput * kApproximation))
        nearest = divide_rounded(numerator * std::int64_t(kSurfacePerInput), denominator);
    return std::int32_t(nearest > kLast ? kLast : nearest < -kLast - 1 ? -kLast - 1 : nearest);
}

/// Of three planes whose sizes multiply to at most this, every determinant fits 128 bits: a component of a cross
/// product is at most the product of two sizes, an offset the third times 2^25, and three of those products are added.
constexpr double kFitsInt128 = 0x1p+98;
static_assert(3 * kFitsInt128 * kRimSteps < 0x1p+126);  // and room for the rounding of sizes

/// Small faces, so nearly all.
Meet meet_small(const Cross& bc, const Cross& ca, const Cross& ab, const Plane& a, const Plane& b, const Plane& c) {
    const Int128 w = bc.x * a.normal[0] + bc.y * a.normal[1] + bc.z * a.normal[2];
    const Int128 da = w < 0 ? a.offset() : -a.offset();
    const Int128 db = w < 0 ? b.offset() : -b.offset();
    const Int128 dc = w < 0 ? c.offset() : -c.offset();
    return {bc.x * da + ca.x * db + ab.x * dc, bc.y * da + ca.y * db + ab.y * dc, bc.z * da + ca.z * db + ab.z * dc,
            w < 0 ? -w : w};
}

int sign_of(Int128 value) {
    return value > 0 ? 1 : value < 0 ? -1 : 0;
}

}  // namespace

// Cramer's rule for normal . p = -offset, three times:
//   (x, y, z) = -(da * nb x nc + db * nc x na + dc * na x nb),  w = na . (nb x nc).
// With normals of at most 2^52 and offsets of at most 2^77 the determinants are at most 4 * 2^181 and 4 * 2^156.
Meet meet(const Plane& a, const Plane& b, const Plane& c) {
    const Cross bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
    if (a.size * b.size * c.size <= kFitsInt128) return meet_small(bc, ca, ab, a, b, c);
    const Int256 w = product(bc.x, a.normal[0]) + product(bc.y, a.normal[1]) + product(bc.z, a.normal[2]);
    const bool negative = w.sign() < 0;
    // The minus of the rule, and the sign of w, go into the offsets.
    const Int128 da = negative ? a.offset() : -a.offset();
    const Int128 db = negative ? b.offset() : -b.offset();
    const Int128 dc = negative ? c.offset() : -c.offset();
    return {product(bc.x, da) + product(ca.x, db) + product(ab.x, dc),
            product(bc.y, da) + product(ca.y, db) + product(ab.y, dc),
            product(bc.z, da) + product(ca.z, db) + product(ab.z, dc), negative ? -w : w};
}

// Where w is not 0, the sums below stay far below 2^255.
bool meet_in_world(const Plane& a, const Plane& b, const Plane& c) {
    const Meet m = meet(a, b, c);
    if (m.w.sign() <= 0) return false;
    const Int256 rim = m.w * std::int64_t(kRimSteps);
    for (const Int256* coordinate : {&m.x, &m.y, &m.z})
        if ((rim - *coordinate).sign() < 0 || (rim + *coordinate).sign() < 0) return false;
    return true;
}

ExactPoint::ExactPoint(const InputPoint& point)
    : approximate_{double(point.x), double(point.y), double(point.z)}, rounded_(to_surface(point)) {}

// approximate(): three roundings (numerator, denominator, quotient) of a number of at most 2^25 are off by no more than
// rounding(3) * 2^25 < 3.01 * 2^-28.
ExactPoint::ExactPoint(const Plane& a, const Plane& b, const Plane& c) : planes_{&a, &b, &c} {
    static_assert(rounding(3) * kRimSteps < kApproximation);
    const Meet m = meet(a, b, c);
    FIRMA_ASSERT(m.w.sign() > 0, "the three planes of a point meet in one: ask exact_turn() first");
    const double w = m.w.to_double();
    approximate_ = {m.x.to_double() / w, m.y.to_double() / w, m.z.to_double() / w};
    FIRMA_ASSERT(max_abs(approximate_) <= kRimSteps + kApproximation, "points lie within the world");
    rounded_ = {round_to_surface(approximate_.x, m.x, m.w), round_to_surface(approximate_.y, m.y, m.w),
                round_to_surface(approximate_.z, m.z, m.w)};
}

int exact_side_by_integers(const Plane& plane, const ExactPoint& point) {
    ++fallbacks;
    if (point.on_grid()) {
        const InputPoint grid = point.grid();
        Int128 sum = plane.offset();
        for (int axis = 0; axis < 3; ++axis) sum += Int128(plane.normal[axis]) * grid[axis];
        return sign_of(sum);
    }
    for (int k = 0; k < 3; ++k)
        if (*point.plane(k) == plane) return 0;
    const Meet m = meet(*point.plane(0), *point.plane(1), *point.plane(2));
    // The 4x4 determinant of the planes: at most 16 * 2^(3 * 52 + 77).
    return (m.x * plane.normal[0] + m.y * plane.normal[1] + m.z * plane.normal[2] + m.w * plane.offset()).sign();
}

bool lies_on(const Plane& plane, const ExactPoint& point) {
    const auto opposite = [&](const Plane& own) {
        return own.offset() == -plane.offset() && own.normal[0] == -plane.normal[0] &&
               own.normal[1] == -plane.normal[1] && own.normal[2] == -plane.normal[2];
    };
    for (int k = 0; k < 3 && !point.on_grid(); ++k)
        if (const Plane& own = *point.plane(k); &own == &plane || own == plane || opposite(own)) return true;
    return exact_side(plane, point) == 0;
}

int exact_order(const Plane& f, const Plane& t, const ExactPoint& a, const Plane& across, const ExactPoint& b) {
    const Vec3 direction = cross(f.direction(), t.direction());
    const double estimate = dot(b.approximate() - a.approximate(), direction);
    // The points are off by kApproximation each; a difference is at most 2^26, and none of the six terms f * t * (b -
    // a) passes through more than six roundings. Their factors f * t are six of the nine terms of the product of the
    // sizes. Two more roundings for the bound itself, and for what points may lie beyond the rim.
    constexpr double kOrderError = 2 * kApproximation + rounding(8) * 2 * kRimSteps;
    if (std::fabs(estimate) > kOrderError * (f.size * t.size)) return estimate > 0 ? 1 : -1;

    // b = a + s * direction: across.normal . (b - a) = s * across.normal . direction, which is the turn of f, t,
    // across.
    ++fallbacks;
    return exact_side(across, b) * exact_turn(f, t, across);
}

std::uint64_t exact_fallbacks() {
    return fallbacks;
}

}  // namespace firma
