// SPDX-License-Identifier: MIT
// Chunks as bodies of Bullet: a compound of the hulls of their convex pieces, on the triangles of a world.
#pragma once

#include <btBulletDynamicsCommon.h>

#include <memory>
#include <vector>

#include "firma/chunk.h"
#include "firma/convex_pieces.h"
#include "firma/world.h"
#include "tests/bullet/bullet_vector.h"

namespace firma::test {

/// Metres: bodies rest so far apart, and are pushed out while they are nearer.
inline constexpr double kBulletMargin = 0.01;

/// A dynamic body with what it is made of.
struct BulletChunk {
    std::vector<std::unique_ptr<btConvexHullShape>> hulls;
    btCompoundShape compound;
    std::unique_ptr<btRigidBody> body;
    btTransform frame;  ///< of the chunk, in the body's own frame

    /// A point of the chunk, where it is now.
    [[nodiscard]] Vec3 place(const Vec3& point) const {
        return our_vector(body->getWorldTransform() * (frame * bullet_vector(point)));
    }
};

/// Bullet's bodies lie in their centre of mass and along their principal axes: the chunk is put at rest where it was.
inline std::unique_ptr<BulletChunk> make_bullet_chunk(const Chunk& chunk, const ConvexPieces& pieces) {
    auto made = std::make_unique<BulletChunk>();
    const std::array<Vec3, 3>& rows = chunk.mass.inertia;
    btMatrix3x3 inertia(btScalar(rows[0].x), btScalar(rows[0].y), btScalar(rows[0].z), btScalar(rows[1].x),
                        btScalar(rows[1].y), btScalar(rows[1].z), btScalar(rows[2].x), btScalar(rows[2].y),
                        btScalar(rows[2].z));
    btMatrix3x3 axes;
    inertia.diagonalize(axes, btScalar(1e-6), 32);
    const btTransform principal(axes, bullet_vector(chunk.mass.centre));
    made->frame = principal.inverse();
    for (const ConvexBody& piece : pieces.pieces) {
        auto hull = std::make_unique<btConvexHullShape>();
        for (const Vec3& corner : piece.corners) hull->addPoint(bullet_vector(corner), false);
        hull->recalcLocalAabb();
        hull->setMargin(btScalar(kBulletMargin));
        made->compound.addChildShape(made->frame, hull.get());
        made->hulls.push_back(std::move(hull));
    }
    const btVector3 moments(inertia[0][0], inertia[1][1], inertia[2][2]);
    btRigidBody::btRigidBodyConstructionInfo info(btScalar(chunk.mass.mass), nullptr, &made->compound, moments);
    info.m_friction = btScalar(0.7);
    info.m_startWorldTransform = btTransform(axes, bullet_vector(chunk.origin + chunk.mass.centre));
    made->body = std::make_unique<btRigidBody>(info);
    return made;
}

/// A world's triangles as ground, and chunks that fall on it.
class BulletScene {
public:
    explicit BulletScene(const World& world) {
        for (const Face& face : world.faces())
            for (std::size_t k = 2; face.solid && k < face.corners.size(); ++k)
                mesh_.addTriangle(bullet_vector(face.corners[0]), bullet_vector(face.corners[k - 1]),
                                  bullet_vector(face.corners[k]));
        ground_shape_ = std::make_unique<btBvhTriangleMeshShape>(&mesh_, true);
        ground_shape_->setMargin(btScalar(kBulletMargin));
        btRigidBody::btRigidBodyConstructionInfo info(0, nullptr, ground_shape_.get());
        info.m_friction = btScalar(0.7);
        ground_ = std::make_unique<btRigidBody>(info);
        world_.setGravity({0, 0, btScalar(-9.81)});
        world_.addRigidBody(ground_.get());
    }
    ~BulletScene() {
        for (const auto& chunk : chunks_) world_.removeRigidBody(chunk->body.get());
        world_.removeRigidBody(ground_.get());
    }

    void add(const Chunk& chunk, const ConvexPieces& pieces) {
        chunks_.push_back(make_bullet_chunk(chunk, pieces));
        world_.addRigidBody(chunks_.back()->body.get());
    }
    void step() { world_.stepSimulation(btScalar(1.0 / 60), 4, btScalar(1.0 / 240)); }
    [[nodiscard]] const std::vector<std::unique_ptr<BulletChunk>>& chunks() const { return chunks_; }

private:
    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver solver_;
    btDiscreteDynamicsWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
    btTriangleMesh mesh_;
    std::unique_ptr<btBvhTriangleMeshShape> ground_shape_;
    std::unique_ptr<btRigidBody> ground_;
    std::vector<std::unique_ptr<BulletChunk>> chunks_;
};

}  // namespace firma::test
