// SPDX-License-Identifier: MIT
// A hash of a solid's set of points.
#include "solid/hash_points.h"

#include "base/random.h"

namespace firma {
namespace {

constexpr std::uint64_t kPrime = (std::uint64_t(1) << 61) - 1;
constexpr std::size_t kTogether = 4096;  ///< edges whose inverses are taken at a time

std::uint64_t reduced(std::uint64_t value) {
    value = (value & kPrime) + (value >> 61);
    return value >= kPrime ? value - kPrime : value;
}

std::uint64_t times(std::uint64_t a, std::uint64_t b) {
    const Unsigned128 whole = Unsigned128(a) * b;
    return reduced((std::uint64_t(whole) & kPrime) + std::uint64_t(whole >> 61));
}

std::uint64_t residue(Int128 value) {
    const auto size = Unsigned128(value < 0 ? -value : value);
    const std::uint64_t positive =
        reduced((std::uint64_t(size) & kPrime) + (std::uint64_t(size >> 61) & kPrime) + std::uint64_t(size >> 122));
    return value < 0 && positive != 0 ? kPrime - positive : positive;
}

/// By Fermat: a^(p - 2).
std::uint64_t inverse(std::uint64_t value) {
    std::uint64_t power = value, result = 1;
    for (std::uint64_t exponent = kPrime - 2; exponent > 0; exponent >>= 1) {
        if (exponent & 1) result = times(result, power);
        power = times(power, power);
    }
    return result;
}

std::uint64_t hash_end(std::uint64_t line, const GridPoint& point) {
    const std::uint64_t xy = std::uint64_t(std::uint32_t(point.x)) << 32 | std::uint32_t(point.y);
    return mix_bits(mix_bits((line ^ xy) * 0x9E3779B97F4A7C15ull) + std::uint32_t(point.z));
}

}  // namespace

std::uint64_t hash_plane(const Plane& plane) {
    std::uint64_t hash = 0;
    for (const std::int64_t n : plane.normal) hash = mix_bits((hash + std::uint64_t(n)) * 0x9E3779B97F4A7C15ull);
    hash = mix_bits((hash + plane.offset_low) * 0x9E3779B97F4A7C15ull);
    return mix_bits((hash + std::uint64_t(plane.offset_high)) * 0x9E3779B97F4A7C15ull);
}

LineDirection LineDirection::along(const GridPoint& from, const GridPoint& to) {
    LineDirection direction;
    for (int axis = 0; axis < 3; ++axis) direction.along_[axis] = residue(Int128(std::int64_t(to[axis]) - from[axis]));
    return direction;
}

LineDirection LineDirection::of(const Plane& a, const Plane& b) {
    Int128 along[3];
    for (int axis = 0; axis < 3; ++axis) along[axis] = normal_minor(a, b, (axis + 1) % 3, (axis + 2) % 3);
    LineDirection direction;
    const auto take = [&] {
        for (int axis = 0; axis < 3; ++axis) direction.along_[axis] = residue(along[axis]);
        return direction.along_[0] == 0 && direction.along_[1] == 0 && direction.along_[2] == 0;
    };
    // Planes name a direction but for a factor. One that the prime divides would leave no ratio, where other planes
    // through the line leave one.
    while (take() && (along[0] != 0 || along[1] != 0 || along[2] != 0))
        for (Int128& component : along) component /= std::int64_t(kPrime);
    return direction;
}

void PointHash::start_face(const Plane& plane, int sign) {
    plane_ = hash_plane(plane);
    axis_ = plane.dominant_axis();
    goes_ = sign < 0;
}

void PointHash::add_edge(const GridPoint& from, const GridPoint& to, const LineDirection& direction) {
    if (from == to) return;
    const int u = axis_ == 0 ? 1 : 0, v = axis_ == 2 ? 1 : 2;
    edges_.push_back({plane_, direction.along_[u], direction.along_[v], from, to, goes_});
    if (edges_.size() == kTogether) finish();
}

const SumsByKey& PointHash::finish() {
    // One inverse for all: of the times, taken apart again from the last to the first.
    products_.clear();
    std::uint64_t all = 1;
    for (const Edge& edge : edges_) {
        products_.push_back(all);
        if (edge.across != 0) all = times(all, edge.across);
    }
    std::uint64_t rest = inverse(all);
    for (std::size_t k = edges_.size(); k-- > 0;) {
        const Edge& edge = edges_[k];
        std::uint64_t ratio = kPrime;  // of no line that goes across
        if (edge.across != 0) {
            ratio = times(edge.along, times(rest, products_[k]));
            rest = times(rest, edge.across);
        }
        const std::uint64_t line = mix_bits(edge.plane + ratio * 0xBF58476D1CE4E5B9ull);
        const std::uint64_t end = hash_end(line, edge.to), start = hash_end(line, edge.from);
        sums_.add(region_of_(edge.to), edge.goes ? -end : end);
        sums_.add(region_of_(edge.from), edge.goes ? start : -start);
    }
    edges_.clear();
    return sums_;
}

}  // namespace firma
