// SPDX-License-Identifier: MIT
// Runs seeded cases of families of cuts on threads, judged one by one, until enough cuts are done; prints a claim a
// family and one in total.
//
// Counted are the cuts that were done; those that met nothing or were refused are judged too, and told beside.
//
// The work is a list of cases, (case, family) in that order, each seeded by itself: case k is the same whatever ran
// before it.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "tests/full/options.h"
#include "tests/reference/judge_cut.h"

namespace firma::full {

struct FamilyOptions : Options {
    std::uint64_t from = 0, to = ~0ull;  ///< cases
    std::string family;                  ///< one alone
    std::string level = FIRMA_ROOT "/levels/first.obj";

    std::vector<ExtraOption> words() {
        return {{"--from", &from}, {"--to", &to}, {"--family", nullptr, &family}, {"--level", nullptr, &level}};
    }
};

/// What a program asks of its cuts together.
struct FamilyClaim {
    std::string name;
    /// Of all cuts asked for, at most so large a share may be refused though the cutter can be placed ...
    double most_refused = 0;
    /// ... and so large a share for what the library is to blame for: degenerate position, a contradiction.
    double most_blamed = 0;
};

struct JudgedFamily {
    std::string name;
    std::function<reference::CutTally(std::uint64_t seed, std::uint64_t index)> judge;
};

/// Hands out cases until enough cuts have been done, and adds up.
class FamilyRun {
public:
    FamilyRun(const FamilyOptions& options, FamilyClaim claim, const std::vector<JudgedFamily>& families)
        : options_(options), claim_(std::move(claim)), next_(options.from) {
        for (const JudgedFamily& family : families)
            if (options.family.empty() || family.name == options.family) families_.push_back(family);
        tallies_.resize(families_.size());
        seconds_.resize(families_.size());
        shown_.resize(families_.size());
    }

    bool empty() const { return families_.empty(); }

    /// @return the program's exit status
    int run() {
        std::vector<std::thread> threads;
        for (int k = 0; k < options_.threads; ++k) threads.emplace_back([this] { work(); });
        for (std::thread& thread : threads) thread.join();
        return report();
    }

private:
    using CutTally = reference::CutTally;
    using ull = unsigned long long;
    /// A run ends, and fails, when this many times the count have been asked for and still too few were done.
    static constexpr std::uint64_t kMostAsked = 8;

    static bool within(std::uint64_t part, const CutTally& tally, double share) {
        return double(part) <= share * double(tally.cuts);
    }

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
            const CutTally tally = families_[family].judge(options_.seed, number / families_.size());
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
            print(families_[family].name, tally, seconds_[family], tally.failed == 0);
            total.add(tallies_[family]);
            seconds += seconds_[family];
        }
        for (const auto& [reason, some] : total.refusals)
            std::printf("refused %llu times: %s (first %s)\n", ull(some.count), reason.c_str(), some.first.c_str());
        for (const auto& [kind, some] : total.kinds)
            std::printf("failed %llu times: %s (first %s)\n", ull(some.count), kind.c_str(), some.first.c_str());
        // A family alone may be all about what is refused.
        const bool all = options_.family.empty();
        const bool few_refused = !all || within(total.refused_in_place(), total, claim_.most_refused);
        const bool few_blamed = !all || within(total.blamed, total, claim_.most_blamed);
        if (!few_refused) std::printf("failure: too many cuts refused whose cutter can be placed\n");
        if (!few_blamed) std::printf("failure: too many cuts refused that the library is to blame for\n");
        const bool enough = options_.to != ~0ull || total.done >= options_.count;
        if (!enough) std::printf("failure: too few cuts done of those asked for\n");
        const bool pass = total.failed == 0 && total.done > 0 && few_refused && few_blamed && enough;
        print("total", total, seconds, pass);
        return pass ? EXIT_SUCCESS : EXIT_FAILURE;
    }

    void print(const std::string& family, const CutTally& tally, double seconds, bool pass) const {
        std::printf(
            "claim=%s family=%s count=%llu seed=%llu asked=%llu failed=%llu nothing=%llu refused=%llu "
            "unplaceable=%llu blamed=%llu sliced=%llu commuted=%llu reseamed=%llu "
            "replayed=%llu points=%llu rays=%llu casts=%llu shared_edges=%llu ",
            claim_.name.c_str(), family.c_str(), ull(tally.done), ull(options_.seed), ull(tally.cuts),
            ull(tally.failed), ull(tally.nothing), ull(tally.refused), ull(tally.unplaceable), ull(tally.blamed),
            ull(tally.sliced), ull(tally.commuted), ull(tally.reseamed), ull(tally.replayed), ull(tally.points),
            ull(tally.rays), ull(tally.casts), ull(tally.shared_edges));
        if (tally.again + tally.history_points > 0)
            std::printf("again=%llu reversed=%llu grown=%llu history_points=%llu ", ull(tally.again),
                        ull(tally.reversed), ull(tally.grown), ull(tally.history_points));
        std::printf("ms_a_cut=%.3f judged_a_second=%.1f result=%s\n",
                    1e3 * tally.carve_seconds / double(std::max<std::uint64_t>(tally.cuts, 1)),
                    double(tally.cuts) / seconds, pass ? "pass" : "fail");
    }

    const FamilyOptions options_;
    const FamilyClaim claim_;
    std::vector<JudgedFamily> families_;
    std::mutex mutex_;
    std::uint64_t next_, done_ = 0, asked_ = 0;
    std::vector<CutTally> tallies_;
    std::vector<double> seconds_;
    std::vector<std::size_t> shown_;
};

}  // namespace firma::full
