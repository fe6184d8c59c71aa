// SPDX-License-Identifier: MIT
// Boxes on a lattice dug out of blocks and filled in again. Prints one claim.
//
//   full_lattice_digs --count 2000 (digs) --seed 1 [--threads 2] [--show 3]
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <thread>
#include <vector>

#include "tests/full/options.h"
#include "tests/reference/judge_cut.h"
#include "tests/reference/judge_lattice_dig.h"

int main(int count, char** words) {
    using namespace firma;
    using ull = unsigned long long;
    full::Options options;
    options.count = 2000;
    if (!full::read_options(count, words, options, {})) {
        std::fprintf(stderr, "full_lattice_digs [--count N] [--seed N] [--threads N] [--show N]\n");
        return 2;
    }
    reference::report_contradictions();
    std::mutex mutex;
    std::atomic<std::uint64_t> next = 0;
    std::uint64_t failed = 0, edits = 0, nothing = 0;
    const auto work = [&] {
        for (std::uint64_t number = next++; number < options.count; number = next++) {
            const reference::LatticeDigVerdict verdict = reference::judge_lattice_dig(options.seed << 32 | number);
            const std::lock_guard lock(mutex);
            for (const std::string& failure : verdict.failures)
                if (failed < options.show) std::printf("failure number=%llu %s\n", ull(number), failure.c_str());
            failed += !verdict.failures.empty();
            edits += verdict.edits;
            nothing += verdict.nothing;
        }
    };
    std::vector<std::thread> threads;
    for (int k = 0; k < options.threads; ++k) threads.emplace_back(work);
    for (std::thread& thread : threads) thread.join();
    const bool pass = failed == 0 && edits > 10 * options.count;
    std::printf("claim=lattice_digs family=total count=%llu seed=%llu failed=%llu edits=%llu nothing=%llu result=%s\n",
                ull(options.count), ull(options.seed), ull(failed), ull(edits), ull(nothing), pass ? "pass" : "fail");
    return pass ? EXIT_SUCCESS : EXIT_FAILURE;
}
