// SPDX-License-Identifier: MIT
// Halls full of pillars and bridges shot at, the loose pieces of each cut beside a flood of all faces. Prints one
// claim.
//
//   full_chunks --count 2000 (halls) --seed 1 [--threads 2] [--show 3]
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <thread>
#include <vector>

#include "tests/full/options.h"
#include "tests/reference/judge_chunks.h"

int main(int count, char** words) {
    using namespace firma;
    using ull = unsigned long long;
    constexpr int kCuts = 100;
    full::Options options;
    options.count = 100;
    if (!full::read_options(count, words, options, {})) {
        std::fprintf(stderr, "full_chunks [--count N] [--seed N] [--threads N] [--show N]\n");
        return 2;
    }
    std::mutex mutex;
    std::atomic<std::uint64_t> next = 0;
    std::uint64_t failed = 0, done = 0, loose = 0;
    const auto work = [&] {
        for (std::uint64_t number = next++; number < options.count; number = next++) {
            const reference::ChunkHallVerdict verdict = reference::judge_chunk_hall(options.seed << 32 | number, kCuts);
            const std::lock_guard lock(mutex);
            if (!verdict.fault.empty() && failed++ < options.show)
                std::printf("failure number=%llu %s\n", ull(number), verdict.fault.c_str());
            done += verdict.done;
            loose += verdict.loose;
        }
    };
    std::vector<std::thread> threads;
    for (int k = 0; k < options.threads; ++k) threads.emplace_back(work);
    for (std::thread& thread : threads) thread.join();
    const bool pass = failed == 0 && loose > 5 * options.count;
    std::printf("claim=chunks family=total count=%llu seed=%llu failed=%llu done=%llu loose=%llu result=%s\n",
                ull(options.count), ull(options.seed), ull(failed), ull(done), ull(loose), pass ? "pass" : "fail");
    return pass ? EXIT_SUCCESS : EXIT_FAILURE;
}
