// SPDX-License-Identifier: MIT
// Thousands of cuts in forced contact, judged one by one: none refused. Prints a claim a family and one in
// total. Beside the families of contact_families.h there is one for the depot and for each map.
//
//   full_contact --count 20000 --seed 1 [--threads 2] [--from 0] [--to N] [--family NAME] [--level levels/first.obj]
//                [--maps DIR] [--show 3 (of each family)]
#include <filesystem>
#include <span>

#include "firma/brush_world.h"
#include "scenes/contact_families.h"
#include "scenes/level_cuts.h"
#include "tests/brush/unprotected_world.h"
#include "tests/full/family_run.h"
#include "tests/openarena_maps.h"

namespace {

using namespace firma;

/// A level of brushes, made into a world twice.
struct Map {
    std::string name;
    World world, again;
    Level walls;
};

std::vector<Map> read_maps(const full::FamilyOptions& options, const std::string& folder) {
    std::vector<std::string> files{FIRMA_ROOT "/levels/depot.map"};
    if (!folder.empty())
        for (const char* map : std::span(kRoomMaps).first(kCarvedMaps)) files.push_back(folder + "/" + map + ".bsp");
    std::vector<Map> maps;
    for (const std::string& file : files) {
        const std::string name = "contact_" + std::filesystem::path(file).stem().string();
        if (!options.family.empty() && options.family != name) continue;
        const Result<BrushLevel> level = read_brush_level(file);
        if (!level) {
            std::fprintf(stderr, "%s\n", level.error().text().c_str());
            std::exit(2);
        }
        // What is judged is the solid: a carving that takes nothing of it is to be none.
        const auto made = [&] { return test::unprotected_world(level.value(), false); };
        Map map{name, made(), made(), {}};
        map.walls = scenes::cut_places(map.world).inside;
        maps.push_back(std::move(map));
    }
    return maps;
}

}  // namespace

int main(int count, char** words) {
    full::FamilyOptions options;
    options.count = 20000;
    std::string folder;
    std::vector<full::ExtraOption> extra = options.words();
    extra.push_back({"--maps", nullptr, &folder});
    if (!full::read_options(count, words, options, extra)) {
        std::fprintf(stderr,
                     "full_contact [--count N] [--seed N] [--threads N] [--from CASE] [--to CASE] [--family NAME] "
                     "[--level FILE] [--maps DIR] [--show N]\n");
        return 2;
    }
    const Result<Level> ours = read_level(options.level);
    if (!ours) {
        std::fprintf(stderr, "%s\n", ours.error().text().c_str());
        return 2;
    }
    reference::report_contradictions();
    reference::JudgeOptions judge;
    judge.contact = true;
    std::vector<full::JudgedFamily> families;
    for (const scenes::CutFamily& family : scenes::contact_families())
        families.push_back({std::string(family.name), [&](std::uint64_t seed, std::uint64_t index) {
                                return reference::judge_case(family, seed, index, ours.value(), judge);
                            }});
    // In maps every cut is judged against all faces of the world, which takes longer.
    const std::vector<Map> maps = read_maps(options, folder);
    for (const Map& map : maps)
        families.push_back(
            {map.name, [&](std::uint64_t seed, std::uint64_t index) {
                 const auto cuts = scenes::contact_cuts(map.walls, seed, index);
                 const std::string name = map.name + " seed=" + std::to_string(seed) + " case=" + std::to_string(index);
                 return reference::judge_cuts(map.world, map.again, cuts, name, seed ^ index << 32, judge);
             }});
    full::FamilyRun run(options, {"contact_cuts", 0, 0}, families);
    if (run.empty()) {
        std::fprintf(stderr, "full_contact: no such family\n");
        return 2;
    }
    return run.run();
}
