// SPDX-License-Identifier: MIT
// Lines first, marks on top of them, so that a crowd of casts stays readable.
#include "draw/draw_casts.h"

#include <algorithm>

namespace firma::draw {

namespace {

constexpr double kTick = 14;          // pixels, of a normal that lies in the page
constexpr double kLeastRadius = 2.5;  // pixels; smaller spheres are not drawn
constexpr double kLargestRadius = 1500;

bool touched(const DrawnCast& cast) {
    return cast.status == Status::kHit || cast.status == Status::kInitialOverlap;
}

Vec3 end_of(const DrawnCast& cast) {
    return touched(cast) ? cast.centre : cast.start + cast.path;
}

bool near_slab(const View& view, const DrawnCast& cast, const Slab& slab) {
    const double a = cast.start[view.depth] - slab.at, b = end_of(cast)[view.depth] - slab.at;
    return std::min(a, b) <= slab.reach && std::max(a, b) >= -slab.reach;
}

const char* kind_of(const DrawnCast& cast) {
    switch (cast.status) {
        case Status::kHit:
            return "hit";
        case Status::kInitialOverlap:
            return "touching";
        default:
            return "miss";
    }
}

bool on_page(const View& view, const Vec3& p) {
    return cut_to_view(view, p, p).visible;
}

void draw_circle(SvgText& svg, const View& view, const Vec3& at, double radius, const char* kind, const char* which) {
    if (radius < kLeastRadius || radius > kLargestRadius) return;
    const PagePoint centre = view.place(at);
    svg.raw("<circle class=\"ball ")
        .raw(kind)
        .raw(which)
        .raw("\" cx=\"")
        .number(centre.x)
        .raw("\" cy=\"")
        .number(centre.y);
    svg.raw("\" r=\"").number(radius).raw("\"/>\n");
}

void draw_dot(SvgText& svg, const PagePoint& at, double radius, const char* kind, const char* which) {
    svg.raw("<circle class=\"").raw(which).raw(kind).raw("\" cx=\"").number(at.x).raw("\" cy=\"").number(at.y);
    svg.raw("\" r=\"").number(radius).raw("\"/>\n");
}

void draw_path(SvgText& svg, const View& view, const DrawnCast& cast) {
    const char* kind = kind_of(cast);
    const PageLine line = cut_to_view(view, cast.start, end_of(cast));
    if (line.visible) {
        svg.raw("<path class=\"way ").raw(kind).raw("\" d=\"M").point(line.from).raw(" ").point(line.to).raw("\"/>\n");
        if (!line.from_cut) draw_dot(svg, line.from, 1.6, kind, "start ");
        if (!line.to_cut && cast.status == Status::kMiss) draw_dot(svg, line.to, 1.6, kind, "end ");
    }
    const double radius = cast.radius * view.scale;
    if (on_page(view, cast.start)) draw_circle(svg, view, cast.start, radius, kind, " begin");
    if (touched(cast) && on_page(view, cast.centre)) draw_circle(svg, view, cast.centre, radius, kind, "");
}

void draw_contact(SvgText& svg, const View& view, const DrawnCast& cast) {
    if (!on_page(view, cast.point)) return;
    const PagePoint at = view.place(cast.point);
    const PagePoint tip{at.x + kTick * cast.normal[view.across], at.y - kTick * cast.normal[view.upward]};
    svg.raw("<path class=\"normal\" d=\"M").point(at).raw(" ").point(tip).raw("\"/>\n");
    draw_dot(svg, at, 2.4, kind_of(cast), "contact ");
}

}  // namespace

std::size_t draw_casts(SvgText& svg, const View& view, std::span<const DrawnCast> casts,
                       const std::optional<Slab>& slab) {
    std::size_t drawn = 0;
    const auto wanted = [&](const DrawnCast& cast) { return !slab || near_slab(view, cast, *slab); };
    for (const DrawnCast& cast : casts) {
        if (!wanted(cast)) continue;
        draw_path(svg, view, cast);
        ++drawn;
    }
    for (const DrawnCast& cast : casts) {
        if (wanted(cast) && touched(cast)) draw_contact(svg, view, cast);
    }
    return drawn;
}

void add_to(Box& box, const DrawnCast& cast) {
    box.add(cast.start);
    box.add(end_of(cast));
}

const char* cast_styles() {
    return ".way{fill:none;stroke-width:1;stroke-opacity:.85}"
           ".hit{stroke:#1559b5}.miss{stroke:#e0730a}.touching{stroke:#c2185b}"
           ".miss.way{stroke-dasharray:5 3}"
           ".ball{fill:none;stroke-width:.9}.ball.begin{stroke-dasharray:2 2;stroke-opacity:.7}"
           ".start{fill:#fff;stroke-width:1}.end{fill:#e0730a;stroke:none}"
           ".contact{stroke:none}.contact.hit{fill:#1559b5}.contact.touching{fill:#c2185b}"
           ".normal{stroke:#111;stroke-width:1.3;fill:none}";
}

}  // namespace firma::draw
