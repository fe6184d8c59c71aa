// SPDX-License-Identifier: MIT
// Faces as a draughtsman shows them: tinted by distance, far ones first, with the edges where the surface turns.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "draw/svg_text.h"
#include "draw/view.h"
#include "firma/world.h"

namespace firma::draw {

/// Red, green and blue, 0 .. 1, of what is far and near.
struct Tint {
    Vec3 far, near;
};

struct FaceLook {
    std::vector<Tint> tints;             ///< at least one
    std::vector<std::uint32_t> tint_of;  ///< of each face, an index of tints
    std::optional<double> cut;           ///< metres along the view's depth axis: what lies nearer is cut away
    std::size_t max_bytes = 1 << 20;     ///< of SVG, about; the smallest faces are left out beyond that
};

struct FacesDrawn {
    std::size_t drawn = 0;
    std::size_t left_out = 0;  ///< would be seen, but are smaller than a fraction of a pixel, or too many
};

/// Draws the faces whose fronts the viewer sees (both sides of two-sided ones).
///
/// @param faces  in order of id, as World::faces() gives them; neighbours that are not among them are not seen
FacesDrawn draw_faces(SvgText& svg, const View& view, const World& world, std::span<const Face> faces,
                      const FaceLook& look);

/// How much of a view's width, in columns of two pixels, lies in the cut that draw_cut_lines() would draw.
std::size_t cut_width(const View& view, std::span<const Face> faces, double cut);

/// Draws the lines in which faces meet the plane across the view's depth axis at `cut` metres. @return how many
std::size_t draw_cut_lines(SvgText& svg, const View& view, std::span<const Face> faces, double cut);

}  // namespace firma::draw
