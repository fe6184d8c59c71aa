// SPDX-License-Identifier: MIT
// Bullet moves bodies and solves joints and contacts; what touches what Firma tells. Bullet has no shape of the level.
#pragma once

#include <BulletCollision/CollisionDispatch/btSimulationIslandManager.h>
#include <btBulletDynamicsCommon.h>

#include <memory>
#include <vector>

#include "firma/bodies.h"
#include "tests/bullet/bullet_vector.h"

namespace firma::test {

/// What a world of Bullet is made of. It has to be there before and after it.
struct BulletMachinery {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
};

/// Bullet's world, in which contacts come from a step of Firma's bodies that are placed as Bullet's are: so they are
/// those that press within the step to come.
class BulletOnContacts : private BulletMachinery, public btDiscreteDynamicsWorld {
public:
    static constexpr double kStep = 1.0 / 480;  ///< seconds: none moves by the radius of its spheres in it

    explicit BulletOnContacts(const World& world)
        : btDiscreteDynamicsWorld(&dispatcher, &broadphase, &solver, &configuration), level_(world) {
        setGravity({0, 0, btScalar(-9.81)});
        getSimulationIslandManager()->setSplitIslands(
            false);  // these follow Bullet's own pairs, of which there are none
        options_.sleep_after = INFINITY;
    }
    ~BulletOnContacts() override {
        while (getNumConstraints() > 0) removeConstraint(getConstraint(0));
        for (const auto& body : bullets_) removeRigidBody(body.get());
        release();
    }
    BulletOnContacts(const BulletOnContacts&) = delete;
    BulletOnContacts& operator=(const BulletOnContacts&) = delete;

    /// Bullet's bodies lie in their centre of mass and along their principal axes.
    btRigidBody& add(const Body& body) {
        const Vec3& moments = body.shape.moments();
        btRigidBody::btRigidBodyConstructionInfo info(btScalar(body.shape.mass()), nullptr, &no_shape_,
                                                      bullet_vector(moments));
        const Quaternion turn = compose(normalised(body.rotation), body.shape.axes());
        const btQuaternion rotation{btScalar(turn[0]), btScalar(turn[1]), btScalar(turn[2]), btScalar(turn[3])};
        info.m_startWorldTransform = btTransform(rotation, bullet_vector(body.position));
        bullets_.push_back(std::make_unique<btRigidBody>(info));
        bullets_.back()->setActivationState(DISABLE_DEACTIVATION);
        bullets_.back()->setDamping(0, btScalar(0.5));  // for resistance to rolling
        addRigidBody(bullets_.back().get());
        add_body(bodies_, body);
        return *bullets_.back();
    }
    void step() { stepSimulation(btScalar(kStep), 0); }
    /// As Bullet has them.
    const Bodies& bodies() {
        place_bodies();
        return bodies_;
    }
    /// In the last step.
    [[nodiscard]] std::size_t contacts() const { return manifolds_.size(); }

    void performDiscreteCollisionDetection() override {
        release();
        place_bodies();
        const Bodies before = bodies_;
        firma::step(bodies_, level_, kStep, options_);
        for (const BodyContact& contact : bodies_.contacts) hand_over(before, contact);
    }

private:
    void place_bodies() {
        for (std::size_t k = 0; k < bullets_.size(); ++k) {
            Body& body = bodies_.slots[k];
            const btRigidBody& bullet = *bullets_[k];
            const btQuaternion turn = bullet.getWorldTransform().getRotation();
            const Quaternion ours{double(turn.x()), double(turn.y()), double(turn.z()), double(turn.w())};
            body.position = our_vector(bullet.getWorldTransform().getOrigin());
            body.rotation = normalised(compose(normalised(ours), turn_back(body.shape.axes())));
            body.velocity = our_vector(bullet.getLinearVelocity());
            body.spin = our_vector(bullet.getAngularVelocity());
        }
    }

    static Sphere sphere_of(const Bodies& bodies, std::uint32_t slot, std::uint32_t sphere) {
        const Body& body = bodies.slots[slot];
        const Sphere& own = body.shape.spheres()[sphere];
        return {body.position + matrix_of(normalised(body.rotation)) * (own.centre - body.shape.centre()), own.radius};
    }

    /// One manifold for each: Bullet's own hold four points at most.
    void hand_over(const Bodies& before, const BodyContact& contact) {
        const bool of_bodies = contact.other != ~0u;
        const Sphere sphere = sphere_of(before, contact.body, contact.sphere);
        Vec3 on_other = contact.point;
        if (of_bodies) {
            const Sphere other = sphere_of(before, contact.other, contact.other_sphere);
            on_other = other.centre + contact.normal * other.radius;
        }
        const Vec3 on_body = sphere.centre - contact.normal * sphere.radius;
        const double gap = dot(on_body - on_other, contact.normal);
        btRigidBody& body = *bullets_[contact.body];
        btRigidBody& other = of_bodies ? *bullets_[contact.other] : ground_;
        btManifoldPoint point(body.getWorldTransform().invXform(bullet_vector(on_body)),
                              other.getWorldTransform().invXform(bullet_vector(on_other)),
                              bullet_vector(contact.normal), btScalar(gap));
        point.m_positionWorldOnA = bullet_vector(on_body);
        point.m_positionWorldOnB = bullet_vector(on_other);
        point.m_combinedFriction = btScalar(0.6);
        point.m_appliedImpulse = btScalar(contact.force * kStep);  // Bullet's solver begins with it
        btPersistentManifold* manifold = dispatcher.getNewManifold(&body, &other);
        manifold->addManifoldPoint(point);
        manifolds_.push_back(manifold);
    }

    void release() {
        for (btPersistentManifold* manifold : manifolds_) dispatcher.releaseManifold(manifold);
        manifolds_.clear();
    }

    btEmptyShape no_shape_;
    btRigidBody ground_{btRigidBody::btRigidBodyConstructionInfo(0, nullptr, &no_shape_)};
    const World& level_;
    StepOptions options_;
    Bodies bodies_;
    std::vector<std::unique_ptr<btRigidBody>> bullets_;
    std::vector<btPersistentManifold*> manifolds_;
};

}  // namespace firma::test
