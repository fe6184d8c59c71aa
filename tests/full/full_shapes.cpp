// SPDX-License-Identifier: MIT
// A million capsules and more, or a million boxes and hulls, each against one polygon and judged by the exact oracle.
// Prints a claim a family and one in total.
//
//   full_shapes --what capsules|hulls --count 1000000 --seed 1 [--threads 2] [--show 3]
//
// A chunk is some casts of one family, seeded by itself, so that the casts do not depend on the threads.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "tests/full/options.h"
#include "tests/reference/judge_shapes.h"

namespace {

using namespace firma;
using reference::ShapeFamily;
using reference::ShapeTally;

struct Options : full::Options {
    std::string what = "capsules";
};

constexpr std::uint64_t kCastsAChunk = 500;

class Run {
public:
    Run(const Options& options, std::span<const ShapeFamily> families)
        : options_(options), families_(families), tallies_(families.size()) {
        const std::uint64_t round = kCastsAChunk * families.size();
        chunks_ = (options.count + round - 1) / round * families.size();
    }

    void work() {
        for (;;) {
            std::uint64_t chunk = 0;
            {
                const std::lock_guard lock(mutex_);
                if (next_ >= chunks_) return;
                chunk = next_++;
            }
            const std::size_t family = chunk % families_.size();
            const std::uint64_t seed = options_.seed * 1'000'003 + chunk / families_.size();
            const ShapeTally tally = judge_shapes(families_[family], seed, kCastsAChunk);
            const std::lock_guard lock(mutex_);
            finish(chunk, family, tally);
        }
    }

    int report() const {
        ShapeTally total;
        for (std::size_t family = 0; family < families_.size(); ++family) {
            claim(families_[family].name, tallies_[family]);
            total.add(tallies_[family]);
        }
        claim("total", total);
        return total.wrong == 0 && total.casts > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
    }

private:
    void finish(std::uint64_t chunk, std::size_t family, const ShapeTally& tally) {
        if (tally.wrong > 0 && shown_++ < options_.show)
            std::printf("failure family=%s chunk=%llu seed=%llu\n%s\n", families_[family].name,
                        static_cast<unsigned long long>(chunk), static_cast<unsigned long long>(options_.seed),
                        tally.first_failure.c_str());
        tallies_[family].add(tally);
        const auto now = std::chrono::steady_clock::now();
        if (now - last_print_ < std::chrono::seconds(5)) return;
        last_print_ = now;
        std::printf("progress chunks=%llu of=%llu\n", static_cast<unsigned long long>(next_),
                    static_cast<unsigned long long>(chunks_));
        std::fflush(stdout);
    }

    void claim(const char* family, const ShapeTally& tally) const {
        const auto number = [](std::uint64_t x) { return static_cast<unsigned long long>(x); };
        std::printf(
            "claim=%s_vs_twin family=%s count=%llu seed=%llu wrong=%llu hits=%llu overlaps=%llu misses=%llu "
            "precise=%llu excused=%llu result=%s\n",
            options_.what.c_str(), family, number(tally.casts), number(options_.seed), number(tally.wrong),
            number(tally.hits), number(tally.overlaps), number(tally.misses), number(tally.precise),
            number(tally.excused), tally.wrong == 0 ? "pass" : "fail");
    }

    const Options options_;
    const std::span<const ShapeFamily> families_;
    std::mutex mutex_;
    std::uint64_t next_ = 0, chunks_ = 0;
    std::vector<ShapeTally> tallies_;
    std::size_t shown_ = 0;
    std::chrono::steady_clock::time_point last_print_ = std::chrono::steady_clock::now();
};

}  // namespace

int main(int count, char** words) {
    Options options;
    options.count = 1'000'000;
    const bool read = full::read_options(count, words, options, {{"--what", nullptr, &options.what}});
    if (!read || (options.what != "capsules" && options.what != "hulls")) {
        std::fprintf(stderr, "full_shapes [--what capsules|hulls] [--count N] [--seed N] [--threads N] [--show N]\n");
        return 2;
    }
    Run run(options, options.what == "hulls" ? reference::hull_families() : reference::capsule_families());
    std::vector<std::thread> threads;
    for (int k = 0; k < options.threads; ++k) threads.emplace_back([&] { run.work(); });
    for (std::thread& thread : threads) thread.join();
    return run.report();
}
