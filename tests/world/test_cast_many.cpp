// SPDX-License-Identifier: MIT
// Batches answer as single casts do, to the bit: in any order, on any threads, from rows and columns; told of and
// ended.
#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <thread>
#include <vector>

#include "firma/batch.h"
#include "firma/rooms.h"
#include "scenes/divided_building.h"
#include "scenes/rng.h"
#include "scenes/terrain.h"
#include "tests/every_kernel.h"
#include "world/cast_together.h"
#include "world/world_data.h"

namespace firma {
namespace {

using scenes::Rng;

const World& hills() {
    static const World world = make_world(scenes::terrain({.squares = 120, .seed = 8})).value();
    return world;
}

const World& rooms_with_doors() {
    static const World world =
        assemble_world(scenes::DividedBuilding({.jitter = 0.2, .closed = 0.3, .seed = 4}).parts()).value();
    return world;
}

/// Anywhere, some that cannot be asked or do not move.
std::vector<CastInput> any_casts(const World& world, std::size_t count, std::uint64_t seed) {
    Rng rng(seed);
    const Box box = world.bounds();
    std::vector<CastInput> casts(count);
    for (CastInput& it : casts) {
        for (int axis = 0; axis < 3; ++axis) it.sphere.centre[axis] = rng.uniform(box.low[axis], box.high[axis] + 2);
        it.sphere.radius = rng.chance(0.5) ? 0 : rng.uniform(0.01, 0.5);
        it.path = rng.direction() * (rng.chance(0.5) ? rng.uniform(0.1, 1) : rng.uniform(1, 50));
        if (rng.chance(0.01)) it.sphere.centre[int(rng.below(3))] = NAN;
        if (rng.chance(0.01)) it.sphere.centre = it.sphere.centre * 1e7;
        if (rng.chance(0.01)) it.path = it.path * 1e30;
        if (rng.chance(0.01)) it.path = {};
        if (rng.chance(0.01)) it.sphere.radius = -1;
    }
    return casts;
}

bool same_number(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool same_vec(const Vec3& a, const Vec3& b) {
    return same_number(a.x, b.x) && same_number(a.y, b.y) && same_number(a.z, b.z);
}

bool same_hit(const Hit& a, const Hit& b) {
    return a.status == b.status && a.feature == b.feature && a.feature_index == b.feature_index && a.face == b.face &&
           a.portal == b.portal && a.material == b.material && same_number(a.fraction, b.fraction) &&
           same_number(a.safe_fraction, b.safe_fraction) && same_vec(a.centre, b.centre) &&
           same_vec(a.point, b.point) && same_vec(a.normal, b.normal) && same_vec(a.face_normal, b.face_normal);
}

bool was_not_made(const Hit& hit) {
    return hit.status == Status::kInvalid && hit.fraction == 0;
}

/// Backward, in one thread.
void run_backward(std::size_t count, void (*work)(void*, std::size_t), void* context, void*) {
    while (count-- > 0) work(context, count);
}

/// Every third piece each.
void run_by_thirds(std::size_t count, void (*work)(void*, std::size_t), void* context, void*) {
    std::vector<std::thread> threads;
    for (std::size_t first = 0; first < 3; ++first)
        threads.emplace_back([=] {
            for (std::size_t k = first; k < count; k += 3) work(context, k);
        });
    for (std::thread& thread : threads) thread.join();
}

void run_not_at_all(std::size_t, void (*)(void*, std::size_t), void*, void*) {}

/// Calls function(options) with each way to run a batch.
template <class Function>
void in_every_way(const CastOptions& cast, const Function& function) {
    static const Tasks backward{run_backward}, threads{run_by_thirds};
    for (const Tasks* tasks : {static_cast<const Tasks*>(nullptr), &backward, &threads})
        function(ManyOptions{.cast = cast, .tasks = tasks});
}

TEST(CastMany, AnswersAsOneByOne) {
    for (const World* world : {&hills(), &rooms_with_doors()}) {
        const std::vector<CastInput> casts = any_casts(*world, 4000, 3);
        const CastOptions options{.room = world == &hills() ? kAnyRoom : kLocateRoom};
        std::vector<Hit> expected(casts.size());
        std::vector<Status> expected_any(casts.size());
        CastCounts alone;
        CastOptions counting = options;
        counting.counts = &alone;
        for (std::size_t k = 0; k < casts.size(); ++k) {
            expected[k] = cast(*world, casts[k].sphere, casts[k].path, counting);
            expected_any[k] = cast_any(*world, casts[k].sphere, casts[k].path, options);
        }
        std::vector<double> column[7];
        for (const CastInput& it : casts)
            for (int k = 0; k < 7; ++k)
                column[k].push_back(k < 3 ? it.sphere.centre[k] : k < 6 ? it.path[k - 3] : it.sphere.radius);
        const CastColumns columns{column[0], column[1], column[2], column[3], column[4], column[5], column[6]};
        EXPECT_GT(std::count_if(expected.begin(), expected.end(), [](const Hit& hit) { return bool(hit); }), 300);
        in_every_way(options, [&](ManyOptions each) {
            CastCounts together;
            each.cast.counts = &together;
            std::vector<Hit> hits(casts.size());
            EXPECT_EQ(cast_many(*world, casts, hits, each), ManyResult::kDone);
            for (std::size_t k = 0; k < casts.size(); ++k) ASSERT_TRUE(same_hit(hits[k], expected[k])) << k;
            EXPECT_EQ(together.nodes, alone.nodes);
            EXPECT_EQ(together.boxes, alone.boxes);
            EXPECT_EQ(together.faces, alone.faces);
            EXPECT_EQ(together.precise, alone.precise);
            each.cast.counts = nullptr;

            std::vector<Status> statuses(casts.size());
            EXPECT_EQ(cast_many_any(*world, casts, statuses, each), ManyResult::kDone);
            EXPECT_EQ(statuses, expected_any);
            statuses.assign(casts.size(), Status::kInvalid);
            EXPECT_EQ(cast_many_any(*world, columns, statuses, each), ManyResult::kDone);
            EXPECT_EQ(statuses, expected_any);

            std::vector<double> numbers[5];
            for (auto& of : numbers) of.resize(casts.size());
            std::vector<FaceRef> faces(casts.size());
            std::vector<std::uint32_t> materials(casts.size());
            const HitColumns said{statuses,   numbers[0], numbers[1], numbers[2],
                                  numbers[3], numbers[4], faces,      materials};
            EXPECT_EQ(cast_many(*world, columns, said, each), ManyResult::kDone);
            for (std::size_t k = 0; k < casts.size(); ++k) {
                ASSERT_EQ(statuses[k], expected[k].status) << k;
                ASSERT_TRUE(same_number(numbers[0][k], expected[k].fraction)) << k;
                ASSERT_TRUE(same_number(numbers[1][k], expected[k].safe_fraction)) << k;
                ASSERT_TRUE(same_vec({numbers[2][k], numbers[3][k], numbers[4][k]}, expected[k].normal)) << k;
                ASSERT_EQ(faces[k], expected[k].face) << k;
                ASSERT_EQ(materials[k], expected[k].material) << k;
            }
        });
    }
}

TEST(CastMany, OfRaysNeedsNoRadii) {
    const std::vector<CastInput> casts = any_casts(hills(), 1500, 5);
    std::vector<double> column[6], fractions(casts.size());
    for (const CastInput& it : casts)
        for (int k = 0; k < 6; ++k) column[k].push_back(k < 3 ? it.sphere.centre[k] : it.path[k - 3]);
    const CastColumns columns{column[0], column[1], column[2], column[3], column[4], column[5]};
    EXPECT_EQ(cast_many(hills(), columns, {.fraction = fractions}), ManyResult::kDone);
    for (std::size_t k = 0; k < casts.size(); ++k)
        ASSERT_TRUE(same_number(fractions[k], cast(hills(), Ray{casts[k].sphere.centre, casts[k].path}).fraction)) << k;
}

TEST(CastMany, OfShapesAnswersAsOneByOne) {
    Rng rng(6);
    const std::vector<CastInput> casts = any_casts(hills(), 1500, 4);
    const Hull box = make_box({0.3, 0.2, 0.5}).value();
    std::vector<CapsuleInput> capsules;
    std::vector<HullInput> hulls;
    for (const CastInput& it : casts) {
        capsules.push_back({make_capsule(it.sphere.centre, rng.direction(), 0.5, it.sphere.radius), it.path});
        hulls.push_back({rng.chance(0.01) ? nullptr : &box, it.sphere.centre, it.path});
    }
    std::vector<Hit> of_capsules, of_hulls;
    std::vector<Status> any_capsules, any_hulls;
    for (std::size_t k = 0; k < casts.size(); ++k) {
        const Hull& hull = hulls[k].hull ? box : Hull();
        of_capsules.push_back(cast(hills(), capsules[k].capsule, capsules[k].path));
        of_hulls.push_back(cast(hills(), hull, hulls[k].at, hulls[k].path));
        any_capsules.push_back(cast_any(hills(), capsules[k].capsule, capsules[k].path));
        any_hulls.push_back(cast_any(hills(), hull, hulls[k].at, hulls[k].path));
    }
    in_every_way({}, [&](const ManyOptions& each) {
        std::vector<Hit> hits(casts.size());
        std::vector<Status> statuses(casts.size());
        EXPECT_EQ(cast_many(hills(), std::span<const CapsuleInput>(capsules), hits, each), ManyResult::kDone);
        for (std::size_t k = 0; k < casts.size(); ++k) ASSERT_TRUE(same_hit(hits[k], of_capsules[k])) << k;
        EXPECT_EQ(cast_many(hills(), std::span<const HullInput>(hulls), hits, each), ManyResult::kDone);
        for (std::size_t k = 0; k < casts.size(); ++k) ASSERT_TRUE(same_hit(hits[k], of_hulls[k])) << k;
        EXPECT_EQ(cast_many_any(hills(), std::span<const CapsuleInput>(capsules), statuses, each), ManyResult::kDone);
        EXPECT_EQ(statuses, any_capsules);
        EXPECT_EQ(cast_many_any(hills(), std::span<const HullInput>(hulls), statuses, each), ManyResult::kDone);
        EXPECT_EQ(statuses, any_hulls);
    });
}

/// Answers by the number of the cast.
struct Together {
    std::vector<Hit> hits;
    std::vector<Status> statuses;

    Together(const World& world, const std::vector<CastInput>& casts, std::uint32_t places)
        : hits(casts.size()), statuses(casts.size()) {
        const auto ask = [&](std::size_t k) { return Asked(casts[k]); };
        const AskedCasts asked{0, casts.size(), true, ask, places};
        cast_together(world, asked, [&](std::size_t k, PutHit put) { put(hits[k]); }, {});
        cast_any_together(world, asked, [&](std::size_t k, Status status) { statuses[k] = status; }, {});
    }
};

TEST(CastTogether, HoweverManyAreOnTheirWay) {
    const std::vector<CastInput> casts = any_casts(hills(), 600, 9);
    test::with_every_kernel([&](const char* kernel) {
        for (const std::uint32_t places : {1u, 2u, 3u, 8u}) {
            const Together all(hills(), casts, places);
            const Together few(hills(), {casts.begin(), casts.begin() + 2}, places);
            for (std::size_t k = 0; k < casts.size(); ++k) {
                const Hit alone = cast(hills(), casts[k].sphere, casts[k].path);
                ASSERT_TRUE(same_hit(all.hits[k], alone)) << kernel << ", " << places << ", " << k;
                ASSERT_EQ(all.statuses[k], cast_any(hills(), casts[k].sphere, casts[k].path)) << kernel << ", " << k;
                if (k < few.hits.size()) {
                    ASSERT_TRUE(same_hit(few.hits[k], alone)) << kernel << ", " << places;
                }
            }
            EXPECT_TRUE(Together(hills(), {}, places).hits.empty());
        }
    });
}

struct BatchTeller {
    std::size_t stop_at = ~std::size_t(0);
    std::vector<std::size_t> told;

    static bool tell(std::size_t done, std::size_t count, void* user) {
        auto& it = *static_cast<BatchTeller*>(user);
        EXPECT_LE(done, count);
        it.told.push_back(done);
        return done < it.stop_at;
    }
};

TEST(CastMany, TellsHowFarItIs) {
    const std::vector<CastInput> casts = any_casts(hills(), 3000, 7);
    in_every_way({}, [&](ManyOptions each) {
        BatchTeller teller;
        each.progress = BatchTeller::tell;
        each.user = &teller;
        std::vector<Hit> hits(casts.size());
        EXPECT_EQ(cast_many(hills(), casts, hits, each), ManyResult::kDone);
        ASSERT_FALSE(teller.told.empty());
        EXPECT_EQ(teller.told.back(), casts.size());
        EXPECT_TRUE(std::is_sorted(teller.told.begin(), teller.told.end()));
    });
}

TEST(CastMany, EndsWhenItIsToldTo) {
    const std::vector<CastInput> casts = any_casts(hills(), 9000, 7);
    std::vector<Hit> expected(casts.size());
    EXPECT_EQ(cast_many(hills(), casts, expected), ManyResult::kDone);
    in_every_way({}, [&](ManyOptions each) {
        BatchTeller teller{3000, {}};
        each.progress = BatchTeller::tell;
        each.user = &teller;
        std::vector<Hit> hits(casts.size());
        EXPECT_EQ(cast_many(hills(), casts, hits, each), ManyResult::kCancelled);
        std::size_t made = 0;
        for (std::size_t k = 0; k < casts.size(); ++k) {
            const bool same = same_hit(hits[k], expected[k]);
            ASSERT_TRUE(same || was_not_made(hits[k])) << k;
            ASSERT_TRUE(same || hits[k].centre == casts[k].sphere.centre) << k << ": a mover would jump";
            made += same && !was_not_made(hits[k]);
        }
        EXPECT_GT(made, 2500u);
        EXPECT_LT(made, 6000u);
        EXPECT_GE(teller.told.back(), 3000u);
        // At the very end there is nothing left to cancel.
        BatchTeller last{casts.size(), {}};
        each.user = &last;
        EXPECT_EQ(cast_many(hills(), casts, hits, each), ManyResult::kDone);
    });
}

TEST(CastMany, RefusesWhatDoesNotFit) {
    const std::vector<CastInput> casts = any_casts(hills(), 1000, 8);
    std::vector<Hit> hits(casts.size() + 1, Hit{});
    EXPECT_EQ(cast_many(hills(), casts, hits), ManyResult::kRefused);
    EXPECT_TRUE(std::all_of(hits.begin(), hits.end(), was_not_made));
    hits.resize(casts.size());
    const Tasks lazy{run_not_at_all};
    EXPECT_EQ(cast_many(hills(), casts, hits, {.tasks = &lazy}), ManyResult::kRefused);
    EXPECT_TRUE(std::all_of(hits.begin(), hits.end(), was_not_made));
    std::vector<double> ten(10, 1.0), nine(9, 1.0), fractions(10, 1.0), few(9, 1.0);
    EXPECT_EQ(cast_many(hills(), {ten, ten, ten, ten, nine, ten}, {.fraction = fractions}), ManyResult::kRefused);
    EXPECT_EQ(fractions, std::vector<double>(10, 0.0));
    EXPECT_EQ(cast_many(hills(), {ten, ten, ten, ten, ten, ten, nine}, {.fraction = fractions}), ManyResult::kRefused);
    EXPECT_EQ(cast_many(hills(), {ten, ten, ten, ten, ten, ten}, {.fraction = few}), ManyResult::kRefused);
    EXPECT_EQ(few, std::vector<double>(9, 0.0));
    EXPECT_EQ(cast_many(hills(), {ten, ten, ten, ten, ten, ten}, {}), ManyResult::kDone);
    EXPECT_EQ(cast_many(hills(), std::span<const CastInput>(), std::span<Hit>()), ManyResult::kDone);
    std::vector<Status> statuses(10);
    EXPECT_EQ(cast_many_any(hills(), {ten, nine, ten, ten, ten, ten}, statuses), ManyResult::kRefused);
    EXPECT_EQ(statuses, std::vector<Status>(10, Status::kInvalid));
}

}  // namespace
}  // namespace firma
