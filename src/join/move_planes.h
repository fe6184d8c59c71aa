// SPDX-License-Identifier: MIT
// Planes moved a little where they make faces too thin for the surface grid.
#pragma once

#include <array>
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
    PlaneMover(const BrushLevel& level, ExactTables& tables);

    /// Takes in the sides that were added to the level.
    void grow();

    /// As the level has it, or as it was moved.
    PlaneId of_side(std::uint32_t side) const { return plane_of_side_[side]; }
    bool is_moved(std::uint32_t side) const { return plane_of_side_[side] != plane_as_read_[side]; }
    /// Points that a side's plane goes through, as BrushSide::points.
    std::array<GridPoint, 3> points_of_side(std::uint32_t side) const;

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

    /// The sides that have another plane since the last move().
    const std::vector<std::uint32_t>& moved_sides() const { return moved_sides_; }

    std::size_t moved() const { return moved_; }

private:
    /// Points that a plane goes through, seen from its front.
    struct PlanePoints {
        PlaneId plane = kNoPlane;
        std::array<GridPoint, 3> points;
    };

    struct SidesOfPlane {
        std::uint32_t any = ~0u, lowest = ~0u;
    };

    PlaneId add_plane(const std::array<GridPoint, 3>& points);
    void list_shapes(std::span<const BrushShape> shapes);
    void find_candidates(const Outline& outline);
    void move_plane(PlaneId plane);
    PlaneId near_candidate(PlaneId plane, std::span<const BrushShape> shapes) const;
    bool bounded_by_both(const BrushShape& shape, PlaneId one, PlaneId other) const;
    void replace(PlaneId was, PlaneId is);

    const BrushLevel& level_;
    ExactTables& tables_;
    std::vector<PlaneId> plane_as_read_, plane_of_side_;
    std::vector<PlaneId> candidates_;           ///< that may be changed
    std::vector<PlaneId> axial_;                ///< that may not
    std::vector<PlanePoints> points_of_plane_;  ///< by number of the plane
    std::vector<std::uint32_t> moved_sides_;
    std::vector<SidesOfPlane> sides_of_plane_;                  ///< by number of the plane
    std::vector<std::uint32_t> next_side_;                      ///< another one in a side's plane
    std::vector<std::uint32_t> first_shape_, shapes_of_plane_;  ///< by number of the plane: brushes that it bounds
    std::vector<bool> changed_;                                 ///< by number of the plane: in the move() at hand
    std::uint32_t rounds_ = 0;
    std::size_t moved_ = 0;
};

}  // namespace firma
