// SPDX-License-Identifier: MIT
// A hash of a solid's set of points.
#include "solid/hash_points.h"

#include "base/random.h"
#include "geometry/residues.h"

namespace firma {
namespace {

constexpr std::size_t kTogether = 4096;  ///< edges whose inverses are taken at a time

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
    for (int axis = 0; axis < 3; ++axis) {
        const std::int64_t steps = std::int64_t(to[axis]) - from[axis];
        direction.along_[axis] = std::uint64_t(steps) + (steps < 0 ? kPrime : 0);
    }
    return direction;
}

LineDirection LineDirection::of(const Plane& a, const Plane& b) {
    Int128 along[3];
    for (int axis = 0; axis < 3; ++axis) along[axis] = normal_minor(a, b, (axis + 1) % 3, (axis + 2) % 3);
    LineDirection direction;
    const auto take = [&] {
        for (int axis = 0; axis < 3; ++axis) direction.along_[axis] = residue_of(along[axis]);
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
        if (edge.across != 0) all = residue_times(all, edge.across);
    }
    std::uint64_t rest = residue_inverse(all);
    for (std::size_t k = edges_.size(); k-- > 0;) {
        const Edge& edge = edges_[k];
        std::uint64_t ratio = kPrime;  // of no line that goes across
        if (edge.across != 0) {
            ratio = residue_times(edge.along, residue_times(rest, products_[k]));
            rest = residue_times(rest, edge.across);
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
