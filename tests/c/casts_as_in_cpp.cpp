// SPDX-License-Identifier: MIT
// Casts at bodies, sweeps of sets, nearest points of scenes and fits of the C API beside those of the C++ library: the
// same bits.
#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "firma/body_index.h"
#include "firma/cast_set.h"
#include "firma/firma_c.h"
#include "firma/moving_parts.h"
#include "firma/save.h"
#include "scenes/rng.h"
#include "tests/body/simple_bodies.h"
#include "tests/random_vector.h"

namespace firma {
namespace {

using scenes::Rng;
using test::random_vector;

#define OK(call) ASSERT_EQ(call, FIRMA_OK) << firma_error_message()

template <class T>
bool same_bits(const T& a, const T& b) {
    return std::memcmp(&a, &b, sizeof a) == 0;
}
/// Three doubles beside a vector.
bool same_bits(const double (&a)[3], const Vec3& b) {
    return std::memcmp(a, &b, sizeof a) == 0;
}

void put(const Vec3& v, double (&out)[3]) {
    for (int axis = 0; axis < 3; ++axis) out[axis] = v[axis];
}

firma_motion motion_in_c(const RigidMotion& from) {
    firma_motion out{};
    put(from.position, out.position);
    for (std::size_t k = 0; k < 4; ++k) out.rotation[k] = from.rotation[k];
    put(from.path, out.path);
    put(from.turn, out.turn);
    return out;
}

std::vector<double> set_in_c(const SphereSet& set) {
    std::vector<double> out;
    for (const Sphere& sphere : set)
        out.insert(out.end(), {sphere.centre.x, sphere.centre.y, sphere.centre.z, sphere.radius});
    return out;
}

firma_world world_in_c(const World& world) {
    const std::vector<std::byte> bytes = pack_world(world);
    firma_world made{};
    EXPECT_EQ(firma_world_unpack(bytes.data(), bytes.size(), nullptr, &made), FIRMA_OK) << firma_error_message();
    return made;
}

SphereSet random_set(Rng& rng, int count) {
    SphereSet set;
    for (int k = 0; k < count; ++k) {
        const Vec3 centre = random_vector(rng, 0, 0.5);
        set.push_back({centre, rng.uniform(0, 0.3)});
    }
    return set;
}

RigidMotion random_motion(Rng& rng, const Vec3& around, double way) {
    RigidMotion motion;
    motion.position = around + random_vector(rng, 0, 4);
    motion.rotation = random_turn(rng.next());
    motion.path = random_vector(rng, 0, way);
    if (rng.chance(0.5)) motion.turn = random_vector(rng, 0, 3);
    return motion;
}

class CastsAsInCpp : public testing::Test {
protected:
    ~CastsAsInCpp() override { EXPECT_EQ(firma_live_handles(), 0u); }
};

TEST_F(CastsAsInCpp, AtBodies) {
    Rng rng(5);
    const SphereSet set{{{0, 0, 0}, 0.4}, {{0.5, 0, 0}, 0.25}};
    const MassProperties mass = mass_of_box({0.75, 0.25, 0.25}, 1000);
    const BodyShape shape = make_body_shape(set, mass).value();
    firma_mass mass_in_c{};
    const double half[3] = {0.75, 0.25, 0.25};
    OK(firma_mass_of_box(half, 1000, &mass_in_c));
    firma_body_shape shape_in_c{};
    OK(firma_body_shape_spheres(set_in_c(set).data(), 2, &mass_in_c, &shape_in_c));
    Bodies bodies;
    firma_bodies bodies_in_c{};
    OK(firma_bodies_create(&bodies_in_c));
    for (int k = 0; k < 30; ++k) {
        Pose pose;
        pose.position = random_vector(rng, 0, 6);
        pose.rotation = random_turn(rng.next());
        const BodyId id = add_body(bodies, body_at(shape, pose));
        Body& body = *bodies.find(id);
        body.velocity = random_vector(rng, 0, 9);
        body.spin = random_vector(rng, 0, 6);
        body.mask = rng.chance(0.2) ? 2 : 3;
        firma_pose pose_in_c{};
        put(pose.position, pose_in_c.position);
        for (std::size_t part = 0; part < 4; ++part) pose_in_c.rotation[part] = pose.rotation[part];
        pose_in_c.scale = 1;
        firma_body_id id_in_c{};
        OK(firma_bodies_add(bodies_in_c, shape_in_c, &pose_in_c, &id_in_c));
        ASSERT_TRUE(id_in_c.slot == id.slot && id_in_c.use == id.use);
        firma_body body_in_c{};
        body_in_c.size = sizeof body_in_c;
        OK(firma_bodies_get(bodies_in_c, id_in_c, &body_in_c));
        put(body.velocity, body_in_c.velocity);
        put(body.spin, body_in_c.spin);
        body_in_c.mask = body.mask;
        OK(firma_bodies_set(bodies_in_c, id_in_c, &body_in_c));
    }
    int hits = 0;
    for (const double seconds : {0.0, 0.25}) {
        const BodyIndex index(bodies, seconds);
        firma_body_index index_in_c{};
        OK(firma_body_index_create(bodies_in_c, seconds, &index_in_c));
        for (int k = 0; k < 300; ++k) {
            const SphereSet cast_set = random_set(rng, 1 + int(rng.below(3)));
            const RigidMotion motion = random_motion(rng, {}, 12);
            const BodyCastOptions options{1, {rng.below(30), 0}, rng.uniform(0, 0.1)};
            firma_body_cast_options options_in_c{
                sizeof options_in_c, 1, {options.except.slot, options.except.use}, options.contact_offset};
            const bool single = rng.chance(0.5);
            const BodyHit expected = single
                                         ? index.cast(Sphere{motion.position, cast_set[0].radius}, motion.path, options)
                                         : index.cast(cast_set, motion, options);
            firma_body_hit hit{};
            if (single) {
                firma_cast_input input{};
                put(motion.position, input.centre);
                input.radius = cast_set[0].radius;
                put(motion.path, input.path);
                OK(firma_body_index_cast(index_in_c, &input, &options_in_c, &hit));
            } else {
                const firma_motion way = motion_in_c(motion);
                OK(firma_body_index_cast_set(index_in_c, set_in_c(cast_set).data(), cast_set.size(), &way,
                                             &options_in_c, &hit));
            }
            ASSERT_EQ(hit.status, std::uint32_t(expected.status));
            ASSERT_TRUE(
                same_bits(hit.fraction, expected.fraction) && same_bits(hit.safe_fraction, expected.safe_fraction) &&
                same_bits(hit.centre, expected.centre) && same_bits(hit.point, expected.point) &&
                same_bits(hit.normal, expected.normal) && same_bits(hit.surface_velocity, expected.surface_velocity));
            ASSERT_TRUE(hit.body.slot == expected.body.slot && hit.body.use == expected.body.use);
            ASSERT_TRUE(hit.sphere == expected.sphere && hit.body_sphere == expected.body_sphere);
            hits += expected.touched();
        }
        OK(firma_body_index_release(index_in_c));
    }
    EXPECT_GT(hits, 100);
    EXPECT_LT(hits, 500);
    OK(firma_bodies_release(bodies_in_c));
    OK(firma_body_shape_release(shape_in_c));
}

TEST_F(CastsAsInCpp, SetsAndNearestPointsInTheDepot) {
    Rng rng(6);
    const World depot = test::depot_world();
    const firma_world depot_in_c = world_in_c(depot);
    const Vec3 middle = (depot.bounds().low + depot.bounds().high) * 0.5;
    const World block = test::brush_world(map_text::box({-1, -1, -1}, {1, 1, 1}, "steel"));
    const firma_world block_in_c = world_in_c(block);
    int hits = 0, pairs = 0, of_part = 0;
    for (int k = 0; k < 300; ++k) {
        const SphereSet a = random_set(rng, 3), b = random_set(rng, 2);
        const RigidMotion way = random_motion(rng, middle, 9);
        const RigidMotion other = random_motion(rng, way.position, 9);
        const firma_motion way_in_c = motion_in_c(way), other_in_c = motion_in_c(other);
        const std::vector<double> a_in_c = set_in_c(a), b_in_c = set_in_c(b);
        const SetHit expected = cast(depot, a, way);
        firma_set_hit hit{};
        OK(firma_cast_set(depot_in_c, a_in_c.data(), 3, &way_in_c, nullptr, &hit));
        ASSERT_EQ(hit.hit.status, std::uint32_t(expected.status));
        ASSERT_TRUE(same_bits(hit.hit.fraction, expected.fraction) && same_bits(hit.hit.centre, expected.centre) &&
                    same_bits(hit.hit.safe_fraction, expected.safe_fraction) && hit.sphere == expected.sphere &&
                    hit.hit.face == expected.face.id.value);
        hits += expected.touched();

        const SetPairHit expected_pair = cast(a, way, b, other);
        firma_set_pair_hit pair{};
        OK(firma_cast_set_pair(a_in_c.data(), 3, &way_in_c, b_in_c.data(), 2, &other_in_c, &pair));
        ASSERT_EQ(pair.status, std::uint32_t(expected_pair.status));
        ASSERT_TRUE(same_bits(pair.fraction, expected_pair.fraction) && same_bits(pair.point, expected_pair.point) &&
                    same_bits(pair.normal, expected_pair.normal) && pair.sphere_a == expected_pair.sphere_a &&
                    pair.sphere_b == expected_pair.sphere_b);
        pairs += expected_pair.touched();

        const std::vector<MovingPart> parts{MovingPart(block, other)};
        firma_part part{};
        firma_part_defaults(&part);
        part.world = block_in_c;
        part.motion = other_in_c;
        firma_scene scene{};
        firma_scene_defaults(&scene);
        scene.world = depot_in_c;
        OK(firma_parts_create(&scene.parts));
        OK(firma_parts_add(scene.parts, &part, nullptr));
        const double fraction = rng.uniform(0, 1), reach = rng.uniform(0, 4);
        const PartNear nearest = closest(Scene{depot, parts}, way.position, reach, fraction);
        double point[3];
        put(way.position, point);
        firma_part_near near{};
        std::uint32_t found = 9;
        OK(firma_closest_scene(&scene, point, reach, fraction, nullptr, &near, &found));
        ASSERT_EQ(found, std::uint32_t(nearest.found()));
        if (nearest.found()) {
            ASSERT_TRUE(same_bits(near.near.point, nearest.point) && same_bits(near.near.distance, nearest.distance) &&
                        same_bits(near.surface_velocity, nearest.surface_velocity) && near.part == nearest.part);
            of_part += nearest.part == 0;
        }
        OK(firma_parts_release(scene.parts));
    }
    EXPECT_GT(hits, 50);
    EXPECT_GT(pairs, 20);
    EXPECT_GT(of_part, 30);
    OK(firma_world_release(block_in_c));
    OK(firma_world_release(depot_in_c));
}

TEST_F(CastsAsInCpp, SpheresOfASolid) {
    const World block = test::brush_world(map_text::box({-1, -1, -1}, {3, 1, 2}, "steel"));
    const firma_world block_in_c = world_in_c(block);
    FitOptions fit;
    fit.max_spheres = 20;
    fit.max_error = 0.02;
    fit.margin = 0.01;
    const SphereFit expected = fit_spheres(block.solid(), fit).value();
    const firma_fit_options fit_in_c{sizeof fit_in_c, 20, 0.02, 0.01};
    std::vector<double> spheres(80);
    std::size_t count = 0;
    double error = 0;
    OK(firma_world_fit_spheres(block_in_c, &fit_in_c, spheres.data(), 20, &count, &error));
    ASSERT_EQ(count, expected.spheres.size());
    spheres.resize(4 * count);
    EXPECT_EQ(spheres, set_in_c(expected.spheres));
    EXPECT_EQ(error, expected.error);
    OK(firma_world_release(block_in_c));
}

}  // namespace
}  // namespace firma
