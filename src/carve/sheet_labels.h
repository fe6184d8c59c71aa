// SPDX-License-Identifier: MIT
// Where pieces of polygons in the air lie against what fills it, and the air that each face of the fill bounds.
#pragma once

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "base/disjoint_sets.h"
#include "carve/point_within.h"
#include "carve/sheet_overlay.h"

namespace firma {

/// Where a piece of a sheet lies against the cutter.
enum class SheetPlace : std::uint8_t { kOut, kIn, kOn, kUnknown };

class SheetLabels {
public:
    /// @param arranged, air_of  live as long as this
    SheetLabels(SheetOverlay& arranged, const std::function<std::uint32_t(std::uint32_t)>& air_of)
        : of_(arranged), air_of_(air_of) {}

    /// @return false where it cannot be told
    bool find();

    // Once find() said true, of cells:
    SheetPlace place(std::uint32_t cell) const { return place_[cell]; }
    const FaceAir& air(std::uint32_t cell) const { return air_[cell]; }
    bool is_kept(std::uint32_t cell) const;

private:
    static constexpr std::uint32_t kNoNumber = SheetOverlay::kNoNumber;
    static constexpr std::uint8_t kWall = 2;  ///< a spoke's operand; its cell is in walls_

    /// How a face that is not in the overlay uses an edge.
    struct WallSide {
        const SolidPlane* plane = nullptr;
        bool reversed = false;
        std::uint32_t air = 0;
        std::uint32_t next = kNoNumber;  ///< of those that use the edge
    };

    bool label_sheets();
    /// By a point within it.
    SheetPlace place_of(const Cell& cell);
    /// Of a piece that is too thin for a point within it: by what stands around its edges.
    SheetPlace place_by_edges(std::uint32_t cell);
    SheetPlace place_around(std::uint32_t piece, std::uint32_t cell);
    CellSpoke spoke_of(std::uint32_t use) const;
    bool label_faces();
    /// Of cells whose air is not told: they meet sheets in points at most, such as a corner that lies on one.
    void find_places(DisjointSets& sets);
    static double distance(const SolidPlane& sheet, const ExactPoint& corner);
    /// Faces that the fill left, and pieces of those that it cut, by the edges that they use.
    void know_walls();
    void look_around(std::uint32_t piece, DisjointSets& sets,
                     std::vector<std::pair<std::uint32_t, std::uint32_t>>& told);
    /// Where faces meet along a line two and two, walls may stand between a face of the fill and a sheet.
    void add_wall_spokes(std::uint32_t piece);
    /// Faces that share an edge, without a sheet between them, bound the same air.
    void tell_by_walls(std::vector<std::pair<std::uint32_t, std::uint32_t>>& told);

    SheetOverlay& of_;
    const std::function<std::uint32_t(std::uint32_t)>& air_of_;
    bool failed_ = false;
    std::vector<SheetPlace> place_;
    std::vector<FaceAir> air_;
    std::vector<WallSide> walls_;
    std::vector<std::uint32_t> first_wall_;  ///< in walls_, of edges by number
    std::vector<std::uint32_t> at_sheet_, faces_at_, numbers_;
    std::vector<CellSpoke> spokes_;
    std::vector<ExactPoint> corners_;
    WithinFinder within_;
};

}  // namespace firma
