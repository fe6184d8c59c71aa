// SPDX-License-Identifier: MIT
// What the colours and lines of a plan stand for: see the header.
#include "draw/plan_legend.h"

#include <string>
#include <string_view>
#include <vector>

#include "draw/draw_frame.h"
#include "draw/room_colours.h"
#include "firma/rooms.h"

namespace firma::draw {
namespace {

constexpr std::size_t kMostRows = 60;  // rooms listed

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
    /// One of many: a sample 20 pixels wide, and a small line of words.
    void row(std::string_view markup, std::string_view text) {
        svg_.raw("<g transform=\"translate(").number(left_ + 10).raw(" ").number(y_ - 4).raw(")\">").raw(markup);
        svg_.raw("</g>\n");
        svg_.label({left_ + 26, y_}, text, "class=\"small\"");
        y_ += 15;
        after_words_ = true;
    }
    double y() const { return y_; }

private:
    SvgText& svg_;
    double left_, y_;
    bool after_words_ = false;
};

std::string sample_of(const Tint& tint, const char* name) {
    return std::string("<linearGradient id=\"") + name + "\"><stop offset=\"0\" stop-color=\"" + hex_colour(tint.far) +
           "\"/><stop offset=\"1\" stop-color=\"" + hex_colour(tint.near) +
           "\"/></linearGradient><rect x=\"-22\" y=\"-6\" width=\"44\" height=\"12\" fill=\"url(#" + name +
           ")\" stroke=\"#78909c\" stroke-width=\".6\"/>";
}

struct CastCount {
    std::size_t all = 0, hit = 0, touching = 0, miss = 0;
};

CastCount count_casts(std::span<const DrawnCast> casts) {
    CastCount count;
    for (const DrawnCast& cast : casts) {
        ++count.all;
        count.hit += cast.status == Status::kHit;
        count.touching += cast.status == Status::kInitialOverlap;
        count.miss += cast.status == Status::kMiss;
    }
    return count;
}

void add_casts(Legend& legend, const LegendFacts& facts) {
    const CastCount count = count_casts(facts.casts);
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
                  "initial overlap (" + grouped_number(count.touching) + ")");
    legend.sample("<circle class=\"ball hit begin\" cx=\"-11\" r=\"7\"/><circle class=\"ball hit\" cx=\"10\" r=\"7\"/>",
                  "sphere at start, at contact");
    legend.words(grouped_number(facts.plan.casts_drawn) + " of " + grouped_number(count.all) +
                 " casts drawn in the plan,");
    legend.words(grouped_number(facts.casts_in_section) + " in the section: those that come");
    legend.words("within " + short_number(facts.slab, 2) + " m of the cut");
}

void add_surfaces(Legend& legend, const LegendFacts& facts) {
    const bool rooms = facts.plan.shows_rooms;
    const Vec3 sample = room_colour({0}, false);
    const std::string up = kAxisNames[facts.plan_view.depth];
    legend.sample(sample_of(rooms ? plan_tint(sample) : kPlanTint, "low-high"), "plan: low to high " + up);
    legend.sample(sample_of(rooms ? section_tint(sample) : kSectionTint, "far-near"), "section: far to near");
    if (facts.plan.new_faces > 0 && !rooms) {
        legend.sample(sample_of(kNewPlanTint, "new-low-high"), "plan: made by an edit");
        legend.sample(sample_of(kNewSectionTint, "new-far-near"), "section: made by an edit");
    }
    legend.sample("<path class=\"edge\" d=\"M-20,0 20,0\"/>", "edge of a face");
    legend.sample("<path class=\"cut\" d=\"M-20,0 20,0\"/>", "cut through a face");
    if (facts.plan.new_faces > 0)
        legend.sample("<path class=\"cut new\" d=\"M-20,0 20,0\"/>", "cut through one an edit made");
    legend.sample("<path class=\"where\" d=\"M-22,0 22,0\"/>", "where the section cuts");
    if (facts.plan.new_faces > 0 && rooms) legend.words("darker: made by an edit");
}

void add_portals(Legend& legend, const World& world) {
    std::size_t open = 0, closed = 0;
    for (std::uint32_t id = 0; id < portal_count(world); ++id) {
        const PortalInfo portal = *portal_info(world, {id});
        if (portal.polygons > 0) ++(portal.open ? open : closed);
    }
    const auto add = [&](const char* kind, const char* name, std::size_t count) {
        if (count == 0) return;
        legend.sample(std::string("<path class=\"portal ") + kind + "\" d=\"M-20,0 0,0M6,-6 20,-6 20,6 6,6Z\"/>",
                      std::string(name) + " (" + grouped_number(count) + ")");
    };
    add("open", "portal, edge-on or not", open);
    add("closed", "closed portal", closed);
    if (open + closed > 0)
        legend.sample("<path class=\"portal open hidden\" d=\"M-20,0 0,0M6,-6 20,-6 20,6 6,6Z\"/>",
                      "portal below a floor");
}

/// Low and high, side by side.
std::string two_tints(const Tint& tint) {
    return "<rect x=\"-10\" y=\"-5\" width=\"10\" height=\"10\" fill=\"" + hex_colour(tint.far) +
           "\"/><rect y=\"-5\" width=\"10\" height=\"10\" fill=\"" + hex_colour(tint.near) + "\"/>";
}

void add_rooms(Legend& legend, const LegendFacts& facts) {
    std::vector<bool> shown(facts.world.room_count());
    for (const RoomId room : facts.rooms) shown[room.value] = true;
    legend.heading("Rooms");
    std::size_t listed = 0, others = 0;
    for (std::uint32_t id = 0; id < shown.size(); ++id) {
        if (!shown[id]) continue;
        if (listed == kMostRows) {
            ++others;
            continue;
        }
        ++listed;
        const bool exterior = room_info(facts.world, {id})->exterior;
        legend.row(two_tints(plan_tint(room_colour({id}, exterior))), room_label(facts.world, {id}));
    }
    if (others > 0) legend.words("and " + grouped_number(others) + " more");
}

}  // namespace

double draw_legend(SvgText& svg, const PagePoint& at, const LegendFacts& facts) {
    Legend legend(svg, at.x, at.y);
    legend.heading("Legend");
    add_surfaces(legend, facts);
    if (facts.plan.shows_rooms) add_portals(legend, facts.world);
    add_casts(legend, facts);
    legend.heading("Drawn");
    legend.words(grouped_number(facts.plan.faces_in_plan) + " faces in the plan, " +
                 grouped_number(facts.plan.faces_in_section));
    legend.words("in the section: those that face the viewer");
    if (facts.plan.faces_left_out > 0)
        legend.words("left out as too small: " + grouped_number(facts.plan.faces_left_out));
    legend.heading("Scale");
    draw_scale_bar(svg, facts.plan_view, {at.x, legend.y() - 8});
    if (!facts.plan.shows_rooms) return legend.y() + 20;
    Legend rooms(svg, at.x, legend.y() + 34);
    add_rooms(rooms, facts);
    return rooms.y();
}

}  // namespace firma::draw
