// SPDX-License-Identifier: MIT
// Lays out the page: title, plan, section, axes in metres, scale bar, legend.
#include "debug/draw_plan.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "debug/draw_faces.h"
#include "debug/draw_frame.h"
#include "debug/view.h"

namespace firma::debug {

namespace {

// The page, in pixels.
constexpr double kLeft = 70, kTop = 96, kBetween = 92, kBottom = 64, kLegend = 270;
constexpr double kMostWidth = 900, kMostPlanHeight = 900, kMostSectionHeight = 450, kLeastSide = 60;

constexpr double kMargin = 0.03;     // of the level's size, around it
constexpr double kCastMargin = 0.4;  // likewise, where casts lead outside
constexpr double kSlab = 0.05;       // of the level's depth: casts this near to the cut are drawn in the section
constexpr const char* kPlanLow = "#b4c3cd";
constexpr const char* kPlanHigh = "#fbf6e9";
constexpr const char* kSectionFar = "#f3f5f6";
constexpr const char* kSectionNear = "#cdd8dd";
// Faces that an edit made.
constexpr const char* kNewPlanLow = "#c98a4b";
constexpr const char* kNewPlanHigh = "#f3c283";
constexpr const char* kNewSectionFar = "#f6dcc0";
constexpr const char* kNewSectionNear = "#dfa871";

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
    const double largest_side = std::max(largest(size), 1e-3);
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

/// Writes the legend from the top down.
class Legend {
public:
    Legend(SvgText& svg, double left, double top) : svg_(svg), left_(left), y_(top) {}

