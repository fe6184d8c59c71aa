// SPDX-License-Identifier: MIT
// What cuts cost along a path, at scales from a metre to eight kilometres: capsules, cylinders and boxes that overlap,
// the first third of them flush with each other.
#include <cmath>
#include <cstdio>
#include <numeric>

#include "scenes/sweeps.h"
#include "support/craters.h"
#include "support/race.h"
#include "support/settings.h"
#include "support/table.h"

namespace firma::bench {
namespace {

/// A row ends once its cuts have taken as much.
constexpr double kMostMilliseconds = 2000, kMostOfQuick = 300;

struct Row {
    std::vector<double> milliseconds;
    std::size_t refused = 0;
    double taken = 0;  ///< by the reports, share of the block
    World world;
};

Row run(scenes::SweepTool tool, int exponent, std::size_t cuts, double most) {
    const scenes::Sweep sweep = scenes::make_sweep(tool, exponent);
    Row row;
    row.world = carvable_world(sweep.block);
    double sum = 0;
    for (std::size_t k = 0; k < cuts && sum < most; ++k) {
        const CutCost cost = cut_crater(row.world, sweep.tool, sweep.poses[k]);
        row.milliseconds.push_back(cost.cpu);
        sum += cost.cpu;
        row.refused += cost.status == CarveStatus::kRefused;
        row.taken += cost.report.volume;
    }
    return row;
}

int measure(const Settings& settings) {
    Table table("sweeps", {"tool", "scale m", "cuts", "median ms", "p99 ms", "sum ms", "refused", "facets",
                           "volume left, share of the block", "reports differ from it by", "check"});
    const std::size_t cuts = settings.quick ? 50 : scenes::kSweepCuts;
    const double most = settings.quick ? kMostOfQuick : kMostMilliseconds;
    run(scenes::SweepTool::kBox, 3, cuts, most);  // so that memory is at hand
    for (const scenes::SweepTool tool : scenes::kSweepTools)
        for (int exponent = 0; exponent <= scenes::kLargestSweep; exponent += settings.quick ? 13 : 1) {
            const Row row = run(tool, exponent, cuts, most);
            const auto fault = check_world(row.world);
            const auto solid_fault = check_solid(row.world);
            const double block = std::ldexp(1.0, 3 * exponent), left = measure_solid(row.world).volume / block;
            char volume[32];
            std::snprintf(volume, sizeof volume, "%.15f", left);
            table.add(
                {std::string(scenes::name_of(tool)), count(std::size_t(1) << exponent), count(row.milliseconds.size()),
                 number(median(row.milliseconds)), number(quantile(row.milliseconds, 0.99)),
                 number(std::accumulate(row.milliseconds.begin(), row.milliseconds.end(), 0.0)), count(row.refused),
                 count(row.world.solid().face_count()), volume, number(std::fabs(row.taken / block + left - 1)),
                 fault         ? fault->what
                 : solid_fault ? solid_fault->what
                               : "sound"});
        }
    return table.finish(settings.csv) ? 0 : 1;
}

}  // namespace
}  // namespace firma::bench

int main(int argc, char** argv) {
    using namespace firma::bench;
    return measure(read_settings(argc, argv, "Overlapping tools along a path, at scales of 1 m to 8192 m."));
}
