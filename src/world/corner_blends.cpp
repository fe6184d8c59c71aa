// SPDX-License-Identifier: MIT
// How pictures along the three axes are mixed at the corners of faces that edits made.
#include "world/corner_blends.h"

#include <span>

#include "base/disjoint_sets.h"
#include "base/sort.h"
#include "index/box_tree.h"
#include "world/block_faces.h"
#include "world/facets_in_box.h"

namespace firma {
namespace {

/// The cosine between normals of faces that meet sharply: 75 degrees and more.
constexpr double kSharp = 0.25;
/// Around a corner of more faces nothing is sharp: comparing each with each would take long.
constexpr std::size_t kMaxCompared = 256;

/// Squares of squares, so that the axis nearest to the direction has most of it.
Blend blend_along(const Vec3& direction) {
    double parts[3], sum = 0;
    int most = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double square = direction[axis] * direction[axis];
        parts[axis] = square * square;
        sum += parts[axis];
        if (parts[axis] > parts[most]) most = axis;
    }
    if (!(sum > 0)) return {85, 85, 85, 0};  // faces back to back
    Blend blend{};
    int left = 255;
    for (int axis = 0; axis < 3; ++axis) {
        if (axis == most) continue;
        blend[std::size_t(axis)] = std::uint8_t(255 * (parts[axis] / sum) + 0.5);
        left -= blend[std::size_t(axis)];
    }
    blend[std::size_t(most)] = std::uint8_t(left);
    return blend;
}

Vec3 unit(const Vec3& v) {
    const double size = length(v);
    return size > 0 ? v * (1 / size) : v;
}

bool holds(const GridBox& box, const GridPoint& point) {
    for (int axis = 0; axis < 3; ++axis)
        if (point[axis] < box.low[axis] || point[axis] > box.high[axis]) return false;
    return true;
}

}  // namespace

CornerBlends::CornerBlends(const WorldData& data, const GridBox& box) {
    struct Found {
        std::uint32_t point;
        Side side;
    };
    std::vector<Found> found;
    facets_in_box(all_facets(data), box, [&](const Block& block, std::uint32_t slot) {
        const FaceRecord& face = block.faces[slot];
        if (face.edit == 0 || !boxes_meet(block.box_of(face), box)) return true;
        const Vec3 normal = unit_normal_of(block, face);
        const std::size_t count = face.corner_count;
        for (std::size_t k = 0; k < count; ++k) {
            const GridPoint& at = block.corner(face, k);
            if (!holds(box, at)) continue;
            const Vec3 here = to_metres(at), next = to_metres(block.corner(face, k + 1 < count ? k + 1 : 0)) - here,
                       last = to_metres(block.corner(face, k > 0 ? k - 1 : count - 1)) - here;
            found.push_back({points_.number(at), {face.id, normal, 1 - dot(unit(next), unit(last))}});
        }
        return true;
    });
    // Gathered by point, there in order of id: by counting.
    first_.assign(points_.count() + 1, 0);
    for (const Found& one : found) ++first_[one.point + 1];
    for (std::size_t k = 1; k < first_.size(); ++k) first_[k] += first_[k - 1];
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    sides_.resize(found.size());
    for (const Found& one : found) sides_[next[one.point]++] = one.side;
    for (std::size_t k = 0; k + 1 < first_.size(); ++k) {
        const std::span around = std::span(sides_).subspan(first_[k], first_[k + 1] - first_[k]);
        sort_range(around, [](const Side& a, const Side& b) { return a.face < b.face; });
        mix(around);
    }
}

/// Those that hang together by edges that are not sharp share the mixture along their mean direction.
void CornerBlends::mix(std::span<Side> around) {
    DisjointSets sets(around.size());
    const bool compared = around.size() <= kMaxCompared;
    for (std::uint32_t a = 1; a < around.size(); ++a)
        for (std::uint32_t b = compared ? 0 : a - 1; b < a; ++b)
            if (!compared || dot(around[a].normal, around[b].normal) > kSharp) sets.join(a, b);
    for (std::uint32_t k = 0; k < around.size(); ++k) {
        if (sets.find(k) != k) {  // the lowest of a set comes first
            around[k].blend = around[sets.find(k)].blend;
            continue;
        }
        Vec3 sum;
        for (std::uint32_t other = k; other < around.size(); ++other)
            if (sets.find(other) == k) sum += around[other].normal * around[other].weight;
        around[k].blend = blend_along(sum);
    }
}

Blend CornerBlends::at(const GridPoint& corner, FaceId face) {
    const std::uint32_t point = points_.number(corner);
    for (std::uint32_t k = first_[point]; k < first_[point + 1]; ++k)
        if (sides_[k].face == face) return sides_[k].blend;
    return blend_along({});
}

}  // namespace firma
