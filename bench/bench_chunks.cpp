// SPDX-License-Identifier: MIT
// What it costs to look for loose pieces: the same craters twice in turn, without and with, in levels of 10 thousand to
// a million triangles and in the depot.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>

#include "firma/brush_world.h"
#include "firma/chunk.h"
#include "support/craters.h"
#include "support/race.h"
#include "support/settings.h"
#include "support/table.h"

namespace firma::bench {
namespace {

struct History {
    World world;
    std::vector<double> milliseconds;  ///< of cuts that took something
    std::vector<double> search, searched;
    std::size_t chunks = 0, crumbs = 0, refused = 0, looked = 0, loose = 0;

    void cut(const Cutter& cutter, const Pose& pose, const CarveOptions& options) {
        const double before = thread_seconds();
        CarveResult result = carve(world, cutter, pose, options);
        world = std::move(result.world);
        const double spent = (thread_seconds() - before) * 1e3;
        refused += result.status == CarveStatus::kRefused;
        if (!result.done()) return;
        milliseconds.push_back(spent);
        search.push_back(result.report.times.chunks);
        searched.push_back(double(result.report.faces_searched));
        looked += result.report.faces_searched > 0;
        loose += result.report.chunks + result.report.crumbs > 0;
        chunks += result.report.chunks;
        crumbs += result.report.crumbs;
    }
};

double mean(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) sum += value;
    return values.empty() ? 0 : sum / double(values.size());
}

template <class PoseOf>
void measure_level(const std::string& name, const World& level, std::size_t cuts, const PoseOf& pose_of, Table& table) {
    History without, with;
    const double before = thread_seconds();
    with.world = with_anchors(level);
    const double anchors = (thread_seconds() - before) * 1e3;
    without.world = level;
    CarveOptions options;
    options.chunks = ChunkOptions{};
    const Cutter cutter = crater();
    for (std::size_t k = 0; k < cuts; ++k) {
        const Pose pose = pose_of(k);
        if (k % 2) without.cut(cutter, pose, {});
        with.cut(cutter, pose, options);
        if (k % 2 == 0) without.cut(cutter, pose, {});
    }
    const double plain = median(without.milliseconds), all = median(with.milliseconds);
    table.add({name, count(level.face_count()), count(with.milliseconds.size()), number(plain), number(all),
               times(all / plain), number(quantile(without.milliseconds, 0.99)),
               number(quantile(with.milliseconds, 0.99)), number(median(with.search)),
               number(quantile(with.search, 0.99)), number(quantile(with.search, 1)), number(mean(with.searched)),
               number(quantile(with.searched, 1)), percent(double(with.looked) / double(with.milliseconds.size())),
               count(with.loose), count(with.chunks), count(with.crumbs), number(anchors)});
}

int measure(const Settings& settings) {
    Table table("chunks",
                {"level", "faces", "cuts", "without ms", "with ms", "with to without", "without p99 ms", "with p99 ms",
                 "search us", "search p99 us", "search worst us", "faces searched, mean", "most", "cuts that search",
                 "cuts with loose pieces", "chunks", "crumbs", "with_anchors ms"});
    const std::size_t cuts = settings.quick ? 20 : 1000;
    std::vector<int> sizes{2, 6, 20};
    if (settings.quick) sizes = {1};
    for (const int rooms : sizes) {
        const World level = carvable_world(crater_level(rooms));
        for (const CraterPlaces places : {CraterPlaces::kSpread, CraterPlaces::kCorner})
            measure_level(
                places == CraterPlaces::kCorner ? "rooms, in one corner" : "rooms", level, cuts,
                [&](std::size_t k) { return crater_pose(rooms, places, k); }, table);
    }
    const Result<World> depot = read_world(settings.repository + "/levels/depot.map");
    if (!depot) return std::fprintf(stderr, "%s\n", depot.error().text().c_str()), 1;
    const Box bounds = depot.value().bounds();
    const auto shot = [&](std::size_t k) {
        scenes::Rng rng(k + 1);
        Pose pose;
        for (int axis = 0; axis < 3; ++axis) pose.position[axis] = rng.uniform(bounds.low[axis], bounds.high[axis]);
        pose.rotation = random_turn(rng.next());
        pose.scale = rng.uniform(0.4, 1.6);
        return pose;
    };
    measure_level("depot", depot.value(), 2 * cuts, shot, table);
    return table.finish(settings.csv) ? 0 : 1;
}

}  // namespace
}  // namespace firma::bench

int main(int argc, char** argv) {
    using namespace firma::bench;
    return measure(read_settings(argc, argv, "What it costs to look for pieces that craters leave loose."));
}
