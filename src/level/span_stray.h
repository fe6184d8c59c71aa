// SPDX-License-Identifier: MIT
// How far the cells of a divided span of a patch stray from its surface.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "firma/vec.h"
#include "level/patch.h"

namespace firma {

/// A span's chords, each way.
struct Chords {
    std::uint32_t along_row = 1, along_column = 1;

    double rows_squared() const { return double(along_row) * along_row; }
    double columns_squared() const { return double(along_column) * along_column; }
    double product() const { return double(along_row) * along_column; }
};

/// By cause; each the largest of all cells.
struct Stray {
    double rows = 0, columns = 0, twist = 0;

    double total() const { return rows + columns + twist; }
    void add(const Stray& other) {
        rows = std::max(rows, other.rows);
        columns = std::max(columns, other.columns);
        twist = std::max(twist, other.twist);
    }
    /// What another division would come to, if cells only differed in size.
    Stray scaled(Chords from, Chords to) const {
        return {rows * (from.rows_squared() / to.rows_squared()),
                columns * (from.columns_squared() / to.columns_squared()), twist * (from.product() / to.product())};
    }
};

/// One span of a patch, looked at by itself.
class SpanView {
public:
    /// The span in column i and row j of spans.
    SpanView(const Patch& patch, std::uint32_t i, std::uint32_t j);

    Stray stray(Chords n) const;

private:
    std::vector<Vec3> row_at(std::uint32_t y, Chords n) const;
    Stray cell_stray(const std::array<Vec3, 4>& corners, std::uint32_t x, std::uint32_t y, Chords n) const;

    std::array<BezierCurve, 3> rows_, columns_;
    BezierCurve row_bends_, column_bends_;
};

}  // namespace firma
