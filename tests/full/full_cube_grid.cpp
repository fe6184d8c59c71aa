// SPDX-License-Identifier: MIT
// Grids of 10 x 10 x 10 cubes filled one by one and carved again: ordered and in three random orders, of edges of 0.25,
// 1 and 64 m. Prints a line a grid and one claim.
//
//   full_cube_grid [--count 12 (grids)] [--seed 1] [--threads 2] [--show 3 (of each grid)] [--side 10] [--from 0]
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "tests/full/options.h"
#include "tests/reference/judge_cube_grid.h"
#include "tests/reference/judge_cut.h"

int main(int count, char** words) {
    using namespace firma;
    using ull = unsigned long long;
    constexpr double kEdges[] = {0.25, 1, 64};
    full::Options options;
    options.count = 12;
    std::uint64_t side = 10, from = 0;
    if (!full::read_options(count, words, options, {{"--side", &side}, {"--from", &from}})) {
        std::fprintf(stderr, "full_cube_grid [--count N] [--seed N] [--threads N] [--show N] [--side N] [--from N]\n");
        return 2;
    }
    reference::report_contradictions();
    std::mutex mutex;
    std::uint64_t next = from, failed = 0;
    reference::CubeGridVerdict total;
    const auto work = [&] {
        for (;;) {
            std::uint64_t number = 0;
            {
                const std::lock_guard lock(mutex);
                if (next == from + options.count) return;
                number = next++;
            }
            reference::CubeGrid grid{int(side), kEdges[number % 3], 0};
            // The ordered one, then random ones.
            if (number / 3 > 0) grid.order = options.seed * 1000 + number / 3;
            const reference::CubeGridVerdict verdict = reference::judge_cube_grid(grid);
            const std::lock_guard lock(mutex);
            for (std::size_t k = 0; k < verdict.failures.size() && k < options.show; ++k)
                std::printf("failure number=%llu %s\n", ull(number), verdict.failures[k].c_str());
            std::printf("grid number=%llu edge=%g order=%llu edits=%llu refused=%llu faces_full=%zu %s\n", ull(number),
                        grid.edge, ull(grid.order), ull(verdict.edits), ull(verdict.refused), verdict.faces_full,
                        verdict.failures.empty() ? "pass" : "fail");
            std::fflush(stdout);
            failed += !verdict.failures.empty();
            total.edits += verdict.edits;
            total.refused += verdict.refused;
        }
    };
    std::vector<std::thread> threads;
    for (int k = 0; k < options.threads; ++k) threads.emplace_back(work);
    for (std::thread& thread : threads) thread.join();
    const bool pass = failed == 0 && options.count > 0;
    std::printf("claim=cube_grid family=total count=%llu seed=%llu failed=%llu edits=%llu refused=%llu result=%s\n",
                ull(options.count), ull(options.seed), ull(failed), ull(total.edits), ull(total.refused),
                pass ? "pass" : "fail");
    return pass ? EXIT_SUCCESS : EXIT_FAILURE;
}
