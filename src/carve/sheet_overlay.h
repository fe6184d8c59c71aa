// SPDX-License-Identifier: MIT
// A fill's faces and the polygons that stand in the air near it, as one arrangement.
#pragma once

#include <cstdint>
#include <vector>

#include "arrange/divide_lines.h"
#include "arrange/find_cells.h"
#include "arrange/find_spans.h"
#include "arrange/label_cells.h"
#include "arrange/overlay.h"
#include "base/flat_map.h"
#include "carve/clip_sheets.h"
#include "carve/cut_view.h"

namespace firma {

/// Polygons are called sheets here. Read by what labels the cells, and by what writes them.
struct SheetOverlay {
    static constexpr std::uint32_t kNoNumber = ~0u;

    /// Where an edge of the overlay comes from: by number (cut_view.h), or a sheet's own.
    struct Origin {
        std::uint32_t number = kNoNumber;
        SolidUse use;
    };

    /// @param cut_in, crossings, cut_loops, cut_sheets  live as long as this
    SheetOverlay(const CutInput& cut_in, const Crossings& crossings, const NewLoops& cut_loops,
                 const std::vector<CutSheet>& cut_sheets);

    /// @return false where cells contradict each other
    bool arrange();

    const CellSet& cells() const { return cell_finder_.cells(); }
    bool is_sheet(std::uint32_t face) const { return face >= face_of.size(); }
    const CutSheet& sheet(std::uint32_t face) const { return sheets[face - face_of.size()]; }
    std::uint32_t start_of(const PieceUse& use) const;
    /// Of a use by a face: the number of the edge that it is part of; kNoNumber within the face.
    std::uint32_t number_of_use(std::uint32_t use) const;
    /// Whether it has all of its edge.
    bool is_whole(const PieceUse& use) const;

    const CutInput& in;
    const CutView view;
    const NewLoops& loops;  ///< of the fill
    const std::vector<CutSheet>& sheets;

    Overlay overlay;
    std::vector<std::uint32_t> overlay_edge;     ///< of edges by number
    std::vector<Origin> origin;                  ///< of the overlay's edges
    std::vector<std::uint32_t> vertex_of_point;  ///< by number, of the overlay's points
    std::vector<std::uint32_t> face_of;          ///< NewLoops::faces, of the overlay's first faces; sheets follow
    SpanFinder spans{overlay};
    DividedLines lines{overlay, spans};
    PieceUsers users;

private:
    void know_divisions();
    std::uint32_t point(const ExactPoint& exact);
    /// The overlay's edge of one by number.
    std::uint32_t numbered_edge(std::uint32_t number);
    std::uint32_t vertex_point(std::uint32_t vertex);
    std::uint32_t own_edge(const SolidUse& use);
    /// What the fill makes of the cutter.
    void add_faces();
    /// Edges that faces have, too, as these have them now.
    void add_sheets();
    void add_numbered_sides(const PatchUse& use);

    CellFinder cell_finder_{overlay, spans, lines};
    std::vector<std::uint32_t> division_of_;  ///< of the patch's edges
    std::vector<OverlaySide> sides_;
    FlatMap own_edge_;  ///< of the overlay, by address
};

}  // namespace firma
