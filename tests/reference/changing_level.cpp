// SPDX-License-Identifier: MIT
// Random craters, fills, doors and undos.
#include "tests/reference/changing_level.h"

#include <optional>
#include <utility>

#include "firma/carve.h"
#include "firma/queries.h"
#include "firma/rooms.h"
#include "scenes/level_cuts.h"
#include "tests/reference/rooms_outside.h"

namespace firma::reference {
namespace {

constexpr std::size_t kMaxPast = 8;  // worlds that may come back
constexpr double kNear = 6;          // metres: craters are made at most so far away

}  // namespace

ChangingLevel::ChangingLevel(const World& level)
    : begun_(with_anchors(level)), world_(begun_), outside_(rooms_outside(world_)) {}

bool ChangingLevel::is_inside(const Vec3& point) const {
    const Location at = locate(world_, point);
    return at.where == Where::kAir && !outside_[at.room.value];
}

void ChangingLevel::put(World world) {
    past_.push_back(world_);
    if (past_.size() > kMaxPast) past_.pop_front();
    world_ = std::move(world);
    outside_ = rooms_outside(world_);
}

void ChangingLevel::change(const Vec3& feet, const Vec3& middle, scenes::Rng& rng) {
    const std::uint32_t kind = rng.below(10);
    if (kind < 5) return cut(middle, rng);
    if (kind < 7) return fill_near(feet, rng);
    if (kind < 8) return toggle_door(rng);
    if (past_.empty()) return;
    ++counts_.undone;
    if (kind == 8) return put(past_[rng.below(std::uint32_t(past_.size()))]);
    put(begun_);
}

void ChangingLevel::cut(const Vec3& from, scenes::Rng& rng) {
    const Hit hit = cast(world_, Ray{from, rng.direction() * kNear});
    if (!hit) return;
    const auto shape = CutterShape(rng.below(2));
    Pose pose;
    pose.position = hit.point;
    pose.scale = rng.uniform(0.3, 2);
    const CarveResult made = carve(world_, make_crater(shape, rng.next()), pose);
    if (!made.done() || opens_way_out(world_, made.world)) return;
    ++counts_.cuts;
    put(made.world);
}

void ChangingLevel::fill_near(const Vec3& feet, scenes::Rng& rng) {
    const double far = rng.uniform(0, 2);
    Pose pose;
    pose.position = feet + rng.direction() * far;
    pose.scale = rng.uniform(0.2, 1.5);
    const std::uint64_t seed = rng.next();
    const CarveResult made = fill(world_, make_crater(CutterShape(rng.below(2)), seed), pose);
    if (!made.done()) return;
    ++counts_.fills;
    put(made.world);
}

void ChangingLevel::toggle_door(scenes::Rng& rng) {
    if (portal_count(world_) == 0) return;
    const PortalId portal{rng.below(std::uint32_t(portal_count(world_)))};
    const std::optional<PortalInfo> info = portal_info(world_, portal);
    const std::optional<World> changed = set_portal_open(world_, portal, !info->open);
    if (!changed) return;
    ++counts_.doors;
    put(*changed);
}

}  // namespace firma::reference
