// SPDX-License-Identifier: MIT
// Puts the two solids of a cut into an overlay, step by step.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "arrange/overlay.h"
#include "base/work_slice.h"
#include "carve/cutter_solid.h"
#include "geometry/flat_loop.h"
#include "solid/solid_patch.h"

namespace firma {

/// The faces of a patch that are not replaced.
class PatchAdder {
public:
    PatchAdder(const SolidPatch& patch, std::uint8_t operand, Overlay& overlay);

    /// @return whether all of it is done; else call it again
    bool add(WorkSlice& slice);

    /// The patch's, of the overlay's faces and edges added.
    const std::vector<std::uint32_t>& faces() const { return faces_; }
    const std::vector<std::uint32_t>& edges() const { return edges_; }
    /// The overlay's, of the patch's vertices; ~0: one of no face added.
    const std::vector<std::uint32_t>& points() const { return point_of_; }

private:
    std::uint32_t point(std::uint32_t vertex);
    std::uint32_t edge(std::uint32_t index);

    const SolidPatch& patch_;
    const std::uint8_t operand_;
    Overlay& overlay_;
    std::uint32_t next_ = 0;
    std::vector<std::uint32_t> point_of_, edge_of_, edges_, faces_;
    std::vector<OverlaySide> sides_;
};

/// A mesh that cuts: neighbouring triangles in one plane are one face.
class MeshAdder {
public:
    MeshAdder(const CutterSolid& cutter, std::uint8_t operand, Overlay& overlay);

    /// @return whether all of it is done; else call it again
    bool add(WorkSlice& slice);

    /// The lowest triangle of each of the overlay's faces added.
    const std::vector<std::uint32_t>& triangles() const { return triangles_; }
    std::size_t edge_count() const { return edge_count_; }
    /// The overlay's, of the cutter's triangles and points.
    const std::vector<std::uint32_t>& face_of() const { return face_of_; }
    const std::vector<std::uint32_t>& points() const { return point_of_; }

private:
    enum class Stage : std::uint8_t { kPlanes, kPoints, kRims, kFaces };

    bool is_rim(std::uint32_t edge) const { return !cutter_.is_seam(cutter_.edges[edge]); }
    void add_rim(std::uint32_t edge);
    void add_face(std::uint32_t polygon);
    void walk_rim(std::uint32_t triangle, std::uint32_t side);

    const CutterSolid& cutter_;
    const std::uint8_t operand_;
    Overlay& overlay_;
    Stage stage_ = Stage::kPlanes;
    std::uint32_t next_ = 0;  ///< in the loop of the stage
    std::vector<PlaneId> planes_;
    std::vector<std::uint32_t> point_of_, edge_of_, face_of_, triangles_;
    std::size_t edge_count_ = 0;
    std::vector<std::uint8_t> seen_;  ///< of each side of a triangle
    // Of the polygon at hand.
    FlatView view_;
    std::vector<OverlaySide> sides_, loop_, holes_;
    std::vector<std::uint32_t> ends_, hole_ends_;
    std::vector<FlatPoint> corners_;
};

}  // namespace firma
