// SPDX-License-Identifier: MIT
// A lift and a leaf by swings of their paths.
#include "tests/reference/parts_near.h"

#include <cmath>
#include <string>

#include "firma/brush_world.h"
#include "tests/brush/map_text.h"

namespace firma::reference {
namespace {

constexpr double kFloorNear = 4;  // metres below the place
constexpr double kBelow = 0.01;   // metres: the lift's top under the floor at its lowest
constexpr double kAbove = 0.05;   // metres: the leaf's foot over the floor

World box(const Vec3& low, const Vec3& high) {
    const std::string text = map_text::world(map_text::box(low, high, "door"));
    return make_world(read_map(text, "part.map", {.scale = 1}).value()).value();
}

}  // namespace

PartsNear::PartsNear() : paths_(2) {
    moving_ = {MovingPart(box({-0.75, -0.75, -0.25}, {0.75, 0.75, 0})),
               MovingPart(box({0, -0.0625, 0}, {1.25, 0.0625, 2}))};
    standing_ = moving_;
}

void PartsNear::put(const World& world, const Vec3& feet, scenes::Rng& rng) {
    const Hit floor = cast(world, Ray{feet + Vec3{0, 0, 0.01}, {0, 0, -kFloorNear}});
    shown_ = floor && floor.normal.z > 0.5;
    if (!shown_) return;
    PartPath& lift = paths_[0];
    lift = {};
    lift.swing.reach = {0, 0, rng.uniform(0.2, 1.2)};
    lift.swing.period = rng.uniform(2, 6);
    lift.swing.phase = 0.75;  // lowest
    lift.stops.emplace_back();
    lift.stops[0].position = floor.point - Vec3{0, 0, kBelow} + lift.swing.reach;
    PartPath& leaf = paths_[1];
    leaf = {};
    Vec3 way = rng.direction();
    way.z = 0;
    leaf.stops.emplace_back();
    leaf.stops[0].position = floor.point + Vec3{0, 0, kAbove} + way * rng.uniform(0.7, 2);
    leaf.stops[0].angle = rng.uniform(0, 6);
    leaf.swing.angle = rng.uniform(0.5, 3);
    leaf.swing.period = rng.uniform(1, 5);
    time_ = 0;
    set_motions(0, 0);
}

void PartsNear::go_on(double seconds) {
    if (shown_) set_motions(time_, time_ + seconds);
    time_ += seconds;
}

void PartsNear::set_motions(double before, double after) {
    for (std::size_t k = 0; k < paths_.size(); ++k) {
        moving_[k].motion = part_motion(paths_[k], before, after);
        const Pose end = pose_at(moving_[k].motion, 1);
        standing_[k].motion = {end.position, end.rotation, {}, {}};
    }
}

}  // namespace firma::reference
