// SPDX-License-Identifier: MIT
// Bullet: compounds of spheres on its mesh shape, with its continuous collision detection on.
#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <cmath>

#include "bodies/body_peer.h"
#include "body/body_shape.h"
#include "body/mover.h"

extern btScalar gDeactivationTime;  // of Bullet

namespace firma::bench {
namespace {

btVector3 bullet_vector(const Vec3& v) {
    return {btScalar(v.x), btScalar(v.y), btScalar(v.z)};
}
Vec3 our_vector(const btVector3& v) {
    return {double(v.x()), double(v.y()), double(v.z())};
}
btQuaternion bullet_turn(const Quaternion& q) {
    return {btScalar(q[0]), btScalar(q[1]), btScalar(q[2]), btScalar(q[3])};
}
Quaternion our_turn(const btQuaternion& q) {
    return {double(q.x()), double(q.y()), double(q.z()), double(q.w())};
}

/// Metres: what Bullet keeps meshes away by unless it is told otherwise (CONVEX_DISTANCE_MARGIN).
constexpr double kUsualMargin = 0.04;

class BulletBodies final : public BodyPeer {
public:
    explicit BulletBodies(double margin) : margin_(margin) {}
    std::string name() const override { return margin_ > 0 ? "Bullet, its margin" : "Bullet"; }
    std::string describe() const override {
        return name() + " " + std::to_string(btGetVersion() / 100) + "." + std::to_string(btGetVersion() % 100) +
               ": btCompoundShape of spheres, btBvhTriangleMeshShape of margin " + std::to_string(margin_) +
               ", steps of 1/240 s, 10 iterations "
               "(the default), continuous collision detection from the radius of the thinnest sphere on";
    }

    void start(const BodyScene& scene) override {
        gDeactivationTime = btScalar(StepOptions().sleep_after);
        world_.setGravity(bullet_vector(StepOptions().gravity));
        add_ground(scene.world);
        for (const Body& body : scene.bodies) add(body);
    }
    void step() override { world_.stepSimulation(btScalar(1.0 / 60), 4, btScalar(1.0 / 240)); }

    void read(std::vector<Body>& bodies) const override {
        for (std::size_t k = 0; k < bodies.size(); ++k) {
            Body& body = bodies[k];
            const btRigidBody& own = *bodies_[k];
            body.position = our_vector(own.getWorldTransform().getOrigin());
            body.rotation =
                normalised(compose(our_turn(own.getWorldTransform().getRotation()), turn_back(body.shape.axes())));
            body.velocity = our_vector(own.getLinearVelocity());
            body.spin = our_vector(own.getAngularVelocity());
            body.asleep = !own.isActive();
        }
    }

    ~BulletBodies() override {
        for (const auto& body : bodies_) world_.removeRigidBody(body.get());
        if (ground_) world_.removeRigidBody(ground_.get());
    }

private:
    void add_ground(const World& world) {
        for (const Face& face : world.faces())
            for (std::size_t k = 2; face.solid && k < face.corners.size(); ++k)
                mesh_.addTriangle(bullet_vector(face.corners[0]), bullet_vector(face.corners[k - 1]),
                                  bullet_vector(face.corners[k]));
        mesh_shape_ = std::make_unique<btBvhTriangleMeshShape>(&mesh_, true);
        mesh_shape_->setMargin(btScalar(margin_));
        btRigidBody::btRigidBodyConstructionInfo info(0, nullptr, mesh_shape_.get());
        info.m_friction = btScalar(std::sqrt(StepOptions().contact_friction));
        info.m_restitution = 1;  // it takes the product of two
        ground_ = std::make_unique<btRigidBody>(info);
        world_.addRigidBody(ground_.get());
    }

    void add(const Body& body) {
        const BodyShapeData& data = body.shape.data();
        auto compound = std::make_unique<btCompoundShape>();
        for (const Sphere& sphere : data.spheres) {
            spheres_.push_back(std::make_unique<btSphereShape>(btScalar(sphere.radius)));
            btTransform place = btTransform::getIdentity();
            place.setOrigin(bullet_vector(sphere.centre));
            compound->addChildShape(place, spheres_.back().get());
        }
        btRigidBody::btRigidBodyConstructionInfo info(btScalar(data.mass), nullptr, compound.get(),
                                                      bullet_vector(data.moments));
        info.m_friction = btScalar(std::sqrt(body.friction));
        info.m_restitution = btScalar(body.restitution);
        info.m_rollingFriction = btScalar(body.rolling * data.thinnest);
        info.m_linearSleepingThreshold = btScalar(StepOptions().sleep_speed);
        info.m_angularSleepingThreshold = btScalar(StepOptions().sleep_speed / std::max(data.reach, 0.05));
        info.m_startWorldTransform = btTransform(bullet_turn(principal_rotation(body)), bullet_vector(body.position));
        auto own = std::make_unique<btRigidBody>(info);
        own->setLinearVelocity(bullet_vector(body.velocity));
        own->setAngularVelocity(bullet_vector(body.spin));
        own->setCcdMotionThreshold(btScalar(data.thinnest));
        own->setCcdSweptSphereRadius(btScalar(data.thinnest * 0.9));
        world_.addRigidBody(own.get());
        compounds_.push_back(std::move(compound));
        bodies_.push_back(std::move(own));
    }

    const double margin_;  ///< of the mesh, metres
    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver solver_;
    btDiscreteDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
    btTriangleMesh mesh_;
    std::unique_ptr<btBvhTriangleMeshShape> mesh_shape_;
    std::unique_ptr<btRigidBody> ground_;
    std::vector<std::unique_ptr<btSphereShape>> spheres_;
    std::vector<std::unique_ptr<btCompoundShape>> compounds_;
    std::vector<std::unique_ptr<btRigidBody>> bodies_;
};

}  // namespace

std::unique_ptr<BodyPeer> make_bullet_bodies() {
    return std::make_unique<BulletBodies>(0);
}
std::unique_ptr<BodyPeer> make_bullet_bodies_with_margin() {
    return std::make_unique<BulletBodies>(kUsualMargin);
}

}  // namespace firma::bench
