// SPDX-License-Identifier: MIT
// Measures how far the cells of a span stray from its surface.
//
// A row of a span is a curve with second derivative 2 D, D = P_0 - 2 P_1 + P_2;
// its chord number k of n strays by  D s(1-s) / n^2,  s in 0..1. Rows in between have for D a mean of the three. So the
// surface of a cell is its bilinear surface, plus such a term of its rows and one of its columns; and the bilinear
// surface strays from the cell's two triangles by a quarter of its twist. Only what is across the cell counts, not what
// is along it: a flat patch needs chords for its rims alone. Rims count whole, since others meet them.
#include "level/span_stray.h"

#include <cmath>
#include <utility>

namespace firma {
namespace {

// What makes a curve bend: half its second derivative.
Vec3 bend(const BezierCurve& c) {
    return (c[0] + c[2]) - 2 * c[1];
}

// The part of `v` that lies along a direction, or square to it; all of it for a direction of no length.
double along(const Vec3& v, const Vec3& direction) {
    const double size = length(direction);
    return size > 0 ? std::fabs(dot(v, direction)) / size : length(v);
}
double across(const Vec3& v, const Vec3& direction) {
    const double size = length(direction);
    return size > 0 ? length(cross(v, direction)) / size : length(v);
}

double rim_stray(const BezierCurve& rim, std::uint32_t n) {
    const Vec3 bow = bend(rim) * (1 / (4.0 * n * n));
    double most = 0;
    Vec3 from = rim[0];
    for (std::uint32_t k = 1; k <= n; ++k) {
        const Vec3 to = point_on(rim, k, n);
        most = std::max(most, across(bow, to - from));
        from = to;
    }
    return most;
}

}  // namespace

SpanView::SpanView(const Patch& patch, std::uint32_t i, std::uint32_t j) {
    for (std::uint32_t k = 0; k < 3; ++k) {
        rows_[k] = row_of(patch, i, 2 * j + k);
        columns_[k] = column_of(patch, 2 * i + k, j);
        row_bends_[k] = bend(rows_[k]);
        column_bends_[k] = bend(columns_[k]);
    }
}

std::vector<Vec3> SpanView::row_at(std::uint32_t y, Chords n) const {
    BezierCurve row;
    for (std::size_t k = 0; k < 3; ++k) row[k] = point_on(columns_[k], y, n.along_column);
    std::vector<Vec3> points;
    for (std::uint32_t x = 0; x <= n.along_row; ++x) points.push_back(point_on(row, x, n.along_row));
    return points;
}

// Corners: two of a row, two of the next. Bends at the cell's ends and its middle stand for those in between.
Stray SpanView::cell_stray(const std::array<Vec3, 4>& c, std::uint32_t x, std::uint32_t y, Chords n) const {
    const Vec3 normal = cross(c[3] - c[0], c[2] - c[1]);
    Stray stray;
    for (std::uint32_t k = 0; k < 3; ++k) {
        const Vec3 row_bend = point_on(row_bends_, 2 * y + k, 2 * n.along_column);
        const Vec3 column_bend = point_on(column_bends_, 2 * x + k, 2 * n.along_row);
        stray.rows = std::max(stray.rows, along(row_bend, normal) / (4 * n.rows_squared()));
        stray.columns = std::max(stray.columns, along(column_bend, normal) / (4 * n.columns_squared()));
    }
    stray.twist = along((c[3] - c[2]) - (c[1] - c[0]), normal) / 4;
    return stray;
}

Stray SpanView::stray(Chords n) const {
    Stray most;
    for (const std::size_t k : {0u, 2u}) {
        most.rows = std::max(most.rows, rim_stray(rows_[k], n.along_row));
        most.columns = std::max(most.columns, rim_stray(columns_[k], n.along_column));
    }
    std::vector<Vec3> row = row_at(0, n), next;
    for (std::uint32_t y = 0; y < n.along_column; ++y) {
        next = row_at(y + 1, n);
        for (std::uint32_t x = 0; x < n.along_row; ++x) {
            most.add(cell_stray({row[x], row[x + 1], next[x], next[x + 1]}, x, y, n));
        }
        std::swap(row, next);
    }
    return most;
}

}  // namespace firma
