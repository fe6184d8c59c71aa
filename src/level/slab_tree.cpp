// SPDX-License-Identifier: MIT
// Directions by how many polygons face them; halves by count, across the direction in which centres lie widest.
#include "level/slab_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/sort.h"

namespace firma {
namespace {

/// Normals are counted in cells of so many to 1.
constexpr int kCells = 15;

Vec3 unit(const AreaVector& n) {
    const Vec3 v{double(n.x), double(n.y), double(n.z)};
    const Vec3 u = v * (1 / length(v));
    const bool back = u.x != 0 ? u.x < 0 : u.y != 0 ? u.y < 0 : u.z < 0;
    return back ? -u : u;
}

std::int32_t nearest(double value) {
    return std::int32_t(std::floor(value + 0.5));
}

std::uint32_t cell_of(const Vec3& unit) {
    const auto part = [](double value) { return std::uint32_t(nearest(value * kCells) + kCells); };
    return part(unit.x) << 16 | part(unit.y) << 8 | part(unit.z);
}

}  // namespace

SlabTree::SlabTree(std::span<const InputPoint> points, std::span<const MeshPolygon> polygons)
    : order_(polygons.size()) {
    std::iota(order_.begin(), order_.end(), 0u);
    choose_directions(polygons);
    std::vector<Slabs> slabs;
    slabs.reserve(polygons.size());
    for (const MeshPolygon& polygon : polygons) slabs.push_back(slabs_of(points, polygon));
    if (!polygons.empty()) build(slabs, 0, std::uint32_t(polygons.size()));
    slabs_.reserve(order_.size());
    for (const std::uint32_t number : order_) slabs_.push_back(slabs[number]);
}

void SlabTree::choose_directions(std::span<const MeshPolygon> polygons) {
    directions_ = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    std::vector<std::uint32_t> cells;
    cells.reserve(polygons.size());
    for (const MeshPolygon& polygon : polygons) cells.push_back(cell_of(unit(polygon.normal)));
    std::vector<std::uint32_t> sorted = cells;
    sort_range(sorted);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> counted;  // how many, cell
    for (std::size_t k = 0, end = 0; k < sorted.size(); k = end) {
        while (end < sorted.size() && sorted[end] == sorted[k]) ++end;
        counted.emplace_back(std::uint32_t(end - k), sorted[k]);
    }
    sort_range(counted, [](const auto& a, const auto& b) {
        return a.first != b.first ? a.first > b.first : a.second < b.second;
    });
    counted.resize(std::min(counted.size(), kMostDirections));
    std::vector<Vec3> sums(counted.size());
    for (std::size_t k = 0; k < polygons.size(); ++k)
        for (std::size_t c = 0; c < counted.size(); ++c)
            if (counted[c].second == cells[k]) sums[c] = sums[c] + unit(polygons[k].normal);
    for (const Vec3& sum : sums) {
        const Vec3 scaled = sum * (kLength / max_abs(sum));
        const Direction direction{nearest(scaled.x), nearest(scaled.y), nearest(scaled.z)};
        const bool axis = (direction.x != 0) + (direction.y != 0) + (direction.z != 0) == 1;
        if (!axis && directions_.size() < kMostDirections) directions_.push_back(direction);
    }
}

SlabTree::Slabs SlabTree::slabs_of(std::span<const InputPoint> points, const MeshPolygon& polygon) const {
    Slabs slabs;
    for (const std::uint32_t corner : polygon.corners) {
        const InputPoint& p = points[corner];
        for (std::size_t k = 0; k < directions_.size(); ++k) {
            const Direction& d = directions_[k];
            const std::int64_t at = std::int64_t(d.x) * p.x + std::int64_t(d.y) * p.y + std::int64_t(d.z) * p.z;
            // Along an axis to the step, along others outward to 64 of what they count.
            const int shift = k < 3 ? 0 : kShift;
            slabs[k].low = std::min(slabs[k].low, std::int32_t(at >> shift));
            slabs[k].high = std::max(slabs[k].high, std::int32_t(-(-at >> shift)));
        }
    }
    return slabs;
}

void SlabTree::build(std::vector<Slabs>& slabs, std::uint32_t first, std::uint32_t count) {
    Node made;
    made.first = first;
    made.count = count;
    const auto centre = [&](std::uint32_t number, std::size_t k) {
        return std::int64_t(slabs[number][k].low) + slabs[number][k].high;
    };
    std::array<std::int64_t, kMostDirections> low, high;
    low.fill(INT64_MAX);
    high.fill(INT64_MIN);
    for (std::uint32_t at = first; at < first + count; ++at) {
        for (std::size_t k = 0; k < directions_.size(); ++k) {
            const Slab& slab = slabs[order_[at]][k];
            made.slabs[k].low = std::min(made.slabs[k].low, slab.low);
            made.slabs[k].high = std::max(made.slabs[k].high, slab.high);
            low[k] = std::min(low[k], centre(order_[at], k));
            high[k] = std::max(high[k], centre(order_[at], k));
        }
    }
    const std::size_t at = nodes_.size();
    nodes_.push_back(made);
    if (count <= kLeafItems) return;
    std::size_t widest = 0;
    double width = -1;
    for (std::size_t k = 0; k < directions_.size(); ++k) {
        const Direction& d = directions_[k];
        const double across =
            double(high[k] - low[k]) * (k < 3 ? 1 : 1 << kShift) / length({double(d.x), double(d.y), double(d.z)});
        if (across > width) {
            widest = k;
            width = across;
        }
    }
    const std::uint32_t half = count / 2;
    sort_range(std::span(order_).subspan(first, count), [&](std::uint32_t a, std::uint32_t b) {
        const std::int64_t of_a = centre(a, widest), of_b = centre(b, widest);
        return of_a != of_b ? of_a < of_b : a < b;
    });
    nodes_[at].count = 0;
    build(slabs, first, half);
    nodes_[at].first = std::uint32_t(nodes_.size());
    build(slabs, first + half, count - half);
}

}  // namespace firma
