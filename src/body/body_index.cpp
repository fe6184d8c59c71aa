// SPDX-License-Identifier: MIT
// Casts at bodies: those near the way by a tree of their boxes, then set against set.
#include "firma/body_index.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "body/body_shape.h"
#include "body/mover.h"
#include "body/sound_body.h"
#include "body/target_box.h"
#include "firma/cast_set.h"
#include "index/box_tree.h"
#include "moving/arc.h"

namespace firma {

struct BodyIndex::Data {
    struct Entry {
        BodyId id;
        BodyShape shape;
        std::uint32_t mask = 0;
        RigidMotion motion;  ///< of its principal axes
        Vec3 velocity, spin;
    };
    std::vector<Entry> entries;
    BoxTree tree;
};

namespace {

GridBox box_of_way(const Vec3& start, const Vec3& path, double reach) {
    GridBox box = target_box(start, reach);
    box.add(target_box(start + path, reach));
    return box;
}

BodyHit invalid_hit() {
    BodyHit hit;
    hit.status = Status::kInvalid;
    hit.fraction = hit.safe_fraction = 0;
    return hit;
}

/// Of a sphere of a set that moves.
Vec3 velocity_of(const RigidMotion& motion, const Vec3& centre, double fraction) {
    const TurnMatrix rotation = matrix_of(normalised(motion.rotation));
    return Arc(motion.position, motion.path, TurnRate(motion.turn), rotation * centre).velocity_at(fraction);
}

double safe_fraction(double fraction, double speed, double offset) {
    if (!(is_finite(offset) && offset > 0)) return fraction;
    const double back = speed > 0 ? offset / speed : 1;
    return back < fraction ? fraction - back : 0;
}

}  // namespace

BodyIndex::BodyIndex(const Bodies& bodies, double seconds) {
    auto data = std::make_shared<Data>();
    const double time = is_finite(seconds) && seconds > 0 ? seconds : 0;
    std::vector<GridBox> boxes;
    for (std::uint32_t slot = 0; slot < bodies.slots.size(); ++slot) {
        const Body& body = bodies.slots[slot];
        if (!body.shape.valid() || !is_sound(body)) continue;
        const double moves = body.asleep ? 0 : time;
        const RigidMotion motion{body.position, principal_rotation(body), body.velocity * moves, body.spin * moves};
        if (!is_usable(motion)) continue;
        data->entries.push_back({{slot, body.use}, body.shape, body.mask, motion, body.velocity, body.spin});
        boxes.push_back(box_of_way(motion.position, motion.path, body.shape.reach()));
    }
    data->tree = BoxTree(boxes);
    data_ = std::move(data);
}

BodyHit BodyIndex::cast(std::span<const Sphere> spheres, const RigidMotion& motion,
                        const BodyCastOptions& options) const {
    if (!is_usable(motion)) return invalid_hit();
    double reach = 0;
    for (const Sphere& sphere : spheres) {
        if (!is_finite(sphere.centre) || !is_finite(sphere.radius) || sphere.radius < 0) return invalid_hit();
        reach = std::max(reach, length(sphere.centre) + sphere.radius);
    }
    BodyHit first;
    data_->tree.for_each_meeting(box_of_way(motion.position, motion.path, reach), [&](std::uint32_t number) {
        const Data::Entry& entry = data_->entries[number];
        if (!(entry.mask & options.mask) || entry.id == options.except) return false;
        const SetPairHit hit = firma::cast(spheres, motion, entry.shape.data().spheres, entry.motion);
        if (!hit.touched()) return false;
        const bool sooner = !first.touched() || hit.fraction < first.fraction ||
                            (hit.fraction == first.fraction && entry.id.slot < first.body.slot);
        if (!sooner) return false;
        first.status = hit.status;
        first.fraction = hit.fraction;
        first.body = entry.id;
        first.body_sphere = hit.sphere_b;
        first.sphere = hit.sphere_a;
        first.point = hit.point;
        first.normal = hit.normal;
        const Vec3& met = entry.shape.data().spheres[hit.sphere_b].centre;
        const Vec3 comes = velocity_of(motion, spheres[hit.sphere_a].centre, hit.fraction) -
                           velocity_of(entry.motion, met, hit.fraction);
        first.safe_fraction = safe_fraction(hit.fraction, -dot(comes, hit.normal), options.contact_offset);
        const Vec3 middle = entry.motion.position + entry.motion.path * hit.fraction;
        first.surface_velocity = entry.velocity + cross(entry.spin, hit.point - middle);
        return false;
    });
    if (!first.touched()) return first;
    const Pose pose = pose_at(motion, first.fraction);
    first.centre = pose.position + matrix_of(normalised(pose.rotation)) * spheres[first.sphere].centre;
    return first;
}

BodyHit BodyIndex::cast(const Sphere& sphere, const Vec3& path, const BodyCastOptions& options) const {
    if (!is_finite(sphere.centre)) return invalid_hit();
    const Sphere here{{}, sphere.radius};
    return cast({&here, 1}, {sphere.centre, {0, 0, 0, 1}, path, {}}, options);
}

BodyHit BodyIndex::cast(const Ray& ray, const BodyCastOptions& options) const {
    return cast(Sphere{ray.start, 0}, ray.path, options);
}

}  // namespace firma
