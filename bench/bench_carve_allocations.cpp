// SPDX-License-Identifier: MIT
// What a crater takes from the general allocator, and whether taking or giving back ever stalls: every operator new and
// delete of an edit, timed. The pool takes its slabs by operator new, so they are among them.
//
// A program of its own, as the clock is read twice a call: times of whole edits are bench_carve's.
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <span>
#include <string>
#include <vector>

#include "support/craters.h"
#include "support/race.h"
#include "support/settings.h"
#include "support/table.h"

namespace firma::bench {
namespace {

/// What went on between two readings, on this thread.
struct Tally {
    std::size_t taken = 0, bytes = 0, largest = 0;
    std::size_t given_back = 0;
    std::int64_t longest = 0, total = 0;  ///< nanoseconds of processor time, in calls of either kind
};

constinit thread_local Tally tally;
constinit thread_local bool counting = false;
std::int64_t clock_cost = 0;  ///< of a pair of readings, taken off each call

/// Processor time: what other programs do meanwhile is not in it.
std::int64_t thread_nanoseconds() {
    timespec now;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return std::int64_t(now.tv_sec) * 1000000000 + now.tv_nsec;
}

void add_time(std::int64_t start) {
    const std::int64_t took = std::max<std::int64_t>(thread_nanoseconds() - start - clock_cost, 0);
    tally.longest = std::max(tally.longest, took);
    tally.total += took;
}

void* take(std::size_t bytes) {
    if (!counting) return std::malloc(bytes);
    const std::int64_t start = thread_nanoseconds();
    void* memory = std::malloc(bytes);
    add_time(start);
    ++tally.taken;
    tally.bytes += bytes;
    tally.largest = std::max(tally.largest, bytes);
    return memory;
}

void give_back(void* memory) noexcept {
    if (!counting) return std::free(memory);
    const std::int64_t start = thread_nanoseconds();
    std::free(memory);
    add_time(start);
    ++tally.given_back;
}

/// The usual cost of reading the clock twice in a row.
std::int64_t measure_clock() {
    std::vector<double> pairs(10001);
    for (double& pair : pairs) {
        const std::int64_t start = thread_nanoseconds();
        pair = double(thread_nanoseconds() - start);
    }
    return std::int64_t(median(pairs));
}

/// Nanoseconds that the first touch of a page costs: memory fresh from the system is filled in then, not when it is
/// taken.
double measure_fault() {
    constexpr std::size_t kPage = 4096, kPages = 16384;
    void* memory = mmap(nullptr, kPages * kPage, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) return 0;
    madvise(memory, kPages * kPage, MADV_NOHUGEPAGE);
    const std::int64_t start = thread_nanoseconds();
    for (std::size_t k = 0; k < kPages; ++k) static_cast<volatile char*>(memory)[k * kPage] = 1;
    const double each = double(thread_nanoseconds() - start) / kPages;
    munmap(memory, kPages * kPage);
    return each;
}

std::size_t page_faults() {
    rusage usage;
    getrusage(RUSAGE_THREAD, &usage);
    return std::size_t(usage.ru_minflt);
}

/// One edit in one round.
struct Edit {
    Tally tally;
    std::size_t faults = 0;
    bool cut = false;  ///< it took something
};

constexpr int kRounds = 3;
constexpr std::size_t kMostCuts = 2000;

struct Run {
    std::size_t faces = 0;
    Edit edits[kRounds][kMostCuts];
};

/// With everything: dropping the result and the world before, too.
Edit cut_counted(World& world, const Cutter& cutter, const Pose& pose) {
    Edit edit;
    const std::size_t faults = page_faults();
    tally = {};
    counting = true;
    {
        CarveResult result = carve(world, cutter, pose);
        world = std::move(result.world);
        edit.cut = result.done();
    }
    counting = false;
    edit.tally = tally;
    edit.faults = page_faults() - faults;
    return edit;
}

constexpr CraterPlaces kPlaces[] = {CraterPlaces::kSpread, CraterPlaces::kCorner};

/// @param runs  a spread one and one in a corner for each size
void cut_all(const std::vector<int>& sizes, std::size_t cuts, int round, std::span<Run> runs) {
    clock_cost = measure_clock();
    const Cutter cutter = crater();
    std::size_t next = 0;
    for (const int rooms : sizes) {
        const World before = carvable_world(crater_level(rooms));
        for (const CraterPlaces places : kPlaces) {
            Run& run = runs[next++];
            run.faces = before.face_count();
            World world = before;
            for (std::size_t k = 0; k < cuts; ++k)
                run.edits[round][k] = cut_counted(world, cutter, crater_pose(rooms, places, k));
        }
    }
}

/// Each round in a process of its own: all make the same calls in the same order, from an empty heap and an empty pool.
/// So what a call of ours costs, it costs in every round; what shows in one is the machine's.
bool cut_in_a_process(const std::vector<int>& sizes, std::size_t cuts, int round, std::span<Run> runs) {
    const pid_t child = fork();
    if (child < 0) return false;
    if (child == 0) {
        cut_all(sizes, cuts, round, runs);
        _exit(0);
    }
    int status = 0;
    return waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/// Of each edit the least or the most of all rounds.
template <class Of>
std::vector<double> each(const Run& run, std::size_t cuts, int rounds, bool most, const Of& of, bool also_air = true) {
    std::vector<double> values;
    for (std::size_t k = 0; k < cuts; ++k) {
        if (!also_air && !run.edits[0][k].cut) continue;
        double value = double(of(run.edits[0][k]));
        for (int round = 1; round < rounds; ++round) {
            const double other = double(of(run.edits[round][k]));
            value = most ? std::max(value, other) : std::min(value, other);
        }
        values.push_back(value);
    }
    return values;
}

bool report(std::span<const Run> runs, std::size_t cuts, int rounds, double fault, const std::string& csv) {
    Table table("carve_allocations",
                {"triangles", "craters", "edits", "taken an edit, median", "most", "KB an edit, median", "KB most",
                 "largest KB", "longest call us", "in any one round", "all calls of an edit us, median", "most us",
                 "most in any one round", "page faults, most", "with page faults, most us"});
    for (std::size_t k = 0; k < runs.size(); ++k) {
        const auto always = [&](const auto& of) { return each(runs[k], cuts, rounds, false, of); };
        const auto usual = [&](const auto& of) {
            return number(median(each(runs[k], cuts, rounds, false, of, false)));
        };
        const auto ever = [&](const auto& of) { return each(runs[k], cuts, rounds, true, of); };
        const auto taken = [](const Edit& e) { return e.tally.taken; };
        const auto bytes = [](const Edit& e) { return double(e.tally.bytes) / 1e3; };
        const auto largest = [](const Edit& e) { return double(e.tally.largest) / 1e3; };
        const auto longest = [](const Edit& e) { return double(e.tally.longest) / 1e3; };
        const auto total = [](const Edit& e) { return double(e.tally.total) / 1e3; };
        const auto faults = [](const Edit& e) { return e.faults; };
        const auto all = [&](const Edit& e) { return total(e) + double(e.faults) * fault / 1e3; };
        table.add({count(runs[k].faces), kPlaces[k % 2] == CraterPlaces::kCorner ? "in one corner" : "spread",
                   count(cuts), usual(taken), number(quantile(always(taken), 1)), usual(bytes),
                   number(quantile(always(bytes), 1)), number(quantile(always(largest), 1)),
                   number(quantile(always(longest), 1)), number(quantile(ever(longest), 1)), usual(total),
                   number(quantile(always(total), 1)), number(quantile(ever(total), 1)),
                   number(quantile(always(faults), 1)), number(quantile(always(all), 1))});
    }
    return table.finish(csv);
}

bool report_clocks(int rounds, double fault, const std::string& csv) {
    Table table("carve_allocations_clocks",
                {"rounds", "taken off each call for the clock, ns", "first touch of a page, ns"});
    table.add({count(std::size_t(rounds)), number(double(measure_clock())), number(fault)});
    return table.finish(csv);
}

/// All rounds did the same work.
bool same_calls(std::span<const Run> runs, std::size_t cuts, int rounds) {
    for (const Run& run : runs)
        for (std::size_t k = 0; k < cuts; ++k)
            for (int round = 1; round < rounds; ++round)
                if (run.edits[round][k].tally.taken != run.edits[0][k].tally.taken ||
                    run.edits[round][k].tally.bytes != run.edits[0][k].tally.bytes) {
                    std::fprintf(stderr, "edit %zu took other memory in round %d\n", k, round);
                    return false;
                }
    return true;
}

int measure(const Settings& settings) {
    std::vector<int> sizes{2, 6, 20};
    if (settings.quick) sizes = {1};
    if (settings.rest == "huge") sizes.push_back(63);
    const std::size_t cuts = settings.quick ? 40 : kMostCuts;
    const int rounds = settings.quick ? 2 : kRounds;
    const std::size_t count_of_runs = 2 * sizes.size();
    void* shared =
        mmap(nullptr, count_of_runs * sizeof(Run), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (shared == MAP_FAILED) return 1;
    const std::span<Run> runs(static_cast<Run*>(shared), count_of_runs);
    for (Run& run : runs) new (&run) Run;
    for (int round = 0; round < rounds; ++round)
        if (!cut_in_a_process(sizes, cuts, round, runs)) return 1;
    const double fault = measure_fault();
    bool fine = same_calls(runs, cuts, rounds);
    fine &= report(runs, cuts, rounds, fault, settings.csv);
    fine &= report_clocks(rounds, fault, settings.csv);
    return fine ? 0 : 1;
}

}  // namespace

void* counted_take(std::size_t bytes) {
    void* memory = take(bytes > 0 ? bytes : 1);
    if (!memory) throw std::bad_alloc();
    return memory;
}

void counted_give_back(void* memory) noexcept {
    give_back(memory);
}

}  // namespace firma::bench

// The whole program's, arrays and sized forms too: the library's defaults of those call these.
void* operator new(std::size_t bytes) {
    return firma::bench::counted_take(bytes);
}
void operator delete(void* memory) noexcept {
    firma::bench::counted_give_back(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    firma::bench::counted_give_back(memory);
}

int main(int argc, char** argv) {
    using namespace firma::bench;
    return measure(
        read_settings(argc, argv, "What a crater takes from the general allocator, and how long that takes."));
}
