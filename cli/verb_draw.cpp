// SPDX-License-Identifier: MIT
// Gathers level and casts; src/debug/draw_plan.h draws.
#include "cli/verb_draw.h"

#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "cli/atomic_file.h"
#include "cli/failure.h"
#include "cli/json.h"
#include "cli/load_level.h"
#include "cli/numbers.h"
#include "cli/read_hits.h"
#include "cli/read_queries.h"
#include "debug/draw_plan.h"

namespace firma::cli {

namespace {

struct DrawArguments {
    LevelArguments level;
    std::string queries, casts, out, up, at, most_casts;
    bool json = false;
};

constexpr const char* kFooter =
    R"(The page shows a plan from above and, below it, a section: what lies beyond a plane and, in heavy lines, what the
plane cuts. Both are to scale, with axes in metres. Faces show where their front faces the viewer, so that a room
is looked into through its ceiling. Faces too small to be seen are left out, and the page says how many.
  --up z (default): plan x to the right, y up the page; section x and z, cut at y
  --up x:           plan y to the right, z up the page; section y and x, cut at z
  --up y:           plan z to the right, x up the page; section z and y, cut at x

--queries and --casts are the files that `firma cast` reads and writes. Hits are blue, misses orange and broken,
touches at the start red; a sphere shows as circles at its start and at the contact. With --queries alone the
casts are made here, one-sided.

--json: level, cut_axis, cut_at, faces_in_plan, faces_in_section, faces_cut, faces_left_out, casts, casts_drawn,
bytes, out.
)";

int axis_option(const std::string& text) {
    if (text.empty() || text == "z") return 2;
    if (text == "x") return 0;
    if (text == "y") return 1;
    throw Failure("--up", "'" + text + "' is neither x, y nor z");
}

std::vector<debug::DrawnCast> gather_casts(const DrawArguments& arguments, const World& world) {
    if (arguments.queries.empty()) return {};
    const std::vector<Query> queries = read_queries(arguments.queries);
    if (!arguments.casts.empty()) return read_hits(arguments.casts, queries);
    std::vector<debug::DrawnCast> casts;
    for (const Query& query : queries) casts.push_back(drawn(query, cast(world, query.sphere, query.path)));
    return casts;
}

int run(const DrawArguments& arguments) {
    if (!arguments.casts.empty() && arguments.queries.empty())
        throw Failure("--casts", "needs --queries as well: the hits do not say where the casts began");
    debug::PlanOptions options;
    options.title = short_name(arguments.level.path);
    options.up = axis_option(arguments.up);
    if (!arguments.at.empty()) options.at = number_option("--at", arguments.at);
    if (!arguments.most_casts.empty())
        options.most_casts = count_option("--most-casts", arguments.most_casts, 0, 100000);
    refuse_json_beside(arguments.json, arguments.out);
    for (const std::string& input : {arguments.level.path, arguments.queries, arguments.casts})
        refuse_overwriting(arguments.out, input);
    const LoadedLevel loaded = load_level(arguments.level);
    const std::vector<debug::DrawnCast> casts = gather_casts(arguments, loaded.world);

    AtomicFile out(arguments.out);
    const debug::Plan plan = debug::draw_plan(loaded.world, casts, options);
    out.write(plan.svg);
    out.commit();
    if (arguments.json) {
        JsonWriter json;
        json.open_object();
        json.add("level", arguments.level.path);
        json.add("cut_axis", plan.cut_axis == 0 ? "x" : plan.cut_axis == 1 ? "y" : "z");
        json.add("cut_at", plan.at);
        json.add("faces_in_plan", plan.faces_in_plan);
        json.add("faces_in_section", plan.faces_in_section);
        json.add("faces_cut", plan.faces_cut);
        json.add("faces_left_out", plan.faces_left_out);
        json.add("casts", casts.size());
        json.add("casts_drawn", plan.casts_drawn);
        json.add("bytes", plan.svg.size());
        json.add("out", arguments.out);
        json.close();
        print(json.text());
    } else if (may_print_beside(arguments.out)) {
        print(fmt::format("{}: {} faces in the plan, {} in the section, {} of {} casts; {}\n", arguments.out,
                          grouped(plan.faces_in_plan), grouped(plan.faces_in_section), grouped(plan.casts_drawn),
                          grouped(casts.size()), bytes_text(plan.svg.size())));
    }
    return 0;
}

}  // namespace

Verb add_draw(CLI::App& app) {
    Command command(app, "draw", "Draws a plan and a section of a level, with casts, as SVG");
    const auto arguments = std::make_shared<DrawArguments>();
    add_level_arguments(command, arguments->level);
    command.add_option("--queries", arguments->queries, "FILE", "csv of casts to draw, as for `firma cast`");
    command.add_option("--casts", arguments->casts, "FILE", "csv of their hits, as `firma cast` writes it");
    add_out_option(command, arguments->out, "SVG to write", true);
    command.add_option("--up", arguments->up, "AXIS", "the axis that points up: x, y or z (default z)");
    command.add_option("--at", arguments->at, "M", "where the section cuts, metres (default: where it shows most)");
    command.add_option("--most-casts", arguments->most_casts, "N", "casts drawn at most, evenly taken (default 200)");
    add_json_flag(command, arguments->json);
    command.set_footer(std::string(kFooter) + kExitCodes);
    return {command, [arguments] { return run(*arguments); }};
}

}  // namespace firma::cli
