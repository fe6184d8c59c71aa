// SPDX-License-Identifier: MIT
// Volume, first and second moments of what faces bound, to some hundred bits.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "firma/mass.h"
#include "geometry/double_double.h"
#include "geometry/exact_point.h"

namespace firma {

class SolidPatch;

/// Integrals over a solid of 1, of each coordinate and of each product of two; about a point, in input steps.
struct Moments {
    DoubleDouble volume;
    DoubleDouble first[3];
    DoubleDouble second[3][3];  ///< [i][j] for i <= j; the others are left 0
};

/// Adds `factor` times the other ones, about the same point.
void add_moments(Moments& to, const Moments& other, double factor);

/// A point about an apex, input steps: what costs most, so whoever has many faces takes each point's once.
struct PointArm {
    DoubleDouble at[3];
};
PointArm arm_of(const ExactPoint& point, const InputPoint& apex);

/// Adds faces up, each with its loops: as they look, so that what is behind them counts.
class MomentSum {
public:
    /// @param apex  near the faces: the nearer, the more digits are left
    explicit MomentSum(const InputPoint& apex) : apex_(apex) {}

    /// @param ends    where each loop ends, counted in corners
    /// @param corner  corner(k) is a const ExactPoint&
    template <class Corner>
    void add_face(const Plane& plane, std::span<const std::uint32_t> ends, const Corner& corner) {
        add_arms(plane, ends, [&](std::uint32_t k) { return arm_of(corner(k), apex_); });
    }
    /// @param arm  arm(k) is that of a corner
    template <class Arm>
    void add_arms(const Plane& plane, std::span<const std::uint32_t> ends, const Arm& arm) {
        take_arms(ends, arm);
        add_cones(plane, ends);
    }
    /// Only to sums().volume, which is the same to the bit.
    template <class Arm>
    void add_volume(const Plane& plane, std::span<const std::uint32_t> ends, const Arm& arm) {
        take_arms(ends, arm);
        add_cone_volumes(plane, ends);
    }

    const Moments& sums() const { return sums_; }
    const InputPoint& apex() const { return apex_; }

private:
    template <class Arm>
    void take_arms(std::span<const std::uint32_t> ends, const Arm& arm) {
        arms_.clear();
        for (std::uint32_t k = 0; !ends.empty() && k < ends.back(); ++k) arms_.push_back(arm(k));
    }
    void add_cones(const Plane& plane, std::span<const std::uint32_t> ends);
    void add_cone_volumes(const Plane& plane, std::span<const std::uint32_t> ends);

    const InputPoint apex_;
    Moments sums_{};
    std::vector<PointArm> arms_;
};

/// Of all faces of a patch, about a point near them. Takes 48 bytes a vertex meanwhile.
Moments moments_of(const SolidPatch& patch, const InputPoint& apex);

/// In metres and kilograms; all 0 where the volume is not positive.
/// @param apex  that the moments are about
MassProperties mass_of(const Moments& moments, const InputPoint& apex, double density);

}  // namespace firma
