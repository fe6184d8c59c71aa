// SPDX-License-Identifier: MIT
// Spheres against the nearest face, middles against rooms.
#include "cli/fight_judge.h"
#include "firma/queries.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/numbers.h"
#include "cli/rooms_outside.h"
#include "firma/rooms.h"

namespace firma::cli {

namespace {

constexpr double kRounded = 1.001;  // of the contact offset
constexpr double kBelowLevel = 1;   // metres

}  // namespace

std::string FightJudge::fault(const FightState& state, std::size_t escaped) {
    const std::uint64_t hash = hash_world(state.world);
    const bool new_world = hash != world_hash_;
    world_hash_ = hash;
    if (new_world) outside_ = rooms_outside(state.world);
    const std::vector<Body>& bodies = state.bodies.slots;
    slept_.resize(bodies.size(), false);
    lost_ = 0;
    for (std::size_t slot = 0; slot < bodies.size(); ++slot) {
        const Body& body = bodies[slot];
        if (!body.shape.valid()) continue;
        lost_ += is_lost(state.world, body.position);
        if (body.asleep && slept_[slot] && !new_world) continue;
        slept_[slot] = body.asleep;
        if (const std::string text = fault_of_body(state.world, body); !text.empty())
            return fmt::format("body {} at {}: {}", slot, point_text(body.position), text);
    }
    if (lost_ > 0) return counted(lost_, "body", "bodies") + " out of the level";
    if (kept_in_ && escaped > 0) return counted(escaped, "ray") + " out of the level";
    const std::string text = fault_of_player(state);
    return text.empty() ? "" : fmt::format("the player at {}: {}", point_text(state.player.position), text);
}

std::string FightJudge::fault_of_body(const World& world, const Body& body) {
    const Pose pose = pose_of(body);
    const TurnMatrix turn = matrix_of(pose.rotation);
    for (const Sphere& sphere : body.shape.spheres()) {
        ++spheres_;
        const Vec3 centre = pose.position + turn * sphere.centre;
        if (locate(world.solid(), centre) == Where::kSolid) return "a sphere's centre is in solid";
        const NearFace near = closest(world, centre, sphere.radius);
        if (!near || !near.face.valid() || !world.face_info(near.face)->solid) continue;
        const double depth = sphere.radius - near.distance;
        deepest_ = std::max(deepest_, depth);
        if (depth > world.tolerance().contact_offset * kRounded)
            return fmt::format("a sphere is {:.3f} mm deep in the level", 1e3 * depth);
    }
    return "";
}

std::string FightJudge::fault_of_player(const FightState& state) const {
    const Player& player = state.player;
    const Vec3 middle = player.position + shape_.up() * (shape_.height(player.crouched) / 2);
    if (player.stuck) return "is stuck";
    if (locate(state.world.solid(), middle) == Where::kSolid) return "is in solid";
    if (!player_fits(state.world, shape_, player.position, player.crouched, player.mask)) return "overlaps the level";
    return is_lost(state.world, middle) ? "is out of the level" : "";
}

bool FightJudge::is_lost(const World& world, const Vec3& at) const {
    const Box box = level_.bounds();
    if (!box.empty() && at.z < box.low.z - kBelowLevel) return true;
    if (!kept_in_) return false;
    const Location place = locate(world, at);
    return place.where == Where::kUnknown || (place.where == Where::kAir && outside_[place.room.value]);
}

}  // namespace firma::cli
