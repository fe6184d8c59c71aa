// SPDX-License-Identifier: MIT
// Distances to many points, row by row.
#include "body/point_cloud.h"

#include <bit>
#include <cmath>
#include <cstdint>

namespace firma {
namespace {

constexpr float kFarAway = 1e18f;

}  // namespace

void PointCloud::add(const Vec3& point) {
    const std::size_t at = count_++ % kRow;
    if (at == 0) {
        Axes& fresh = rows_.emplace_back();
        for (Row* axis : {&fresh.x, &fresh.y, &fresh.z}) axis->fill(kFarAway);
    }
    const Vec3 way = point - middle_;
    Axes& row = rows_.back();
    row.x[at] = float(way.x);
    row.y[at] = float(way.y);
    row.z[at] = float(way.z);
}

void PointCloud::squares(std::size_t row, const Vec3& from, Row& to) const {
    const Axes& axes = rows_[row];
    const Vec3 way = from - middle_;
    const float x = float(way.x), y = float(way.y), z = float(way.z);
    Row found;
    for (std::size_t k = 0; k < kRow; ++k) {
        const float dx = axes.x[k] - x, dy = axes.y[k] - y, dz = axes.z[k] - z;
        found[k] = dx * dx + dy * dy + dz * dz;
    }
    to = found;
}

PointCloud::Nearest PointCloud::nearest(const Vec3& from) const {
    // Numbers that are not negative are in the order of their bits, which lanes compare in any build.
    std::int32_t best = INT32_MAX;
    std::size_t best_row = 0, at = 0;
    Row found;
    for (std::size_t row = 0; row < rows_.size(); ++row) {
        squares(row, from, found);
        std::int32_t least = INT32_MAX;
        for (std::size_t k = 0; k < kRow; ++k) {
            const auto bits = std::bit_cast<std::int32_t>(found[k]);
            least = bits < least ? bits : least;
        }
        if (!(least < best)) continue;
        best = least;
        best_row = row;
        for (at = 0; std::bit_cast<std::int32_t>(found[at]) != best;) ++at;
    }
    const Axes& row = rows_[best_row];
    return {std::sqrt(double(std::bit_cast<float>(best))), middle_ + Vec3{row.x[at], row.y[at], row.z[at]}};
}

}  // namespace firma
