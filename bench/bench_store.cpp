// SPDX-License-Identifier: MIT
// A reader at a WorldStore while an editor cuts craters and publishes, against the same reader alone: does a cast ever
// wait for a cut? And what publishing costs.
#include <sys/resource.h>

#include <atomic>
#include <chrono>
#include <thread>
#include <vector>

#include "firma/queries.h"
#include "firma/versions.h"
#include "scenes/cast_families.h"
#include "support/craters.h"
#include "support/race.h"
#include "support/settings.h"
#include "support/table.h"

namespace firma::bench {
namespace {

using Clock = std::chrono::steady_clock;

double microseconds_since(Clock::time_point start) {
    return std::chrono::duration<double, std::micro>(Clock::now() - start).count();
}

enum Phase { kAlone, kBeside, kPhases, kPause, kEnd };

/// What a reader saw in one phase, microseconds.
struct Seen {
    std::vector<double> wall, processor;  ///< a cast each
    std::vector<double> current;          ///< a handle taken each, wall
    std::vector<double> undisturbed;      ///< as `wall`, of jobs during which the thread kept its processor
    long gave_way = 0;    ///< times that the thread left the processor of itself, as one that waits for a lock does
    long pushed_off = 0;  ///< times that it was put off it, for another thread's turn
};

/// Moves about the rooms, short and long.
std::vector<scenes::CastQuery> moves_in_rooms(int rooms, std::size_t count) {
    scenes::Rng rng(31);
    std::vector<scenes::CastQuery> moves(count);
    for (scenes::CastQuery& move : moves) {
        const auto a = int(rng.below(std::uint32_t(rooms)));
        const auto b = int(rng.below(std::uint32_t(rooms)));
        move.sphere.centre = floor_of_room(a, b);
        for (int axis = 0; axis < 3; ++axis)
            move.sphere.centre[axis] += axis == 2 ? rng.uniform(0.7, 5.3) : rng.uniform(-5.3, 5.3);
        move.sphere.radius = rng.uniform(0.3, 0.5);
        const Vec3 way = rng.direction();
        move.path = way * rng.uniform(0.1, 8);
    }
    return moves;
}

/// A handle a job, a hundred casts a job, until the end.
void read(const WorldStore& store, const std::vector<scenes::CastQuery>& moves, const std::atomic<int>& phase,
          Seen (&seen)[kPhases]) {
    constexpr std::size_t kCastsAJob = 100;
    double wall[kCastsAJob], processor[kCastsAJob];
    std::size_t next = 0;
    for (int now = phase; now != kEnd; now = phase) {
        if (now == kPause) {
            std::this_thread::sleep_for(std::chrono::microseconds(100));
            continue;
        }
        rusage before, after;
        getrusage(RUSAGE_THREAD, &before);
        const Clock::time_point asked = Clock::now();
        const World world = store.current();
        const double current = microseconds_since(asked);
        for (std::size_t k = 0; k < kCastsAJob; ++k) {
            const scenes::CastQuery& move = moves[next++ % moves.size()];
            const Clock::time_point start = Clock::now();
            const double cpu = thread_seconds();
            keep(cast(world, move.sphere, move.path).fraction);
            processor[k] = (thread_seconds() - cpu) * 1e6;
            wall[k] = microseconds_since(start);
        }
        getrusage(RUSAGE_THREAD, &after);
        if (phase != now) continue;  // partly in another phase
        Seen& mine = seen[now];
        mine.current.push_back(current);
        mine.wall.insert(mine.wall.end(), wall, wall + kCastsAJob);
        mine.processor.insert(mine.processor.end(), processor, processor + kCastsAJob);
        if (after.ru_nvcsw == before.ru_nvcsw && after.ru_nivcsw == before.ru_nivcsw)
            mine.undisturbed.insert(mine.undisturbed.end(), wall, wall + kCastsAJob);
        mine.gave_way += after.ru_nvcsw - before.ru_nvcsw;
        mine.pushed_off += after.ru_nivcsw - before.ru_nivcsw;
    }
}

struct Edits {
    std::vector<double> cut, cut_wall, publish, undo, redo;  // microseconds; processor time but for cut_wall
};

/// Microseconds of processor time.
template <class Work>
double timed(const Work& work) {
    const double start = thread_seconds();
    work();
    return (thread_seconds() - start) * 1e6;
}

/// Turn by turn the reader is left alone, and craters are cut beside it, for as long.
void edit(WorldStore& store, int rooms, std::size_t cuts, std::atomic<int>& phase, Edits& edits) {
    constexpr std::size_t kCutsATurn = 25;
    const Cutter cutter = crater();
    double turn = 30e3;
    for (std::size_t k = 0; k < cuts;) {
        phase = kAlone;
        std::this_thread::sleep_for(std::chrono::duration<double, std::micro>(turn));
        phase = kBeside;
        const Clock::time_point start = Clock::now();
        for (const std::size_t end = std::min(cuts, k + kCutsATurn); k < end; ++k) {
            const World before = store.current();
            World after = before;
            const CutCost cost = cut_crater(after, cutter, crater_pose(rooms, CraterPlaces::kSpread, k));
            edits.cut.push_back(cost.cpu * 1e3);
            edits.cut_wall.push_back(cost.wall * 1e3);
            if (cost.status != CarveStatus::kDone) continue;
            edits.publish.push_back(timed([&] { keep(store.publish(before, std::move(after))); }));
        }
        turn = microseconds_since(start);
        phase = kPause;
        edits.undo.push_back(timed([&] { keep(store.undo().has_value()); }));
        edits.redo.push_back(timed([&] { keep(store.redo().has_value()); }));
    }
    phase = kEnd;
}

void measure_level(int rooms, const Settings& settings, Table& reading, Table& editing) {
    const World first = carvable_world(crater_level(rooms));
    const std::vector<scenes::CastQuery> moves = moves_in_rooms(rooms, 10000);
    WorldStore store(first, {std::size_t(16) << 20});
    std::atomic<int> phase = kPause;
    Seen seen[kPhases];
    Edits edits;
    std::thread reader([&] { read(store, moves, phase, seen); });
    edit(store, rooms, settings.quick ? 50 : 1000, phase, edits);
    reader.join();
    for (const Phase which : {kAlone, kBeside}) {
        const Seen& it = seen[which];
        reading.add({count(first.face_count()), which == kAlone ? "alone" : "beside an editor", count(it.wall.size()),
                     number(median(it.processor)), number(quantile(it.processor, 0.999)),
                     number(quantile(it.processor, 1)), number(median(it.wall)), number(quantile(it.wall, 0.999)),
                     number(quantile(it.wall, 1)), number(quantile(it.undisturbed, 1)), count(std::size_t(it.gave_way)),
                     count(std::size_t(it.pushed_off)), number(median(it.current) * 1e3),
                     number(quantile(it.current, 1))});
    }
    const StoreHistory history = store.history();
    editing.add({count(first.face_count()), number(median(edits.cut)), number(median(edits.cut_wall)),
                 number(quantile(edits.cut_wall, 1)), number(median(edits.publish)),
                 number(quantile(edits.publish, 0.99)), number(quantile(edits.publish, 1)), number(median(edits.undo)),
                 number(median(edits.redo)), count(history.versions), number(double(history.bytes) / 1e6)});
}

int measure(const Settings& settings) {
    Table reading("store_readers", {"triangles", "reader", "casts", "median us", "p99.9 us", "longest us",
                                    "median wall us", "p99.9 wall us", "longest wall us", "... not put off",
                                    "left the processor", "put off it", "current() ns", "longest current() us"});
    Table editing("store_editor",
                  {"triangles", "cut us", "cut wall us", "longest cut wall us", "publish us", "p99 publish us",
                   "longest publish us", "undo us", "redo us", "versions kept", "history MB"});
    for (const int rooms : {2, 6, 20}) {
        if (settings.quick && rooms > 2) break;
        measure_level(rooms, settings, reading, editing);
    }
    const bool fine = reading.finish(settings.csv);
    return editing.finish(settings.csv) && fine ? 0 : 1;
}

}  // namespace
}  // namespace firma::bench

int main(int argc, char** argv) {
    using namespace firma::bench;
    return measure(read_settings(argc, argv, "A reader at a WorldStore, beside an editor and alone; publishing."));
}
