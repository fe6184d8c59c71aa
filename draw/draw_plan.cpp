// SPDX-License-Identifier: MIT
// Lays out the page: title, plan, section, axes in metres, scale bar, legend.
#include "draw/draw_plan.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "draw/draw_faces.h"
#include "draw/draw_frame.h"
#include "draw/draw_rooms.h"
#include "draw/plan_legend.h"
#include "draw/plan_raster.h"
#include "draw/room_colours.h"
#include "draw/view.h"

namespace firma::draw {

namespace {

// The page, in pixels.
constexpr double kLeft = 70, kTop = 96, kBetween = 92, kBottom = 64, kLegend = 270;
constexpr double kMostWidth = 900, kMostPlanHeight = 900, kMostSectionHeight = 450, kLeastSide = 60;

constexpr double kMargin = 0.03;     // of the level's size, around it
constexpr double kCastMargin = 0.4;  // likewise, where casts lead outside
constexpr double kSlab = 0.05;       // of the level's depth: casts this near to the cut are drawn in the section
constexpr double kNewShade = 0.72;   // of a room's colour, on faces that an edit made

constexpr const char* kStyles =
    "text{font-family:'DejaVu Sans',Arial,sans-serif;font-size:12px;fill:#222}"
    ".title{font-size:19px;font-weight:bold}.head{font-size:14px;font-weight:bold}.small{font-size:11px;fill:#555}"
    ".edge{fill:none;stroke:#78909c;stroke-width:.6;stroke-linejoin:round}"
    ".cut{fill:none;stroke:#1c262b;stroke-width:1.8;stroke-linecap:round}.cut.new{stroke:#a34f00}"
    ".where{stroke:#8e24aa;stroke-width:1.2;stroke-dasharray:9 4 2 4}.mark{fill:#8e24aa;font-weight:bold}";

/// Where a section shows most: of planes across the middle half, the one whose cut spans the greatest width; of several
/// such the one nearest to the middle.
double best_cut(std::span<const Face> faces, const Box& bounds, const View& section) {
    constexpr int kPlanes = 33;
    if (bounds.empty()) return 0;
    const double low = bounds.low[section.depth], size = bounds.high[section.depth] - low;
    double best = low + size / 2;
    std::size_t most = 0;
    for (int k = 0; k < kPlanes; ++k) {
        const int outward = k % 2 == 0 ? k / 2 : -(k + 1) / 2;  // 0, -1, 1, -2, 2 ... steps from the middle
        const double at = low + size * (0.5 + 0.5 * (outward + 0.25) / kPlanes);  // a wall is likelier in the middle
        const std::size_t width = cut_width(section, faces, at);
        if (double(width) > double(most) * 1.02) best = at, most = width;
    }
    return best;
}

/// What both views show: the level, and casts a little way out of it.
Box region_of(const Box& bounds, std::span<const DrawnCast> casts) {
    Box level = bounds;
    if (level.empty()) level.add(Vec3{});
    const Vec3 size = level.high - level.low;
    const double largest_side = std::max(max_abs(size), 1e-3);
    Box reached = level;
    for (const DrawnCast& cast : casts) add_to(reached, cast);
    for (int axis = 0; axis < 3; ++axis) {
        const double most = kCastMargin * largest_side, margin = kMargin * largest_side;
        level.low[axis] = std::max(reached.low[axis], level.low[axis] - most) - margin;
        level.high[axis] = std::min(reached.high[axis], level.high[axis] + most) + margin;
    }
    return level;
}

/// Some of many, evenly taken.
std::vector<DrawnCast> chosen(std::span<const DrawnCast> casts, std::size_t most) {
    if (casts.size() <= most) return {casts.begin(), casts.end()};
    std::vector<DrawnCast> some;
    for (std::size_t k = 0; k < most; ++k) some.push_back(casts[k * casts.size() / most]);
    return some;
}

struct Page {
    View plan, section;
    double width = 0, height = 0;
};

Page lay_out(const Box& region, int up) {
    const int across = (up + 1) % 3, other = (up + 2) % 3;
    const Vec3 size = region.high - region.low;
    double scale = kMostWidth / size[across];
    scale = std::min({scale, kMostPlanHeight / size[other], kMostSectionHeight / size[up]});
    Page page;
    page.plan = {across, other, up, 1, region, scale, {}};
    page.section = {across, up, other, -1, region, scale, {}};
    const double plan_height = std::max(page.plan.height(), kLeastSide);
    const double section_height = std::max(page.section.height(), kLeastSide);
    page.plan.corner = {kLeft, kTop + plan_height};
    page.section.corner = {kLeft, kTop + plan_height + kBetween + section_height};
    page.width = kLeft + std::max(page.plan.width(), 330.0) + 30 + kLegend;
    page.height = std::max(page.section.corner.y + kBottom, 560.0);
    return page;
}

/// The line in the plan along which the section cuts, with A at both ends and arrows the way the section looks.
void draw_where(SvgText& svg, const View& plan, double at) {
    Vec3 p = plan.region.low;
    p[plan.upward] = at;
    const double y = plan.place(p).y, left = plan.corner.x, right = left + plan.width();
    svg.line({left - 4, y}, {right + 4, y}, "class=\"where\"");
    for (const double x : {left + 10, right - 10}) {
        svg.raw("<path fill=\"#8e24aa\" d=\"M")
            .point({x - 5, y})
            .raw(" ")
            .point({x, y - 9})
            .raw(" ")
            .point({x + 5, y})
            .raw("Z\"/>\n");
    }
    svg.label({left + 20, y - 4}, "A", "class=\"mark\"");
    svg.label({right - 20, y - 4}, "A", "class=\"mark\" text-anchor=\"end\"");
}

/// Of plan and section, and which of them each face has.
struct PlanTints {
    std::vector<Tint> plan, section;
    std::vector<std::uint32_t> of;
};

/// By what made a face: the level, or an edit.
PlanTints plain_tints(std::span<const Face> faces) {
    PlanTints tints{{kPlanTint, kNewPlanTint}, {kSectionTint, kNewSectionTint}, {}};
    for (const Face& face : faces) tints.of.push_back(face.source_edit != 0);
    return tints;
}

/// By room and by what made a face.
PlanTints room_tints(const World& world, std::span<const Face> faces, std::span<const RoomId> rooms) {
    PlanTints tints;
    for (std::uint32_t room = 0; room < world.room_count(); ++room) {
        const Vec3 colour = room_colour({room}, room_info(world, {room})->exterior);
        for (const double shade : {1.0, kNewShade}) {
            tints.plan.push_back(plan_tint(colour * shade));
            tints.section.push_back(section_tint(colour * shade));
        }
    }
    for (std::size_t k = 0; k < faces.size(); ++k) tints.of.push_back(2 * rooms[k].value + (faces[k].source_edit != 0));
    return tints;
}

Box box_of(std::span<const Face> faces) {
    Box box;
    for (const Face& face : faces)
        for (const Vec3& corner : face.corners) box.add(corner);
    return box;
}

std::string plan_heading(const PlanOptions& options) {
    const std::string axis = kAxisNames[options.up];
    return (options.below ? "Plan: cut at " + axis + " = " + short_number(*options.below, 3) + " m, seen along -"
                          : "Plan: seen along -") +
           axis;
}

std::string section_heading(const Plan& plan, const View& section) {
    return std::string("Section A-A: cut at ") + kAxisNames[section.depth] + " = " + short_number(plan.at, 3) +
           " m, seen along +" + kAxisNames[section.depth];
}

void draw_head(SvgText& svg, const Page& page, const World& world, const PlanOptions& options) {
    svg.raw("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"")
        .number(page.width)
        .raw("\" height=\"")
        .number(page.height);
    svg.raw("\" viewBox=\"0 0 ")
        .number(page.width)
        .raw(" ")
        .number(page.height)
        .raw("\">\n<title>")
        .words(options.title);
    svg.raw("</title>\n<style>")
        .raw(kStyles)
        .raw(frame_styles())
        .raw(cast_styles())
        .raw(room_styles())
        .raw("</style>\n");
    svg.raw("<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n");
    svg.label({kLeft, 30}, options.title.empty() ? "A world" : options.title, "class=\"title\"");
    const Vec3 size = world.face_count() > 0 ? world.bounds().high - world.bounds().low : Vec3{};
    svg.label({kLeft, 50}, grouped_number(world.face_count()) + " faces; " + short_number(size.x, 2) + " x " +
                               short_number(size.y, 2) + " x " + short_number(size.z, 2) + " m");
}

}  // namespace

Plan draw_plan(const World& world, std::span<const DrawnCast> casts, const PlanOptions& options) {
    const std::vector<Face> faces = faces_to_show(world);
    const std::vector<RoomId> rooms = rooms_of_faces(faces);
    const std::vector<DrawnCast> some = chosen(casts, options.most_casts);
    const Box bounds = box_of(faces);
    Page page = lay_out(region_of(bounds, some), options.up);
    Plan plan;
    plan.shows_rooms = options.rooms.value_or(count_inner_rooms(world) > 1);
    plan.new_faces =
        std::size_t(std::count_if(faces.begin(), faces.end(), [](const Face& face) { return face.source_edit != 0; }));
    plan.cut_axis = page.section.depth;
    plan.at = options.at ? *options.at : best_cut(faces, bounds, page.section);
    const double slab = bounds.empty() ? 0 : kSlab * (bounds.high[plan.cut_axis] - bounds.low[plan.cut_axis]);
    const PlanTints tints = plan.shows_rooms ? room_tints(world, faces, rooms) : plain_tints(faces);

    SvgText svg;
    const FacesDrawn in_plan = draw_faces(svg, page.plan, world, faces, {tints.plan, tints.of, options.below, 1 << 20});
    if (options.below) draw_cut_lines(svg, page.plan, faces, *options.below);
    if (plan.shows_rooms) {
        const PlanRaster raster = make_raster(page.plan, faces, options.below);
        plan.portals_drawn = draw_portals(svg, page.plan, world, raster, options.below);
        plan.rooms_labelled = label_rooms(svg, world, raster, rooms);
    }
    draw_where(svg, page.plan, plan.at);
    plan.casts_drawn = draw_casts(svg, page.plan, some);
    draw_frame(svg, page.plan, plan_heading(options));

    const FacesDrawn in_section =
        draw_faces(svg, page.section, world, faces, {tints.section, tints.of, plan.at, 1 << 20});
    plan.faces_cut = draw_cut_lines(svg, page.section, faces, plan.at);
    if (plan.shows_rooms) {
        const PlanRaster raster = make_raster(page.section, faces, plan.at);
        draw_portals(svg, page.section, world, raster, plan.at);
        label_rooms(svg, world, raster, rooms);
    }
    const std::size_t casts_in_section = draw_casts(svg, page.section, some, Slab{plan.at, slab});
    draw_frame(svg, page.section, section_heading(plan, page.section));
    plan.faces_in_plan = in_plan.drawn;
    plan.faces_in_section = in_section.drawn;
    plan.faces_left_out = in_plan.left_out + in_section.left_out;
    const double end = draw_legend(svg, {page.width - kLegend, kTop + 4},
                                   {world, plan, page.plan, rooms, casts, casts_in_section, slab});
    page.height = std::max(page.height, end + kBottom / 2);

    SvgText head;
    draw_head(head, page, world, options);
    plan.svg = head.text() + svg.text() + "</svg>\n";
    return plan;
}

}  // namespace firma::draw
