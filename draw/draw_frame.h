// SPDX-License-Identifier: MIT
// What makes a view measurable: its frame, axes in metres, a scale bar.
#pragma once

#include <string>

#include "draw/svg_text.h"
#include "draw/view.h"

namespace firma::draw {

/// Frame, grid, numbers and names of both axes, and a heading above.
void draw_frame(SvgText& svg, const View& view, const std::string& heading);

/// A bar of a round number of metres. @param at  its upper left corner
void draw_scale_bar(SvgText& svg, const View& view, const PagePoint& at);

/// Styles that these use, for the head of the picture.
const char* frame_styles();

}  // namespace firma::draw
