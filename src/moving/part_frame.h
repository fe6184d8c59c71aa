// SPDX-License-Identifier: MIT
// From the world to the frame of a part and back.
#pragma once

#include <cmath>
#include <span>

#include "firma/motion.h"
#include "firma/moving_parts.h"
#include "moving/corner_list.h"

namespace firma {

/// Where a part is at a time.
struct PartFrame {
    Vec3 position;
    TurnMatrix rotation;
    bool turned = false;  ///< false: the rotation is none, exactly

    PartFrame(const RigidMotion& motion, double fraction) {
        const Pose pose = pose_at(motion, fraction);
        position = pose.position;
        turned = pose.rotation != Quaternion{0, 0, 0, 1};
        if (turned) rotation = matrix_of(pose.rotation);
    }

    Vec3 direction_in(const Vec3& v) const { return turned ? rotation.back(v) : v; }
    Vec3 direction_out(const Vec3& v) const { return turned ? rotation * v : v; }
    Vec3 in(const Vec3& p) const { return direction_in(p - position); }
    Vec3 out(const Vec3& p) const { return position + direction_out(p); }
};

/// Whether a part turns during its motion.
inline bool turns(const RigidMotion& motion) {
    return !(motion.turn == Vec3{});
}

/// Whether a part's motion can be worked with.
bool is_usable_part(const MovingPart& part);

/// A part in the stretch of its motion that is asked about.
struct PartNow {
    const MovingPart& part;
    RigidMotion motion;

    PartNow(const Scene& scene, const MovingPart& of)
        : part(of), motion(motion_between(of.motion, scene.from, scene.to)) {}
    const World& world() const { return part.world(); }
    const Box& bounds() const { return part.bounds(); }
};

/// Whether all parts' motions, and the stretch of them, can be worked with.
bool is_usable_scene(const Scene& scene);

/// A box around all of a part's solid and what is nearer than `reach` to it, in its frame; empty for no solid.
inline Box box_around(const PartNow& part, double reach) {
    Box box = part.bounds();
    if (box.empty()) return box;
    // Far above the rounding of places within reach of the world.
    const double more = reach * (1 + 0x1p-30) + 0x1p-16;
    box.low = box.low - Vec3{more, more, more};
    box.high = box.high + Vec3{more, more, more};
    return box;
}

/// A mover, whichever it is, as far as parts that turn are concerned: the hull of corners, and all within a radius.
struct MoverCore {
    CornerList corner;  ///< in the world, at the start
    double radius = 0;
    Vec3 middle;       ///< Hit::centre at the start
    double reach = 0;  ///< no point of it is farther from the middle

    MoverCore(double r, const Vec3& at, double far) : radius(r), middle(at), reach(far) {}
};

}  // namespace firma
