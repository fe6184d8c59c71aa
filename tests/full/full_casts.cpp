// SPDX-License-Identifier: MIT
// A million casts and more of every family against the exact oracle. Prints a claim a family and one in total.
//
//   full_casts --count 1000000 --seed 1 [--threads 2] [--from 0] [--to N] [--family NAME] [--show 3 (of each family)]
//              [--kernel NAME]
//
// --kernel: casts by this one of the lanes' kernels (AVX-512, AVX2, SSE4, compiled), or one by one (none); else by the
// best. It must be one that this processor runs.
//
// The work is a list of chunks, (scene, family) in that order, each seeded by itself: chunk k is the same whatever ran
// before it. --from and --to name chunks, to go on after an interruption; a progress line says up to where all are
// done.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "tests/full/options.h"
#include "tests/reference/judge_scene.h"
#include "world/sweep_lanes.h"

namespace {

using namespace firma;
using reference::Fault;
using reference::Tally;

struct Options : full::Options {
    std::uint64_t from = 0, to = ~0ull;
    std::string family, kernel;
};

/// @return false where there is no such kernel
bool take_kernel(const std::string& name) {
    if (name.empty()) return true;
    if (name == "none") return take_lane_kernel(nullptr), true;
    for (const LaneKernel& kernel : lane_kernels())
        if (name == kernel.name) return take_lane_kernel(&kernel), true;
    return false;
}

/// Hands out chunks until enough casts have been judged, and adds up.
class Run {
public:
    explicit Run(const Options& options) : options_(options), next_(options.from), done_up_to_(options.from) {
        for (const scenes::CastFamily& family : scenes::cast_families())
            if (options.family.empty() || family.name == options.family) families_.push_back(family);
        tallies_.resize(families_.size());
        shown_.resize(families_.size());
    }

    bool empty() const { return families_.empty(); }

    void work() {
        for (;;) {
            std::uint64_t chunk = 0;
            {
                const std::lock_guard lock(mutex_);
                // Whole rounds of families, so that what is run does not depend on which thread was faster.
                if (next_ >= options_.to || (casts_ >= options_.count && next_ % families_.size() == 0)) return;
                chunk = next_++;
            }
            const std::size_t family = chunk % families_.size();
            const Tally tally = reference::judge_family(families_[family], options_.seed, chunk / families_.size());
            const std::lock_guard lock(mutex_);
            finish(chunk, family, tally);
        }
    }

    int report() const {
        Tally total;
        for (std::size_t family = 0; family < families_.size(); ++family) {
            claim(std::string(families_[family].name), tallies_[family]);
            total.add(tallies_[family]);
        }
        claim("total", total);
        return total.errors() == 0 && total.casts > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
    }

private:
    void finish(std::uint64_t chunk, std::size_t family, const Tally& tally) {
        for (const std::string& failure : tally.failures) {
            if (shown_[family]++ >= options_.show) break;
            std::printf("failure family=%s chunk=%llu seed=%llu\n%s\n", std::string(families_[family].name).c_str(),
                        static_cast<unsigned long long>(chunk), static_cast<unsigned long long>(options_.seed),
                        failure.c_str());
        }
        tallies_[family].add(tally);
        casts_ += tally.casts;
        finished_[chunk] = true;
        while (!finished_.empty() && finished_.begin()->first == done_up_to_) {
            finished_.erase(finished_.begin());
            ++done_up_to_;
        }
        const auto now = std::chrono::steady_clock::now();
        if (now - last_print_ < std::chrono::seconds(5)) return;
        last_print_ = now;
        std::uint64_t errors = 0;
        for (const Tally& each : tallies_) errors += each.errors();
        std::printf("progress chunks=%llu casts=%llu of=%llu errors=%llu\n",
                    static_cast<unsigned long long>(done_up_to_), static_cast<unsigned long long>(casts_),
                    static_cast<unsigned long long>(options_.count), static_cast<unsigned long long>(errors));
        std::fflush(stdout);
    }

    void claim(const std::string& family, const Tally& tally) const {
        const auto of = [&](Fault fault) { return static_cast<unsigned long long>(tally.faults[std::size_t(fault)]); };
        std::printf(
            "claim=casts_vs_twin family=%s count=%llu seed=%llu missed=%llu false=%llu late=%llu fields=%llu "
            "early=%llu "
            "fraction=%llu touched=%llu excused=%llu result=%s\n",
            family.c_str(), static_cast<unsigned long long>(tally.casts),
            static_cast<unsigned long long>(options_.seed), of(Fault::kMissed), of(Fault::kFalse), of(Fault::kLate),
            of(Fault::kFields), of(Fault::kEarly), of(Fault::kFraction), static_cast<unsigned long long>(tally.touched),
            static_cast<unsigned long long>(tally.excused), tally.errors() == 0 ? "pass" : "fail");
    }

    const Options options_;
    std::vector<scenes::CastFamily> families_;
    std::mutex mutex_;
    std::uint64_t next_, done_up_to_, casts_ = 0;
    std::map<std::uint64_t, bool> finished_;
    std::vector<Tally> tallies_;
    std::vector<std::size_t> shown_;  // failures, of each family
    std::chrono::steady_clock::time_point last_print_ = std::chrono::steady_clock::now();
};

}  // namespace

int main(int count, char** words) {
    Options options;
    options.count = 1000000;
    if (!full::read_options(count, words, options,
                            {{"--from", &options.from},
                             {"--to", &options.to},
                             {"--family", nullptr, &options.family},
                             {"--kernel", nullptr, &options.kernel}})) {
        std::fprintf(stderr,
                     "full_casts [--count N] [--seed N] [--threads N] [--from CHUNK] [--to CHUNK] [--family NAME] "
                     "[--show N] [--kernel NAME]\n");
        return 2;
    }
    if (!take_kernel(options.kernel)) {
        std::fprintf(stderr, "full_casts: this processor runs no kernel of that name\n");
        return 2;
    }
    Run run(options);
    if (run.empty()) {
        std::fprintf(stderr, "full_casts: no such family\n");
        return 2;
    }
    std::vector<std::thread> threads;
    for (int k = 0; k < options.threads; ++k) threads.emplace_back([&] { run.work(); });
    for (std::thread& thread : threads) thread.join();
    return run.report();
}
