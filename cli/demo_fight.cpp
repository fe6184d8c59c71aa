// SPDX-License-Identifier: MIT
// Ends at the first fault.
#include "cli/demo_fight.h"

#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "cli/anchor_options.h"
#include "cli/atomic_file.h"
#include "cli/demo_depot.h"
#include "cli/failure.h"
#include "cli/fight_judge.h"
#include "cli/fight_pictures.h"
#include "cli/fight_plans.h"
#include "cli/json.h"
#include "cli/numbers.h"
#include "cli/progress.h"
#include "cli/verb.h"

namespace firma::cli {

namespace {

constexpr double kFightSeconds = 20;

struct FightOutcome {
    double wall_seconds = 0;  ///< of the frames, without judging and drawing
    std::string fault;        ///< empty: all held
    std::size_t bodies = 0, at_rest = 0;
    std::vector<std::string> pictures;
};

std::string fight_row(const char* what, const std::string& value) {
    return fmt::format("{:<24} {}\n", what, value);
}

std::string ms_text(double seconds) {
    return fmt::format("{:.2f}", 1e3 * seconds);
}

std::string craters_of(const FightFigures& figures) {
    std::string text = fmt::format("{} done, {} nothing, {} refused", grouped(figures.craters),
                                   grouped(figures.nothing), grouped(figures.refused));
    if (figures.undone > 0)
        text += fmt::format("; {} of these taken back, as they opened a way out of the level", grouped(figures.undone));
    return text;
}

std::string rooms_of(const FightFigures& figures) {
    std::string text;
    for (const std::string& room : figures.rooms) text += (text.empty() ? "" : ", ") + room;
    return text.empty() ? "none" : text;
}

std::string fight_text(const LoadedLevel& loaded, const FightGame& game, const FightJudge& judge,
                       const FightOutcome& outcome) {
    const FightFigures& figures = game.figures();
    std::string text = fight_row("level", loaded.level.name);
    text += fight_row("frames", fmt::format("{}: {:.1f} s of a fire fight, in {}", grouped(figures.frames),
                                            game.seconds(), seconds_text(outcome.wall_seconds)));
    text += fight_row("rockets", fmt::format("{} fired, {} hit", grouped(figures.shots), grouped(figures.hits)));
    text += fight_row("craters", craters_of(figures));
    text += fight_row("came loose", fmt::format("{}; {} broke; {} of dust", counted(figures.loose, "body", "bodies"),
                                                grouped(figures.broken), counted(figures.dust, "piece")));
    text += fight_row(
        "bodies", fmt::format("{} at most; {} at the end, {} of them at rest; {} removed", grouped(figures.most_bodies),
                              grouped(outcome.bodies), grouped(outcome.at_rest), grouped(figures.removed)));
    text += fight_row("deepest in the level",
                      fmt::format("{:.3f} mm, of {} judged; {:g} mm is the contact offset", 1e3 * judge.deepest(),
                                  counted(judge.spheres(), "sphere"), 1e3 * game.world().tolerance().contact_offset));
    text += fight_row("lost bodies", grouped(judge.lost()));
    text += fight_row("the player",
                      fmt::format("went {:.1f} m, {} where the level was solid; pushed by {}", figures.player_way,
                                  counted(figures.holes, "time"), counted(figures.player_pushed, "blast")));
    text += fight_row("rooms it was in", rooms_of(figures));
    text += fight_row("rays that escape", fmt::format("{} of {}", grouped(figures.escaped), grouped(figures.rays)));
    std::string phases;
    for (const FightPhase& phase : figures.phases)
        phases +=
            fmt::format("{}{} {} (worst {})", phases.empty() ? "" : ", ", phase.name,
                        ms_text(phase.total / double(std::max<std::size_t>(figures.frames, 1))), ms_text(phase.worst));
    text += fight_row("processor ms a frame", phases);
    text += fight_row("hash", fmt::format("{:016x}", hash_fight(game.state())));
    for (const std::string& picture : outcome.pictures) text += fight_row("picture", picture);
    if (!outcome.fault.empty()) text += "\nWHAT MUST HOLD DID NOT: " + outcome.fault + "\n";
    return text;
}

Json fight_json(const LoadedLevel& loaded, const FightGame& game, const FightJudge& judge,
                const FightOutcome& outcome) {
    const FightFigures& figures = game.figures();
    Json json;
    json["level"] = loaded.level.name;
    json["frames"] = figures.frames;
    json["seconds"] = game.seconds();
    json["wall_seconds"] = outcome.wall_seconds;
    json["rockets"] = {{"fired", figures.shots}, {"hit", figures.hits}};
    json["craters"] = {{"done", figures.craters},
                       {"nothing", figures.nothing},
                       {"refused", figures.refused},
                       {"taken_back", figures.undone}};
    json["bodies"] = {
        {"loose", figures.loose}, {"broken", figures.broken},          {"dust", figures.dust},
        {"unfit", figures.unfit}, {"pushes", figures.pushed},          {"max", figures.most_bodies},
        {"end", outcome.bodies},  {"at_rest", outcome.at_rest},        {"removed", figures.removed},
        {"lost", judge.lost()},   {"spheres_judged", judge.spheres()}, {"deepest_mm", 1e3 * judge.deepest()}};
    json["player"] = {{"way", figures.player_way},
                      {"through_solid", figures.holes},
                      {"pushed", figures.player_pushed},
                      {"rooms", figures.rooms},
                      {"at", game.player().position}};
    json["blasts"] = Json::array();
    for (const FightFlash& blast : game.flashes())
        json["blasts"].push_back({{"seconds", blast.seconds},
                                  {"at", blast.at},
                                  {"crater", blast.crater == CarveStatus::kDone      ? "done"
                                             : blast.crater == CarveStatus::kNothing ? "nothing"
                                                                                     : "refused"},
                                  {"loose", blast.loose},
                                  {"broken", blast.broken}});
    json["rays"] = {{"cast", figures.rays}, {"escaped", figures.escaped}};
    for (const FightPhase& phase : figures.phases)
        json["ms"][phase.name] = {{"mean", 1e3 * phase.total / double(std::max<std::size_t>(figures.frames, 1))},
                                  {"worst", 1e3 * phase.worst}};
    json["hash"] = fmt::format("{:016x}", hash_fight(game.state()));
    json["pictures"] = outcome.pictures;
    json["fault"] = outcome.fault.empty() ? Json() : Json(outcome.fault);
    return json;
}

}  // namespace

int run_fight(const FightArguments& arguments) {
    const std::uint64_t seed =
        arguments.seed.empty() ? 1 : count_option("--seed", arguments.seed, 0, ~std::uint64_t(0));
    const double seconds =
        arguments.seconds.empty() ? kFightSeconds : number_option("--seconds", arguments.seconds, 0.1, 600);
    const LoadedLevel loaded = load_level(arguments.level);
    const World level = with_usual_anchors(anchored(loaded, {}));
    const bool depot = is_depot(level);
    std::unique_ptr<FightPlan> plan;
    std::optional<Vec3> start;
    if (depot) {
        const FightList list = depot_fight();
        start = list.start;
        plan = std::make_unique<ListedFight>(list);
    } else {
        start = find_start(level, loaded.brushes ? &loaded.brushes->level : nullptr, seed);
        plan = std::make_unique<RoamingFight>(seed, seconds);
    }
    if (!start) throw Failure(arguments.level.path, "no place was found where a player of 1.8 m fits");

    if (!arguments.frames.empty()) make_folder(arguments.frames);
    FightGame game(level, *start, seed);
    FightJudge judge(game);
    FightCamera camera(arguments.frames.empty() ? std::vector<FightFilm>{}
                                                : (depot ? depot_films() : roaming_films(seconds)));
    FightOutcome outcome;
    const auto frames = std::size_t(seconds * kFightRate + 0.5);
    {
        Progress progress("fighting", frames);
        for (std::size_t frame = 0; frame < frames && outcome.fault.empty(); ++frame) {
            const auto begun = std::chrono::steady_clock::now();
            game.advance(plan->next(game));
            outcome.wall_seconds += seconds_since(begun);
            camera.look(game);
            if (const std::string fault = judge.fault(game.state(), game.figures().escaped); !fault.empty())
                outcome.fault = fmt::format("frame {}: {}", frame, fault);
            progress.add(1);
        }
    }
    for (const Body& body : game.state().bodies.slots) {
        outcome.bodies += body.shape.valid();
        outcome.at_rest += body.shape.valid() && body.asleep;
    }
    if (!arguments.frames.empty()) outcome.pictures = camera.develop(arguments.frames);
    print(arguments.json ? json_text(fight_json(loaded, game, judge, outcome))
                         : fight_text(loaded, game, judge, outcome));
    return outcome.fault.empty() ? 0 : 1;
}

}  // namespace firma::cli
