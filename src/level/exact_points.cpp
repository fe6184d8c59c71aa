// SPDX-License-Identifier: MIT
// Exact positions as whole numbers.
#include "level/exact_points.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace firma {
namespace {

/// The least exponent of any number but zero: multiplied by its inverse, all are whole.
std::int32_t least_exponent(const ExactMesh& mesh, std::span<const std::uint32_t> vertices) {
    std::int32_t least = std::numeric_limits<std::int32_t>::max();
    for (const std::uint32_t vertex : vertices)
        for (const ExactNumber& number : mesh.exact[vertex])
            if (number.mantissa != 0) least = std::min(least, number.exponent);
    return least;
}

constexpr std::int64_t kLargestSmall = (std::int64_t(1) << 61) - 1;

bool to_small(const ExactNumber& number, int base, std::int32_t least, std::int64_t& value) {
    value = number.mantissa;
    if (value == 0) return true;
    if (number.long_digits != ExactNumber::kShort) return false;
    for (std::int32_t k = least; k < number.exponent; ++k)
        if (__builtin_mul_overflow(value, base, &value)) return false;
    return value >= -kLargestSmall && value <= kLargestSmall;
}

}  // namespace

bool to_small_points(const ExactMesh& mesh, std::span<const std::uint32_t> vertices, std::vector<SmallPoint>& points) {
    const std::int32_t least = least_exponent(mesh, vertices);
    points.resize(vertices.size());
    for (std::size_t k = 0; k < vertices.size(); ++k)
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (!to_small(mesh.exact[vertices[k]][axis], mesh.base, least, points[k][axis])) return false;
    return true;
}

void to_big_points(const ExactMesh& mesh, std::span<const std::uint32_t> vertices, std::vector<BigPoint>& points) {
    const std::int32_t least = least_exponent(mesh, vertices);
    points.resize(vertices.size());
    for (std::size_t k = 0; k < vertices.size(); ++k)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const ExactNumber& number = mesh.exact[vertices[k]][axis];
            BigInt& value = points[k][axis];
            value = number.mantissa;
            if (number.mantissa == 0) continue;
            if (number.long_digits != ExactNumber::kShort) value *= BigInt(mesh.long_digits[number.long_digits]);
            value *= boost::multiprecision::pow(BigInt(mesh.base), unsigned(number.exponent - least));
        }
}

int bits_of(std::span<const SmallPoint> points) {
    std::uint64_t all = 0;
    for (const SmallPoint& point : points)
        for (const std::int64_t value : point) all |= std::uint64_t(value < 0 ? -value : value);
    return int(std::bit_width(all));
}

}  // namespace firma
