// SPDX-License-Identifier: MIT
// A page with a plan and a section of a world, what edits made in it and casts, as SVG for people.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "draw/draw_casts.h"
#include "firma/world.h"

namespace firma::draw {

struct PlanOptions {
    std::string title = {};  ///< of the page; the level's name, say
    int up = 2;              ///< axis that points up: the plan looks down on it
    /// Metres along the plan's vertical axis, where the section cuts; where it shows most unless given.
    std::optional<double> at = {};
    std::optional<double> below = {};  ///< metres along the `up` axis: the plan leaves away what lies above
    std::size_t most_casts = 200;      ///< drawn at most, evenly taken from all
    /// Rooms in colours of their own with their numbers, and portals; where there are two or more beside the exterior
    /// unless given.
    std::optional<bool> rooms = {};
};

/// The page, and what is on it.
struct Plan {
    std::string svg;
    double at = 0;     ///< where the section cuts, metres
    int cut_axis = 1;  ///< along which axis that is
    std::size_t faces_in_plan = 0, faces_in_section = 0, faces_cut = 0;
    std::size_t faces_left_out = 0;  ///< too small to be seen, of both views
    std::size_t casts_drawn = 0;
    std::size_t new_faces = 0;  ///< of those shown: those an edit made, in colours of their own
    bool shows_rooms = false;
    std::size_t rooms_labelled = 0, portals_drawn = 0;  ///< in the plan
};

/// The plan looks along the `up` axis from above, the section along the next but one; both to one scale, one above the
/// other. Faces of the exterior are left out unless most faces are such, and so are clips.
Plan draw_plan(const World& world, std::span<const DrawnCast> casts, const PlanOptions& options = {});

}  // namespace firma::draw
