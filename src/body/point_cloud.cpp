// SPDX-License-Identifier: MIT
// Distances to many points, row by row.
#include "body/point_cloud.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace firma {
namespace {

constexpr float kFarAway = 1e18f;
/// A bound rounds, and so does what it bounds.
constexpr float kBoundSlack = 1 - 0x1p-20f;

}  // namespace

void PointCloud::add(const Vec3& point) {
    const std::size_t at = count_++ % kRow;
    if (at == 0) {
        Axes& fresh = rows_.emplace_back();
        for (Row* axis : {&fresh.x, &fresh.y, &fresh.z}) axis->fill(kFarAway);
        fresh.low.fill(kFarAway);
        fresh.high.fill(-kFarAway);
    }
    const Vec3 way = point - middle_;
    Axes& row = rows_.back();
    const Corner corner{float(way.x), float(way.y), float(way.z)};
    row.x[at] = corner[0];
    row.y[at] = corner[1];
    row.z[at] = corner[2];
    for (std::size_t axis = 0; axis < 3; ++axis) {
        row.low[axis] = std::min(row.low[axis], corner[axis]);
        row.high[axis] = std::max(row.high[axis], corner[axis]);
    }
}

float PointCloud::least_square(std::size_t row, const Vec3& from) const {
    const Axes& axes = rows_[row];
    const Vec3 way = from - middle_;
    float sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const float at = float(way[axis]), low = axes.low[std::size_t(axis)], high = axes.high[std::size_t(axis)];
        const float off = at < low ? low - at : at > high ? at - high : 0;
        sum += off * off;
    }
    return sum * kBoundSlack;
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
        if (std::bit_cast<std::int32_t>(least_square(row, from)) >= best) continue;
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
