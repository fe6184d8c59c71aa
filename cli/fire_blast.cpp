// SPDX-License-Identifier: MIT
// The shape is made before the clock starts: a game has its craters ready.
#include "cli/fire_blast.h"
#include "cli/numbers.h"

#include <algorithm>
#include <chrono>

namespace firma::cli {

namespace {

using Clock = std::chrono::steady_clock;

}  // namespace

Fired fire_blast(World& world, const Blast& blast, const FireOptions& options) {
    FireOptions own = options;
    own.carve.from = blast.from;
    return fire_cut(world, cutter_of(blast), pose_of(blast), own);
}

Fired fire_cut(World& world, const Cutter& cutter, const Pose& pose, const FireOptions& options) {
    Fired fired;
    const Clock::time_point start = Clock::now();
    {
        CarveJob job(world, cutter, pose, options.carve);
        for (bool finished = false; !finished;) {
            const Clock::time_point begun = Clock::now();
            finished = job.run(options.slice);
            fired.longest_slice = std::max(fired.longest_slice, seconds_since(begun));
        }
        fired.result = job.result();
        world = fired.result.world;
    }
    fired.seconds = seconds_since(start);
    return fired;
}

bool met_only_castable(const CarveResult& result) {
    return result.status == CarveStatus::kNothing && result.report.faces_castable_only > 0;
}

double percentile(std::vector<double>& values, double share) {
    if (values.empty()) return 0;
    const std::size_t place = std::min(values.size() - 1, std::size_t(share * double(values.size())));
    std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(place), values.end());
    return values[place];
}

}  // namespace firma::cli
