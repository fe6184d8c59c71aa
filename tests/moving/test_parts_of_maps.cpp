// SPDX-License-Identifier: MIT
// Parts that the entities of OpenArena's maps make: sound worlds, which casts meet while they go as these say.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "firma/brush_parts.h"
#include "firma/brush_world.h"
#include "firma/moving_parts.h"
#include "firma/rooms.h"
#include "firma/solid.h"
#include "scenes/rng.h"
#include "tests/openarena_maps.h"
#include "tests/random_vector.h"
#include "tests/sample.h"

namespace firma::test {
namespace {

BrushParts parts_of_map(const BrushLevel& level) {
    Result<BrushParts> made = make_brush_parts(level);
    EXPECT_TRUE(made.ok()) << made.error().text();
    return made.ok() ? std::move(made.value()) : BrushParts{};
}

void expect_sound_parts(const BrushParts& made) {
    for (const BrushPart& part : made.parts) {
        const std::optional<WorldFault> fault = check_world(part.world);
        EXPECT_FALSE(fault) << "entity " << part.entity << ": " << fault->what;
        const auto solid = check_solid(part.world);
        EXPECT_FALSE(solid) << "entity " << part.entity << ": " << solid->what;
        EXPECT_GT(part.world.faces().size(), 0u) << "entity " << part.entity;
    }
}

TEST(PartsOfMaps, AllAreSoundWorlds) {
    if (openarena_maps().empty()) GTEST_SKIP() << kNoOpenArena;
    const std::vector<std::filesystem::path> maps = sampled(openarena_maps());
    std::size_t parts = 0;
    for (const std::filesystem::path& path : maps) {
        SCOPED_TRACE(path.stem().string());
        const BrushParts made = parts_of_map(read_brush_level(path.string()).value());
        expect_sound_parts(made);
        EXPECT_EQ(made.notes.size(), 0u);
        parts += made.parts.size();
    }
    // docs/moving.md counts those of the 50 maps.
    if (maps.size() == 50) {
        EXPECT_EQ(parts, 140u);
    } else {
        EXPECT_GT(parts, 0u);  // of the maps in a sample some have none
    }
}

/// Whether a sphere meets level or parts at a fraction.
bool meets_scene(const Scene& scene, const Vec3& at, double radius, double fraction) {
    const auto found = [](const PartOverlap&) { return false; };
    return overlap_each(scene, Sphere{at, radius}, found, fraction) != Status::kMiss;
}

/// Ticks at random times, and in each casts near a part.
class MovingMap {
public:
    explicit MovingMap(const BrushLevel& level)
        : world_(make_world(level).value()), made_(parts_of_map(level)), rng_(5) {
        expect_sound_parts(made_);
        for (const BrushPart& part : made_.parts) parts_.emplace_back(part.world);
    }

    std::size_t parts() const { return parts_.size(); }
    std::size_t hits = 0, part_hits = 0, moved = 0;

    void cast_about(int ticks, int casts) {
        constexpr double kTickSeconds = 1.0 / 20;
        for (int tick = 0; tick < ticks; ++tick) {
            const double time = rng_.uniform(0, 8);
            for (std::size_t k = 0; k < parts_.size(); ++k) {
                parts_[k].motion = part_motion(made_.parts[k].path, time, time + kTickSeconds);
                moved += parts_[k].motion.path != Vec3{} || parts_[k].motion.turn != Vec3{};
            }
            const Scene scene{world_, parts_};
            for (int made = 0, tried = 0; made < casts && tried < 40 * casts; ++tried) made += cast_one(scene);
        }
    }

private:
    /// Whether there was room.
    bool cast_one(const Scene& scene) {
        const MovingPart& near = parts_[rng_.below(std::uint32_t(parts_.size()))];
        Vec3 at;
        for (int axis = 0; axis < 3; ++axis)
            at[axis] = rng_.uniform(near.bounds().low[axis] - 0.5, near.bounds().high[axis] + 0.5);
        const Pose pose = pose_at(near.motion, 0);
        at = pose.position + matrix_of(pose.rotation) * at;
        const double radius = rng_.uniform(0.01, 0.2);
        const Vec3 path = rng_.chance(0.3) ? Vec3{} : random_vector(rng_, 0, 1.5);
        if (locate(world_, at).where != Where::kAir || meets_scene(scene, at, radius + 2 * kPartTouch, 0)) return false;
        CastOptions options;
        options.sides = Sides::kBoth;
        const PartHit hit = cast(scene, Sphere{at, radius}, path, options);
        EXPECT_NE(hit.status, Status::kInvalid);
        const double end = hit.touched() ? hit.fraction : 1;
        constexpr int kLooks = 24;
        for (int k = 0; k <= kLooks; ++k) {
            const double fraction = end * k / kLooks;
            EXPECT_FALSE(meets_scene(scene, at + path * fraction, radius - 2e-6, fraction))
                << "late: at " << k << " of " << kLooks << ", part " << hit.part;
        }
        if (!hit.touched()) return true;
        ++hits;
        part_hits += hit.part != kNoPart;
        EXPECT_TRUE(meets_scene(scene, at + path * end, radius + kPartTouch + 1e-6, end)) << "of nothing: " << hit.part;
        return true;
    }

    World world_;
    BrushParts made_;
    std::vector<MovingPart> parts_;
    scenes::Rng rng_;
};

TEST(PartsOfMaps, CastsMeetThemWhileTheyMove) {
    if (openarena_maps().empty()) GTEST_SKIP() << kNoOpenArena;
    for (const char* name : {"fan", "kaos2", "oa_dm2"}) {
        SCOPED_TRACE(name);
        const auto maps = openarena_maps();
        const auto path = std::find_if(maps.begin(), maps.end(), [&](const auto& map) { return map.stem() == name; });
        ASSERT_NE(path, maps.end());
        MovingMap map(read_brush_level(path->string()).value());
        ASSERT_GE(map.parts(), 1u);
        map.cast_about(20, sample(100));
        EXPECT_GT(map.moved, 0u);
        EXPECT_GT(map.hits, std::size_t(sample(200)));
        EXPECT_GT(map.part_hits, std::size_t(sample(100)));
    }
}

}  // namespace
}  // namespace firma::test
