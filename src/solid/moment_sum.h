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

/// Integrals over a solid of 1, of each coordinate and of each product of two; about a point, in input steps.
struct Moments {
    DoubleDouble volume;
    DoubleDouble first[3];
    DoubleDouble second[3][3];  ///< [i][j] for i <= j; the others are left 0
};

/// Adds `factor` times the other ones, about the same point.
void add_moments(Moments& to, const Moments& other, double factor);

/// Adds faces up, each with its loops: as they look, so that what is behind them counts.
class MomentSum {
public:
    /// @param apex  near the faces: the nearer, the more digits are left
    explicit MomentSum(const InputPoint& apex) : apex_(apex) {}

    /// @param ends    where each loop ends, counted in corners
    /// @param corner  corner(k) is a const ExactPoint&
    template <class Corner>
    void add_face(const Plane& plane, std::span<const std::uint32_t> ends, const Corner& corner) {
        if (ends.empty()) return;
        arms_.clear();
        for (std::uint32_t k = 0; k < ends.back(); ++k) arms_.push_back(arm(corner(k)));
        add_cones(plane, ends);
    }

    const Moments& sums() const { return sums_; }
    const InputPoint& apex() const { return apex_; }

private:
    /// A corner about the apex, input steps.
    struct PointArm {
        DoubleDouble at[3];
    };
    PointArm arm(const ExactPoint& point) const;
    void add_cones(const Plane& plane, std::span<const std::uint32_t> ends);

    const InputPoint apex_;
    Moments sums_{};
    std::vector<PointArm> arms_;
};

/// In metres and kilograms; all 0 where the volume is not positive.
/// @param apex  that the moments are about
MassProperties mass_of(const Moments& moments, const InputPoint& apex, double density);

}  // namespace firma
