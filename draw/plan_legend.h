// SPDX-License-Identifier: MIT
// What the colours and lines of a plan stand for.
#pragma once

#include <cstddef>
#include <span>

#include "draw/draw_casts.h"
#include "draw/draw_faces.h"
#include "draw/draw_plan.h"
#include "draw/room_colours.h"
#include "draw/view.h"

namespace firma::draw {

inline constexpr Tint kPlanTint{{0.71, 0.77, 0.80}, {0.98, 0.96, 0.91}};
inline constexpr Tint kSectionTint{{0.95, 0.96, 0.97}, {0.80, 0.85, 0.87}};
// Faces that an edit made.
inline constexpr Tint kNewPlanTint{{0.79, 0.54, 0.29}, {0.95, 0.76, 0.51}};
inline constexpr Tint kNewSectionTint{{0.97, 0.86, 0.75}, {0.87, 0.66, 0.44}};

// A room's colour on its faces.
inline Tint plan_tint(const Vec3& colour) {
    return {mixed(colour, kWhite, 0.1), mixed(colour, kWhite, 0.55)};
}
inline Tint section_tint(const Vec3& colour) {
    return {mixed(colour, kWhite, 0.75), mixed(colour, kWhite, 0.35)};
}

struct LegendFacts {
    const World& world;
    const Plan& plan;  ///< all but its text
    const View& plan_view;
    std::span<const RoomId> rooms;     ///< of the faces shown
    std::span<const DrawnCast> casts;  ///< all, drawn or not
    std::size_t casts_in_section = 0;
    double slab = 0;  ///< metres: how near to the cut these come
};

/// Writes from the top down. @return how far down it got
double draw_legend(SvgText& svg, const PagePoint& at, const LegendFacts& facts);

}  // namespace firma::draw
