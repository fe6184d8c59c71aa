// SPDX-License-Identifier: MIT
// Contacts handed to Bullet: a chain of rubble with Bullet's joints, and rubble by itself, fall on floors that blasts
// left. What they touch Firma tells.
#include <gtest/gtest.h>

#include <cmath>

#include "firma/queries.h"
#include "tests/body/level_floors.h"
#include "tests/bullet/bullet_on_contacts.h"

namespace firma::test {
namespace {

class ContactsInBullet : public InBlastedLevels {};
INSTANTIATE_TEST_SUITE_P(, ContactsInBullet, testing::Values(0, 1, 2), name_of_blasted_level);

TEST_P(ContactsInBullet, AChainOfRubbleFallsAndRests) {
    const std::vector<FloorPlace> places = floor_places(level().world, 1, 1, 2.4, 1);
    ASSERT_EQ(places.size(), 1u);
    const auto chunks = chunks_of_size(level().chunks, 0.1, 0.6);
    ASSERT_FALSE(chunks.empty());
    std::vector<std::unique_ptr<btPoint2PointConstraint>> joints;
    BulletOnContacts scene(level().world);
    std::vector<btRigidBody*> made;
    for (std::size_t k = 0; k < 60 && made.size() < 6; ++k) {
        const double apart = 0.3 * double(made.size());
        const Result<Body> body = chunk_over(*chunks[k % chunks.size()], 4, places[0].at + Vec3{0, 0, 0.6 + apart}, k);
        if (body) made.push_back(&scene.add(body.value()));
    }
    ASSERT_EQ(made.size(), 6u);
    // The first four hang together; the other two fall on these.
    for (std::size_t k = 1; k < 4; ++k) {
        const btVector3 middle =
            (made[k - 1]->getWorldTransform().getOrigin() + made[k]->getWorldTransform().getOrigin()) / btScalar(2);
        joints.push_back(std::make_unique<btPoint2PointConstraint>(*made[k - 1], *made[k],
                                                                   made[k - 1]->getWorldTransform().invXform(middle),
                                                                   made[k]->getWorldTransform().invXform(middle)));
        scene.addConstraint(joints.back().get(), true);
    }
    double deepest = 0, widest = 0;
    for (int frame = 0; frame < 20 * 480; ++frame) {
        scene.step();
        for (const auto& joint : joints) {
            const btVector3 gap = joint->getRigidBodyA().getWorldTransform() * joint->getPivotInA() -
                                  joint->getRigidBodyB().getWorldTransform() * joint->getPivotInB();
            widest = std::max(widest, double(gap.length()));
        }
    }
    for (const Body& body : scene.bodies().slots) {
        EXPECT_LT(length(body.velocity), 0.05);
        EXPECT_LT(length(body.spin), 0.3);
        EXPECT_LT(body.position.z, places[0].at.z + 1.2);
        for (const Sphere& own : body.shape.spheres()) {
            const Vec3 at = body.position + matrix_of(body.rotation) * (own.centre - body.shape.centre());
            ASSERT_NE(locate(level().world.solid(), at), Where::kSolid);
            const auto near = closest(level().world, at, own.radius);
            if (near.found()) deepest = std::max(deepest, own.radius - near.distance);
        }
    }
    EXPECT_LT(deepest, 0.001);
    EXPECT_LT(widest, 0.01);
    EXPECT_GE(scene.contacts(), 6u);
}

}  // namespace
}  // namespace firma::test
