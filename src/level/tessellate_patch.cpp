// SPDX-License-Identifier: MIT
// Evaluates a patch, row after row.
#include "level/tessellate_patch.h"

namespace firma {

std::vector<Vec3> tessellate_patch(const Patch& patch, const PatchDivision& division) {
    std::vector<Vec3> points;
    points.reserve(std::size_t(division.columns()) * division.rows());
    // One row of points, from a row of the net's columns each brought to the same place.
    const auto add_row = [&](std::uint32_t span, std::uint32_t y) {
        const auto control = [&](std::uint32_t column) {
            return point_on(column_of(patch, column, span), y, division.along_column[span]);
        };
        points.push_back(control(0));
        for (std::uint32_t i = 0; i < division.along_row.size(); ++i) {
            const BezierCurve across = {control(2 * i), control(2 * i + 1), control(2 * i + 2)};
            for (std::uint32_t x = 1; x <= division.along_row[i]; ++x) {
                points.push_back(point_on(across, x, division.along_row[i]));
            }
        }
    };
    add_row(0, 0);
    for (std::uint32_t j = 0; j < division.along_column.size(); ++j) {
        for (std::uint32_t y = 1; y <= division.along_column[j]; ++y) add_row(j, y);
    }
    return points;
}

}  // namespace firma
