// SPDX-License-Identifier: MIT
// Quadratic Bezier patches, as Quake 3 has them: how finely each is divided, and the points that come of it.
//
// A patch is a net of control points, odd in width and height: spans of three by three that share their rims, each
//   S(u, v) = sum over i, j in 0..2 of B_i(u) B_j(v) P_ij,  B_0 = (1-t)^2, B_1 = 2t(1-t), B_2 = t^2.
// A span of n chords is the curve at t = k/n:  ((n-k)^2 P_0 + k^2 P_2 + 2k(n-k) P_1) / n^2.
// The weights are whole numbers and the outer terms are added first, so from the other end it is the same sum, bit for
// bit.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
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
    std::uint32_t columns() const;
    std::uint32_t rows() const;
    std::uint64_t cells() const { return std::uint64_t(columns() - 1) * (rows() - 1); }
};

/// No span gets more chords than this, whatever the tolerance.
inline constexpr std::uint32_t kMostChords = 64;

/// Chooses the divisions of all patches of a level together.
///
/// @param tolerance   > 0, in the unit of the control points
/// @param most_cells  of all patches together
/// @return one division a patch; nothing when they would make more cells, found before work or memory is spent on them.
///         Each is fine enough for its own patch (short of kMostChords): every point of the surface is within
///         `tolerance` of the triangles of its cells, and every point of a rim of its chord. (Measured on the cells,
///         not proven. Where a patch folds over itself within its own plane, the fold may be off by a few times as
///         much.) Spans of any patches that have a rim with the same three control points, in either direction, get the
///         same number of chords. So they get the same points there: no cracks. Where a rim of one patch is only part
///         of a span of another, or is met by flat surfaces, nothing is promised.
std::optional<std::vector<PatchDivision>> divide_patches(std::span<const Patch> patches, double tolerance,
                                                         std::uint64_t most_cells);

/// Points row by row, columns() by rows() of them.
std::vector<Vec3> tessellate_patch(const Patch& patch, const PatchDivision& division);

}  // namespace firma
