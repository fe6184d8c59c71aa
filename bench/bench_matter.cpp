// SPDX-License-Identifier: MIT
// What matter costs: the same blasts in worlds of one matter, of the built-in table's, and with its hardness too. In
// the first two all may be carved, the sky as well.
//
// bench_matter [--csv FOLDER]; of OpenArena's maps where FIRMA_OPENARENA names their folder.
#include <cstdio>
#include <filesystem>

#include "firma/brush_world.h"
#include "firma/matter.h"
#include "scenes/blasts.h"
#include "support/craters.h"
#include "support/race.h"
#include "support/settings.h"
#include "support/table.h"
#include "tests/openarena_maps.h"

namespace firma::bench {
namespace {

constexpr std::size_t kManyMaterials = 1000;  // as many as any map here has, and more

/// A world that is cut blast by blast; what refuses or finds nothing leaves it as it is.
struct History {
    World world;
    std::vector<double> milliseconds;  ///< of cuts that took something
    std::size_t short_cuts = 0, refused = 0;

    void blast(const scenes::RoomBlast& it) {
        CarveOptions options;
        options.from = it.from;
        const double before = thread_seconds();
        const CarveResult result = it.cut.kind == CarveKind::kFill ? fill(world, it.cut.cutter, it.cut.pose, options)
                                                                   : carve(world, it.cut.cutter, it.cut.pose, options);
        const double spent = (thread_seconds() - before) * 1e3;
        refused += result.status == CarveStatus::kRefused;
        if (!result.done()) return;
        world = result.world;
        short_cuts += result.report.cut_short > 0;
        milliseconds.push_back(spent);
    }
};

double sum(const std::vector<double>& values) {
    double all = 0;
    for (const double value : values) all += value;
    return all;
}
double mean(const std::vector<double>& values) {
    return values.empty() ? 0 : sum(values) / double(values.size());
}

bool measure_level(const std::string& path, std::size_t cases, Table& table) {
    const Result<BrushLevel> read = read_brush_level(path);
    if (!read) return std::fprintf(stderr, "%s\n", read.error().text().c_str()), false;
    BrushLevel level = read.value();
    MatterTable soft = default_matters();
    for (Matter& matter : soft.matters) matter.hardness = 0;
    History all[3];
    const MatterTable tables[3] = {MatterTable{}, soft, default_matters()};
    World worlds[3];
    for (int k = 0; k < 3; ++k) {
        WorldOptions options;
        options.matters = tables[k];
        Result<World> made = make_world(level, options);
        if (!made) return std::fprintf(stderr, "%s\n", made.error().text().c_str()), false;
        CarveRules rules;
        if (k < 2) rules.hardness.assign(kManyMaterials, 0);
        worlds[k] = with_rules(made.value(), rules).value();
    }
    for (std::size_t number = 0; number < cases; ++number) {
        scenes::Rng rng(number + 1);
        const auto blasts = scenes::room_blasts(scenes::blast_places(worlds[0]), 12, rng);
        for (int k = 0; k < 3; ++k) all[k].world = worlds[k];
        for (const scenes::RoomBlast& blast : blasts)
            for (History& it : all) it.blast(blast);
    }
    table.add({std::filesystem::path(path).stem().string(), count(worlds[0].face_count()),
               count(all[2].milliseconds.size()), number(median(all[0].milliseconds)),
               number(median(all[1].milliseconds)), number(median(all[2].milliseconds)),
               number(mean(all[0].milliseconds)), number(mean(all[1].milliseconds)), number(mean(all[2].milliseconds)),
               number(quantile(all[0].milliseconds, 0.99)), number(quantile(all[1].milliseconds, 0.99)),
               number(quantile(all[2].milliseconds, 0.99)), count(all[2].short_cuts), count(all[2].refused)});
    return true;
}

int measure(const Settings& settings) {
    Table table("matter", {"level", "faces", "cuts", "one ms", "soft ms", "all ms", "one mean", "soft mean", "all mean",
                           "one p99", "soft p99", "all p99", "cut short", "refused"});
    bool good = measure_level(settings.repository + "/levels/depot.map", settings.few(60), table);
    const char* folder = std::getenv("FIRMA_OPENARENA");
    if (folder != nullptr && !settings.quick)
        for (std::size_t k = 0; k < kCarvedMaps; ++k)
            good &= measure_level(std::string(folder) + "/" + kRoomMaps[k] + ".bsp", settings.few(20), table);
    return table.finish(settings.csv) && good ? 0 : 1;
}

}  // namespace
}  // namespace firma::bench

int main(int argc, char** argv) {
    using namespace firma::bench;
    return measure(read_settings(argc, argv, "What matter costs in random blasts."));
}
