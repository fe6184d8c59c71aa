// SPDX-License-Identifier: MIT
// The parts of a level that move, as a step sees them: where each is as it begins, and how it goes on.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "body/mover.h"
#include "firma/cast_set.h"
#include "firma/moving_parts.h"
#include "moving/part_frame.h"

namespace firma {

struct StepPart {
    const MovingPart& part;
    RigidMotion motion;  ///< of the step
    PartFrame frame;     ///< as the step begins
    /// Metres a second, of the frame's origin; radians a second.
    Vec3 velocity, spin;
    double way = 0;        ///< metres: no point of it goes farther in the step
    bool moves = false;    ///< within the step
    bool changed = false;  ///< it is not where the last step left it, or another solid, or it moves

    /// Of its surface, metres a second.
    /// @param at  seconds from the start of the step
    Vec3 velocity_of(const Vec3& point, double at) const {
        return velocity + cross(spin, point - (motion.position + velocity * at));
    }
    /// Whether a ball comes into a box around all of its way.
    bool may_meet(const Vec3& centre, double reach) const;
};

/// A touch of a set with a part.
struct StepPartHit : SetHit {
    std::uint32_t part = kNoPart;
};

class StepParts {
public:
    /// @param scene    usable
    /// @param seconds  of the step; the scene's stretch is as long
    StepParts(const Scene& scene, double seconds);

    bool empty() const { return parts_.empty(); }
    std::size_t size() const { return parts_.size(); }
    const StepPart& operator[](std::size_t k) const { return parts_[k]; }

    /// Says which have changed since, and puts what they are now in place of it.
    void compare(std::vector<std::uint64_t>& hashes);
    bool is_moving(std::uint32_t part) const { return part < parts_.size() && parts_[part].moves; }

    /// The first touch of a moving set with a part, between two fractions of the step; as cast() of a set and a
    /// world. Its own fractions are of the set's motion.
    /// @param left_out  a part that it cannot meet; kNoPart: none
    StepPartHit cast_set(std::span<const Sphere> spheres, const RigidMotion& motion, double from, double to,
                         std::uint32_t left_out, const CastOptions& options) const;

    struct Carried {
        RigidMotion motion;
        double to = 1;  ///< fraction of the step
    };
    /// Where something at rest on a part is taken, from a fraction of the step on: to its end, or as far as it goes
    /// straight within 0.1 mm.
    Carried carried(std::uint32_t part, const Vec3& position, const Quaternion& rotation, double from) const;

private:
    World nothing_;  ///< in place of the level
    double from_ = 0, to_ = 1, seconds_ = 0;
    std::vector<StepPart> parts_;
};

}  // namespace firma
