// SPDX-License-Identifier: MIT
// Gathers level, blasts and casts; draw/draw_plan.h and draw_view.h draw them.
#include "cli/verbs.h"
#include "firma/queries.h"

#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/atomic_file.h"
#include "cli/failure.h"
#include "cli/find_camera.h"
#include "cli/fire_blast.h"
#include "cli/json.h"
#include "cli/load_level.h"
#include "cli/numbers.h"
#include "cli/read_blasts.h"
#include "cli/read_hits.h"
#include "cli/read_queries.h"
#include "draw/draw_plan.h"
#include "draw/draw_view.h"
#include "draw/picture.h"

namespace firma::cli {

namespace {

struct DrawArguments {
    LevelArguments level;
    std::string queries, casts, blasts, out, up, at, below, most_casts, eye, look, zoom, rooms;
    bool view = false, before_after = false, plain = false, json = false;

    bool shows_rooms() const { return !rooms.empty(); }
};

constexpr const char* kDrawFooter =
    R"(The page shows a plan from above and, below it, a section: what lies beyond a plane and, in heavy lines, what the
plane cuts. Both are to scale, with axes in metres. Faces show where their front faces the viewer, so that a room
is looked into through its ceiling. Faces too small to be seen are left out, and the page says how many.
  --up z (default): plan x to the right, y up the page; section x and z, cut at y
  --up x:           plan y to the right, z up the page; section y and x, cut at z
  --up y:           plan z to the right, x up the page; section z and y, cut at x

A plan of a level of two rooms or more, beside the exterior, gives each room a colour of its own and writes its
number, and its name where that has room; green lines and panes are portals, red ones closed. --plain draws it
without them; --rooms does the same for a level of one room, and for views; --rooms auto divides a .map, or the
brushes of a .bsp, at doorways and where the air narrows first. Plans leave the hull's outside away,
unless most of the level lies out there, and clip brushes always.

--queries and --casts are the files that `firma cast` reads and writes. Hits are blue, misses orange and broken,
touches at the start red; a sphere shows as circles at its start and at the contact. With --queries alone the
casts are made here, one-sided.

--blasts is the file that `firma carve` reads: the level is drawn after them, new faces brown.

--view writes a PNG instead: the level as seen from --eye toward --look, with the shadows of a lamp beside the eye.
Without both, and with --blasts, it looks for a place from which many of the new faces are seen. --before-after
shows the level without the blasts on the left, with them on the right.
  firma draw levels/first.obj --blasts blasts.csv --view --before-after -o crater.png

--json: level, cut_axis, cut_at, faces_in_plan, faces_in_section, faces_cut, faces_left_out, casts, casts_drawn,
blasts, new_faces, shows_rooms, rooms_labelled, portals_drawn, bytes, out. With --view: level, eye, look, blasts,
new_faces, bytes, out.
)";

constexpr int kViewWidth = 640, kViewHeight = 480;

std::vector<draw::DrawnCast> gather_casts(const DrawArguments& arguments, const World& world) {
    if (arguments.queries.empty()) return {};
    const std::vector<Query> queries = read_queries(arguments.queries);
    if (!arguments.casts.empty()) return read_hits(arguments.casts, queries);
    std::vector<draw::DrawnCast> casts;
    for (const Query& query : queries) casts.push_back(drawn(query, cast(world, query.sphere, query.path)));
    return casts;
}

World after_blasts(const World& before, const std::vector<Blast>& blasts) {
    World world = before;
    for (const Blast& blast : blasts) fire_blast(world, blast);
    return world;
}

std::size_t new_faces(const World& world) {
    std::size_t count = 0;
    for (const Face& face : world.faces()) count += face.source_edit != 0;
    return count;
}

draw::Camera camera_of(const DrawArguments& arguments, const World& before, const World& after) {
    draw::Camera camera;
    camera.up = axis_option("--up", arguments.up);
    camera.width = kViewWidth;
    camera.height = kViewHeight;
    if (!arguments.zoom.empty()) camera.zoom = number_option("--zoom", arguments.zoom, 0.1, 100);
    if (arguments.eye.empty() != arguments.look.empty()) throw Failure("--view", "needs --eye and --look, or neither");
    if (!arguments.eye.empty()) {
        camera.eye = point_option("--eye", arguments.eye);
        camera.target = point_option("--look", arguments.look);
        if (camera.eye == camera.target) throw Failure("--look", "is where the eye is");
        return camera;
    }
    const std::optional<draw::Camera> found = find_camera(before, after, camera);
    if (!found) throw Failure("--view", "needs --eye and --look where no blast made anything to see");
    return *found;
}

/// A PNG in perspective.
void draw_view(const DrawArguments& arguments, const World& before, const World& after, std::size_t blasts) {
    const draw::Camera camera = camera_of(arguments, before, after);
    AtomicFile out(arguments.out);
    const bool rooms = arguments.shows_rooms();
    draw::Picture picture = draw::draw_view(after, camera, rooms);
    if (arguments.before_after) picture = side_by_side(draw::draw_view(before, camera, rooms), picture);
    const std::string bytes = png_bytes(picture);
    out.write(bytes);
    out.commit();
    if (arguments.json) {
        Json json;
        json["level"] = arguments.level.path;
        json["eye"] = camera.eye;
        json["look"] = camera.target;
        json["blasts"] = blasts;
        json["new_faces"] = new_faces(after);
        json["bytes"] = bytes.size();
        json["out"] = arguments.out;
        print(json_text(std::move(json)));
    } else if (may_print_beside(arguments.out)) {
        const Vec3 &eye = camera.eye, &look = camera.target;
        print(fmt::format("{}: from ({:.2f}, {:.2f}, {:.2f}) toward ({:.2f}, {:.2f}, {:.2f}); {}\n", arguments.out,
                          eye.x, eye.y, eye.z, look.x, look.y, look.z, bytes_text(bytes.size())));
    }
}

/// An SVG with plan and section.
void draw_plan(const DrawArguments& arguments, const World& world, std::size_t blasts) {
    draw::PlanOptions options;
    options.title = short_name(arguments.level.path);
    options.up = axis_option("--up", arguments.up);
    if (!arguments.at.empty()) options.at = number_option("--at", arguments.at);
    if (!arguments.below.empty()) options.below = number_option("--below", arguments.below);
    if (!arguments.most_casts.empty())
        options.most_casts = count_option("--most-casts", arguments.most_casts, 0, 100000);
    if (arguments.shows_rooms() || arguments.plain) options.rooms = arguments.shows_rooms();
    const std::vector<draw::DrawnCast> casts = gather_casts(arguments, world);

    AtomicFile out(arguments.out);
    const draw::Plan plan = draw::draw_plan(world, casts, options);
    out.write(plan.svg);
    out.commit();
    if (arguments.json) {
        Json json;
        json["level"] = arguments.level.path;
        json["cut_axis"] = plan.cut_axis == 0 ? "x" : plan.cut_axis == 1 ? "y" : "z";
        json["cut_at"] = plan.at;
        json["faces_in_plan"] = plan.faces_in_plan;
        json["faces_in_section"] = plan.faces_in_section;
        json["faces_cut"] = plan.faces_cut;
        json["faces_left_out"] = plan.faces_left_out;
        json["casts"] = casts.size();
        json["casts_drawn"] = plan.casts_drawn;
        json["blasts"] = blasts;
        json["new_faces"] = plan.new_faces;
        json["shows_rooms"] = plan.shows_rooms;
        json["rooms_labelled"] = plan.rooms_labelled;
        json["portals_drawn"] = plan.portals_drawn;
        json["bytes"] = plan.svg.size();
        json["out"] = arguments.out;
        print(json_text(std::move(json)));
    } else if (may_print_beside(arguments.out)) {
        const std::string rooms = plan.shows_rooms
                                      ? fmt::format(", {} labelled, {} drawn", counted(plan.rooms_labelled, "room"),
                                                    counted(plan.portals_drawn, "portal"))
                                      : "";
        print(fmt::format("{}: {} faces in the plan, {} in the section{}, {} of {} casts; {}\n", arguments.out,
                          grouped(plan.faces_in_plan), grouped(plan.faces_in_section), rooms, grouped(plan.casts_drawn),
                          grouped(casts.size()), bytes_text(plan.svg.size())));
    }
}

/// A plan under a view's name would open nowhere, and the other way round.
void judge_ending(const DrawArguments& arguments) {
    if (!arguments.view && has_ending(arguments.out, ".png"))
        throw Failure(arguments.out, "a .png is a view: add --view; a plan is an .svg");
    if (arguments.view && has_ending(arguments.out, ".svg"))
        throw Failure(arguments.out, "an .svg is a plan: leave --view out; a view is a .png");
}

int run(const DrawArguments& arguments) {
    if (!arguments.casts.empty() && arguments.queries.empty())
        throw Failure("--casts", "needs --queries as well: the hits do not say where the casts began");
    if (!arguments.view) {
        for (const auto& [option, given] :
             {std::pair("--eye", !arguments.eye.empty()), std::pair("--look", !arguments.look.empty()),
              std::pair("--zoom", !arguments.zoom.empty()), std::pair("--before-after", arguments.before_after)})
            if (given) throw Failure(option, "needs --view: the plan has no such thing");
    } else if (!arguments.queries.empty() || !arguments.at.empty() || !arguments.below.empty() ||
               !arguments.most_casts.empty()) {
        throw Failure("--view", "shows neither casts nor a section");
    }
    if (arguments.shows_rooms() && arguments.plain) throw Failure("--plain", "and --rooms exclude each other");
    axis_option("--up", arguments.up);
    refuse_json_beside(arguments.json, arguments.out);
    for (const std::string& input : {arguments.level.path, arguments.queries, arguments.casts, arguments.blasts})
        refuse_overwriting(arguments.out, input);
    judge_ending(arguments);
    LevelArguments level = arguments.level;
    if (arguments.rooms != "true") level.rooms = arguments.rooms;
    const LoadedLevel loaded = load_level(level);
    const std::vector<Blast> blasts = arguments.blasts.empty() ? std::vector<Blast>{} : read_blasts(arguments.blasts);
    const World world = after_blasts(loaded.world, blasts);
    if (arguments.view) {
        draw_view(arguments, loaded.world, world, blasts.size());
    } else {
        draw_plan(arguments, world, blasts.size());
    }
    return 0;
}

}  // namespace

