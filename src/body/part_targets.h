// SPDX-License-Identifier: MIT
// Parts that move as projectiles meet them: boxes around their ways in a step, in a tree.
#pragma once

#include <cstdint>
#include <vector>

#include "firma/moving_parts.h"
#include "index/box_tree.h"
#include "moving/part_frame.h"

namespace firma {

/// Metres a second: no projectile goes faster, and no point of a part. (Parts may go far in a step, but numbers end.)
inline constexpr double kMaxFlightSpeed = 0x1p20, kMaxPartSpeed = 0x1p60;

/// No point of a part goes faster than this in a scene's stretch that takes so many seconds, metres a second.
double fastest_of_part(const Scene& scene, const MovingPart& part, double seconds);

class PartTargets {
public:
    /// @param scene    usable; its stretch takes so many seconds
    PartTargets(const Scene& scene, double seconds);

    /// The first part on the way of a ray, from one time of the step to another; seconds. Of several at one fraction
    /// that of the lowest index.
    PartHit first(const Ray& ray, double from, double to, const CastOptions& options) const;

    /// Calls `function(part)` for each part whose box around its way holds a point, until it returns true, in no order.
    template <class Function>
    void for_each_near(const Vec3& point, const Function& function) const {
        const GridBox at = box_around_way(point, point);
        tree_.for_each_meeting(at, [&](std::uint32_t number) { return function(numbers_[number]); });
    }

    const MovingPart& operator[](std::uint32_t part) const { return scene_.parts[part]; }
    double seconds() const { return seconds_; }
    /// Where a part is at a time of the step.
    PartFrame frame(std::uint32_t part, double at) const {
        return PartFrame(scene_.parts[part].motion, fraction_at(at));
    }
    /// How fast a part is at a point at a time of the step, metres a second.
    Vec3 velocity(std::uint32_t part, double at, const Vec3& point) const;
    bool moves(std::uint32_t part) const {
        const RigidMotion& motion = scene_.parts[part].motion;
        return scene_.from < scene_.to && (turns(motion) || !(motion.path == Vec3{}));
    }
    bool turns_in_step(std::uint32_t part) const { return scene_.from < scene_.to && turns(scene_.parts[part].motion); }

private:
    double fraction_at(double at) const;
    /// In steps of kWaySteps, outward.
    static GridBox box_around_way(const Vec3& low, const Vec3& high);

    const Scene scene_;
    const double seconds_;
    const World nothing_{};
    std::vector<std::uint32_t> numbers_;  ///< of the parts in the tree
    BoxTree tree_;
};

}  // namespace firma
