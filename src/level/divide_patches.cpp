// SPDX-License-Identifier: MIT
// Divides patches: each span by its own shape, then spans that share a rim by the finest of them.
#include "level/divide_patches.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "base/disjoint_sets.h"
#include "level/span_stray.h"

namespace firma {
namespace {

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

// Each span by itself; a patch's spans in one column of the net share their chords along the row, and so on.
std::optional<std::vector<PatchDivision>> divide_alone(std::span<const Patch> patches, double tolerance,
                                                       std::uint64_t max_cells) {
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
                if (cells > max_cells) return std::nullopt;
            }
        }
        divisions.push_back(std::move(division));
    }
    return divisions;
}

// A rim of a span, the same from either end, and whose chords it is divided by.
struct Rim {
    BezierCurve curve;
    std::uint32_t chords = 0;

    Rim(const BezierCurve& c, std::uint32_t owner) : curve(c), chords(owner) {
        if (key(c[2]) < key(c[0])) std::swap(curve[0], curve[2]);
    }
    static std::tuple<double, double, double> key(const Vec3& p) { return {p.x, p.y, p.z}; }
    auto key() const { return std::tuple_cat(key(curve[0]), key(curve[1]), key(curve[2])); }
};

// Every rim of every patch; numbers of chords are counted through all divisions, along rows, then along columns.
std::vector<Rim> gather_rims(std::span<const Patch> patches) {
    std::vector<Rim> rims;
    const auto add = [&](const BezierCurve& curve, std::uint32_t owner) {
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

std::optional<std::vector<PatchDivision>> divide_patches(std::span<const Patch> patches, double tolerance,
                                                         std::uint64_t max_cells) {
    auto divisions = divide_alone(patches, tolerance, max_cells);
    if (!divisions) return std::nullopt;
    level_out(patches, *divisions);
    std::uint64_t cells = 0;
    for (const PatchDivision& division : *divisions) {
        cells += division.cells();
        if (cells > max_cells) return std::nullopt;
    }
    return divisions;
}

}  // namespace firma
