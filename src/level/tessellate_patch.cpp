// SPDX-License-Identifier: MIT
// Divides patches: each span by its own shape, then spans that share a rim by the finest of them.
//
// How far cells stray from the surface. A row of a span is a curve with second derivative 2 D, D = P_0 - 2 P_1 + P_2;
// its chord number k of n strays by  D s(1-s) / n^2,  s in 0..1. Rows in between have for D a mean of the three. So the
// surface of a cell is its bilinear surface, plus such a term of its rows and one of its columns; and the bilinear
// surface strays from the cell's two triangles by a quarter of its twist. Only what is across the cell counts, not what
// is along it: a flat patch needs chords for its rims alone. Rims count whole, since others meet them.
#include "level/tessellate_patch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "level/disjoint_sets.h"

namespace firma {
namespace {

// Three control points in a line of the net.
using Curve = std::array<Vec3, 3>;

Vec3 point_on(const Curve& curve, std::uint32_t k, std::uint32_t n) {
    if (k == 0) return curve[0];
    if (k == n) return curve[2];
    const double a = double(n - k), b = double(k);
    return ((a * a) * curve[0] + (b * b) * curve[2] + (2 * a * b) * curve[1]) * (1 / (double(n) * double(n)));
}

// What makes a curve bend: half its second derivative.
Vec3 bend(const Curve& c) {
    return (c[0] + c[2]) - 2 * c[1];
}

Curve row_of(const Patch& patch, std::uint32_t span, std::uint32_t row) {
    return {patch.at(2 * span, row), patch.at(2 * span + 1, row), patch.at(2 * span + 2, row)};
}

Curve column_of(const Patch& patch, std::uint32_t column, std::uint32_t span) {
    return {patch.at(column, 2 * span), patch.at(column, 2 * span + 1), patch.at(column, 2 * span + 2)};
}

struct Chords {
    std::uint32_t along_row = 1, along_column = 1;

    double rows() const { return double(along_row) * along_row; }
    double columns() const { return double(along_column) * along_column; }
    double both() const { return double(along_row) * along_column; }
};

// How far a division strays from its span, by cause; each the largest of all cells.
struct Stray {
    double rows = 0, columns = 0, twist = 0;

    double total() const { return rows + columns + twist; }
    void add(const Stray& other) {
        rows = std::max(rows, other.rows);
        columns = std::max(columns, other.columns);
        twist = std::max(twist, other.twist);
    }
    // What another division would come to, if cells only differed in size.
    Stray scaled(Chords from, Chords to) const {
        return {rows * (from.rows() / to.rows()), columns * (from.columns() / to.columns()),
                twist * (from.both() / to.both())};
    }
};

// The part of `v` that lies along a direction, or square to it; all of it for a direction of no length.
double along(const Vec3& v, const Vec3& direction) {
    const double size = length(direction);
    return size > 0 ? std::fabs(dot(v, direction)) / size : length(v);
}
double across(const Vec3& v, const Vec3& direction) {
    const double size = length(direction);
    return size > 0 ? length(cross(v, direction)) / size : length(v);
}

// One span of a patch, looked at by itself.
class SpanView {
public:
    SpanView(const Patch& patch, std::uint32_t i, std::uint32_t j) {
        for (std::uint32_t k = 0; k < 3; ++k) {
            rows_[k] = row_of(patch, i, 2 * j + k);
            columns_[k] = column_of(patch, 2 * i + k, j);
            row_bends_[k] = bend(rows_[k]);
            column_bends_[k] = bend(columns_[k]);
        }
    }

