// SPDX-License-Identifier: MIT
// Ticks at 1, 2 or 5 times a power of ten, so that the numbers are short.
#include "draw/draw_frame.h"

#include <cmath>

namespace firma::draw {

namespace {

constexpr double kTickDistance = 80;  // pixels between numbers of an axis, about

/// 1, 2 or 5 times a power of ten, at least `least`.
double round_step(double least) {
    double power = 1;
    while (power > least) power /= 10;
    while (power * 10 <= least) power *= 10;
    for (const double times : {1.0, 2.0, 5.0}) {
        if (power * times >= least) return power * times;
    }
    return power * 10;
}

int decimals_of(double step) {
    int decimals = 0;
    while (decimals < 9 && std::fabs(step - std::floor(step + 0.5)) > 1e-6 * step) step *= 10, ++decimals;
    return decimals;
}

/// Lines and numbers of one axis, along the bottom or the left side of a view.
void draw_axis(SvgText& svg, const View& view, int axis, bool upright) {
    const double step = round_step(kTickDistance / view.scale);
    const int decimals = decimals_of(step);
    const double low = view.region.low[axis], high = view.region.high[axis];
    const double left = view.corner.x, bottom = view.corner.y, right = left + view.width(),
                 top = bottom - view.height();
    for (double k = std::ceil(low / step); k * step <= high; ++k) {
        Vec3 p = view.region.low;
        p[axis] = k * step;
        const PagePoint at = view.place(p);
        const std::string number = short_number(k * step, decimals);
        if (upright) {
            svg.line({left, at.y}, {right, at.y}, "class=\"grid\"");
            svg.line({left - 5, at.y}, {left, at.y}, "class=\"tick\"");
            svg.label({left - 8, at.y + 4}, number, "class=\"small\" text-anchor=\"end\"");
        } else {
            svg.line({at.x, bottom}, {at.x, top}, "class=\"grid\"");
            svg.line({at.x, bottom}, {at.x, bottom + 5}, "class=\"tick\"");
            svg.label({at.x, bottom + 17}, number, "class=\"small\" text-anchor=\"middle\"");
        }
    }
}

}  // namespace

void draw_frame(SvgText& svg, const View& view, const std::string& heading) {
    const double left = view.corner.x, bottom = view.corner.y, width = view.width(), height = view.height();
    svg.raw("<rect class=\"frame\" x=\"")
        .number(left)
        .raw("\" y=\"")
        .number(bottom - height)
        .raw("\" width=\"")
        .number(width);
    svg.raw("\" height=\"").number(height).raw("\"/>\n");
    draw_axis(svg, view, view.across, false);
    draw_axis(svg, view, view.upward, true);
    svg.label({left, bottom - height - 10}, heading, "class=\"head\"");
    const std::string unit = " (m)";
    svg.label({left + width / 2, bottom + 34}, kAxisNames[view.across] + unit, "text-anchor=\"middle\"");
    const double x = left - 48, y = bottom - height / 2;
    svg.raw("<g transform=\"rotate(-90 ").number(x).raw(" ").number(y).raw(")\">");
    svg.label({x, y}, kAxisNames[view.upward] + unit, "text-anchor=\"middle\"");
    svg.raw("</g>\n");
}

void draw_scale_bar(SvgText& svg, const View& view, const PagePoint& at) {
    const double metres = round_step(70 / view.scale), width = metres * view.scale;
    svg.raw("<rect class=\"bar\" x=\"").number(at.x).raw("\" y=\"").number(at.y).raw("\" width=\"").number(width / 2);
    svg.raw("\" height=\"5\"/>\n<rect x=\"").number(at.x).raw("\" y=\"").number(at.y).raw("\" width=\"").number(width);
    svg.raw("\" height=\"5\" fill=\"none\" stroke=\"#222\"/>\n");
    svg.label({at.x, at.y + 20}, "0", "class=\"small\"");
    svg.label({at.x + width, at.y + 20}, short_number(metres, decimals_of(metres)) + " m",
              "class=\"small\" text-anchor=\"middle\"");
}

const char* frame_styles() {
    return ".frame{fill:none;stroke:#999;stroke-width:1}.tick{stroke:#999;stroke-width:1}"
           ".grid{stroke:#000;stroke-opacity:.07}.bar{fill:#222}";
}

}  // namespace firma::draw
