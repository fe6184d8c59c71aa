// SPDX-License-Identifier: MIT
// The layout for casts of a leaf of an index over faces.
#include "solid/lay_out_faces.h"

#include <algorithm>
#include <cmath>

#include "solid/face_shape.h"

namespace firma {
namespace {

constexpr float kUp = 1 + 0x1p-20f;  ///< far more than the rounding of a few floats

/// The middle of some facets, on the grid.
GridPoint middle_of(const Block& block, std::uint32_t first, std::uint32_t end) {
    GridBox box;
    for (std::uint32_t slot = first; slot < end; ++slot) box.add(block.box_of(block.faces[slot]));
    GridPoint middle;
    for (int axis = 0; axis < 3; ++axis)
        middle[axis] = std::int32_t((std::int64_t(box.low[axis]) + box.high[axis]) >> 1);
    return middle;
}

/// How far corners lie from the plane of casts: that of the normal, through the first one. Metres, rounded up.
double unevenness(const PolygonShape& polygon) {
    if (polygon.corners.size() == 3 || !polygon.has_area()) return 0;
    const Vec3 normal = polygon.unit_normal();
    double most = 0;
    for (const Vec3& corner : polygon.corners)
        most = std::max(most, std::fabs(dot(corner - polygon.corners[0], normal)));
    const double size = max_abs(polygon.corners[0]) + 2 * length(polygon.corners[1] - polygon.corners[0]);
    return most * (1 + 0x1p-40) + size * 0x1p-44;
}

/// Triangles into lanes, one after the other.
class LaneWriter {
public:
    LaneWriter(const Block& block, const GridPoint& origin, std::vector<FaceLanes>& lanes)
        : block_(block), origin_(origin), lanes_(lanes) {}

    void add(std::uint32_t slot) {
        const FaceRecord& face = block_.faces[slot];
        const double uneven = unevenness(FaceShape(block_, face).polygon);
        for (std::uint32_t k = 2; k < face.corner_count; ++k) {
            if (lane_ == FaceLanes::kLanes) {
                lanes_.emplace_back();
                lanes_.back().block = &block_;
                lanes_.back().origin = origin_;
                lanes_.back().mask_of_all = ~0u;
                lane_ = 0;
            }
            FaceLanes& it = lanes_.back();
            it.uneven = std::max(it.uneven, float(uneven) * kUp);
            // Outlines of more corners are convex but for the rounding to the grid.
            if (face.corner_count > 3) it.shifted = std::max(it.shifted, float(1 / kSurfaceSteps));
            it.mask_of_all &= face.mask;
            it.slot[lane_] = std::uint8_t(slot);
            it.used |= std::uint8_t(1u << lane_);
            if (face.two_sided) it.two_sided |= std::uint8_t(1u << lane_);
            bool whole = face.corner_count == 3;
            const std::uint32_t corners[3] = {0, k - 1, k};
            for (std::uint32_t c = 0; c < 3; ++c) whole &= put(it, c, block_.corner(face, corners[c]));
            if (whole) it.whole |= std::uint8_t(1u << lane_);
            ++lane_;
        }
    }

    /// Lanes that are left repeat the last triangle.
    void finish() {
        FaceLanes& it = lanes_.back();
        for (; lane_ < FaceLanes::kLanes; ++lane_) {
            it.slot[lane_] = it.slot[lane_ - 1];
            for (auto& corner : it.corner)
                for (float(&axis)[FaceLanes::kLanes] : corner) axis[lane_] = axis[lane_ - 1];
        }
    }

private:
    /// @return whether a corner is exact
    bool put(FaceLanes& it, std::uint32_t c, const GridPoint& point) const {
        double sum = 0, off = 0;
        bool exact = true;
        for (int axis = 0; axis < 3; ++axis) {
            const double from = double(std::int64_t(point[axis]) - origin_[axis]) / kSurfaceSteps;
            const auto rounded = float(from);
            it.corner[c][axis][lane_] = rounded;
            // Up to 2^23 steps differences of corners, and what is made of their products, have no rounding either.
            exact = exact && double(rounded) == from && std::fabs(from) <= 32;
            sum += std::fabs(from);
            off += std::fabs(from - double(rounded));
        }
        it.size = std::max(it.size, float(sum) * kUp);
        if (off > 0) it.shifted = std::max(it.shifted, float(off + 1 / kSurfaceSteps) * kUp);
        return exact;
    }

    const Block& block_;
    const GridPoint origin_;
    std::vector<FaceLanes>& lanes_;
    std::uint32_t lane_ = FaceLanes::kLanes;
};

}  // namespace

std::uint32_t FaceLayout::lanes_below(const Node& leaf, std::uint32_t bin) const {
    std::uint32_t first = bin;
    while (!leaf.bins[first].is_leaf()) ++first;
    return before_[last_[bin]] - before_[leaf.bins[first].first];
}

/// The facets below a bin.
std::uint32_t FaceLayout::put(const Node& leaf, std::uint32_t bin) {
    std::uint32_t at = bin;
    while (!leaf.bins[at].is_leaf()) ++at;
    const std::uint32_t first = leaf.bins[at].first, end = last_[bin];
    first_.push_back(std::uint32_t(lanes_.size()));
    LaneWriter writer(*block_, middle_of(*block_, first, end), lanes_);
    for (std::uint32_t slot = first; slot < end; ++slot) writer.add(slot);
    writer.finish();
    return std::uint32_t(first_.size()) - 1;
}

void FaceLayout::make([[maybe_unused]] Node& leaf, [[maybe_unused]] Block& block) {
#ifdef FIRMA_SIMD
    block_ = &block;
    before_.assign(1, 0);
    for (const FaceRecord& face : block.faces) before_.push_back(before_.back() + face.corner_count - 2);
    last_.assign(leaf.bins.size(), 0);
    for (std::size_t k = leaf.bins.size(); k-- > 0;)
        last_[k] = leaf.bins[k].is_leaf() ? leaf.bins[k].first + leaf.bins[k].count : last_[leaf.bins[k].first];
    lanes_.clear();
    first_.clear();
    widener_.widen(
        leaf,
        [&](std::uint32_t bin) {
            const bool ends = leaf.bins[bin].is_leaf() || lanes_below(leaf, bin) <= FaceLanes::kLanes;
            return ends ? put(leaf, bin) : BinWidener::kNone;
        },
        [&](std::uint32_t item, WideNode& above, std::uint32_t lane) {
            if (block.lanes.empty()) block.lanes.assign(lanes_.begin(), lanes_.end());
            const std::uint32_t end = item + 1 < first_.size() ? first_[item + 1] : std::uint32_t(lanes_.size());
            above.child[lane] = &block.lanes[first_[item]];
            above.facets[lane] = std::uint16_t(end - first_[item]);
        });
#endif
}

}  // namespace firma
