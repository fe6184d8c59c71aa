// SPDX-License-Identifier: MIT
// Rays against bodies.
#include "body/body_targets.h"

#include "body/body_shape.h"
#include "body/first_within.h"
#include "body/mover.h"
#include "body/target_box.h"
#include "index/sweep_box.h"
#include "world/sweep_world.h"

namespace firma {

BodyTargets::BodyTargets(const Bodies& bodies) {
    std::vector<GridBox> boxes;
    for (std::uint32_t slot = 0; slot < bodies.slots.size(); ++slot) {
        const Body& body = bodies.slots[slot];
        if (!body.shape.valid() || !is_finite(body.position)) continue;
        targets_.push_back({body.position, matrix_of(principal_rotation(body)), &body, slot});
        boxes.push_back(target_box(body.position, body.shape.reach()));
    }
    tree_ = BoxTree(boxes);
}

BodyMet BodyTargets::first(const Ray& ray, std::uint32_t mask) const {
    BodyMet met;
    Sweep sweep;
    if (make_sweep({ray.start, 0}, ray.path, sweep) != Status::kHit) return met;
    const SweepBox boxes(sweep);
    const auto meets = [&](const GridBox& box) {
        const Vec3 low = to_metres(box.low) * (kSurfaceSteps / kTargetSteps);
        const Vec3 high = to_metres(box.high) * (kSurfaceSteps / kTargetSteps);
        double nearest;
        return boxes.enters(BoxD{{low.x, low.y, low.z}, {high.x, high.y, high.z}}, sweep.end, nearest);
    };
    tree_.for_each_where(meets, [&](std::uint32_t number) {
        const Target& target = targets_[number];
        if (!(target.body->mask & mask)) return false;
        for (const Sphere& sphere : target.body->shape.data().spheres) {
            const Vec3 centre = target.position + target.matrix * sphere.centre;
            const double t = first_within(ray.start - centre, ray.path, sphere.radius);
            if (t > 1 || t > met.fraction || (t == met.fraction && target.slot >= met.slot)) continue;
            const Vec3 apart = ray.start + ray.path * t - centre;
            const double distance = length(apart);
            met = {t, target.slot, ray.start + ray.path * t,
                   distance > 0 ? apart * (1 / distance) : ray.path * (-1 / length(ray.path))};
        }
        return false;
    });
    return met;
}

}  // namespace firma
