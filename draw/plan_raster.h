// SPDX-License-Identifier: MIT
// What is nearest to the viewer in each small square of a plan: for what may be hidden, and for places of labels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "draw/view.h"
#include "firma/world.h"

namespace firma::draw {

struct PlanRaster {
    static constexpr double kCell = 3;  ///< pixels
    static constexpr std::uint32_t kNothing = ~0u;

    int width = 0, height = 0;        ///< cells
    PagePoint corner;                 ///< page position of the upper left one
    std::vector<std::uint32_t> face;  ///< index of the nearest face, rows from the top, or kNothing
    std::vector<double> nearness;     ///< of it, as View::nearness

    std::size_t at(int x, int y) const { return std::size_t(y) * std::size_t(width) + std::size_t(x); }
    PagePoint middle(int x, int y) const { return {corner.x + (x + 0.5) * kCell, corner.y + (y + 0.5) * kCell}; }
};

/// @param cut  metres along the view's depth axis: what lies nearer is cut away
PlanRaster make_raster(const View& view, std::span<const Face> faces, const std::optional<double>& cut);

/// Whether the viewer sees some of a polygon's corners, drawn in a little, or its middle.
bool is_seen(const PlanRaster& raster, const View& view, std::span<const Vec3> polygon);

}  // namespace firma::draw
