// SPDX-License-Identifier: MIT
// Thousands of cuts of every family, judged one by one. Prints a claim a family and one in total.
//
//   full_carve --count 20000 --seed 1 [--threads 2] [--from 0] [--to N] [--family NAME] [--level levels/first.obj]
//              [--show 3 (of each family)]
//
// Counted are the cuts that were done; those that met nothing or were refused are judged too, and told beside. Refusals
// must stay few: see kMostRefused.
//
// The work is a list of cases, (case, family) in that order, each seeded by itself: case k is the same whatever ran
// before it.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "tests/full/options.h"
#include "tests/reference/judge_cut.h"

namespace {

using namespace firma;
using reference::CutTally;
using ull = unsigned long long;

/// Of all cuts asked for, at most so large a share may be refused though the cutter can be placed ...
constexpr double kMostRefused = 0.1;
/// ... and so large a share for what the library is to blame for: degenerate position, a contradiction.
constexpr double kMostBlamed = 0.02;
/// A run ends, and fails, when this many times the count have been asked for and still too few were done.
constexpr std::uint64_t kMostAsked = 8;

struct Options : full::Options {
    std::uint64_t from = 0, to = ~0ull;
    std::string family, level = FIRMA_ROOT "/levels/first.obj";
};

bool within(std::uint64_t part, const CutTally& tally, double share) {
    return double(part) <= share * double(tally.cuts);
}

/// Hands out cases until enough cuts have been done, and adds up.
class Run {
public:
    Run(const Options& options, const Level& ours) : options_(options), ours_(ours), next_(options.from) {
        for (const scenes::CutFamily& family : scenes::cut_families())
            if (options.family.empty() || family.name == options.family) families_.push_back(family);
        tallies_.resize(families_.size());
        seconds_.resize(families_.size());
        shown_.resize(families_.size());
    }

    bool empty() const { return families_.empty(); }

    void work() {
        for (;;) {
            std::uint64_t number = 0;
            {
                const std::lock_guard lock(mutex_);
                // Whole rounds of families, so that what is run does not depend on which thread was faster.
                const bool enough = done_ >= options_.count || asked_ / kMostAsked >= options_.count;
                if (next_ >= options_.to || (enough && next_ % families_.size() == 0)) return;
                number = next_++;
            }
            const std::size_t family = number % families_.size();
            const auto start = std::chrono::steady_clock::now();
            const CutTally tally =
                reference::judge_case(families_[family], options_.seed, number / families_.size(), ours_);
            const std::lock_guard lock(mutex_);
            seconds_[family] += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
            for (const std::string& failure : tally.failures)
                if (shown_[family]++ < options_.show)
                    std::printf("failure number=%llu %s\n", ull(number), failure.c_str());
            std::fflush(stdout);
            tallies_[family].add(tally);
            done_ += tally.done;
            asked_ += tally.cuts;
        }
    }

    int report() const {
        CutTally total;
        double seconds = 0;
        for (std::size_t family = 0; family < families_.size(); ++family) {
            const CutTally& tally = tallies_[family];
            claim(std::string(families_[family].name), tally, seconds_[family], tally.failed == 0);
            total.add(tallies_[family]);
            seconds += seconds_[family];
        }
        for (const auto& [reason, some] : total.refusals)
            std::printf("refused %llu times: %s (first %s)\n", ull(some.count), reason.c_str(), some.first.c_str());
        // A family alone may be all about what is refused.
        const bool all = options_.family.empty();
        const bool few_refused = !all || within(total.refused_in_place(), total, kMostRefused);
        const bool few_blamed = !all || within(total.blamed, total, kMostBlamed);
        if (!few_refused) std::printf("failure: too many cuts refused whose cutter can be placed\n");
        if (!few_blamed) std::printf("failure: too many cuts refused that the library is to blame for\n");
        const bool enough = options_.to != ~0ull || total.done >= options_.count;
        if (!enough) std::printf("failure: too few cuts done of those asked for\n");
        const bool pass = total.failed == 0 && total.done > 0 && few_refused && few_blamed && enough;
        claim("total", total, seconds, pass);
        return pass ? EXIT_SUCCESS : EXIT_FAILURE;
    }

private:
    void claim(const std::string& family, const CutTally& tally, double seconds, bool pass) const {
        std::printf(
            "claim=carve_cuts family=%s count=%llu seed=%llu asked=%llu failed=%llu nothing=%llu refused=%llu "
            "unplaceable=%llu blamed=%llu moved=%llu retries=%llu sliced=%llu commuted=%llu reseamed=%llu "
            "replayed=%llu points=%llu rays=%llu casts=%llu shared_edges=%llu ms_a_cut=%.3f judged_a_second=%.1f "
            "result=%s\n",
            family.c_str(), ull(tally.done), ull(options_.seed), ull(tally.cuts), ull(tally.failed), ull(tally.nothing),
            ull(tally.refused), ull(tally.unplaceable), ull(tally.blamed), ull(tally.moved), ull(tally.retries),
            ull(tally.sliced), ull(tally.commuted), ull(tally.reseamed), ull(tally.replayed), ull(tally.points),
            ull(tally.rays), ull(tally.casts), ull(tally.shared_edges),
            1e3 * tally.carve_seconds / double(std::max<std::uint64_t>(tally.cuts, 1)), double(tally.cuts) / seconds,
            pass ? "pass" : "fail");
    }

    const Options options_;
    const Level& ours_;
    std::vector<scenes::CutFamily> families_;
    std::mutex mutex_;
    std::uint64_t next_, done_ = 0, asked_ = 0;
    std::vector<CutTally> tallies_;
    std::vector<double> seconds_;
    std::vector<std::size_t> shown_;
};

}  // namespace

int main(int count, char** words) {
    Options options;
    options.count = 20000;
    if (!full::read_options(count, words, options,
                            {{"--from", &options.from},
                             {"--to", &options.to},
                             {"--family", nullptr, &options.family},
                             {"--level", nullptr, &options.level}})) {
        std::fprintf(stderr,
                     "full_carve [--count N] [--seed N] [--threads N] [--from CASE] [--to CASE] [--family NAME] "
                     "[--level FILE] [--show N]\n");
        return 2;
    }
    const Result<Level> ours = read_level(options.level);
    if (!ours) {
        std::fprintf(stderr, "%s\n", ours.error().text().c_str());
        return 2;
    }
    reference::report_contradictions();
    Run run(options, ours.value());
    if (run.empty()) {
        std::fprintf(stderr, "full_carve: no such family\n");
        return 2;
    }
    std::vector<std::thread> threads;
    for (int k = 0; k < options.threads; ++k) threads.emplace_back([&] { run.work(); });
    for (std::thread& thread : threads) thread.join();
    return run.report();
}
