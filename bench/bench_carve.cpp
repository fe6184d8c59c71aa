// SPDX-License-Identifier: MIT
// What a crater costs in levels of 10 thousand to 10 million triangles, spread over the level and all in one corner:
// time by phase, the first cuts against the last, memory. `bench_carve huge` has the largest level too (2.6 GB).
#include <sys/resource.h>

#include <algorithm>
#include <cstdio>
#include <memory>

#include "firma/memory.h"
#include "support/craters.h"
#include "support/race.h"
#include "support/settings.h"
#include "support/table.h"

namespace firma::bench {
namespace {

constexpr std::size_t kTurn = 20;     // cuts of one run before the next run takes over
constexpr std::size_t kBucket = 100;  // cuts that the curve takes together

/// One level and all the craters made in it.
struct Run {
    std::string name;
    int rooms = 1;
    CraterPlaces places = CraterPlaces::kSpread;
    World world;
    std::size_t faces = 0, bytes = 0;  ///< before the first cut
    std::vector<CutCost> costs;
    std::vector<double> added;  ///< bytes that one more version holds, for a few cuts

    /// Of the cuts that took something: in one corner, craters after the first few hundred often meet only air.
    template <class Of>
    std::vector<double> each(const Of& of, std::size_t from = 0, std::size_t to = ~std::size_t(0)) const {
        std::vector<double> values;
        for (std::size_t k = from; k < std::min(to, costs.size()); ++k)
            if (costs[k].status == CarveStatus::kDone) values.push_back(of(costs[k]));
        return values;
    }
    std::vector<double> cpu(std::size_t from = 0, std::size_t to = ~std::size_t(0)) const {
        return each([](const CutCost& cost) { return cost.cpu; }, from, to);
    }
    template <class Of>
    double middle(const Of& of) const {
        return median(each(of));
    }
};

void cut_some(Run& run, const Cutter& cutter, std::size_t count, bool weigh) {
    for (std::size_t k = 0; k < count; ++k) {
        const Pose pose = crater_pose(run.rooms, run.places, run.costs.size());
        const World before = weigh && k == 0 ? run.world : World();
        run.costs.push_back(cut_crater(run.world, cutter, pose));
        if (weigh && k == 0) {
            const World both[] = {before, run.world};
            if (run.costs.back().status == CarveStatus::kDone)
                run.added.push_back(double(memory_used(both)) - double(memory_used(before)));
        }
    }
}

bool report_growth(const std::vector<std::unique_ptr<Run>>& runs, const std::string& csv) {
    Table table("carve_growth",
                {"triangles",   "craters",       "cuts",           "met only air",  "refused",     "median ms",
                 "p99 ms",      "worst ms",      "to 10k",         "wall ms",       "wall p99 ms", "first 100 ms",
                 "last 100 ms", "last to first", "first fifth ms", "last fifth ms", "retries",     "faces looked at",
                 "faces new",   "facets now"});
    for (const auto& run : runs) {
        const std::size_t cuts = run->costs.size(), some = std::min<std::size_t>(kBucket, cuts / 2);
        const std::size_t fifth = cuts / 5;
        const std::vector<double> wall = run->each([](const CutCost& cost) { return cost.wall; });
        std::size_t refused = 0, nothing = 0;
        int retries = 0;
        for (const CutCost& cost : run->costs) {
            nothing += cost.status == CarveStatus::kNothing;
            refused += cost.status == CarveStatus::kRefused;
            retries += cost.report.retries;
        }
        const double all = median(run->cpu()), first = median(run->cpu(0, some)), last = median(run->cpu(cuts - some));
        const Run& small = *runs[run->places == CraterPlaces::kCorner];
        table.add({count(run->faces),
                   run->places == CraterPlaces::kCorner ? "in one corner" : "spread",
                   count(cuts),
                   count(nothing),
                   count(refused),
                   number(all),
                   number(quantile(run->cpu(), 0.99)),
                   number(quantile(run->cpu(), 1)),
                   times(all / median(small.cpu())),
                   number(median(wall)),
                   number(quantile(wall, 0.99)),
                   number(first),
                   number(last),
                   times(last / first),
                   number(median(run->cpu(0, fifth))),
                   number(median(run->cpu(cuts - fifth))),
                   count(std::size_t(retries)),
                   number(run->middle([](const CutCost& c) { return double(c.report.candidate_faces); })),
                   number(run->middle([](const CutCost& c) { return double(c.report.faces_added); })),
                   count(run->world.face_count())});
    }
    return table.finish(csv);
}

bool report_phases(const std::vector<std::unique_ptr<Run>>& runs, const std::string& csv) {
    Table table("carve_phases", {"triangles", "craters", "place us", "gather us", "cut us", "label us", "trace us",
                                 "facets us", "tree us", "all phases us", "with dropping us"});
    for (const auto& run : runs) {
        const auto phase = [&](double CarveReport::Times::* which) {
            return number(run->middle([&](const CutCost& c) { return c.report.times.*which; }));
        };
        using T = CarveReport::Times;
        table.add({count(run->faces), run->places == CraterPlaces::kCorner ? "in one corner" : "spread",
                   phase(&T::place), phase(&T::gather), phase(&T::cut), phase(&T::label), phase(&T::trace),
                   phase(&T::facets), phase(&T::tree),
                   number(run->middle([](const CutCost& c) { return c.report.times.total(); })),
                   number(run->middle([](const CutCost& c) { return c.wall * 1e3; }))});
    }
    return table.finish(csv);
}

bool report_memory(const std::vector<std::unique_ptr<Run>>& runs, const std::string& csv) {
    Table table("carve_memory", {"triangles", "craters", "world MB", "bytes a face", "KB a version more, median",
                                 "KB, most", "world MB after all cuts", "bytes a facet then"});
    for (const auto& run : runs) {
        const double after = double(memory_used(run->world));
        table.add({count(run->faces), run->places == CraterPlaces::kCorner ? "in one corner" : "spread",
                   number(double(run->bytes) / 1e6), number(double(run->bytes) / double(run->faces)),
                   number(median(run->added) / 1e3), number(quantile(run->added, 1) / 1e3), number(after / 1e6),
                   number(after / double(run->world.face_count()))});
    }
    return table.finish(csv);
}

bool report_curve(const std::vector<std::unique_ptr<Run>>& runs, const std::string& csv) {
    std::vector<std::string> columns{"cuts"};
    for (const auto& run : runs) columns.push_back(run->name);
    Table table("carve_by_cuts", columns);
    for (std::size_t from = 0; from < runs[0]->costs.size(); from += kBucket) {
        std::vector<std::string> row{count(std::min(from + kBucket, runs[0]->costs.size()))};
        for (const auto& run : runs) row.push_back(number(median(run->cpu(from, from + kBucket))));
        table.add(row);
    }
    return table.finish(csv);
}

/// The slowest of all: what are they, work or a stumble? Page faults and other threads show in the second time only.
bool report_spikes(const std::vector<std::unique_ptr<Run>>& runs, const std::string& csv) {
    Table table("carve_spikes", {"triangles", "craters", "median ms", "p99 ms", "p99.9 ms", "worst ms", "its cut",
                                 "its retries", "its faces looked at", "its faces new", "above 1 ms over median"});
    for (const auto& run : runs) {
        const auto worst = std::max_element(run->costs.begin(), run->costs.end(),
                                            [](const CutCost& a, const CutCost& b) { return a.cpu < b.cpu; });
        const double middle = median(run->cpu());
        const auto slow =
            std::count_if(run->costs.begin(), run->costs.end(), [&](const CutCost& c) { return c.cpu > middle + 1; });
        table.add({count(run->faces), run->places == CraterPlaces::kCorner ? "in one corner" : "spread", number(middle),
                   number(quantile(run->cpu(), 0.99)), number(quantile(run->cpu(), 0.999)), number(worst->cpu),
                   count(std::size_t(worst - run->costs.begin()) + 1), count(std::size_t(worst->report.retries)),
                   count(worst->report.candidate_faces), count(worst->report.faces_added), count(std::size_t(slow))});
    }
    return table.finish(csv);
}

bool report_process(const std::string& csv) {
    rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    Table table("carve_process", {"most memory the process held, MB"});
    table.add({number(double(usage.ru_maxrss) / 1e3)});
    return table.finish(csv);
}

int measure(const Settings& settings) {
    std::vector<int> sizes{2, 6, 20};
    if (settings.quick) sizes = {1, 2};
    if (settings.rest == "huge") sizes.push_back(63);
    const std::size_t cuts = settings.quick ? 40 : 2000;
    std::vector<std::unique_ptr<Run>> runs;
    for (const int rooms : sizes) {
        World world;
        {
            const Level level = crater_level(rooms);
            world = carvable_world(level);
        }
        const std::size_t bytes = memory_used(world);
        for (const CraterPlaces places : {CraterPlaces::kSpread, CraterPlaces::kCorner}) {
            runs.push_back(std::make_unique<Run>());
            Run& run = *runs.back();
            run.rooms = rooms;
            run.places = places;
            run.world = world;  // two histories of one world: they share what neither has touched
            run.faces = world.face_count();
            run.bytes = bytes;
            run.name = count(run.faces) + (places == CraterPlaces::kCorner ? " corner" : " spread");
        }
    }
    const Cutter cutter = crater();
    for (std::size_t done = 0; done < cuts; done += kTurn)
        for (const auto& run : runs) cut_some(*run, cutter, kTurn, done % (5 * kTurn) == 0);

    bool fine = report_growth(runs, settings.csv);
    fine &= report_phases(runs, settings.csv);
    fine &= report_memory(runs, settings.csv);
    fine &= report_curve(runs, settings.csv);
    fine &= report_spikes(runs, settings.csv);
    fine &= report_process(settings.csv);
    return fine ? 0 : 1;
}

}  // namespace
}  // namespace firma::bench

int main(int argc, char** argv) {
    using namespace firma::bench;
    return measure(read_settings(argc, argv, "What a crater costs as levels and the number of craters grow."));
}
