// SPDX-License-Identifier: MIT
// A million casts made together, of rays, spheres, capsules, boxes and hulls, by each of the lanes' kernels that this
// processor runs: the answers are those of single casts, to the bit, and as much is looked at.
//
//   full_together --count 1000000 --seed 1 [--show 3]
//
// The count is of casts by each kernel: in the scenes of the casts' families, in our level, and in the depot by room.
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "firma/brush_world.h"
#include "firma/level.h"
#include "firma/rooms.h"
#include "scenes/cast_families.h"
#include "tests/every_kernel.h"
#include "tests/full/options.h"
#include "tests/world/any_shape.h"
#include "tests/world/hit_bits.h"
#include "world/cast_asked.h"
#include "world/cast_together.h"

namespace {

using namespace firma;

struct Tally {
    std::uint64_t casts = 0, touched = 0, wrong = 0;
};

/// All of one kind.
struct Batch {
    bool spheres;
    std::vector<Asked> casts;
};

/// Those of spheres, and as many of other shapes.
std::vector<Batch> batches_of(const std::vector<scenes::CastQuery>& queries, std::uint64_t seed) {
    scenes::Rng rng(seed);
    std::vector<Batch> batches(2);
    batches[0].spheres = true;
    batches[1].spheres = false;
    static std::vector<AnyShape> shapes;  // hulls have to live as long as what asks for them
    shapes.clear();
    for (const scenes::CastQuery& query : queries) {
        const double radius = query.sphere.radius, size = radius > 1e-6 && radius < 1e6 ? radius : 0.5;
        shapes.emplace_back(rng, query.sphere.centre, size);
    }
    for (std::size_t k = 0; k < queries.size(); ++k) {
        const scenes::CastQuery& query = queries[k];
        batches[0].casts.emplace_back(CastInput{query.sphere, query.path});
        if (shapes[k].hull.valid())
            batches[1].casts.emplace_back(HullInput{&shapes[k].hull, query.sphere.centre, query.path});
        else
            batches[1].casts.emplace_back(CapsuleInput{shapes[k].capsule, query.path});
    }
    return batches;
}

/// Short and long ones, anywhere.
std::vector<scenes::CastQuery> casts_in(const World& level, std::uint64_t seed) {
    scenes::Rng rng(seed);
    const Box bounds = level.bounds();
    std::vector<scenes::CastQuery> casts(500);
    for (scenes::CastQuery& it : casts) {
        for (int axis = 0; axis < 3; ++axis) it.sphere.centre[axis] = rng.uniform(bounds.low[axis], bounds.high[axis]);
        it.sphere.radius = rng.chance(0.5) ? 0 : rng.uniform(0.01, 1);
        it.path = rng.direction();
        it.path = it.path * (rng.chance(0.5) ? rng.uniform(0.01, 2) : rng.uniform(2, 60));
    }
    return casts;
}

bool same_counts(const CastCounts& a, const CastCounts& b) {
    return a.nodes == b.nodes && a.boxes == b.boxes && a.faces == b.faces && a.precise == b.precise;
}

class Judge {
public:
    explicit Judge(std::uint64_t show) : show_(show) {}

    void judge(const World& world, const std::string& name, const std::vector<scenes::CastQuery>& queries,
               std::uint64_t seed, RoomId room = kAnyRoom) {
        scenes::Rng rng(seed);
        for (const Batch& batch : batches_of(queries, seed)) {
            const std::uint32_t places = 1 + std::uint32_t(rng.below(8));
            tally.casts += batch.casts.size();
            bool first = true;
            test::with_every_kernel([&](const char* kernel) {
                const std::string where = name + ", " + kernel + ", " + std::to_string(places) + " at a time";
                compare(world, batch, places, room, where, first);
                first = false;
            });
        }
    }

    Tally tally;

private:
    void compare(const World& world, const Batch& batch, std::uint32_t places, RoomId room, const std::string& where,
                 bool count) {
        const std::size_t many = batch.casts.size();
        CastCounts alone, together;
        const CastOptions single{.counts = &alone, .room = room}, each{.counts = &together, .room = room};
        std::vector<Hit> hits(many);
        std::vector<Status> statuses(many);
        std::vector<int> told(many);
        const auto ask = [&](std::size_t k) { return batch.casts[k]; };
        const AskedCasts asked{0, many, batch.spheres, ask, places};
        cast_together(
            world, asked,
            [&](std::size_t k, PutHit put) {
                ++told[k];
                put(hits[k]);
            },
            each);
        cast_any_together(
            world, asked,
            [&](std::size_t k, Status status) {
                ++told[k];
                statuses[k] = status;
            },
            each);
        for (std::size_t k = 0; k < many; ++k) {
            const Hit hit = cast_asked(world, batch.casts[k], single);
            const Status status = cast_any_asked(world, batch.casts[k], single);
            std::vector<std::uint64_t> said, expected;
            add_bits(said, hits[k]);
            add_bits(expected, hit);
            if (count) tally.touched += bool(hit);
            if (said != expected || statuses[k] != status || told[k] != 2) fail(where + ", cast " + std::to_string(k));
        }
        if (!same_counts(alone, together)) fail(where + ": not as much was looked at");
    }

    void fail(const std::string& what) {
        if (++tally.wrong <= show_) std::printf("failure %s\n", what.c_str());
    }

    const std::uint64_t show_;
};

World depot() {
    return make_world(read_brush_level(FIRMA_ROOT "/levels/depot.map").value()).value();
}

}  // namespace

int main(int count, char** words) {
    full::Options options;
    options.count = 1'000'000;
    if (!full::read_options(count, words, options, {})) {
        std::fprintf(stderr, "full_together [--count N] [--seed N] [--show N]\n");
        return 2;
    }
    Judge judge(options.show);
    const World level = make_world(read_level(FIRMA_ROOT "/levels/first.obj").value()).value(), rooms = depot();
    for (std::uint64_t index = 0; judge.tally.casts < options.count; ++index) {
        const std::uint64_t seed = options.seed * 1'000'003 + index;
        const std::string scene_name = ", scene " + std::to_string(index);
        for (const scenes::CastFamily& family : scenes::cast_families()) {
            const scenes::CastScene scene = scenes::make_cast_scene(family, options.seed, index);
            judge.judge(make_world(scenes::level_of(scene.polygons, scene.two_sided)).value(),
                        std::string(family.name) + scene_name, scene.casts, seed);
        }
        judge.judge(level, "first.obj" + scene_name, casts_in(level, seed), seed);
        judge.judge(rooms, "depot.map" + scene_name, casts_in(rooms, seed), seed, index % 2 ? kLocateRoom : kAnyRoom);
    }
    const auto number = [](std::uint64_t x) { return static_cast<unsigned long long>(x); };
    const Tally& tally = judge.tally;
    std::printf("claim=casts_together family=total count=%llu seed=%llu wrong=%llu touched=%llu result=%s\n",
                number(tally.casts), number(options.seed), number(tally.wrong), number(tally.touched),
                tally.wrong == 0 ? "pass" : "fail");
    return tally.wrong == 0 && tally.touched > 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
