// SPDX-License-Identifier: MIT
// How a leaf of an index over faces is laid out.
#include "solid/lay_out_faces.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "base/seldom.h"
#include "solid/face_shape.h"

namespace firma {
namespace {

constexpr float kUp = 1 + 0x1p-20f;  ///< far more than the rounding of a few floats

/// Corners within so many steps of the origin make normals that double holds exactly: sides have 2^26 steps at most,
/// and a normal is a difference of two products of these. Where 16 bits hold a corner, sides have 2^17 steps.
constexpr std::int64_t kExactSteps = std::int64_t(1) << 25;
static_assert(2 * kExactSteps * (2 * kExactSteps) * 2 <= std::int64_t(1) << 53);

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
FIRMA_SELDOM double unevenness(std::span<const GridPoint> corners) {
    const Vec3 first = to_metres(corners[0]);
    Vec3 normal, sizes, last = to_metres(corners[1]) - first;
    double farthest = 0;
    for (const GridPoint& corner : corners.subspan(2)) {
        const Vec3 next = to_metres(corner) - first;
        normal += cross(last, next);
        const Vec3 a{std::fabs(last.x), std::fabs(last.y), std::fabs(last.z)},
            b{std::fabs(next.x), std::fabs(next.y), std::fabs(next.z)};
        sizes += Vec3{a.y * b.z + a.z * b.y, a.z * b.x + a.x * b.z, a.x * b.y + a.y * b.x};
        farthest = std::max(farthest, b.x + b.y + b.z);
        last = next;
    }
    const double off = double(corners.size() + 3) * 0x1p-52 * (sizes.x + sizes.y + sizes.z);
    const double long_as = length(normal);
    if (!(long_as > 0x1p+30 * off)) return unevenness(FaceShape(corners).polygon);
    double most = 0;
    for (const GridPoint& corner : corners.subspan(1))
        most = std::max(most, std::fabs(dot(to_metres(corner) - first, normal)));
    return (most + farthest * off) / long_as * (1 + 0x1p-28) + (max_abs(first) + 2 * farthest) * 0x1p-44;
}

// FaceRecord::first_lane: of as many corners as there may be, in twice as many lanes, and in each of as many groups one
// that is not filled.
static_assert(2 * (kNodeItems * (kMaxCorners - 2) + kNodeItems * FaceLanes::kLanes) <= kLastFirstLane);
static_assert(kMaxCorners <= kLastCornerCount && kNodeItems <= kNoOwner);

/// Of steps of lanes, so that they and their sums stay far from the ends of whole numbers.
constexpr int kMostStepBits = 16;

/// Rounded up to its upper half.
std::uint16_t upper_half(float x) {
    return std::uint16_t((std::bit_cast<std::uint32_t>(x) + 0xFFFF) >> 16);
}

/// Eight triangles that become lanes.
class LaneGroup {
public:
    explicit LaneGroup(const Block& block) : block_(block) {}

    bool is_full() const { return count_ == FaceLanes::kLanes; }
    std::uint32_t count() const { return count_; }

    /// @param corners  of the facet
    /// @param k        which triangle of its fan
    /// @param uneven   of the facet
    void add(std::uint32_t slot, std::span<const GridPoint> corners, std::uint32_t k, float uneven) {
        Triangle& it = triangles_[count_];
        it.slot = slot;
        it.corners[0] = corners[0];
        it.corners[1] = corners[k + 1];
        it.corners[2] = corners[k + 2];
        for (const GridPoint& corner : it.corners) {
            box_.add(corner);
            for (int axis = 0; axis < 3; ++axis)
                differ_ |= std::uint32_t(corner[axis]) ^ std::uint32_t(triangles_[0].corners[0][axis]);
        }
        ++count_;
        if (corners.size() > 3) {
            fans_ = true;
            uneven_ = std::max(uneven_, uneven);
        }
    }

    /// How many FaceLanes it takes.
    std::uint32_t lanes() const { return is_wide() ? 2 : 1; }

