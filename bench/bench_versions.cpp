// SPDX-License-Identifier: MIT
// What keeping, dropping, comparing and hashing versions of a world costs.
#include <cstdio>
#include <vector>

#include "firma/memory.h"
#include "firma/versions.h"
#include "support/craters.h"
#include "support/race.h"
#include "support/settings.h"
#include "support/table.h"

namespace firma::bench {
namespace {

/// Microseconds of processor time.
template <class Work>
double timed(const Work& work) {
    const double start = thread_seconds();
    work();
    return (thread_seconds() - start) * 1e6;
}

struct Numbers {
    std::vector<double> copy_ns, undo, drop_old, drop_new, hash, diff_1, diff_10, diff_100;
};

void measure_level(int rooms, const Settings& settings, Table& table) {
    const std::size_t cuts = settings.quick ? 100 : 1000;
    std::vector<World> versions{carvable_world(crater_level(rooms))};
    const Cutter cutter = crater();
    for (std::size_t k = 0; k < cuts; ++k) {
        World next = versions.back();
        cut_crater(next, cutter, crater_pose(rooms, CraterPlaces::kSpread, k));
        versions.push_back(next);
    }
    const double one = double(memory_used(versions.back())), all = double(memory_used(versions));
    Numbers of;
    constexpr int kCopies = 1000;
    std::vector<World> copies(kCopies);
    for (int round = 0; round < settings.rounds; ++round) {
        of.copy_ns.push_back(timed([&] {
                                 for (World& copy : copies) copy = versions.back();
                             }) /
                             kCopies * 1e3);
        of.hash.push_back(timed([&] { keep(hash_world(versions.back())); }));
    }
    copies.clear();
    for (std::size_t k = 0; k + 100 < versions.size(); k += 50)
        for (const auto& [apart, into] :
             {std::pair{1, &of.diff_1}, std::pair{10, &of.diff_10}, std::pair{100, &of.diff_100}})
            into->push_back(timed(
                [&, step = apart] { keep(diff_worlds(versions[k], versions[k + std::size_t(step)]).removed.size()); }));
    // Undo: the newest version goes. History that is forgotten: the oldest.
    const std::size_t half = versions.size() / 2;
    while (versions.size() > half) of.drop_new.push_back(timed([&] { versions.pop_back(); }));
    for (World& version : versions)
        if (&version != &versions.back()) of.drop_old.push_back(timed([&] { version = World(); }));
    table.add({count(carvable_world(crater_level(rooms)).face_count()), count(cuts), number(median(of.copy_ns)),
               number(median(of.drop_new)), number(quantile(of.drop_new, 1)), number(median(of.drop_old)),
               number(quantile(of.drop_old, 1)), number(median(of.hash) / 1e3), number(median(of.diff_1)),
               number(median(of.diff_10)), number(median(of.diff_100)), number(one / 1e6), number(all / 1e6),
               times(all / one), number((all - one) / double(cuts) / 1e3)});
}

int measure(const Settings& settings) {
    Table table("versions",
                {"triangles", "craters", "copy of a world ns", "drop the newest us", "worst us", "drop the oldest us",
                 "worst of those us", "hash_world ms", "diff 1 edit apart us", "diff 10 apart us", "diff 100 apart us",
                 "one version MB", "all versions MB", "all to one", "KB a version kept"});
    for (const int rooms : {2, 6, 20}) {
        if (settings.quick && rooms > 2) break;
        measure_level(rooms, settings, table);
    }
    return table.finish(settings.csv) ? 0 : 1;
}

}  // namespace
}  // namespace firma::bench

int main(int argc, char** argv) {
    using namespace firma::bench;
    return measure(read_settings(argc, argv, "Versions of a world: kept, dropped, compared, hashed."));
}
