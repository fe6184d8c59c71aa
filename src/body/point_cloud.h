// SPDX-License-Identifier: MIT
// Many points, in rows of single precision: distances to all of them at a time.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "firma/vec.h"

namespace firma {

/// Rows begin at a middle near all points, so distances are off by some 2^-22 of how far these are from it.
class PointCloud {
public:
    static constexpr std::size_t kRow = 64;
    using Row = std::array<float, kRow>;

    explicit PointCloud(const Vec3& middle) : middle_(middle) {}

    void add(const Vec3& point);
    std::size_t size() const { return count_; }
    /// The last row is filled up with points far away.
    std::size_t row_count() const { return rows_.size(); }

    /// Of the distances from a point to those of one row: square metres.
    void squares(std::size_t row, const Vec3& from, Row& to) const;
    /// None of squares() is less. Rows whose points lie near each other are passed over by this.
    float least_square(std::size_t row, const Vec3& from) const;

    struct Nearest {
        double distance = 0;  ///< metres
        Vec3 at;
    };
    /// Looks at all of them, of which there is at least one. Of several as near the first.
    Nearest nearest(const Vec3& from) const;

private:
    using Corner = std::array<float, 3>;
    struct Axes {
        Row x, y, z;
        Corner low, high;  ///< of a box around them
    };

    Vec3 middle_;
    std::vector<Axes> rows_;
    std::size_t count_ = 0;
};

}  // namespace firma
