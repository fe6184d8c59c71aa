// SPDX-License-Identifier: MIT
// Casts and rays through worlds that were cut a thousand times: judged by the exact oracle, and none may escape
// or get behind a face. Prints one claim.
//
//   full_carved_casts --what casts|rays --count 1000000 --seed 1 [--threads 2] [--cuts 1000] [--show 3]
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "tests/full/options.h"
#include "tests/reference/judge_carved_casts.h"
#include "tests/reference/world_facets.h"

namespace {

using namespace firma;
using ull = unsigned long long;

struct Options : full::Options {
    std::uint64_t cuts = 1000;
    std::string what = "casts";
};

/// Our level, its carving spread and in one corner: rock outside, so that no ray may get out.
std::vector<World> worlds(const Options& options) {
    const Level ours = read_level(FIRMA_ROOT "/levels/first.obj").value();
    std::vector<World> made;
    for (const scenes::CutFamily& family : scenes::cut_families()) {
        if (family.name != "our_level_spread" && family.name != "our_level_corner") continue;
        made.push_back(reference::carved_world(family, options.seed, options.cuts, ours));
        std::printf("world family=%s cuts=%llu faces=%zu version=%llu\n", std::string(family.name).c_str(),
                    ull(options.cuts), made.back().face_count(), ull(made.back().version()));
        std::fflush(stdout);
    }
    return made;
}

/// Calls work(chunk, rng) on threads until all chunks are done.
template <class Work>
void in_chunks(const Options& options, std::uint64_t chunks, const Work& work) {
    std::uint64_t next = 0;
    std::mutex mutex;
    const auto run = [&] {
        for (;;) {
            std::uint64_t chunk = 0;
            {
                const std::lock_guard lock(mutex);
                if (next == chunks) return;
                chunk = next++;
            }
            scenes::Rng rng(options.seed * 0x9E3779B97F4A7C15ull ^ (chunk + 1) * 0xD1B54A32D192ED03ull);
            work(chunk, rng);
        }
    };
    std::vector<std::thread> threads;
    for (int k = 0; k < options.threads; ++k) threads.emplace_back(run);
    for (std::thread& thread : threads) thread.join();
}

int judge_casts(const Options& options) {
    constexpr int kCastsAChunk = 250;
    const std::vector<World> all = worlds(options);
    reference::Tally total;
    std::mutex mutex;
    in_chunks(options, (options.count + kCastsAChunk - 1) / kCastsAChunk, [&](std::uint64_t chunk, scenes::Rng& rng) {
        const double size = 0.5 + 3 * rng.uniform();
        const reference::Tally tally = reference::judge_casts_at(all[chunk % all.size()], rng, kCastsAChunk, size);
        const std::lock_guard lock(mutex);
        for (const std::string& failure : tally.failures)
            if (total.failures.size() < options.show)
                std::printf("failure chunk=%llu seed=%llu\n%s\n", ull(chunk), ull(options.seed), failure.c_str());
        total.add(tally);
    });
    std::printf(
        "claim=carved_casts family=total count=%llu seed=%llu cuts=%llu errors=%llu touched=%llu excused=%llu "
        "result=%s\n",
        ull(total.casts), ull(options.seed), ull(options.cuts), ull(total.errors()), ull(total.touched),
        ull(total.excused), total.errors() == 0 ? "pass" : "fail");
    return total.errors() == 0 && total.casts > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

int shoot_rays(const Options& options) {
    constexpr std::uint64_t kRaysAChunk = 20000;
    const std::vector<World> all = worlds(options);
    reference::RayTally total;
    std::mutex mutex;
    in_chunks(options, (options.count + kRaysAChunk - 1) / kRaysAChunk, [&](std::uint64_t chunk, scenes::Rng& rng) {
        reference::RayTally tally;
        reference::shoot_from_air(all[chunk % all.size()], rng, kRaysAChunk, tally);
        const std::lock_guard lock(mutex);
        if (!tally.first_failure.empty())
            std::printf("failure chunk=%llu seed=%llu %s\n", ull(chunk), ull(options.seed),
                        tally.first_failure.c_str());
        total.rays += tally.rays;
        total.lost += tally.lost;
        total.at_edges += tally.at_edges;
    });
    std::printf("claim=carved_rays family=total count=%llu seed=%llu cuts=%llu lost=%llu at_edges=%llu result=%s\n",
                ull(total.rays), ull(options.seed), ull(options.cuts), ull(total.lost), ull(total.at_edges),
                total.lost == 0 ? "pass" : "fail");
    return total.lost == 0 && total.rays > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace

int main(int count, char** words) {
    Options options;
    options.count = 1000000;
    const bool read =
        full::read_options(count, words, options, {{"--cuts", &options.cuts}, {"--what", nullptr, &options.what}});
    if (!read || (options.what != "rays" && options.what != "casts")) {
        std::fprintf(
            stderr, "full_carved_casts --what casts|rays [--count N] [--seed N] [--threads N] [--cuts N] [--show N]\n");
        return 2;
    }
    return options.what == "rays" ? shoot_rays(options) : judge_casts(options);
}