    /// Where `lanes()` of them are, as they were made.
    void write(FaceLanes* lanes) const {
        FaceLanes& it = *lanes;
        it.block = &block_;
        it.faces = block_.faces.data();
        const bool wide = is_wide();
        const int shift = wide ? 0 : step_bits();
        it.origin = origin(shift);
        it.step = float(std::int32_t(1) << shift) * float(1 / kSurfaceSteps);
        it.mask_of_all = ~0u;
        it.uneven_high = upper_half(uneven_);
        it.packed = triangles_[0].slot << FaceLanes::kFirstSlot | (count_ - 1) << FaceLanes::kCount |
                    (fans_ ? FaceLanes::kFans : 0) | (wide ? FaceLanes::kWide : 0);
        float shifted = fans_ ? float(1 / kSurfaceSteps) : 0;
        for (std::uint32_t lane = 0; lane < FaceLanes::kLanes; ++lane) {
            const Triangle& from = triangles_[std::min(lane, count_ - 1)];
            const FaceRecord& face = block_.faces[from.slot];
            if (lane > 0) it.packed |= (from.slot - triangles_[0].slot) << (3 * (lane - 1));
            bool exact = face.corner_count == 3;
            for (std::uint32_t c = 0; c < 3; ++c) {
                double sum = 0, off = 0;
                for (int axis = 0; axis < 3; ++axis) {
                    const auto steps = std::int32_t(std::int64_t(from.corners[c][axis]) - it.origin[axis]);
                    exact = exact && (!wide || std::abs(std::int64_t(steps)) <= kExactSteps);
                    sum += std::fabs(double(steps));
                    if (wide) {
                        off += std::fabs(double(steps) - double(float(steps)));
                        it.corner[c][axis][lane] = std::int16_t(steps >> 16);
                        lanes[1].corner[c][axis][lane] = std::int16_t(std::uint16_t(steps));
                    } else {
                        it.corner[c][axis][lane] = std::int16_t(steps >> shift);
                    }
                }
                it.size = std::max(it.size, float(sum / kSurfaceSteps) * kUp);
                if (off > 0) shifted = std::max(shifted, float((off + 1) / kSurfaceSteps) * kUp);
            }
            if (lane >= count_) continue;
            it.mask_of_all &= face.mask;
            if (exact) it.whole |= std::uint8_t(1u << lane);
            if (face.two_sided) it.two_sided |= std::uint8_t(1u << lane);
        }
        if (wide) lanes[1].size = shifted;
    }

private:
    struct Triangle {
        std::uint32_t slot;
        GridPoint corners[3];
    };

    /// Bits below which corners do not differ.
    int step_bits() const { return differ_ ? std::min(std::countr_zero(differ_), kMostStepBits) : 0; }
    bool is_wide() const {
        const int shift = step_bits();
        for (int axis = 0; axis < 3; ++axis)
            if ((std::int64_t(box_.high[axis]) - box_.low[axis]) >> shift > 0xFFFF) return true;
        return false;
    }
    /// In the middle, steps away from all corners.
    GridPoint origin(int shift) const {
        GridPoint made;
        for (int axis = 0; axis < 3; ++axis) {
            const std::int64_t steps = (std::int64_t(box_.high[axis]) - box_.low[axis]) >> shift;
            made[axis] = std::int32_t(box_.low[axis] + ((steps + 1) / 2 << shift));
        }
        return made;
    }

    const Block& block_;
    std::uint32_t count_ = 0;
    std::uint32_t differ_ = 0;
    GridBox box_;
    float uneven_ = 0;
    bool fans_ = false;
    Triangle triangles_[FaceLanes::kLanes];
};

/// Facets in a row into lanes; those before the last group tell that more follow.
void lay_out(Block& block, const FaceSet& faces, std::span<const BuildItem> items, std::uint32_t first,
             std::vector<FaceLanes>& lanes) {
    std::optional<LaneGroup> group;
    GridPoint room[kMaxCorners];
    const auto finish = [&](bool last) {
        const std::size_t at = lanes.size();
        lanes.resize(at + group->lanes());
        group->write(lanes.data() + at);
        if (!last) lanes[at].uneven_high |= FaceLanes::kMore;
    };
    std::uint32_t slot = first;
    for (const BuildItem& item : items) {
        const FaceSet::Entry& face = faces.faces[item.face];
        for (std::uint32_t k = 0; k < face.corner_count; ++k) room[k] = faces.corner(face, k);
        const std::span<const GridPoint> corners(room, face.corner_count);
        const float uneven = corners.size() > 3 ? float(unevenness(corners)) * kUp : 0;
        for (std::uint32_t k = 0; k + 2 < corners.size(); ++k) {
            if (group && group->is_full()) {
                finish(false);
                group.reset();
            }
            if (!group) group.emplace(block);
            if (k == 0)
                block.faces[slot].first_lane =
                    std::uint32_t(lanes.size() * FaceLanes::kLanes + group->count()) & kLastFirstLane;
            group->add(slot, corners, k, uneven);
        }
        ++slot;
    }
    finish(true);
}

}  // namespace

void FaceLayout::make(Node& leaf, Block& block, const FaceSet& faces, const BinTree& tree, std::uint32_t top) {
    const std::span<const BinWidener::Item> items = widener_.widen(leaf, tree, top);
    const std::uint32_t before = tree.nodes[top].first;
    scratch_.clear();
    std::size_t starts[kNodeItems];
    for (std::size_t k = 0; k < items.size(); ++k) {
        const BinWidener::Item& item = items[k];
        const BinNode& bin = tree.nodes[item.what];
        starts[k] = scratch_.size();
        lay_out(block, faces, tree.items_of(bin), bin.first - before, scratch_);
    }
    block.lanes.assign(scratch_.begin(), scratch_.end());
    for (std::size_t k = 0; k < items.size(); ++k)
        leaf.wide[items[k].above].lead_to_facets(items[k].lane, block.lanes.data() + starts[k]);
}

}  // namespace firma
