// SPDX-License-Identifier: MIT
// Facets laid out for casts: triangles eight side by side, with their corners inside, so that a processor looks at
// eight at a time and fetches nothing else for those that are not met. Corners are exact here, and nowhere else.
#pragma once

#include <bit>
#include <cstdint>

#include "base/seldom.h"
#include "firma/grid.h"
#include "firma/vec.h"

namespace firma {

class Block;
struct FaceRecord;

/// Facets of one block. One of more than three corners is a fan of triangles, side by side, maybe in several of these.
///
/// Corners are whole multiples of a step from an origin. Mostly 16 bits hold them: corners lie on a coarse grid, and
/// facets beside each other are small. Where they do not, two of these in a row hold eight triangles: the second has
/// the lower halves of the numbers, and of all else only `size`.
struct FaceLanes {
    static constexpr std::uint32_t kLanes = 8;

    const Block* block = nullptr;
    const FaceRecord* faces = nullptr;  ///< of the block: one place less to wait for than by way of it
    GridPoint origin;
    float step = 0;  ///< metres, a power of two; here, so that four numbers may be read in a row
    float size = 0;  ///< no corner is farther from the origin, by the sum of its coordinates; of a second: `shifted()`
    std::uint32_t mask_of_all = 0;  ///< bits that all facets have
    std::uint32_t packed = 0;       ///< see below
    std::uint16_t uneven_high = 0;  ///< the upper half of uneven(), and kMore
    std::uint8_t whole = 0;  ///< lanes whose corners are all that the facet has, with a normal that is exact in double
    std::uint8_t two_sided = 0;
    std::int16_t corner[3][3][kLanes] = {};  ///< by corner and axis; of two in a row the upper halves

    static constexpr std::uint16_t kMore = 0x8000;  // the sign of uneven(), which is none

    // Packed: from the lowest bit on, how far the slots of lanes 1 to 7 lie behind the first one's, three bits each;
    // that one's slot, six; how many lanes hold a triangle less one, three; whether there are fans; whether a second
    // follows.
    static constexpr std::uint32_t kFirstSlot = 21, kCount = 27, kFans = 1u << 30, kWide = 1u << 31;

    /// Lanes that hold a triangle, from the first on; the others repeat the last one.
    std::uint32_t count() const { return (packed >> kCount & 7) + 1; }
    std::uint32_t slot(std::uint32_t lane) const {
        return (packed >> kFirstSlot & 63) + ((packed << 3) >> (3 * lane) & 7);  // in the block
    }
    bool is_wide() const { return (packed & kWide) != 0; }
    /// How many of these in a row hold the triangles.
    std::uint32_t in_a_row() const { return (packed >> 31) + 1; }
    /// Whether a wide node leads to those behind them, too, by the same lane.
    bool more_follow() const { return (uneven_high & kMore) != 0; }

    /// No corner is farther from its facet's plane: not 0 where rounding bent one, metres.
    float uneven() const { return std::bit_cast<float>(std::uint32_t(uneven_high & ~kMore) << 16); }
    /// Nor from where the facet has it, in its plane, by more: not 0 where floats, or rounding in polygons, turn a
    /// triangle's normal away from its facet's, metres.
    float shifted() const {
        if (is_wide()) return this[1].size;
        return packed & kFans ? float(1 / kSurfaceSteps) : 0;
    }

    static constexpr std::int32_t kHalves = 1 << 16;  ///< what an upper half counts

    /// A coordinate of a corner, in steps from the origin.
    std::int32_t steps(std::uint32_t k, int axis, std::uint32_t lane) const {
        const std::int32_t upper = corner[k][axis][lane];
        return is_wide() ? upper * kHalves + std::uint16_t(this[1].corner[k][axis][lane]) : upper;
    }
    /// A corner of a lane, exact.
    [[gnu::always_inline]] GridPoint grid_corner(std::uint32_t lane, std::uint32_t k) const {
        GridPoint at = origin;
        if (!is_wide()) [[likely]]
            for (int axis = 0; axis < 3; ++axis) at[axis] += std::int32_t(corner[k][axis][lane]) << step_bits();
        else
            for (int axis = 0; axis < 3; ++axis) at[axis] += steps(k, axis, lane);
        return at;
    }
    /// All three, exact.
    FIRMA_SELDOM void grid_corners(std::uint32_t lane, GridPoint (&corners)[3]) const {
        const int shift = step_bits();
        const auto read = [&](const auto& steps_of) {
            for (int k = 0; k < 3; ++k)
                for (int axis = 0; axis < 3; ++axis) corners[k][axis] = origin[axis] + steps_of(k, axis);
        };
        if (!is_wide()) [[likely]]
            read([&](int k, int axis) { return std::int32_t(corner[k][axis][lane]) << shift; });
        else
            read([&](int k, int axis) { return steps(std::uint32_t(k), axis, lane); });
    }
    /// The corners of a lane, metres, exact.
    void read_corners(std::uint32_t lane, Vec3 (&corners)[3]) const {
        const int shift = step_bits();
        const auto read = [&](const auto& upper) {
            for (int k = 0; k < 3; ++k)
                for (int axis = 0; axis < 3; ++axis)
                    corners[k][axis] = double(origin[axis] + upper(k, axis)) * (1 / kSurfaceSteps);
        };
        if (!is_wide()) [[likely]]
            read([&](int k, int axis) { return std::int32_t(corner[k][axis][lane]) << shift; });
        else
            read([&](int k, int axis) { return steps(std::uint32_t(k), axis, lane); });
    }

    /// A step is 2^that of the grid's.
    int step_bits() const { return exponent(step) - exponent(float(1 / kSurfaceSteps)); }

private:
    /// Of a power of two, counted from that of the smallest float.
    static constexpr int exponent(float power) { return int(std::bit_cast<std::uint32_t>(power) >> 23); }
};

static_assert(sizeof(void*) != 8 || sizeof(FaceLanes) == 192);  // three lines of a cache

/// One triangle after the other of a face's fan, in a block's lanes.
class FaceFan {
public:
    /// @param first_lane  where the first one is: its place among the block's FaceLanes times kLanes, and its lane
    /// there
    FaceFan(const FaceLanes* of_block, std::uint32_t first_lane)
        : lanes_(of_block + first_lane / FaceLanes::kLanes), lane_(first_lane % FaceLanes::kLanes) {}

    /// @param triangles  the fan has so many more
    FIRMA_SELDOM void advance(std::uint32_t triangles) {
        lane_ += triangles;
        while (lane_ >= FaceLanes::kLanes) {  // one that goes on in the next fills this one
            lane_ -= FaceLanes::kLanes;
            lanes_ += lanes_->in_a_row();
        }
    }
    FIRMA_SELDOM GridPoint corner(std::uint32_t k) const { return lanes_->grid_corner(lane_, k); }
    void read_corners(GridPoint (&corners)[3]) const { lanes_->grid_corners(lane_, corners); }

    const FaceLanes* lanes() const { return lanes_; }
    std::uint32_t lane() const { return lane_; }

private:
    const FaceLanes* lanes_;
    std::uint32_t lane_;
};

}  // namespace firma
