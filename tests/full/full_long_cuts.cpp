// SPDX-License-Identifier: MIT
// Long rows of cuts, none refused: random craters in the depot, one after the other; the sweeps at every scale. Prints
// a line a row and one claim.
//
//   full_long_cuts --what craters --count 10000 --seed 1     (a row)
//   full_long_cuts --what sweeps --count 42 --seed 1 [--threads 2]   (rows: 3 tools at 14 scales; no seed changes them)
//
// The world is judged every so many cuts: all that check_world() and check_solid() ask, the volume of its rock against
// that before and what the reports say was taken.
#include <atomic>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "firma/brush_world.h"
#include "firma/carve.h"
#include "scenes/level_cuts.h"
#include "scenes/sweeps.h"
#include "tests/brush/unprotected_world.h"
#include "tests/full/options.h"

namespace {

using namespace firma;
using ull = unsigned long long;

/// Of the volume of all rock, or air: what sums of ten thousand reports may be off by.
constexpr double kVolumeError = 1e-12;

struct Tally {
    std::string name;
    std::uint64_t asked = 0, done = 0, nothing = 0, refused = 0, unplaceable = 0, checks = 0;
    double worst = 0;  ///< of volumes, as a share
    std::vector<std::string> failures;
};

class Row {
public:
    Row(std::string name, World world) : world_(std::move(world)), before_(measure_solid(world_).volume) {
        tally_.name = std::move(name);
    }

    /// Whether the cutter can be placed at all: some cross themselves once they are snapped.
    bool cut(const Cutter& cutter, const Pose& pose) {
        const CarveResult result = carve(world_, cutter, pose);
        const bool refused = result.status == CarveStatus::kRefused;
        if (refused && subtract(Solid(), cutter, pose).status == CarveStatus::kRefused) {
            ++tally_.unplaceable;
            return false;
        }
        if (refused) fail("cut " + std::to_string(tally_.asked) + " refused: " + result.error.text());
        ++tally_.asked;
        tally_.done += result.status == CarveStatus::kDone;
        tally_.nothing += result.status == CarveStatus::kNothing;
        tally_.refused += refused;
        taken_ += result.report.volume;
        world_ = result.world;
        return true;
    }

    void check() {
        ++tally_.checks;
        const std::string after = " after " + std::to_string(tally_.asked) + " cuts";
        if (const auto fault = check_world(world_)) fail(fault->what + after);
        if (const auto fault = check_solid(world_)) fail(fault->what + after);
        const double now = measure_solid(world_).volume;
        const double off = std::fabs(before_ - taken_ - now) / std::fabs(before_);
        tally_.worst = std::fmax(tally_.worst, off);
        if (!(off < kVolumeError)) fail("the volume is off by " + std::to_string(off) + " of it" + after);
    }

    const Tally& tally() const { return tally_; }

private:
    void fail(const std::string& what) { tally_.failures.push_back(tally_.name + ": " + what); }

    World world_;
    const double before_;
    double taken_ = 0;
    Tally tally_;
};

Tally craters(std::uint64_t count, std::uint64_t seed) {
    constexpr std::uint64_t kAtATime = 500;
    const World depot = test::unprotected_world(read_brush_level(FIRMA_ROOT "/levels/depot.map").value(), true);
    const scenes::CutPlaces places = scenes::cut_places(depot);
    Row row("craters", depot);
    std::uint64_t made = 0;
    for (std::uint64_t index = 0; made < count; ++index)
        for (const scenes::CutOrder& order : scenes::level_cuts(places, scenes::LevelCuts::kSpread, seed, index)) {
            if (made == count) break;
            if (!row.cut(order.cutter, order.pose)) continue;
            if (++made % kAtATime == 0 || made == count) row.check();
        }
    return row.tally();
}

Tally sweep(std::uint64_t number) {
    const scenes::SweepTool tool = scenes::kSweepTools[number % 3];
    const int exponent = int(number / 3) % (scenes::kLargestSweep + 1);
    const scenes::Sweep made = scenes::make_sweep(tool, exponent);
    Row row(std::string(scenes::name_of(tool)) + "_" + std::to_string(1 << exponent) + "m",
            make_world(made.block).value());
    for (const Pose& pose : made.poses) row.cut(made.tool, pose);
    row.check();
    return row.tally();
}

}  // namespace

int main(int count, char** words) {
    full::Options options;
    std::string what;
    if (!full::read_options(count, words, options, {{"--what", nullptr, &what}}) ||
        (what != "craters" && what != "sweeps")) {
        std::fprintf(stderr, "full_long_cuts --what craters|sweeps --count N [--seed N] [--threads N] [--show N]\n");
        return 2;
    }
    const std::uint64_t rows = what == "craters" ? 1 : options.count;
    std::mutex mutex;
    Tally total;
    std::uint64_t failed = 0;
    std::atomic<std::uint64_t> next = 0;
    const auto work = [&] {
        for (std::uint64_t number = next++; number < rows; number = next++) {
            const Tally tally = what == "craters" ? craters(options.count, options.seed) : sweep(number);
            const std::lock_guard lock(mutex);
            for (std::size_t k = 0; k < tally.failures.size() && k < options.show; ++k)
                std::printf("failure %s\n", tally.failures[k].c_str());
            std::printf(
                "row=%s asked=%llu done=%llu nothing=%llu refused=%llu unplaceable=%llu checks=%llu volume_off=%.3g\n",
                tally.name.c_str(), ull(tally.asked), ull(tally.done), ull(tally.nothing), ull(tally.refused),
                ull(tally.unplaceable), ull(tally.checks), tally.worst);
            std::fflush(stdout);
            failed += tally.failures.size();
            total.asked += tally.asked;
            total.done += tally.done;
            total.nothing += tally.nothing;
            total.refused += tally.refused;
            total.unplaceable += tally.unplaceable;
            total.checks += tally.checks;
            total.worst = std::fmax(total.worst, tally.worst);
        }
    };
    std::vector<std::thread> threads;
    for (int k = 0; k < options.threads; ++k) threads.emplace_back(work);
    for (std::thread& thread : threads) thread.join();
    const bool pass = failed == 0 && total.done > total.asked / 2 && total.checks > 0;
    std::printf(
        "claim=long_%s family=total count=%llu seed=%llu failed=%llu asked=%llu done=%llu nothing=%llu refused=%llu "
        "unplaceable=%llu checks=%llu volume_off=%.3g result=%s\n",
        what.c_str(), ull(options.count), ull(options.seed), ull(failed), ull(total.asked), ull(total.done),
        ull(total.nothing), ull(total.refused), ull(total.unplaceable), ull(total.checks), total.worst,
        pass ? "pass" : "fail");
    return pass ? EXIT_SUCCESS : EXIT_FAILURE;
}
