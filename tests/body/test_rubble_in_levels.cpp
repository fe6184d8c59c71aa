// SPDX-License-Identifier: MIT
// Rubble of real blasts on the floors that these left: it comes to rest, as pieces of 1 to 200 spheres, in piles with a
// thousand times their mass on top, and wakes when the ground goes or comes back.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/body/level_floors.h"
#include "tests/carve/cutters.h"
#include "tests/reference/judge_bodies.h"

namespace firma::test {
namespace {

class RubbleInLevels : public InBlastedLevels {};
INSTANTIATE_TEST_SUITE_P(, RubbleInLevels, testing::Values(0, 1, 2), name_of_blasted_level);

double energy_of(const Bodies& bodies) {
    double sum = 0;
    for (const Body& body : bodies.slots)
        if (body.shape.valid()) sum += kinetic_energy(body) + 9.81 * body.shape.mass() * body.position.z;
    return sum;
}

std::size_t asleep(const Bodies& bodies) {
    std::size_t count = 0;
    for (const Body& body : bodies.slots) count += body.shape.valid() && body.asleep;
    return count;
}

/// Steps until all sleep, each judged; metres a body may be in the level are those of BodyDepths.
int settle(Bodies& bodies, const World& world, int most) {
    reference::BodyDepths depths(true);
    for (int tick = 0; tick < most; ++tick) {
        if (step(bodies, world, kTick).awake == 0) return tick;
        const std::string fault = depths.fault(world, bodies);
        if (!fault.empty()) {
            ADD_FAILURE() << "tick " << tick << ": " << fault;
            return most;
        }
    }
    return most;
}

TEST_P(RubbleInLevels, PiecesOf1To200SpheresComeToRest) {
    const World& world = level().world;
    const std::vector<FloorPlace> places = floor_places(world, 0.9, 0.9, 2, 3);
    const auto chunks = chunks_of_size(level().chunks, 0.15, 0.8);
    ASSERT_GE(places.size(), 2u);
    ASSERT_GE(chunks.size(), 3u);
    std::size_t most_spheres = 0, rested = 0;
    for (const std::size_t spheres : {1u, 12u, 64u, 200u})
        for (std::size_t k = 0; k < places.size(); ++k) {
            const Chunk& chunk = *chunks[k * (chunks.size() - 1) / places.size()];
            const Result<Body> made = chunk_over(chunk, spheres, places[k].at + Vec3{0, 0, 1}, k);
            if (!made) continue;
            most_spheres = std::max(most_spheres, made.value().shape.spheres().size());
            Bodies bodies;
            const BodyId id = add_body(bodies, made.value());
            const int rest = settle(bodies, world, 900);
            EXPECT_LT(rest, 900) << spheres << " spheres at " << k;
            // It lies, and does not hang: woken, it stays where it is.
            const Vec3 at = bodies.find(id)->position;
            wake_body(bodies, id);
            EXPECT_EQ(step(bodies, world, kTick).awake, 1u);
            EXPECT_LT(settle(bodies, world, 120), 120) << spheres << " spheres at " << k;
            // Still is what goes no farther than this in half a second.
            const StepOptions options;
            EXPECT_LT(length(bodies.find(id)->position - at), 2 * options.sleep_speed * options.sleep_after)
                << spheres << " spheres at " << k;
            ++rested;
        }
    EXPECT_GE(rested, 8u);
    EXPECT_GE(most_spheres, 150u);
}

/// The next of the chunks that can be put there, as so many kilograms.
Result<Body> next_over(const std::vector<const Chunk*>& chunks, std::size_t& next, const Vec3& floor,
                       std::uint64_t turn, double mass) {
    Result<Body> made = Error{};
    for (std::size_t tried = 0; tried < chunks.size() && !made; ++tried) {
        const Chunk& chunk = *chunks[next++ % chunks.size()];
        const Box box = chunk.solid.bounds();
        const Vec3 up{0, 0, length(box.high - box.low) + 0.05};
        made = chunk_over(chunk, 40, floor + up, turn, mass / chunk.mass.mass);
    }
    return made;
}

/// Pieces of 1, 10, 100 and 1,000 kg dropped one after another on one place.
TEST_P(RubbleInLevels, APileWithAThousandTimesTheMassOnTopComesToRest) {
    const World& world = level().world;
    const std::vector<FloorPlace> places = floor_places(world, 0.9, 0.9, 2.6, 2);
    const auto chunks = chunks_of_size(level().chunks, 0.1, 0.6);
    ASSERT_GE(places.size(), 1u);
    ASSERT_GE(chunks.size(), 2u);
    for (const FloorPlace& place : places) {
        Bodies bodies;
        reference::BodyDepths depths(true);
        std::size_t next = 0;
        for (int k = 0; k < 4; ++k) {
            double top = 0;
            for (const Body& body : bodies.slots)
                top = std::max(top, body.position.z + body.shape.reach() - place.at.z);
            const Vec3 over = place.at + Vec3{0, 0, top};
            const Result<Body> made = next_over(chunks, next, over, std::uint64_t(k), std::pow(10.0, k));
            ASSERT_TRUE(made.ok()) << "piece " << k;
            add_body(bodies, made.value());
            const double first = energy_of(bodies);
            for (int tick = 0; tick < 180; ++tick) {
                step(bodies, world, kTick);
                // Contacts that were pressed in by micrometres lift what lies on them by as much.
                ASSERT_LT(energy_of(bodies), first + 1e-9 * std::fabs(first) + 2e-5)
                    << "piece " << k << ", tick " << tick;
                ASSERT_EQ(depths.fault(world, bodies), "") << "piece " << k << ", tick " << tick;
            }
        }
        EXPECT_NEAR(bodies.slots[3].shape.mass(), 1000 * bodies.slots[0].shape.mass(), 1e-6);
        EXPECT_LT(settle(bodies, world, 1800), 1800);
        EXPECT_EQ(asleep(bodies), 4u);
    }
}

TEST_P(RubbleInLevels, WakesWhenTheFloorIsCutAwayAndIsPutOutWhenThatIsUndone) {
    const World& world = level().world;
    const std::vector<FloorPlace> places = floor_places(world, 0.9, 0.9, 2, 2);
    const auto chunks = chunks_of_size(level().chunks, 0.15, 0.5);
    ASSERT_GE(places.size(), 1u);
    std::size_t woken = 0;
    for (const FloorPlace& place : places)
        for (std::size_t k = 0; k < 2; ++k) {
            const Result<Body> made = chunk_over(*chunks[k * (chunks.size() - 1)], 40, place.at + Vec3{0, 0, 1}, k);
            if (!made) continue;
            Bodies bodies;
            const BodyId id = add_body(bodies, made.value());
            ASSERT_LT(settle(bodies, world, 900), 900);
            const Vec3 rested = bodies.find(id)->position;
            const CarveResult cut =
                carve(world, make_crater(CutterShape::kRocky, 3), pose_at(rested.x, rested.y, place.at.z, 0.9));
            ASSERT_TRUE(cut.done());
            if (reference::opens_way_out(world, cut.world)) continue;
            EXPECT_EQ(step(bodies, cut.world, kTick).woken, 1u);
            ++woken;
            EXPECT_LT(settle(bodies, cut.world, 900), 900);
            EXPECT_LT(bodies.find(id)->position.z, rested.z - 0.05);
            // The floor is back: out of it by the shortest way.
            for (int tick = 0; tick < 600; ++tick) step(bodies, world, kTick);
            EXPECT_FALSE(bodies.find(id)->stuck);
            EXPECT_EQ(reference::BodyDepths(true).fault(world, bodies), "");
        }
    EXPECT_GE(woken, 1u);
}

}  // namespace
}  // namespace firma::test
