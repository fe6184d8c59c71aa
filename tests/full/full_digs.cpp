// SPDX-License-Identifier: MIT
// Blocks dug out and filled in again: by boxes on a lattice, by all kinds of cutters. Prints one claim.
//
//   full_digs --what lattice|mixed --count 2000 (digs) --seed 1 [--threads 2] [--show 3]
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "tests/full/options.h"
#include "tests/reference/judge_cut.h"
#include "tests/reference/judge_digs.h"

int main(int count, char** words) {
    using namespace firma;
    using ull = unsigned long long;
    full::Options options;
    options.count = 2000;
    std::string what;
    if (!full::read_options(count, words, options, {{"--what", nullptr, &what}}) ||
        (what != "lattice" && what != "mixed")) {
        std::fprintf(stderr, "full_digs --what lattice|mixed [--count N] [--seed N] [--threads N] [--show N]\n");
        return 2;
    }
    reference::report_contradictions();
    std::mutex mutex;
    std::atomic<std::uint64_t> next = 0;
    std::uint64_t failed = 0;
    reference::DigVerdict total;
    const auto work = [&] {
        for (std::uint64_t number = next++; number < options.count; number = next++) {
            const std::uint64_t seed = options.seed << 32 | number;
            const reference::DigVerdict verdict =
                what == "lattice" ? reference::judge_lattice_dig(seed) : reference::judge_mixed_dig(seed);
            const std::lock_guard lock(mutex);
            for (const std::string& failure : verdict.failures)
                if (failed < options.show) std::printf("failure number=%llu %s\n", ull(number), failure.c_str());
            failed += !verdict.failures.empty();
            total.edits += verdict.edits;
            total.done += verdict.done;
            total.nothing += verdict.nothing;
            total.unplaceable += verdict.unplaceable;
        }
    };
    std::vector<std::thread> threads;
    for (int k = 0; k < options.threads; ++k) threads.emplace_back(work);
    for (std::thread& thread : threads) thread.join();
    const bool pass = failed == 0 && total.done > 10 * options.count;
    std::printf(
        "claim=%s_digs family=total count=%llu seed=%llu failed=%llu edits=%llu done=%llu nothing=%llu "
        "unplaceable=%llu "
        "result=%s\n",
        what.c_str(), ull(options.count), ull(options.seed), ull(failed), ull(total.edits), ull(total.done),
        ull(total.nothing), ull(total.unplaceable), pass ? "pass" : "fail");
    return pass ? EXIT_SUCCESS : EXIT_FAILURE;
}
