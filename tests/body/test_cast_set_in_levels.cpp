// SPDX-License-Identifier: MIT
// Sets of spheres of real chunks on their ways through blasted levels, and against each other, beside poses sampled
// finely: never late, never inside.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "firma/cast_set.h"
#include "scenes/rng.h"
#include "tests/body/level_floors.h"
#include "tests/random_vector.h"
#include "tests/sample.h"

namespace firma::test {
namespace {

using scenes::Rng;

class CastSetInLevels : public InBlastedLevels {
protected:
    /// Spheres fitted to some chunks, about their centres of mass.
    std::vector<SphereSet> sets(std::size_t count, std::size_t spheres) const {
        std::vector<SphereSet> made;
        const auto chunks = chunks_of_size(level().chunks, 0.15, 1);
        for (std::size_t k = 0; k < chunks.size() && made.size() < count; ++k) {
            const Result<SphereFit> fit = fit_spheres(chunks[k]->solid, {.max_error = 1e-3, .max_spheres = spheres});
            if (!fit) continue;
            made.push_back(fit.value().spheres);
            for (Sphere& sphere : made.back()) sphere.centre -= chunks[k]->mass.centre;
        }
        return made;
    }
};
INSTANTIATE_TEST_SUITE_P(, CastSetInLevels, testing::Values(0, 1, 2), name_of_blasted_level);

Vec3 middle_at(const RigidMotion& motion, double fraction, const Sphere& sphere) {
    const Pose pose = pose_at(motion, fraction);
    return pose.position + matrix_of(pose.rotation) * sphere.centre;
}

/// Metres between the nearest sphere and faces that bound solid, up to 0.2.
double gap_to_solid(const World& world, const SphereSet& spheres, const RigidMotion& motion, double fraction) {
    double least = 0.2;
    for (const Sphere& sphere : spheres)
        overlap_each(world, {middle_at(motion, fraction, sphere), sphere.radius + least}, [&](const Overlap& near) {
            if (near.face.valid() && world.face_info(near.face)->solid)
                least = std::min(least, near.distance - sphere.radius);
            return true;
        });
    return least;
}

bool in_solid(const World& world, const SphereSet& spheres, const RigidMotion& motion, double fraction) {
    return std::any_of(spheres.begin(), spheres.end(), [&](const Sphere& sphere) {
        return locate(world, middle_at(motion, fraction, sphere)).where == Where::kSolid;
    });
}

/// A way toward a face, that starts clear of all.
/// @param faces  that bound solid
RigidMotion way_near_a_face(const World& world, const std::vector<Face>& faces, const SphereSet& spheres, double turn,
                            Rng& rng) {
    for (;;) {
        const Face& face = faces[rng.below(std::uint32_t(faces.size()))];
        Vec3 middle;
        for (const Vec3& corner : face.corners) middle += corner * (1.0 / double(face.corners.size()));
        RigidMotion motion;
        motion.position = middle + face.normal * rng.uniform(0.1, 2);
        motion.rotation = random_turn(rng.next());
        motion.path = face.normal * rng.uniform(-3, 0) + random_vector(rng, 0, 1);
        motion.turn = rng.direction() * turn;
        if (locate(world, motion.position).where != Where::kAir) continue;
        if (in_solid(world, spheres, motion, 0) || gap_to_solid(world, spheres, motion, 0) < 0.002) continue;
        return motion;
    }
}

TEST_P(CastSetInLevels, StraightAndTurningNeverLateNeverInside) {
    const World& world = level().world;
    const std::vector<SphereSet> all = sets(4, 24);
    ASSERT_GE(all.size(), 2u);
    std::vector<Face> faces;
    for (const Face& face : world.faces())
        if (face.solid) faces.push_back(face);
    Rng rng(17);
    for (const double turn : {0.0, 0.3, 3.0, 20.0}) {
        std::size_t hits = 0;
        for (int k = 0; k < sample(30); ++k) {
            const SphereSet& spheres = all[std::size_t(k) % all.size()];
            const RigidMotion motion = way_near_a_face(world, faces, spheres, turn, rng);
            const SetHit hit = cast(world, spheres, motion);
            ASSERT_NE(hit.status, Status::kInvalid);
            const double end = hit.touched() ? hit.fraction : 1;
            for (int look = 0; look <= 24; ++look) {
                EXPECT_GT(gap_to_solid(world, spheres, motion, end * look / 24), -1e-9) << look << " of 24";
                EXPECT_FALSE(in_solid(world, spheres, motion, end * look / 24)) << look << " of 24";
            }
            if (!hit.touched()) continue;
            ++hits;
            const Sphere& met = spheres[hit.sphere];
            const double early = length(middle_at(motion, end, met) - hit.point) - met.radius;
            EXPECT_LE(early, (turn > 0 ? 2 * kMaxBulge : 0) + 1e-9);
        }
        EXPECT_GE(hits, std::size_t(sample(10))) << turn;
    }
}

TEST_P(CastSetInLevels, TwoChunksMeetAsSampled) {
    const std::vector<SphereSet> all = sets(4, 24);
    ASSERT_GE(all.size(), 2u);
    Rng rng(18);
    std::size_t hits = 0;
    for (int k = 0; k < sample(120); ++k) {
        const SphereSet& one = all[std::size_t(k) % all.size()];
        const SphereSet& other = all[std::size_t(k / 4 + 1) % all.size()];
        RigidMotion a, b;
        a.rotation = random_turn(rng.next());
        b.rotation = random_turn(rng.next());
        b.position = random_vector(rng, 1, 3);
        a.path = b.position * rng.uniform(0.5, 2) + random_vector(rng, 0, 0.5);
        b.path = random_vector(rng, 0, 1);
        if (k % 3 > 0) a.turn = random_vector(rng, 0, 6);
        if (k % 3 > 1) b.turn = random_vector(rng, 0, 6);
        const auto gap = [&](double fraction) {
            double least = INFINITY;
            for (const Sphere& of_a : one)
                for (const Sphere& of_b : other) {
                    const Vec3 apart = middle_at(a, fraction, of_a) - middle_at(b, fraction, of_b);
                    least = std::min(least, length(apart) - of_a.radius - of_b.radius);
                }
            return least;
        };
        if (gap(0) < 1e-3) continue;
        const SetPairHit hit = cast(one, a, other, b);
        ASSERT_NE(hit.status, Status::kInvalid);
        const double end = hit.touched() ? hit.fraction : 1;
        for (int look = 0; look <= 32; ++look) EXPECT_GT(gap(end * look / 32), -1e-9) << look << " of 32";
        if (!hit.touched()) continue;
        ++hits;
        EXPECT_LE(gap(end), 4 * kMaxBulge + 1e-9);
    }
    EXPECT_GE(hits, std::size_t(sample(20)));
}

}  // namespace
}  // namespace firma::test
