// SPDX-License-Identifier: MIT
// Planes moved a little where they make faces too thin for the surface grid.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "firma/brush_level.h"
#include "join/brush_shape.h"

namespace firma {

/// Planes that were not exactly so in the author's tools meet in points a few millionths of a metre apart, once they
/// are exact. Where the surface grid cannot tell those apart, one of the planes is moved by about half a millimetre, on
/// all brushes that have it at once: so neighbours stay neighbours.
class PlaneMover {
public:
    PlaneMover(const BrushLevel& level, JoinTables& tables);

    /// As the level has it, or as it was moved.
    PlaneId of_side(std::uint32_t side) const { return plane_of_side_[side]; }

    /// A face that makes no facets.
    struct Outline {
        PlaneId plane;
        std::vector<std::uint32_t> corners;
    };
    /// Chooses planes that keep outlines from making facets, and changes each once: two that are nearly one become one,
    /// else one is moved.
    /// @param shapes  the brushes as they are
    /// @return for each outline whether one of its planes was moved, now or for another outline
    std::vector<bool> move(std::span<const Outline> outlines, std::span<const BrushShape> shapes);

    std::size_t moved() const { return moved_; }

private:
    void find_candidates(const Outline& outline);
    void move_plane(PlaneId plane);
    PlaneId near_candidate(PlaneId plane, std::span<const BrushShape> shapes) const;
    bool bounded_by_both(const BrushShape& shape, PlaneId one, PlaneId other) const;
    void replace(PlaneId was, PlaneId is);

    const BrushLevel& level_;
    JoinTables& tables_;
    std::vector<PlaneId> plane_of_side_;
    std::vector<PlaneId> candidates_;           ///< that may be changed
    std::vector<PlaneId> axial_;                ///< that may not
    std::vector<std::uint32_t> side_of_plane_;  ///< the first that has it; by number of the plane
    std::uint32_t rounds_ = 0;
    std::size_t moved_ = 0;
};

}  // namespace firma
