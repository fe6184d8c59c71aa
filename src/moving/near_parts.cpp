// SPDX-License-Identifier: MIT
// What is overlapped, and what is nearest, of a level and the parts that move in it, at a fraction of their motions.
#include "cast/capsule_shape.h"
#include "cast/hull_shape.h"
#include "moving/turned_hull.h"

namespace firma {
namespace {

bool is_fraction(double fraction) {
    return fraction >= 0 && fraction <= 1;
}

bool box_holds(const Box& box, const Vec3& p) {
    for (int axis = 0; axis < 3; ++axis)
        if (!(p[axis] >= box.low[axis] && p[axis] <= box.high[axis])) return false;
    return true;
}

/// From the part's frame to the world.
void put_out(const PartFrame& frame, const PartNow& part, double fraction, std::size_t index, PartOverlap& overlap) {
    overlap.point = frame.out(overlap.point);
    overlap.direction = frame.direction_out(overlap.direction);
    overlap.part = std::uint32_t(index);
    overlap.surface_velocity = velocity_at(part.motion, fraction, overlap.point);
}

/// @param in_level  asks the level: in_level(visit, options)
/// @param in_part   asks a part in its frame: in_part(part, frame, visit, options) returns whether to go on
template <class InLevel, class InPart>
Status overlap_scene(const Scene& scene, const Vec3& middle, double reach, PartOverlapVisitor visit, double fraction,
                     const NearOptions& options, const InLevel& in_level, const InPart& in_part) {
    if (!is_fraction(fraction) || !is_usable_scene(scene)) return Status::kInvalid;
    bool any = false, goes_on = true;
    const Status level = in_level(
        [&](const Overlap& found) {
            PartOverlap overlap;
            static_cast<Overlap&>(overlap) = found;
            any = true;
            return goes_on = visit(overlap);
        },
        options);
    if (level == Status::kInvalid) return level;
    NearOptions of_part = options;
    of_part.room = kAnyRoom;
    for (std::size_t k = 0; k < scene.parts.size() && goes_on; ++k) {
        if (!(scene.parts[k].mask & options.mask)) continue;
        const PartNow part(scene, scene.parts[k]);
        const PartFrame frame(part.motion, fraction);
        if (!box_holds(box_around(part, reach), frame.in(middle))) continue;
        in_part(
            part, frame,
            [&](const Overlap& found) {
                PartOverlap overlap;
                static_cast<Overlap&>(overlap) = found;
                put_out(frame, part, fraction, k, overlap);
                any = true;
                return goes_on = visit(overlap);
            },
            of_part);
    }
    return any ? Status::kInitialOverlap : Status::kMiss;
}

}  // namespace

Status overlap_each(const Scene& scene, const Sphere& sphere, PartOverlapVisitor visit, double fraction,
                    const NearOptions& options) {
    return overlap_scene(
        scene, sphere.centre, sphere.radius, visit, fraction, options,
        [&](OverlapVisitor found, const NearOptions& near) { return overlap_each(scene.world, sphere, found, near); },
        [&](const PartNow& part, const PartFrame& frame, OverlapVisitor found, const NearOptions& near) {
            overlap_each(part.world(), Sphere{frame.in(sphere.centre), sphere.radius}, found, near);
        });
}

Status overlap_each(const Scene& scene, const Capsule& capsule, PartOverlapVisitor visit, double fraction,
                    const NearOptions& options) {
    const Sphere around = ball_around(capsule);
    return overlap_scene(
        scene, around.centre, around.radius, visit, fraction, options,
        [&](OverlapVisitor found, const NearOptions& near) { return overlap_each(scene.world, capsule, found, near); },
        [&](const PartNow& part, const PartFrame& frame, OverlapVisitor found, const NearOptions& near) {
            const Capsule there{frame.in(capsule.from), frame.in(capsule.to), capsule.radius};
            overlap_each(part.world(), there, found, near);
        });
}

Status overlap_each(const Scene& scene, const Hull& hull, const Vec3& at, PartOverlapVisitor visit, double fraction,
                    const NearOptions& options) {
    if (!hull.valid()) return Status::kInvalid;
    return overlap_scene(
        scene, at, hull.shape()->reach, visit, fraction, options,
        [&](OverlapVisitor found, const NearOptions& near) { return overlap_each(scene.world, hull, at, found, near); },
        [&](const PartNow& part, const PartFrame& frame, OverlapVisitor found, const NearOptions& near) {
            if (frame.turned)
                TurnedHull(frame, hull, at).overlap_each(part.part, near, found);
            else
                overlap_each(part.world(), hull, frame.in(at), found, near);
        });
}

PartNear closest(const Scene& scene, const Vec3& point, double reach, double fraction, const NearOptions& options) {
    PartNear best;
    if (!is_fraction(fraction) || !is_usable_scene(scene)) {
        best.status = Status::kInvalid;
        return best;
    }
    static_cast<NearFace&>(best) = closest(scene.world, point, reach, options);
    if (best.status == Status::kInvalid) return best;
    NearOptions of_part = options;
    of_part.room = kAnyRoom;
    for (std::size_t k = 0; k < scene.parts.size(); ++k) {
        if (!(scene.parts[k].mask & options.mask)) continue;
        const PartNow part(scene, scene.parts[k]);
        const PartFrame frame(part.motion, fraction);
        const NearFace near = closest(part.world(), frame.in(point), best ? best.distance : reach, of_part);
        if (!near || (best && !(near.distance < best.distance))) continue;
        static_cast<NearFace&>(best) = near;
        best.point = frame.out(near.point);
        best.part = std::uint32_t(k);
        best.surface_velocity = velocity_at(part.motion, fraction, best.point);
    }
    return best;
}

}  // namespace firma
