// SPDX-License-Identifier: MIT
// Casts through a level and the parts that move in it.
#include <algorithm>
#include <cmath>
#include <utility>

#include "cast/capsule_shape.h"
#include "cast/hull_shape.h"
#include "geometry/rounding.h"
#include "moving/arc.h"
#include "moving/cast_turning.h"
#include "world/invalid_hit.h"

namespace firma {

MovingPart::MovingPart(World world, const RigidMotion& moves)
    : motion(moves), world_(std::move(world)), bounds_(world_.bounds()) {}

void MovingPart::set_world(World world) {
    world_ = std::move(world);
    bounds_ = world_.bounds();
}

bool is_usable_part(const MovingPart& part) {
    const RigidMotion& motion = part.motion;
    return is_usable(motion) && length(motion.turn) <= kMaxPartTurn && max_abs(motion.position) <= kLargestNumber &&
           max_abs(motion.path) <= kLargestNumber;
}

bool is_usable_scene(const Scene& scene) {
    if (!(scene.from >= 0 && scene.from <= scene.to && scene.to <= 1)) return false;
    for (const MovingPart& part : scene.parts)
        if (!is_usable_part(part)) return false;
    return true;
}

namespace {

/// What a mover has to tell: where its middle is, a ball around it, its core, and how it is cast, here or in a frame.
struct MovingSphere {
    Sphere sphere;

    static constexpr bool kCanTurn = true;

    Vec3 middle() const { return sphere.centre; }
    double reach() const { return sphere.radius; }
    MoverCore core() const {
        MoverCore core(sphere.radius, middle(), reach());
        core.corner.add(sphere.centre);
        return core;
    }
    Hit through(const World& world, const Vec3& path, const CastOptions& options) const {
        return cast(world, sphere, path, options);
    }
    Hit through(const PartNow& part, const PartFrame& frame, const Vec3& path, const CastOptions& options) const {
        return cast(part.world(), {frame.in(sphere.centre), sphere.radius}, path, options);
    }
};

struct MovingCapsule {
    Capsule capsule;
    Sphere around = ball_around(capsule);

    static constexpr bool kCanTurn = true;
    explicit MovingCapsule(const Capsule& c) : capsule(c) {}
    Vec3 middle() const { return around.centre; }
    double reach() const { return around.radius; }
    MoverCore core() const {
        MoverCore core(capsule.radius, middle(), reach());
        core.corner.add(capsule.from);
        core.corner.add(capsule.to);
        return core;
    }
    Hit through(const World& world, const Vec3& path, const CastOptions& options) const {
        return cast(world, capsule, path, options);
    }
    Hit through(const PartNow& part, const PartFrame& frame, const Vec3& path, const CastOptions& options) const {
        return cast(part.world(), Capsule{frame.in(capsule.from), frame.in(capsule.to), capsule.radius}, path, options);
    }
};

struct MovingHull {
    const Hull& hull;
    Vec3 at;

    static constexpr bool kCanTurn = false;  ///< a hull turned is another, which takes memory

