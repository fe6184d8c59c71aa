// SPDX-License-Identifier: MIT
// Quadratic Bezier patches, as Quake 3 has them: nets of control points, and points of their curves.
//
// A net is odd in width and height: spans of three by three control points that share their rims, each the surface
//   S(u, v) = sum over i, j in 0..2 of B_i(u) B_j(v) P_ij,  B_0 = (1-t)^2, B_1 = 2t(1-t), B_2 = t^2.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "firma/vec.h"

namespace firma {

/// Control points row by row; width and height odd and at least 3.
struct Patch {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<Vec3> control;

    const Vec3& at(std::uint32_t column, std::uint32_t row) const { return control[std::size_t(row) * width + column]; }
};

/// The number of chords that each span is divided into, along its rows and along its columns.
struct PatchDivision {
    std::vector<std::uint32_t> along_row, along_column;  ///< width / 2 and height / 2 of them

    /// Of points.
    std::uint32_t columns() const { return points_of(along_row); }
    std::uint32_t rows() const { return points_of(along_column); }
    std::uint64_t cells() const { return std::uint64_t(columns() - 1) * (rows() - 1); }

private:
    static std::uint32_t points_of(const std::vector<std::uint32_t>& chords) {
        std::uint32_t points = 1;
        for (const std::uint32_t n : chords) points += n;
        return points;
    }
};

/// Three control points in a line of the net: one span's part of a row or a column.
using BezierCurve = std::array<Vec3, 3>;

inline BezierCurve row_of(const Patch& patch, std::uint32_t span, std::uint32_t row) {
    return {patch.at(2 * span, row), patch.at(2 * span + 1, row), patch.at(2 * span + 2, row)};
}

inline BezierCurve column_of(const Patch& patch, std::uint32_t column, std::uint32_t span) {
    return {patch.at(column, 2 * span), patch.at(column, 2 * span + 1), patch.at(column, 2 * span + 2)};
}

/// The point at t = k / n:  ((n-k)^2 P_0 + k^2 P_2 + 2k(n-k) P_1) / n^2.  The weights are whole numbers and the outer
/// terms are added first, so from the other end it is the same sum, bit for bit.
inline Vec3 point_on(const BezierCurve& curve, std::uint32_t k, std::uint32_t n) {
    if (k == 0) return curve[0];
    if (k == n) return curve[2];
    const double a = double(n - k), b = double(k);
    return ((a * a) * curve[0] + (b * b) * curve[2] + (2 * a * b) * curve[1]) * (1 / (double(n) * double(n)));
}

}  // namespace firma
