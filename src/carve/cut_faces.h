// SPDX-License-Identifier: MIT
// Where a face of the world and the cutter's triangles cross: segments directed along face normal x triangle normal.
#pragma once

#include "carve/cut_state.h"
#include "carve/pair_budget.h"

namespace firma {

/// Cuts one face of the patch by all triangles whose boxes meet its own.
///
/// A predicate that answers zero is settled as if the cutter were shifted by less than anything (exact_shift.h), where
/// nothing touches: a corner on a plane, but beside the polygon in it. Where something touches, the position is
/// degenerate.
class FaceCutter {
public:
    /// @param budget  a pair of a face and a triangle takes one; looking at all corners of a face one for every 64
    FaceCutter(Cut& cut, PairBudget& budget) : cut_(cut), budget_(budget) {}

    /// What touches is added to Cut::touching. Stops at the first degenerate pair unless the cut collects them, and
    /// when the budget is spent: then nothing is known.
    Verdict cut_face(std::uint32_t face);

private:
    struct OnLine {
        std::uint32_t crossing;
        const Plane* across;  ///< through the point, not along the line
        bool of_face;         ///< the face's rim crosses the triangle here; else the other way round
    };

    Verdict cut_pair(std::uint32_t face, std::uint32_t triangle);
    void start_face(const PatchFace& face);
    bool touches_face(const PatchFace& face, const ExactPoint& point);
    bool touches_triangle(std::uint32_t triangle, const ExactPoint& point) const;
    int side_of_face(std::uint32_t cutter_vertex, const PatchFace& face);
    int side_of_triangle(std::uint32_t patch_vertex, std::uint32_t triangle) const;
    int order(const OnLine& a, const OnLine& b, const Plane& triangle) const;
    std::uint32_t world_crossing(std::uint32_t edge, std::uint32_t triangle);
    std::uint32_t cutter_crossing(std::uint32_t edge, std::uint32_t face);
    Verdict emit(std::uint32_t face, std::uint32_t triangle);
    std::uint32_t vertex_of(std::uint32_t crossing);
    std::uint32_t new_vertex(std::uint32_t crossing);

    Cut& cut_;
    PairBudget& budget_;
    const Plane* face_plane_ = nullptr;
    std::vector<std::int8_t> cutter_sides_;  ///< of the face at hand; kUnasked where not known yet
    std::vector<std::uint32_t> asked_;       ///< the vertices of which they are known
    std::vector<std::int8_t> face_sides_;
    std::vector<OnLine> line_;
    std::vector<GridPoint> points_;
};

}  // namespace firma