    Vec3 middle() const { return at; }
    double reach() const { return hull.valid() ? hull.shape()->reach : 0; }
    MoverCore core() const {
        MoverCore core(0, at, reach());
        for (const Vec3& corner : hull.corners()) core.corner.add(at + corner);
        return core;
    }
    Hit through(const World& world, const Vec3& path, const CastOptions& options) const {
        return cast(world, hull, at, path, options);
    }
    Hit through(const PartNow& part, const PartFrame& frame, const Vec3& path, const CastOptions& options) const {
        return cast(part.world(), hull, frame.in(at), path, options);
    }
};

PartHit refused(const Vec3& middle) {
    PartHit hit;
    static_cast<Hit&>(hit) = invalid_hit(middle);
    return hit;
}

/// Against a part that does not turn.
template <class Mover>
Hit cast_straight(const PartNow& part, const PartFrame& frame, const Mover& mover, const Vec3& path,
                  const CastOptions& options) {
    const Vec3 way = frame.direction_in(path - part.motion.path);
    Hit hit;
    hit.centre = mover.middle() + path;
    const Box box = box_around(part, mover.reach());
    if (box.empty()) return hit;
    const Vec3 start = frame.in(mover.middle());
    if (!is_finite(start) || !is_finite(way)) return invalid_hit(mover.middle());
    if (!clip_segment_box(start, way, box)) return hit;
    hit = mover.through(part, frame, way, options);
    hit.centre = mover.middle() + path * hit.fraction;
    if (!hit.touched()) return hit;
    hit.point = frame.out(hit.point) + part.motion.path * hit.fraction;
    hit.normal = frame.direction_out(hit.normal);
    hit.face_normal = frame.direction_out(hit.face_normal);
    return hit;
}

/// @param latest  a touch later than this fraction need not be found
template <class Mover>
Hit cast_part(const PartNow& part, const Mover& mover, const Vec3& path, double latest, const CastOptions& options) {
    if (!turns(part.motion)) {
        const PartFrame frame(part.motion, 0);
        if (Mover::kCanTurn || !frame.turned) return cast_straight(part, frame, mover, path, options);
    }
    return cast_turning(part, mover.core(), path, latest, options);
}

/// Whether a part is beyond all that a mover reaches, wherever in its motion it is: told by balls around both, far
/// beyond rounding. Large numbers are left to the casts, which say what is wrong with them.
bool is_far(const MovingPart& part, const Vec3& middle, double reach, double way) {
    constexpr double kFar = 0x1p20, kMore = 0x1p-10;  // metres
    const Vec3 apart = middle - part.motion.position;
    const double distance = length(apart);
    if (!(distance < kFar)) return false;
    Vec3 corner;
    for (int axis = 0; axis < 3; ++axis)
        corner[axis] = std::max(std::fabs(part.bounds().low[axis]), std::fabs(part.bounds().high[axis]));
    return distance > length(corner) + length(part.motion.path) + reach + way + kMore;
}

/// What is met first, or anything at all.
template <class Mover>
PartHit cast_scene(const Scene& scene, const Mover& mover, const Vec3& path, const CastOptions& options, bool any) {
    PartHit first;
    static_cast<Hit&>(first) = mover.through(scene.world, path, options);
    if (first.status == Status::kInvalid) return first;
    if (!is_usable_scene(scene)) return refused(mover.middle());
    CastOptions of_part = options;
    of_part.room = kAnyRoom;
    of_part.trail = nullptr;
    const Vec3 middle = mover.middle();
    const double reach = mover.reach(), way = length(path);
    for (std::size_t k = 0; k < scene.parts.size(); ++k) {
        if (first.touched() && (any || first.fraction == 0)) break;
        if (!(scene.parts[k].mask & options.mask) || is_far(scene.parts[k], middle, reach, way)) continue;
        const PartNow part(scene, scene.parts[k]);
        const Hit hit = cast_part(part, mover, path, first.fraction, of_part);
        if (hit.status == Status::kInvalid) return refused(mover.middle());
        if (!hit.touched() || (first.touched() && !(hit.fraction < first.fraction))) continue;
        static_cast<Hit&>(first) = hit;
        first.part = std::uint32_t(k);
        first.surface_velocity = velocity_at(part.motion, hit.fraction, hit.point);
    }
    return first;
}

}  // namespace

PartHit cast(const Scene& scene, const Sphere& sphere, const Vec3& path, const CastOptions& options) {
    return cast_scene(scene, MovingSphere{sphere}, path, options, false);
}

PartHit cast(const Scene& scene, const Capsule& capsule, const Vec3& path, const CastOptions& options) {
    return cast_scene(scene, MovingCapsule(capsule), path, options, false);
}

PartHit cast(const Scene& scene, const Hull& hull, const Vec3& at, const Vec3& path, const CastOptions& options) {
    return cast_scene(scene, MovingHull{hull, at}, path, options, false);
}

Status cast_any(const Scene& scene, const Sphere& sphere, const Vec3& path, const CastOptions& options) {
    return cast_scene(scene, MovingSphere{sphere}, path, options, true).status;
}

Status cast_any(const Scene& scene, const Capsule& capsule, const Vec3& path, const CastOptions& options) {
    return cast_scene(scene, MovingCapsule(capsule), path, options, true).status;
}

Status cast_any(const Scene& scene, const Hull& hull, const Vec3& at, const Vec3& path, const CastOptions& options) {
    return cast_scene(scene, MovingHull{hull, at}, path, options, true).status;
}

}  // namespace firma
