// SPDX-License-Identifier: MIT
// Ten million rays and small balls from inside closed meshes, aimed at where faces meet: not one may get out.
//
//   full_watertight --count 10000000 --seed 1 [--threads 2] [--from CHUNK] [--to CHUNK] [--show 3]
//
// A chunk is one mesh with its casts, seeded by itself, so that runs add up and go on after an interruption.
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "tests/full/options.h"
#include "tests/reference/escapes.h"

namespace {

using namespace firma;
using reference::EscapeTally;

struct Options : full::Options {
    std::uint64_t from = 0, to = ~0ull;
};

class Run {
public:
    explicit Run(const Options& options) : options_(options), next_(options.from), done_up_to_(options.from) {}

    void work() {
        for (;;) {
            std::uint64_t chunk = 0;
            {
                const std::lock_guard lock(mutex_);
                if (next_ >= options_.to || (next_ - options_.from) * reference::kEscapesAChunk >= options_.count)
                    return;
                chunk = next_++;
            }
            const EscapeTally tally = reference::try_escapes(options_.seed, chunk);
            const std::lock_guard lock(mutex_);
            finish(chunk, tally);
        }
    }

    int report() const {
        EscapeTally total;
        for (int kind = 0; kind < scenes::kMeshKinds; ++kind) {
            claim(scenes::name_of(scenes::MeshKind(kind)), tallies_[std::size_t(kind)]);
            total.add(tallies_[std::size_t(kind)]);
        }
        claim("total", total);
        return total.lost == 0 && total.wrong == 0 && total.casts > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
    }

private:
    void finish(std::uint64_t chunk, const EscapeTally& tally) {
        if (!tally.first_failure.empty() && shown_++ < options_.show)
            std::printf("failure chunk=%llu seed=%llu\n%s\n", static_cast<unsigned long long>(chunk),
                        static_cast<unsigned long long>(options_.seed), tally.first_failure.c_str());
        tallies_[std::size_t(tally.kind)].add(tally);
        finished_[chunk] = true;
        while (!finished_.empty() && finished_.begin()->first == done_up_to_) {
            finished_.erase(finished_.begin());
            ++done_up_to_;
        }
        const auto now = std::chrono::steady_clock::now();
        if (now - last_print_ < std::chrono::seconds(5)) return;
        last_print_ = now;
        EscapeTally total;
        for (const EscapeTally& each : tallies_) total.add(each);
        std::printf("progress chunks=%llu casts=%llu of=%llu lost=%llu\n", static_cast<unsigned long long>(done_up_to_),
                    static_cast<unsigned long long>(total.casts), static_cast<unsigned long long>(options_.count),
                    static_cast<unsigned long long>(total.lost));
        std::fflush(stdout);
    }

    void claim(const std::string& mesh, const EscapeTally& tally) const {
        std::printf("claim=watertight mesh=%s count=%llu seed=%llu lost=%llu judged=%llu wrong=%llu result=%s\n",
                    mesh.c_str(), static_cast<unsigned long long>(tally.casts),
                    static_cast<unsigned long long>(options_.seed), static_cast<unsigned long long>(tally.lost),
                    static_cast<unsigned long long>(tally.judged), static_cast<unsigned long long>(tally.wrong),
                    tally.lost == 0 && tally.wrong == 0 ? "pass" : "fail");
    }

    const Options options_;
    std::mutex mutex_;
    std::uint64_t next_, done_up_to_;
    std::map<std::uint64_t, bool> finished_;
    std::array<EscapeTally, scenes::kMeshKinds> tallies_;
    std::size_t shown_ = 0;
    std::chrono::steady_clock::time_point last_print_ = std::chrono::steady_clock::now();
};

}  // namespace

int main(int count, char** words) {
    Options options;
    options.count = 10000000;
    if (!full::read_options(count, words, options, {{"--from", &options.from}, {"--to", &options.to}})) {
        std::fprintf(stderr,
                     "full_watertight [--count N] [--seed N] [--threads N] [--from CHUNK] [--to CHUNK] [--show N]\n");
        return 2;
    }
    Run run(options);
    std::vector<std::thread> threads;
    for (int k = 0; k < options.threads; ++k) threads.emplace_back([&] { run.work(); });
    for (std::thread& thread : threads) thread.join();
    return run.report();
}
