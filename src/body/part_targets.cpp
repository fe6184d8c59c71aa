// SPDX-License-Identifier: MIT
// Rays against parts that move.
#include "body/part_targets.h"

#include <algorithm>
#include <cmath>

#include "cast/sweep.h"
#include "index/sweep_box.h"

namespace firma {
namespace {

/// A metre has so many steps of the tree's boxes: 32 bits hold all of what projectiles reach.
constexpr double kWaySteps = 64;
struct WayBox {
    double low[3], high[3];  ///< metres
};

/// Metres, and of a length: far above rounding.
constexpr double kWayMargin = 0x1p-10, kWayRounding = 0x1p-30;

double way_radius(const Box& box) {
    Vec3 far;
    for (int axis = 0; axis < 3; ++axis) far[axis] = std::max(std::fabs(box.low[axis]), std::fabs(box.high[axis]));
    return length(far);
}

/// Around all places of a part in the scene's stretch, metres.
Box box_of_way(const Scene& scene, const MovingPart& part) {
    const RigidMotion motion = motion_between(part.motion, scene.from, scene.to);
    const PartFrame frame(motion, 0);
    Box way;
    if (turns(motion)) {
        const double radius = way_radius(part.bounds());
        way = {frame.position - Vec3{radius, radius, radius}, frame.position + Vec3{radius, radius, radius}};
    } else {
        for (int k = 0; k < 8; ++k) {
            Vec3 corner;
            for (int axis = 0; axis < 3; ++axis)
                corner[axis] = k >> axis & 1 ? part.bounds().high[axis] : part.bounds().low[axis];
            way.add(frame.out(corner));
        }
    }
    const Box begin = way;
    way.add(begin.low + motion.path);
    way.add(begin.high + motion.path);
    const double more = kWayMargin + kWayRounding * (max_abs(way.low) + max_abs(way.high));
    return {way.low - Vec3{more, more, more}, way.high + Vec3{more, more, more}};
}

}  // namespace

double fastest_of_part(const Scene& scene, const MovingPart& part, double seconds) {
    if (part.bounds().empty()) return 0;
    const double way = length(part.motion.path) + length(part.motion.turn) * way_radius(part.bounds());
    return way * (scene.to - scene.from) / seconds;
}

GridBox PartTargets::box_around_way(const Vec3& low, const Vec3& high) {
    const auto step = [](double at) { return std::int32_t(std::clamp(at, double(INT32_MIN), double(INT32_MAX))); };
    GridBox box;
    for (int axis = 0; axis < 3; ++axis) {
        box.low[axis] = step(std::floor(low[axis] * kWaySteps));
        box.high[axis] = step(std::ceil(high[axis] * kWaySteps));
    }
    return box;
}

PartTargets::PartTargets(const Scene& scene, double seconds) : scene_(scene), seconds_(seconds) {
    std::vector<GridBox> boxes;
    for (std::uint32_t k = 0; k < scene.parts.size(); ++k) {
        if (scene.parts[k].bounds().empty()) continue;
        const Box way = box_of_way(scene, scene.parts[k]);
        numbers_.push_back(k);
        boxes.push_back(box_around_way(way.low, way.high));
    }
    tree_ = BoxTree(boxes);
}

double PartTargets::fraction_at(double at) const {
    if (at >= seconds_) return scene_.to;
    return std::min(scene_.from + (scene_.to - scene_.from) * (at / seconds_), scene_.to);
}

Vec3 PartTargets::velocity(std::uint32_t part, double at, const Vec3& point) const {
    Vec3 velocity = velocity_at(scene_.parts[part].motion, fraction_at(at), point) * (scene_.to - scene_.from);
    for (int axis = 0; axis < 3; ++axis) velocity[axis] /= seconds_;
    return velocity;
}

PartHit PartTargets::first(const Ray& ray, double from, double to, const CastOptions& options) const {
    PartHit first;
    const double begin = fraction_at(from), end = std::max(begin, fraction_at(to));
    const auto cast_at = [&](std::uint32_t number) {
        const std::uint32_t part = numbers_[number];
        PartHit hit = cast(Scene{nothing_, scene_.parts.subspan(part, 1), begin, end}, ray, options);
        hit.part = part;
        if (!hit.touched()) return false;
        if (!first.touched() || hit.fraction < first.fraction || (hit.fraction == first.fraction && part < first.part))
            first = hit;
        return false;
    };
    Sweep sweep;
    if (make_sweep({ray.start, 0}, ray.path, sweep) != Status::kHit) {  // it stands: parts may come
        tree_.for_each_meeting(box_around_way(ray.start, ray.start), cast_at);
        return first;
    }
    const SweepBox boxes(sweep);
    constexpr double kWayStep = 1 / kWaySteps;
    const auto meets = [&](const GridBox& box) {
        double nearest;
        const WayBox metres{{box.low.x * kWayStep, box.low.y * kWayStep, box.low.z * kWayStep},
                            {box.high.x * kWayStep, box.high.y * kWayStep, box.high.z * kWayStep}};
        return boxes.enters(metres, sweep.end, nearest);
    };
    tree_.for_each_where(meets, cast_at);
    return first;
}

}  // namespace firma
