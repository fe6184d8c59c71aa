// SPDX-License-Identifier: MIT
// Bullet: rays and spheres against its mesh shape, by what its world does for each object.
#include <BulletCollision/NarrowPhaseCollision/btRaycastCallback.h>
#include <btBulletCollisionCommon.h>

#include <algorithm>

#include "scale/scale_peer.h"

namespace firma::bench {
namespace {

btVector3 bullet_point(const float* p) {
    return {p[0], p[1], p[2]};
}

class BulletScalePeer final : public ScalePeer {
public:
    BulletScalePeer() { object_.setWorldTransform(btTransform::getIdentity()); }

    std::string describe() const override {
        return "Bullet " + std::to_string(btGetVersion() / 100) + "." + std::to_string(btGetVersion() % 100) +
               "; btCollisionWorld::rayTestSingle(), objectQuerySingle() on btBvhTriangleMeshShape, quantised (the "
               "default), mesh margin 0";
    }
    bool has(CastShape) const override { return true; }

    void build(const ScaleScene& scene) override {
        positions_ = scene.mesh.positions;
        corners_.assign(scene.mesh.corners.begin(), scene.mesh.corners.end());
        // Its quantised nodes number the triangles of a part with 21 bits.
        constexpr std::size_t kPart = std::size_t(1) << 20;
        for (std::size_t from = 0; from < scene.mesh.triangles(); from += kPart) {
            btIndexedMesh part;
            part.m_numTriangles = int(std::min(kPart, scene.mesh.triangles() - from));
            part.m_triangleIndexBase = reinterpret_cast<const unsigned char*>(corners_.data() + 3 * from);
            part.m_triangleIndexStride = 3 * sizeof(int);
            part.m_numVertices = int(positions_.size() / 3);
            part.m_vertexBase = reinterpret_cast<const unsigned char*>(positions_.data());
            part.m_vertexStride = 3 * sizeof(float);
            part.m_vertexType = PHY_FLOAT;
            arrays_.addIndexedMesh(part, PHY_INTEGER);
        }
        shape_ = std::make_unique<btBvhTriangleMeshShape>(&arrays_, true);
        shape_->setMargin(0);
        object_.setCollisionShape(shape_.get());
    }
    std::size_t own_bytes() const override {
        return shape_->getOptimizedBvh()->calculateSerializeBufferSize() + positions_.size() * sizeof(float) +
               corners_.size() * sizeof(int);
    }

    void cast(CastShape shape, std::span<const FloatCast> casts, double* fractions) override {
        const btTransform still = btTransform::getIdentity();
        btTransform from = still, to = still;
        btSphereShape sphere(1);
        for (std::size_t k = 0; k < casts.size(); ++k) {
            const btVector3 start = bullet_point(casts[k].start), end = start + bullet_point(casts[k].path);
            from.setOrigin(start);
            to.setOrigin(end);
            if (shape == CastShape::kRay) {
                btCollisionWorld::ClosestRayResultCallback hit(start, end);
                btCollisionWorld::rayTestSingle(from, to, &object_, shape_.get(), still, hit);
                fractions[k] = hit.hasHit() ? double(hit.m_closestHitFraction) : kScaleMiss;
            } else {
                sphere.setUnscaledRadius(casts[k].radius);
                btCollisionWorld::ClosestConvexResultCallback hit(start, end);
                btCollisionWorld::objectQuerySingle(&sphere, from, to, &object_, shape_.get(), still, hit, 0);
                fractions[k] = hit.hasHit() ? double(hit.m_closestHitFraction) : kScaleMiss;
            }
        }
    }

private:
    std::vector<float> positions_;
    std::vector<int> corners_;
    btTriangleIndexVertexArray arrays_;
    std::unique_ptr<btBvhTriangleMeshShape> shape_;
    btCollisionObject object_;
};

}  // namespace

std::unique_ptr<ScalePeer> make_bullet_peer() {
    return std::make_unique<BulletScalePeer>();
}

}  // namespace firma::bench
