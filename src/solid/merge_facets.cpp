// SPDX-License-Identifier: MIT
// Merges triangles of a face into convex polygons that are exactly planar.
#include "solid/merge_facets.h"

#include "base/sort.h"
#include "geometry/polygon_shape.h"

namespace firma {

void FacetMerger::merge(std::span<const GridPoint> points, std::span<const FlatPoint> flat, const Triangles& triangles,
                        Facets& facets) {
    find_diagonals(points, triangles);
    const std::size_t count = triangles.corners.size() / 3;
    if (diagonals_.empty()) {
        facets.corners.assign(triangles.corners.begin(), triangles.corners.end());
        facets.first.clear();
        for (std::size_t k = 0; k <= count; ++k) facets.first.push_back(std::uint32_t(3 * k));
        return;
    }
    sides_.clear();
    for (std::uint32_t k = 0; k < triangles.corners.size(); k += 3)
        for (std::uint32_t i = 0; i < 3; ++i)
            sides_.push_back({k + (i + 2) % 3, k + (i + 1) % 3, triangles.corners[k + i], false});
    pieces_.resize(count);
    for (std::uint32_t k = 0; k < count; ++k) pieces_[k] = k;
    sizes_.assign(count, 3);
    for (const Diagonal& diagonal : diagonals_) {
        const std::uint32_t side = diagonal.side, twin = triangles.twins[side];
        const std::uint32_t here = piece_of(side / 3), there = piece_of(twin / 3);
        const std::uint32_t size = sizes_[here] + sizes_[there] - 2;
        if (size > kMaxCorners || !convex_without(side, twin, flat)) continue;
        remove(side, twin);
        pieces_[there] = here;
        sizes_[here] = size;
    }
    write(facets);
}

/// Pieces are planar, so two of them that meet in a diagonal are of one plane when the triangles there are.
void FacetMerger::find_diagonals(std::span<const GridPoint> points, const Triangles& triangles) {
    diagonals_.clear();
    const auto corner = [&](std::uint32_t side) -> const GridPoint& { return points[triangles.corners[side]]; };
    for (std::uint32_t side = 0; side < triangles.twins.size(); ++side) {
        const std::uint32_t twin = triangles.twins[side];
        if (twin == Triangles::kNoTwin || twin < side) continue;
        const std::uint32_t next = side % 3 == 2 ? side - 2 : side + 1, opposite = next % 3 == 2 ? next - 2 : next + 1;
        const std::uint32_t across = twin / 3 * 3 + (twin % 3 + 2) % 3;
        if (coplanar(corner(side), corner(next), corner(opposite), corner(across)))
            diagonals_.push_back({square_distance(corner(side), corner(next)), side});
    }
    sort_range(diagonals_, [](const Diagonal& a, const Diagonal& b) {
        return a.length != b.length ? a.length > b.length : a.side < b.side;
    });
}

/// Both ends of a diagonal turn left without it, or go straight on. A loop passes each end, so the angle there is less
/// than 360 degrees: straight is never back.
bool FacetMerger::convex_without(std::uint32_t side, std::uint32_t twin, std::span<const FlatPoint> flat) const {
    const auto turns_left = [&](std::uint32_t in, std::uint32_t out) {
        return turn(flat[sides_[in].corner], flat[sides_[out].corner], flat[sides_[sides_[out].after].corner]) >= 0;
    };
    return turns_left(sides_[side].before, sides_[twin].after) && turns_left(sides_[twin].before, sides_[side].after);
}

void FacetMerger::remove(std::uint32_t side, std::uint32_t twin) {
    const auto link = [&](std::uint32_t in, std::uint32_t out) {
        sides_[in].after = out;
        sides_[out].before = in;
    };
    link(sides_[side].before, sides_[twin].after);
    link(sides_[twin].before, sides_[side].after);
    sides_[side].gone = sides_[twin].gone = true;
}

std::uint32_t FacetMerger::piece_of(std::uint32_t triangle) {
    while (pieces_[triangle] != triangle) triangle = pieces_[triangle] = pieces_[pieces_[triangle]];
    return triangle;
}

void FacetMerger::write(Facets& facets) {
    facets.corners.clear();
    facets.first.assign(1, 0);
    for (std::uint32_t begin = 0; begin < sides_.size(); ++begin) {
        if (sides_[begin].gone) continue;
        for (std::uint32_t k = begin; !sides_[k].gone; k = sides_[k].after) {
            facets.corners.push_back(sides_[k].corner);
            sides_[k].gone = true;
        }
        facets.first.push_back(std::uint32_t(facets.corners.size()));
    }
}

}  // namespace firma
