// SPDX-License-Identifier: MIT
// Polygons that bound nothing (sheets, decals, clips), and what placed cutters leave of them: each without what lies in
// a cutter, with no cap.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "arrange/find_cells.h"
#include "carve/cutter_pairs.h"
#include "carve/overlay_operands.h"
#include "carve/pair_budget.h"
#include "solid/face_set.h"
#include "solid/make_facets.h"

namespace firma {

/// A placed cutter, and what it may take of.
struct Trim {
    const CutterSolid* cutter = nullptr;
    std::vector<std::uint32_t> facets;  ///< numbers, ascending
};

/// Of facets with corners on the surface grid, by any number of cutters at once, which may overlap. All is decided
/// exactly, also where a cutter touches; corners that come are rounded once to that grid, and neighbours get the same
/// ones. What of a polygon lies on a cutter's surface goes where both look the same way, as of solids. Slivers of some
/// micrometres at that surface, which come of rounding, stay: so the same cut again takes nothing.
///
/// A slanted polygon longer than 16 m whose corners lie off the input grid may have no exact plane: it is divided
/// first.
class PolygonTrimmer {
public:
    enum class End : std::uint8_t {
        kGoesOn,  ///< call step() again
        kDone,
        kPairs,     ///< the budget is spent
        kTooLarge,  ///< more planes than one arrangement holds
        kBroken,    ///< a cutter crosses itself
    };
    enum class Fate : std::uint8_t { kStays, kTrimmed, kGoes };

    /// @param facets     kept alive by the caller, as are the cutters
    /// @param max_pairs  of all cutters
    PolygonTrimmer(std::vector<FacetPlace> facets, std::vector<Trim> trims, std::uint64_t max_pairs);

    /// Does one piece of work.
    End step();

    // Once it is done:
    const std::vector<FacetPlace>& facets() const { return facets_; }
    Fate fate(std::size_t facet) const { return fate_[facet]; }
    /// Puts what is left of a facet at the end of a set: convex polygons, exactly planar, ids left open. Of one that
    /// does not go; of one that stays, all of it.
    void append_left(std::size_t facet, FaceSet& set) const;

private:
    enum class Phase : std::uint8_t { kPolygons, kCutters, kPairs, kSpans, kLines, kCells, kPlaces };
    /// A polygon that is left.
    struct Left {
        std::uint32_t facet = 0;
        std::uint32_t first = 0, count = 0;  ///< in left_corners_
    };

    /// Cutters that may take of a facet, by number.
    std::span<const std::uint32_t> cutters_of(std::uint32_t facet) const {
        return {cutters_.data() + first_cutter_[facet], first_cutter_[facet + 1] - first_cutter_[facet]};
    }
    void add_facet(std::uint32_t facet);
    void add_polygon(std::uint32_t facet, const std::vector<GridPoint>& corners);
    void divide(std::uint32_t facet, const std::vector<GridPoint>& corners);
    std::uint32_t point(const GridPoint& p);
    End add_cutters(WorkSlice& slice);
    bool add_cutter(WorkSlice& slice);
    void start_pairs();
    End meet_next();
    void place_cells(std::uint32_t face);
    bool lies_in(const Cell& cell);
    bool lies_deep(std::span<const std::uint32_t> cutters, const Vec3& middle) const;
    void write_cells(std::uint32_t face);
    bool join_kept(std::uint32_t face);
    void write(std::uint32_t facet, const Plane& plane, std::span<const PieceUse> uses,
               std::span<const std::uint32_t> ends);
    void find_facets(const Plane& plane, std::span<const PieceUse> uses, std::span<const std::uint32_t> ends);
    End finish();
    template <class Function>
    void for_each_facet(std::span<const GridPoint> points, FlatView view, const Function& function) const;
    void add_left(std::uint32_t facet, std::span<const GridPoint> corners);
    std::uint32_t start_of(const PieceUse& use) const {
        const Piece& piece = lines_.piece(use.piece);
        return use.forward ? piece.from : piece.to;
    }

    const std::vector<FacetPlace> facets_;
    const std::vector<Trim> trims_;
    std::vector<std::uint32_t> first_cutter_, cutters_;  ///< of each facet
    PairBudget budget_;
    Phase phase_ = Phase::kPolygons;
    std::uint32_t next_ = 0;  ///< in the loop of the phase

    Overlay overlay_;
    std::vector<std::uint32_t> facet_of_;               ///< of the overlay's first faces; the cutters' follow
    std::vector<std::uint32_t> first_face_;             ///< of each facet, and one more
    std::vector<std::vector<std::uint32_t>> faces_of_;  ///< the overlay's, of each cutter's triangles or facets
    std::unique_ptr<PatchAdder> solid_;
    std::uint32_t first_of_solid_ = 0;  ///< its first face of the overlay
    std::unique_ptr<MeshAdder> mesh_;
    CutterPairs pairs_;
    SpanFinder spans_{overlay_};
    DividedLines lines_{overlay_, spans_};
    CellFinder cells_{overlay_, spans_, lines_};
    FlatEdges flat_{overlay_, lines_};
    std::vector<std::uint8_t> kept_;  ///< of the cells of the face at hand

    std::vector<Fate> fate_;
    std::vector<std::uint8_t> loses_;  ///< each facet, whether it does
    std::vector<Left> left_;           ///< in order of facets, once it is done
    std::vector<GridPoint> left_corners_;

    // Scratch.
    std::vector<PieceUse> uses_, loops_;
    std::vector<std::uint32_t> ends_;
    LoopsByOutline outlines_;
    std::vector<OverlaySide> sides_;
    std::vector<GridPoint> points_;
    std::vector<Vec3> exact_;
    FacetMaker facet_maker_;
    Facets made_;
};

}  // namespace firma
