// SPDX-License-Identifier: MIT
// How a leaf of an index over faces is laid out.
#include "solid/lay_out_faces.h"

#include <algorithm>
#include <cmath>

#include "base/seldom.h"
#include "solid/face_shape.h"

namespace firma {
namespace {

constexpr float kUp = 1 + 0x1p-20f;  ///< far more than the rounding of a few floats

/// Up to so many steps differences of corners, and what is made of their products, have no rounding in floats.
constexpr std::int64_t kExactSteps = std::int64_t(1) << 23;

GridPoint origin_for(const GridBox& box) {
    GridPoint middle;
    for (int axis = 0; axis < 3; ++axis)
        middle[axis] = std::int32_t((std::int64_t(box.low[axis]) + box.high[axis]) >> 1);
    return middle;
}

/// Whether all of a box lies within so many steps of a point, axis by axis.
bool within(const GridBox& box, const GridPoint& point, std::int64_t steps) {
    for (int axis = 0; axis < 3; ++axis)
        if (point[axis] - std::int64_t(box.low[axis]) > steps || box.high[axis] - std::int64_t(point[axis]) > steps)
            return false;
    return true;
}

/// How far corners lie from the plane of casts: that of the normal, through the first one. Metres, rounded up.
FIRMA_SELDOM double unevenness(const PolygonShape& polygon) {
    if (!polygon.has_area()) return 0;
    const Vec3 normal = polygon.unit_normal();
    double most = 0;
    for (const Vec3& corner : polygon.corners)
        most = std::max(most, std::fabs(dot(corner - polygon.corners[0], normal)));
    const double size = max_abs(polygon.corners[0]) + 2 * length(polygon.corners[1] - polygon.corners[0]);
    return most * (1 + 0x1p-40) + size * 0x1p-44;
}

/// The same without exact sums, a little more. Differences of corners are exact; the normal's components, sums of 2n
/// products, are off by (n + 3) 2^-53 of the sum of the products' sizes at most. Where that is so little of the normal
/// that it does not matter, a corner's height is off by as little of its distance.
double unevenness(const Block& block, const FaceRecord& face) {
    const Vec3 first = to_metres(block.corner(face, 0));
    Vec3 normal, sizes, last = to_metres(block.corner(face, 1)) - first;
    double farthest = 0;
    for (std::uint32_t k = 2; k < face.corner_count; ++k) {
        const Vec3 next = to_metres(block.corner(face, k)) - first;
        normal += cross(last, next);
        const Vec3 a{std::fabs(last.x), std::fabs(last.y), std::fabs(last.z)},
            b{std::fabs(next.x), std::fabs(next.y), std::fabs(next.z)};
        sizes += Vec3{a.y * b.z + a.z * b.y, a.z * b.x + a.x * b.z, a.x * b.y + a.y * b.x};
        farthest = std::max(farthest, b.x + b.y + b.z);
        last = next;
    }
    const double off = double(face.corner_count + 3) * 0x1p-52 * (sizes.x + sizes.y + sizes.z);
    const double long_as = length(normal);
    if (!(long_as > 0x1p+30 * off)) return unevenness(FaceShape(block, face).polygon);
    double most = 0;
    for (std::uint32_t k = 1; k < face.corner_count; ++k)
        most = std::max(most, std::fabs(dot(to_metres(block.corner(face, k)) - first, normal)));
    return (most + farthest * off) / long_as * (1 + 0x1p-28) + (max_abs(first) + 2 * farthest) * 0x1p-44;
}

/// Triangles into lanes, one after the other.
class LaneWriter {
public:
    /// @param box  around the facets that are added
    LaneWriter(const Block& block, const GridBox& box, FaceLanes* lanes)
        : block_(block), origin_(origin_for(box)), exact_(within(box, origin_, kExactSteps)), next_(lanes) {}

    void add(std::uint32_t slot) {
        const FaceRecord& face = block_.faces[slot];
        Corner corners[kMaxCorners];
        Measure measure;
        for (std::uint32_t k = 0; k < face.corner_count; ++k)
            corners[k] =
                exact_ ? exact_corner(block_.corner(face, k), measure) : corner(block_.corner(face, k), measure);
        if (face.corner_count > 3) {
            measure.uneven = float(unevenness(block_, face)) * kUp;
            // Outlines of more corners are convex but for the rounding to the grid.
            measure.shifted = std::max(measure.shifted, float(1 / kSurfaceSteps));
        }
        const bool whole = face.corner_count == 3 && measure.exact;
        for (std::uint32_t k = 2; k < face.corner_count; ++k) {
            if (lane_ == FaceLanes::kLanes) start();
            FaceLanes& it = *last_;
            it.size = std::max(it.size, measure.size);
            it.uneven = std::max(it.uneven, measure.uneven);
            it.shifted = std::max(it.shifted, measure.shifted);
            it.mask_of_all &= face.mask;
            it.slot[lane_] = std::uint8_t(slot);
            const auto bit = std::uint8_t(1u << lane_);
            it.used |= bit;
            if (face.two_sided) it.two_sided |= bit;
            if (whole) it.whole |= bit;
            for (int axis = 0; axis < 3; ++axis) {
                it.corner[0][axis][lane_] = corners[0].at[axis];
                it.corner[1][axis][lane_] = corners[k - 1].at[axis];
                it.corner[2][axis][lane_] = corners[k].at[axis];
            }
            ++lane_;
        }
    }

