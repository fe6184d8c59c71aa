// SPDX-License-Identifier: MIT
// Families of planes in cells of normal and distance.
#include "brush/plane_families.h"

#include <algorithm>
#include <cmath>

#include "base/table_key.h"

namespace firma {
namespace {

// Of a component of the normal, and of the distance in units: how planes of one family may differ, and how wide cells
// are. Editors write points with six digits or more.
constexpr double kNormalApart = 1.0 / (1 << 17), kDistanceApart = 1.0 / 16;
constexpr double kNormalCell = 1.0 / 64, kDistanceCell = 1;
// Units: as the compilers of these games have it.
constexpr double kCornerApart = 0.01;
// A file made to hurt could fill one cell with planes: beyond these, planes stay apart.
constexpr std::size_t kMostInCell = 64;

constexpr double apart(std::size_t k) {
    return k < 3 ? kNormalApart : kDistanceApart;
}

double number(const FloatPlane& plane, std::size_t k) {
    return k < 3 ? plane.normal[int(k)] : plane.distance;
}

// What is beyond all worlds, or no number, is in one cell: odd scales make such planes.
std::int64_t cell_of(double value, std::size_t k) {
    constexpr double kMost = 1e15;
    const double cell = std::floor(value / (k < 3 ? kNormalCell : kDistanceCell));
    return cell > -kMost && cell < kMost ? std::int64_t(cell) : 0;
}

bool alike(const FloatPlane& family, const FloatPlane& plane, std::span<const Vec3> corners) {
    for (std::size_t k = 0; k < 4; ++k)
        if (!(std::fabs(number(family, k) - number(plane, k)) <= apart(k))) return false;
    return std::all_of(corners.begin(), corners.end(), [&](const Vec3& corner) {
        return std::fabs(dot(family.normal, corner) - family.distance) <= kCornerApart;
    });
}

}  // namespace

std::size_t PlaneFamilies::Hash::operator()(const Cell& cell) const {
    std::uint64_t mixed = table_seed();
    for (const std::int64_t part : cell) mixed = mix_bits(mixed ^ std::uint64_t(part));
    return std::size_t(mixed);
}

void PlaneFamilies::search(const Cell& cell, const FloatPlane& plane, std::span<const Vec3> corners, bool flipped,
                           std::optional<Match>& best) const {
    const auto found = cells_.find(cell);
    if (found == cells_.end()) return;
    for (const std::uint32_t family : found->second) {
        if (best && best->family <= family) return;
        if (alike(planes_[family], plane, corners)) best = {family, flipped};
    }
}

// Up to sixteen cells: two for each number that lies near a cell's border.
std::optional<PlaneFamilies::Match> PlaneFamilies::find(const FloatPlane& plane, std::span<const Vec3> corners) const {
    std::optional<Match> best;
    for (const bool flipped : {false, true}) {
        const FloatPlane turned = flipped ? FloatPlane{-plane.normal, -plane.distance} : plane;
        Cell low, high;
        for (std::size_t k = 0; k < 4; ++k) {
            low[k] = cell_of(number(turned, k) - apart(k), k);
            high[k] = cell_of(number(turned, k) + apart(k), k);
            if (high[k] != low[k] + 1) high[k] = low[k];
        }
        Cell cell;
        for (cell[0] = low[0]; cell[0] <= high[0]; ++cell[0])
            for (cell[1] = low[1]; cell[1] <= high[1]; ++cell[1])
                for (cell[2] = low[2]; cell[2] <= high[2]; ++cell[2])
                    for (cell[3] = low[3]; cell[3] <= high[3]; ++cell[3]) search(cell, turned, corners, flipped, best);
    }
    return best;
}

std::uint32_t PlaneFamilies::add(const FloatPlane& plane) {
    Cell cell;
    for (std::size_t k = 0; k < 4; ++k) cell[k] = cell_of(number(plane, k), k);
    std::vector<std::uint32_t>& families = cells_[cell];
    const auto family = std::uint32_t(planes_.size());
    if (families.size() < kMostInCell) families.push_back(family);
    planes_.push_back(plane);
    return family;
}

}  // namespace firma
