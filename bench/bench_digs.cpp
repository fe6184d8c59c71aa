// SPDX-License-Identifier: MIT
// What cuts cost that touch: cubes of a metre dug out of a block's top, in rows and in random order; craters cut one by
// one beside their union, made first and cut once; and 20,000 cutters in one edit.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <vector>

#include "firma/memory.h"
#include "firma/solid.h"
#include "scenes/rng.h"
#include "support/craters.h"
#include "support/race.h"
#include "support/settings.h"
#include "support/table.h"

namespace firma::bench {
namespace {

Solid block_of(double width) {
    Pose pose;
    pose.scale = width / 2;
    return unite(Solid(), make_crater(CutterShape::kBox, 0), pose).solid;
}

/// Processor time, seconds.
class Stopwatch {
public:
    double seconds() const { return thread_seconds() - start_; }

private:
    double start_ = thread_seconds();
};

/// Milliseconds a cut, in the order of the cuts; each must be done.
std::vector<double> dig(int side, bool shuffled, Solid& solid) {
    std::vector<int> order(std::size_t(side) * std::size_t(side));
    std::iota(order.begin(), order.end(), 0);
    scenes::Rng rng(1);
    if (shuffled)
        for (std::size_t k = order.size(); k > 1; --k) std::swap(order[k - 1], order[rng.below(std::uint32_t(k))]);
    const Cutter cube = make_crater(CutterShape::kBox, 0);
    std::vector<double> times;
    for (const int k : order) {
        Pose pose;
        pose.scale = 0.5;
        pose.position = Vec3{k % side + 0.5, k / side + 0.5, side - 0.5} - Vec3{1, 1, 1} * (side / 2.0);
        const Stopwatch watch;
        SolidResult cut = subtract(solid, cube, pose);
        solid = std::move(cut.solid);
        times.push_back(1e3 * watch.seconds());
        if (!cut.done()) std::exit((std::fprintf(stderr, "a cube was not cut: %s\n", cut.error.text().c_str()), 1));
    }
    return times;
}

void add_digs(const Settings& settings, Table& table) {
    for (const int side : settings.quick ? std::vector<int>{8} : std::vector<int>{16, 32, 64})
        for (const bool shuffled : {false, true}) {
            Solid solid = block_of(side);
            const std::vector<double> times = dig(side, shuffled, solid);
            const auto part = [&](std::size_t k) {
                const std::size_t eighth = times.size() / 8;
                const auto first = times.begin() + std::ptrdiff_t(k * eighth);
                return median(std::vector<double>(first, first + std::ptrdiff_t(eighth)));
            };
            table.add({count(std::size_t(side)), shuffled ? "random" : "rows", count(times.size()), number(part(0)),
                       number(part(4)), number(part(7)), number(quantile(times, 0.99)), count(solid.face_count()),
                       check_solid(solid) ? "broken" : "sound"});
        }
}

struct Placed {
    Cutter cutter;
    Pose pose;
};

/// Of neighbours in the list first.
Solid united(const std::vector<Placed>& cutters, std::size_t first, std::size_t end) {
    if (end - first == 1) return unite(Solid(), cutters[first].cutter, cutters[first].pose).solid;
    const std::size_t middle = (first + end) / 2;
    const Solid a = united(cutters, first, middle), b = united(cutters, middle, end);
    return unite(a, cutter_from_solid(b).value(), {}).solid;
}

void add_unions(const Settings& settings, Table& table) {
    const std::size_t most = settings.quick ? 8 : 256;
    for (const double size : {0.5, 2.0}) {
        scenes::Rng rng(2);
        std::vector<Placed> cutters;
        for (std::size_t k = 0; k < most; ++k) {
            Pose pose;
            pose.scale = size;
            pose.rotation = random_turn(rng.next());
            // Along a curve, each in the next one.
            const double at = double(k) / double(most);
            pose.position = {-30 + 60 * at, 20 * at * at, 32 + rng.uniform(-0.2, 0.2)};
            cutters.push_back({make_crater(CutterShape::kRocky, k % 50), pose});
        }
        const Solid block = block_of(64);
        const Stopwatch one_by_one;
        Solid cut = block;
        for (const Placed& it : cutters) cut = subtract(cut, it.cutter, it.pose).solid;
        const double apart = one_by_one.seconds();
        const Stopwatch uniting;
        const Cutter all = cutter_from_solid(united(cutters, 0, cutters.size())).value();
        const double together = uniting.seconds();
        const Stopwatch cutting;
        const Solid at_once = subtract(block, all, {}).solid;
        const double once = cutting.seconds();
        table.add({number(size), count(most), number(apart), number(together), number(once),
                   times((together + once) / apart), same_solid(cut, at_once) ? "yes" : "no"});
    }
}

/// Anywhere within a block of 64 m, as one version.
void add_one_edit(const Settings& settings, Table& table) {
    const std::size_t most = settings.quick ? 40 : 20'000;
    for (const CutterShape shape : {CutterShape::kBox, CutterShape::kRocky}) {
        scenes::Rng rng(3);
        const Cutter cutter = make_crater(shape, 7);
        const bool box = shape == CutterShape::kBox;  // flush with each other, on a lattice of a metre
        const Cutter block = make_crater(CutterShape::kBox, 0);
        Pose whole;
        whole.scale = 32;
        WorldEdit edit(WorldEdit(World()).fill(block, whole).world);
        std::vector<double> times;
        std::size_t refused = 0, nothing = 0;
        for (std::size_t k = 0; k < most; ++k) {
            Pose pose;
            pose.scale = 0.5;
            for (int axis = 0; axis < 3; ++axis)
                pose.position[axis] = box ? double(rng.below(64)) - 31.5 : rng.uniform(-32, 32);
            if (!box) pose.rotation = random_turn(rng.next());
            const Stopwatch watch;
            const CarveStatus status = edit.carve(cutter, pose).status;
            times.push_back(1e6 * watch.seconds());
            refused += status == CarveStatus::kRefused;
            nothing += status == CarveStatus::kNothing;
        }
        const World world = edit.finish();
        const std::size_t tenth = most / 10;
        table.add({box ? "cubes on a lattice" : "rocky craters", count(most),
                   number(1e-6 * std::accumulate(times.begin(), times.end(), 0.0)), number(median(times)),
                   number(median({times.begin(), times.begin() + std::ptrdiff_t(tenth)})),
                   number(median({times.end() - std::ptrdiff_t(tenth), times.end()})), number(quantile(times, 0.99)),
                   count(refused), count(nothing), count(world.solid().face_count()),
                   number(double(memory_used(world)) / (1 << 20)), check_solid(world) ? "broken" : "sound"});
    }
}

int measure(const Settings& settings) {
    Table digs("digs", {"block m", "order", "cuts", "median ms, first eighth", "fifth eighth", "last eighth", "p99 ms",
                        "facets", "check"});
    add_digs(settings, digs);
    Table unions("unions", {"crater m", "craters", "one by one s", "united s", "cut once s",
                            "united and cut to one by one", "same solid"});
    add_unions(settings, unions);
    Table edit("one_edit", {"cutters", "how many", "s", "median us", "first tenth us", "last tenth us", "p99 us",
                            "refused", "nothing to take", "facets", "MB", "check"});
    add_one_edit(settings, edit);
    return digs.finish(settings.csv) && unions.finish(settings.csv) && edit.finish(settings.csv) ? 0 : 1;
}

}  // namespace
}  // namespace firma::bench

int main(int argc, char** argv) {
    using namespace firma::bench;
    return measure(read_settings(
        argc, argv, "Cuts that touch, by the thousand; cutters one by one, and united first; 20,000 in one edit."));
}
