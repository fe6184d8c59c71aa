// SPDX-License-Identifier: MIT
// Sums of doubles held exactly, for the sign of a sum of products.
// Source: J. R. Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates, 1997,
// section 2.
#pragma once

#include <array>

#include "base/assert.h"
#include "geometry/double_double.h"

namespace firma {

/// An exact sum of up to `capacity` doubles: parts that do not overlap, smallest first, zeros left out.
template <int capacity>
class Expansion {
public:
    /// Adds a double, exactly.
    void add(double value) {
        int kept = 0;
        for (int k = 0; k < count_; ++k) {
            const DoubleDouble sum = two_sum(value, parts_[k]);
            if (sum.low != 0) parts_[kept++] = sum.low;
            value = sum.high;
        }
        if (value != 0) {
            FIRMA_ASSERT(kept < capacity, "an expansion outgrew its capacity: count its terms again");
            parts_[kept++] = value;
        }
        count_ = kept;
    }

    /// Adds a * b, exactly.
    void add_product(double a, double b) {
        if (a == 0 || b == 0) return;
        const DoubleDouble p = two_product(a, b);
        add(p.low);
        add(p.high);
    }

    /// -1, 0 or 1: that of the largest part.
    int sign() const { return count_ == 0 ? 0 : parts_[count_ - 1] < 0 ? -1 : 1; }

    int count() const { return count_; }
    double operator[](int k) const { return parts_[k]; }

private:
    std::array<double, capacity> parts_;
    int count_ = 0;
};

}  // namespace firma