    /// Lanes that are left repeat the last triangle.
    void finish() {
        FaceLanes& it = *last_;
        for (; lane_ < FaceLanes::kLanes; ++lane_) {
            it.slot[lane_] = it.slot[lane_ - 1];
            for (auto& corner : it.corner)
                for (float(&axis)[FaceLanes::kLanes] : corner) axis[lane_] = axis[lane_ - 1];
        }
    }

private:
    /// Metres from the origin.
    struct Corner {
        float at[3];
    };
    /// What FaceLanes says of all, of one facet.
    struct Measure {
        float size = 0, uneven = 0, shifted = 0;
        bool exact = true;
    };

    void start() {
        last_ = next_++;
        last_->block = &block_;
        last_->faces = block_.faces.data();
        last_->origin = origin_;
        last_->mask_of_all = ~0u;
        lane_ = 0;
    }

    Corner exact_corner(const GridPoint& point, Measure& measure) const {
        Corner made;
        float sum = 0;
        for (int axis = 0; axis < 3; ++axis) {
            made.at[axis] = float(point[axis] - origin_[axis]) * float(1 / kSurfaceSteps);
            sum += std::fabs(made.at[axis]);
        }
        measure.size = std::max(measure.size, sum * kUp);
        return made;
    }
    Corner corner(const GridPoint& point, Measure& measure) const {
        Corner made;
        double sum = 0, off = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const std::int64_t steps = std::int64_t(point[axis]) - origin_[axis];
            const double from = double(steps) / kSurfaceSteps;
            made.at[axis] = float(from);
            measure.exact = measure.exact && std::abs(steps) <= kExactSteps;
            sum += std::fabs(from);
            off += std::fabs(from - double(made.at[axis]));
        }
        measure.size = std::max(measure.size, float(sum) * kUp);
        if (off > 0) measure.shifted = std::max(measure.shifted, float(off + 1 / kSurfaceSteps) * kUp);
        return made;
    }

    const Block& block_;
    const GridPoint origin_;
    const bool exact_;
    FaceLanes* next_;
    FaceLanes* last_ = nullptr;
    std::uint32_t lane_ = FaceLanes::kLanes;
};

}  // namespace

void FaceLayout::make(Node& leaf, [[maybe_unused]] Block& block, const BinTree& tree, std::uint32_t top) {
    const auto is_item = [&](std::uint32_t bin) { return tree.nodes[bin].left == 0; };
    const auto facets_of = [&](std::uint32_t bin) { return tree.nodes[bin].count; };
    const std::span<const BinWidener::Item> items = widener_.widen(leaf, tree, top, is_item, facets_of);
#ifdef FIRMA_SIMD
    const std::uint32_t before = tree.nodes[top].first;
    std::size_t all = 0;
    for (const BinWidener::Item& item : items) {
        const BinNode& bin = tree.nodes[item.what];
        std::uint32_t triangles = 0;
        for (std::uint32_t k = 0; k < bin.count; ++k)
            triangles += block.faces[bin.first - before + k].corner_count - 2u;
        const std::uint32_t lanes = (triangles + FaceLanes::kLanes - 1) / FaceLanes::kLanes;
        leaf.wide[item.above].facets[item.lane] = std::uint16_t(lanes);
        all += lanes;
    }
    block.lanes.resize(all);
    FaceLanes* next = block.lanes.data();
    for (const BinWidener::Item& item : items) {
        const BinNode& bin = tree.nodes[item.what];
        leaf.wide[item.above].child[item.lane] = next;
        LaneWriter writer(block, bin.box, next);
        for (std::uint32_t k = 0; k < bin.count; ++k) writer.add(bin.first - before + k);
        writer.finish();
        next += leaf.wide[item.above].facets[item.lane];
    }
#else
    for (const BinWidener::Item& item : items) leaf.wide[item.above].facets[item.lane] = 1;
#endif
}

}  // namespace firma
