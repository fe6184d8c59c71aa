// SPDX-License-Identifier: MIT
// FCL: spheres by conservative advancement over its distance(); it casts no rays. Its own, continuousCollide() with
// CCDC_CONSERVATIVE_ADVANCEMENT, finds nothing between a mesh and a sphere in 0.7.0, whatever the bounding volumes,
// motions and solvers; its default samples ten places along the path.
#include <fcl/fcl.h>

#include <cmath>

#include "scale/scale_peer.h"

namespace firma::bench {
namespace {

constexpr double kLeft = 1e-4;  // metres
constexpr int kMaxSteps = 1000;

class FclScalePeer final : public ScalePeer {
public:
    std::string describe() const override {
        return "FCL " FCL_VERSION
               "; conservative advancement over distance() until 0.1 mm are left, BVHModel<OBBRSS>, "
               "double; continuousCollide() finds nothing between a mesh and a sphere";
    }
    bool has(CastShape shape) const override { return shape == CastShape::kSphere; }

    void prepare(const ScaleScene& scene) override {
        const TriangleMesh& mesh = scene.mesh;
        for (std::size_t k = 0; k < mesh.positions.size(); k += 3)
            points_.emplace_back(mesh.positions[k], mesh.positions[k + 1], mesh.positions[k + 2]);
        for (std::size_t k = 0; k < mesh.corners.size(); k += 3)
            triangles_.emplace_back(mesh.corners[k], mesh.corners[k + 1], mesh.corners[k + 2]);
    }
    void build(const ScaleScene&) override {
        model_ = std::make_shared<fcl::BVHModel<fcl::OBBRSSd>>();
        model_->beginModel(int(triangles_.size()), int(points_.size()));
        model_->addSubModel(points_, triangles_);
        model_->endModel();
    }
    std::size_t own_bytes() const override { return std::size_t(model_->memUsage(0)); }

    void cast(CastShape, std::span<const FloatCast> casts, double* fractions) override {
        const fcl::Transform3d still = fcl::Transform3d::Identity();
        const fcl::DistanceRequestd request;
        for (std::size_t k = 0; k < casts.size(); ++k) {
            const FloatCast& c = casts[k];
            const fcl::Sphered sphere(c.radius);
            const fcl::Vector3d start(c.start[0], c.start[1], c.start[2]), path(c.path[0], c.path[1], c.path[2]);
            const double length = path.norm();
            fcl::Transform3d at = still;
            double fraction = 0;
            fractions[k] = kScaleMiss;
            for (int step = 0; step < kMaxSteps && fraction <= 1; ++step) {
                at.translation() = start + path * fraction;
                fcl::DistanceResultd result;
                const double left = fcl::distance(model_.get(), still, &sphere, at, request, result);
                if (left <= kLeft) {
                    fractions[k] = fraction;
                    break;
                }
                fraction += left / length;
            }
        }
    }

private:
    std::vector<fcl::Vector3d> points_;
    std::vector<fcl::Triangle> triangles_;
    std::shared_ptr<fcl::BVHModel<fcl::OBBRSSd>> model_;
};

}  // namespace

std::unique_ptr<ScalePeer> make_fcl_peer() {
    return std::make_unique<FclScalePeer>();
}

}  // namespace firma::bench