    Stray stray(Chords n) const {
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

private:
    std::vector<Vec3> row_at(std::uint32_t y, Chords n) const {
        Curve row;
        for (std::size_t k = 0; k < 3; ++k) row[k] = point_on(columns_[k], y, n.along_column);
        std::vector<Vec3> points;
        for (std::uint32_t x = 0; x <= n.along_row; ++x) points.push_back(point_on(row, x, n.along_row));
        return points;
    }

    static double rim_stray(const Curve& rim, std::uint32_t n) {
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

    // Corners: two of a row, two of the next. Bends at the cell's ends and its middle stand for those in between.
    Stray cell_stray(const std::array<Vec3, 4>& c, std::uint32_t x, std::uint32_t y, Chords n) const {
        const Vec3 normal = cross(c[3] - c[0], c[2] - c[1]);
        Stray stray;
        for (std::uint32_t k = 0; k < 3; ++k) {
            const Vec3 row_bend = point_on(row_bends_, 2 * y + k, 2 * n.along_column);
            const Vec3 column_bend = point_on(column_bends_, 2 * x + k, 2 * n.along_row);
            stray.rows = std::max(stray.rows, along(row_bend, normal) / (4 * n.rows()));
            stray.columns = std::max(stray.columns, along(column_bend, normal) / (4 * n.columns()));
        }
        stray.twist = along((c[3] - c[2]) - (c[1] - c[0]), normal) / 4;
        return stray;
    }

    std::array<Curve, 3> rows_, columns_;
    Curve row_bends_, column_bends_;
};

// One step finer, where it helps most; false when there is none.
bool refine(Chords& n, const Stray& stray) {
    const bool rows = stray.rows >= stray.columns;
    for (std::uint32_t* more : {rows ? &n.along_row : &n.along_column, rows ? &n.along_column : &n.along_row}) {
        if (*more == kMostChords) continue;
        *more = std::min(kMostChords, *more + 1 + *more / 8);
        return true;
    }
    return false;
}

// As few chords as will do: foreseen from a coarse division, then measured on the very cells.
Chords chords_of(const SpanView& span, double tolerance) {
    constexpr Chords kCoarse = {4, 4}, kWhole = {1, 1};
    Stray foreseen = span.stray(kCoarse).scaled(kCoarse, kWhole);
    Chords n = kWhole;
    for (;;) {
        while (foreseen.scaled(kWhole, n).total() > tolerance) {
            if (!refine(n, foreseen.scaled(kWhole, n))) return n;
        }
        const Stray measured = span.stray(n);
        if (measured.total() <= tolerance || !refine(n, measured)) return n;
        foreseen.add(measured.scaled(n, kWhole));
    }
}

std::uint32_t points_of(std::span<const std::uint32_t> chords) {
    std::uint32_t points = 1;
    for (const std::uint32_t n : chords) points += n;
    return points;
}

// Each span by itself; a patch's spans in one column of the net share their chords along the row, and so on.
std::optional<std::vector<PatchDivision>> divide_alone(std::span<const Patch> patches, double tolerance,
                                                       std::uint64_t most_cells) {
    std::vector<PatchDivision> divisions;
    std::uint64_t cells = 0;
    for (const Patch& patch : patches) {
        PatchDivision division;
        division.along_row.resize(patch.width / 2, 1);
        division.along_column.resize(patch.height / 2, 1);
        for (std::uint32_t j = 0; j < patch.height / 2; ++j) {
            for (std::uint32_t i = 0; i < patch.width / 2; ++i) {
                const Chords n = chords_of(SpanView(patch, i, j), tolerance);
                division.along_row[i] = std::max(division.along_row[i], n.along_row);
                division.along_column[j] = std::max(division.along_column[j], n.along_column);
                cells += std::uint64_t(n.along_row) * n.along_column;
                if (cells > most_cells) return std::nullopt;
            }
        }
        divisions.push_back(std::move(division));
    }
    return divisions;
}

// A rim of a span, the same from either end, and whose chords it is divided by.
struct Rim {
    Curve curve;
    std::uint32_t chords = 0;

    Rim(const Curve& c, std::uint32_t owner) : curve(c), chords(owner) {
        if (key(c[2]) < key(c[0])) std::swap(curve[0], curve[2]);
    }
    static std::tuple<double, double, double> key(const Vec3& p) { return {p.x, p.y, p.z}; }
    auto key() const { return std::tuple_cat(key(curve[0]), key(curve[1]), key(curve[2])); }
};

// Every rim of every patch; numbers of chords are counted through all divisions, along rows, then along columns.
std::vector<Rim> gather_rims(std::span<const Patch> patches) {
    std::vector<Rim> rims;
    const auto add = [&](const Curve& curve, std::uint32_t owner) {
        if (curve[0] != curve[1] || curve[0] != curve[2]) rims.emplace_back(curve, owner);  // a point joins nothing
    };
    std::uint32_t first = 0;
    for (const Patch& patch : patches) {
        const std::uint32_t spans_along_row = patch.width / 2, spans_along_column = patch.height / 2;
        for (std::uint32_t i = 0; i < spans_along_row; ++i) {
            for (std::uint32_t y = 0; y < patch.height; y += 2) add(row_of(patch, i, y), first + i);
        }
        first += spans_along_row;
        for (std::uint32_t j = 0; j < spans_along_column; ++j) {
            for (std::uint32_t x = 0; x < patch.width; x += 2) add(column_of(patch, x, j), first + j);
        }
        first += spans_along_column;
    }
    return rims;
}

// Gives all chords that are tied to each other by rims the number of the finest.
void level_out(std::span<const Patch> patches, std::span<PatchDivision> divisions) {
    std::vector<std::uint32_t*> chords;
    for (PatchDivision& division : divisions) {
        for (std::uint32_t& n : division.along_row) chords.push_back(&n);
        for (std::uint32_t& n : division.along_column) chords.push_back(&n);
    }
    DisjointSets ties(chords.size());
    std::vector<Rim> rims = gather_rims(patches);
    std::sort(rims.begin(), rims.end(), [](const Rim& a, const Rim& b) { return a.key() < b.key(); });
    for (std::size_t k = 1; k < rims.size(); ++k) {
        if (rims[k - 1].key() == rims[k].key()) ties.join(rims[k - 1].chords, rims[k].chords);
    }
    for (std::uint32_t k = 0; k < chords.size(); ++k) {
        std::uint32_t& finest = *chords[ties.find(k)];
        finest = std::max(finest, *chords[k]);
    }
    for (std::uint32_t k = 0; k < chords.size(); ++k) *chords[k] = *chords[ties.find(k)];
}

}  // namespace

std::uint32_t PatchDivision::columns() const {
    return points_of(along_row);
}
std::uint32_t PatchDivision::rows() const {
    return points_of(along_column);
}

std::optional<std::vector<PatchDivision>> divide_patches(std::span<const Patch> patches, double tolerance,
                                                         std::uint64_t most_cells) {
    auto divisions = divide_alone(patches, tolerance, most_cells);
    if (!divisions) return std::nullopt;
    level_out(patches, *divisions);
    std::uint64_t cells = 0;
    for (const PatchDivision& division : *divisions) {
        cells += division.cells();
        if (cells > most_cells) return std::nullopt;
    }
    return divisions;
}

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
            const Curve across = {control(2 * i), control(2 * i + 1), control(2 * i + 2)};
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