    void heading(std::string_view text) {
        y_ += 8;
        svg_.label({left_, y_}, text, "class=\"head\"");
        y_ += 22;
    }
    void words(std::string_view text) {
        svg_.label({left_, y_}, text, "class=\"small\"");
        y_ += 16;
        after_words_ = true;
    }
    /// A sample 44 pixels wide, whose markup is drawn about (0, 0), and what it stands for.
    void sample(std::string_view markup, std::string_view text) {
        if (after_words_) y_ += 5;
        after_words_ = false;
        svg_.raw("<g transform=\"translate(")
            .number(left_ + 22)
            .raw(" ")
            .number(y_ - 4)
            .raw(")\">")
            .raw(markup)
            .raw("</g>\n");
        svg_.label({left_ + 56, y_}, text);
        y_ += 20;
    }
    double y() const { return y_; }

private:
    SvgText& svg_;
    double left_, y_;
    bool after_words_ = false;
};

std::string tint(const char* low, const char* high, const char* name) {
    return std::string("<linearGradient id=\"") + name + "\"><stop offset=\"0\" stop-color=\"" + low +
           "\"/><stop offset=\"1\" stop-color=\"" + high +
           "\"/></linearGradient><rect x=\"-22\" y=\"-6\" width=\"44\" height=\"12\" fill=\"url(#" + name +
           ")\" stroke=\"#78909c\" stroke-width=\".6\"/>";
}

struct CastCount {
    std::size_t all = 0, hit = 0, touching = 0, miss = 0;
};

void draw_cast_legend(Legend& legend, const CastCount& count, const Plan& plan, std::size_t in_section, double slab) {
    if (count.all == 0) return;
    legend.heading("Casts");
    legend.sample(
        "<path class=\"way hit\" d=\"M-20,0 12,0\"/><circle class=\"start hit\" cx=\"-20\" r=\"1.6\"/>"
        "<path class=\"normal\" d=\"M14,0 2,-7\"/><circle class=\"contact hit\" cx=\"14\" r=\"2.4\"/>",
        "hit (" + grouped_number(count.hit) + ")");
    legend.words("open dot: start; full dot: contact point;");
    legend.words("black: contact normal");
    legend.sample(
        "<path class=\"way miss\" d=\"M-20,0 18,0\"/><circle class=\"start miss\" cx=\"-20\" r=\"1.6\"/>"
        "<circle class=\"end miss\" cx=\"18\" r=\"1.6\"/>",
        "miss (" + grouped_number(count.miss) + ")");
    legend.sample("<circle class=\"contact touching\" r=\"2.4\"/><path class=\"normal\" d=\"M0,0 10,-7\"/>",
                  "touching at the start (" + grouped_number(count.touching) + ")");
    legend.sample("<circle class=\"ball hit begin\" cx=\"-11\" r=\"7\"/><circle class=\"ball hit\" cx=\"10\" r=\"7\"/>",
                  "sphere at start, at contact");
    legend.words(grouped_number(plan.casts_drawn) + " of " + grouped_number(count.all) + " casts drawn in the plan,");
    legend.words(grouped_number(in_section) + " in the section: those that come");
    legend.words("within " + short_number(slab, 2) + " m of the cut");
}

CastCount count_casts(std::span<const DrawnCast> casts) {
    CastCount count;
    for (const DrawnCast& cast : casts) {
        ++count.all;
        count.hit += cast.status == Status::kHit;
        count.touching += cast.status == Status::kTouching;
        count.miss += cast.status == Status::kMiss;
    }
    return count;
}

void draw_legend(SvgText& svg, const Page& page, const Plan& plan, const CastCount& casts, std::size_t in_section,
                 double slab) {
    const double left = page.width - kLegend;
    Legend legend(svg, left, kTop + 4);
    legend.heading("Legend");
    const std::string up = kAxisNames[page.plan.depth], across = kAxisNames[page.section.depth];
    legend.sample(tint(kPlanLow, kPlanHigh, "low-high"), "plan: low to high " + up);
    legend.sample(tint(kSectionFar, kSectionNear, "far-near"), "section: far to near");
    if (plan.new_faces > 0) {
        legend.sample(tint(kNewPlanLow, kNewPlanHigh, "new-low-high"), "plan: made by an edit");
        legend.sample(tint(kNewSectionFar, kNewSectionNear, "new-far-near"), "section: made by an edit");
    }
    legend.sample("<path class=\"edge\" d=\"M-20,0 20,0\"/>", "edge of a face");
    legend.sample("<path class=\"cut\" d=\"M-20,0 20,0\"/>", "cut through a face");
    if (plan.new_faces > 0)
        legend.sample("<path class=\"cut new\" d=\"M-20,0 20,0\"/>", "cut through one an edit made");
    legend.sample("<path class=\"where\" d=\"M-22,0 22,0\"/>", "where the section cuts");
    draw_cast_legend(legend, casts, plan, in_section, slab);
    legend.heading("Drawn");
    legend.words(grouped_number(plan.faces_in_plan) + " faces in the plan, " + grouped_number(plan.faces_in_section));
    legend.words("in the section: those that face the viewer");
    if (plan.faces_left_out > 0) legend.words("left out as too small: " + grouped_number(plan.faces_left_out));
    legend.heading("Scale");
    draw_scale_bar(svg, page.plan, {left, legend.y() - 8});
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
    svg.raw("</title>\n<style>").raw(kStyles).raw(frame_styles()).raw(cast_styles()).raw("</style>\n");
    svg.raw("<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n");
    svg.label({kLeft, 30}, options.title.empty() ? "A world" : options.title, "class=\"title\"");
    const Vec3 size = world.face_count() > 0 ? world.bounds().high - world.bounds().low : Vec3{};
    svg.label({kLeft, 50}, grouped_number(world.face_count()) + " faces; " + short_number(size.x, 2) + " x " +
                               short_number(size.y, 2) + " x " + short_number(size.z, 2) + " m");
}

}  // namespace

Plan draw_plan(const World& world, std::span<const DrawnCast> casts, const PlanOptions& options) {
    const std::vector<DrawnCast> some = chosen(casts, options.most_casts);
    const Page page = lay_out(region_of(world.bounds(), some), options.up);
    const std::vector<Face> faces = world.faces();
    Plan plan;
    plan.new_faces =
        std::size_t(std::count_if(faces.begin(), faces.end(), [](const Face& face) { return face.source_edit != 0; }));
    plan.cut_axis = page.section.depth;
    const Box bounds = world.bounds();
    plan.at = options.at ? *options.at : best_cut(faces, bounds, page.section);
    const double slab = bounds.empty() ? 0 : kSlab * (bounds.high[plan.cut_axis] - bounds.low[plan.cut_axis]);

    SvgText svg;
    draw_head(svg, page, world, options);
    const FacesDrawn in_plan =
        draw_faces(svg, page.plan, faces, {kPlanLow, kPlanHigh, kNewPlanLow, kNewPlanHigh, {}, 1 << 20});
    draw_where(svg, page.plan, plan.at);
    plan.casts_drawn = draw_casts(svg, page.plan, some);
    draw_frame(svg, page.plan, std::string("Plan: seen along -") + kAxisNames[options.up]);

    const FacesDrawn in_section = draw_faces(
        svg, page.section, faces, {kSectionFar, kSectionNear, kNewSectionFar, kNewSectionNear, plan.at, 1 << 20});
    plan.faces_cut = draw_cut_lines(svg, page.section, faces, plan.at);
    const std::size_t casts_in_section = draw_casts(svg, page.section, some, Slab{plan.at, slab});
    draw_frame(svg, page.section,
               std::string("Section A-A: cut at ") + kAxisNames[plan.cut_axis] + " = " + short_number(plan.at, 3) +
                   " m, seen along +" + kAxisNames[plan.cut_axis]);
    plan.faces_in_plan = in_plan.drawn;
    plan.faces_in_section = in_section.drawn;
    plan.faces_left_out = in_plan.left_out + in_section.left_out;
    draw_legend(svg, page, plan, count_casts(casts), casts_in_section, slab);
    svg.raw("</svg>\n");
    plan.svg = svg.text();
    return plan;
}

}  // namespace firma::debug
