// SPDX-License-Identifier: MIT
// Where a face of the world and the cutter's triangles cross: segments directed along face normal x triangle normal.
#pragma once

#include "base/flat_map.h"
#include "carve/crossings.h"
#include "carve/pair_budget.h"

namespace firma {

/// Cuts faces of the patch, one by one, each by all triangles whose boxes meet its own.
///
/// A predicate that answers zero is settled as if the cutter were shifted by less than anything (exact_shift.h), where
/// nothing touches: a corner on a plane, but beside the polygon in it. Where something touches, the position is
/// degenerate.
class FaceCutter {
public:
    /// @param budget  a pair of a face and a triangle takes one; looking at all corners of a face one for every 64
    FaceCutter(const CutInput& in, PairBudget& budget) : patch_(in.patch), cutter_(in.cutter), budget_(budget) {}

    /// Forgets what it made, but keeps the memory.
    void start();

    /// Stops at the first degenerate pair, and when the budget is spent: then nothing is known.
    Verdict cut_face(std::uint32_t face);

    /// Of all faces cut since the start.
    const Crossings& made() const { return made_; }

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

    const SolidPatch& patch_;
    const CutterSolid& cutter_;
    PairBudget& budget_;
    Crossings made_;
    FlatMap world_crossings_, cutter_crossings_;  ///< by edge and face
    FlatMap met_at_;                              ///< by triangle and place, those of world edges
    const Plane* face_plane_ = nullptr;
    std::vector<std::int8_t> cutter_sides_;  ///< of the face at hand; kUnasked where not known yet
    std::vector<std::uint32_t> asked_;       ///< the vertices of which they are known
    std::vector<std::int8_t> face_sides_;
    std::vector<OnLine> line_;
    std::vector<GridPoint> points_;
};

}  // namespace firma