Verb add_draw(CLI::App& app) {
    Command command(app, "draw", "Draws a level, before or after blasts: plan and section as SVG, or a view as PNG");
    const auto arguments = std::make_shared<DrawArguments>();
    add_level_arguments(command, arguments->level);
    command.add_option("--queries", arguments->queries, "FILE", "csv of casts to draw, as for `firma cast`");
    command.add_option("--casts", arguments->casts, "FILE", "csv of their hits, as `firma cast` writes it");
    command.add_option("--blasts", arguments->blasts, "FILE", "csv of blasts to fire first, as for `firma carve`");
    add_out_option(command, arguments->out, "SVG to write; with --view a PNG", true);
    command.add_option("--up", arguments->up, "AXIS", "the axis that points up: x, y or z (default z)");
    command.add_option("--at", arguments->at, "M", "where the section cuts, metres (default: where it shows most)");
    command.add_option("--below", arguments->below, "M", "the plan leaves away what lies above, metres: a storey, say");
    command.add_option("--most-casts", arguments->most_casts, "N", "casts drawn at most, evenly taken (default 200)");
    command.add_flag("--view", arguments->view, "draw a view in perspective, as PNG");
    command.add_option("--eye", arguments->eye, "X,Y,Z", "with --view: where it looks from, metres");
    command.add_option("--look", arguments->look, "X,Y,Z", "with --view: the point in the middle of the picture");
    command.add_option("--zoom", arguments->zoom, "Z", "with --view: 1 (default) sees 90 degrees, 2 half as much");
    command.add_flag("--before-after", arguments->before_after, "with --view: the level before the blasts beside it");
    command.add_flag("--rooms", arguments->rooms,
                     "each room in a colour of its own, and the portals; `--rooms auto`: of a level of brushes, its "
                     "air divided where it narrows");
    command.add_flag("--plain", arguments->plain, "no rooms and portals: a plan shows several rooms otherwise");
    add_json_flag(command, arguments->json);
    command.set_footer(std::string(kDrawFooter) + kExitCodes);
    return {command, [arguments] { return run(*arguments); }};
}

}  // namespace firma::cli
