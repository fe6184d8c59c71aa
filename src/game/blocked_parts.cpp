// SPDX-License-Identifier: MIT
// Who would be crushed by which part.
#include "game/blocked_parts.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "firma/queries.h"
#include "game/game_parts.h"
#include "game/player_spheres.h"
#include "moving/part_frame.h"

namespace firma {
namespace {

/// Metres: what is crushed is no farther from the part than this, and as far as the part goes in a tick.
constexpr double kTouching = 0.02;

/// As far as any of its points goes.
double way_of(const MovingPart& part, const RigidMotion& motion) {
    const Box box = part.bounds();
    double reach = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double side = std::max(std::fabs(box.low[axis]), std::fabs(box.high[axis]));
        reach += side * side;
    }
    return length(motion.path) + length(motion.turn) * std::sqrt(reach);
}

/// Of a part that goes from one of two stops to the other: the time at which it is in the same place on its way back.
/// None while it stands, for any other path, and where there is no way back.
std::optional<double> seconds_on_the_way_back(const PartPath& path, double seconds) {
    if (path.stops.size() != 2 || path.spin != 0 || path.swing.period > 0) return std::nullopt;
    const PartStop &first = path.stops[0], &second = path.stops[1];
    const double out = std::max(first.wait, 0.0), home = out + first.seconds + std::max(second.wait, 0.0);
    const double round = home + second.seconds;
    if (!(first.seconds > 0) || !(second.seconds > 0) || !is_finite(round)) return std::nullopt;
    const double rounds = path.repeats && seconds > 0 ? round * std::floor(seconds / round) : 0;
    const double at = seconds - rounds;
    if (at > out && at < out + first.seconds) return rounds + home + (1 - (at - out) / first.seconds) * second.seconds;
    if (at > home && at < round) return rounds + out + (1 - (at - home) / second.seconds) * first.seconds;
    return std::nullopt;
}

class BlockedParts {
public:
    BlockedParts(const GameState& game, std::span<const RigidMotion> motions)
        : game_(game), parts_(game.parts), blocked_(game.parts.size()) {
        for (std::size_t k = 0; k < parts_.size(); ++k) {
            parts_[k].motion = motions[k];
            const bool goes = !(motions[k].path == Vec3{} && motions[k].turn == Vec3{});
            if (goes && game.drives[k].when_blocked != WhenBlocked::kCrushes && !parts_[k].bounds().empty())
                yielding_.push_back(k);
        }
    }

    std::vector<bool> find() {
        if (!yielding_.empty()) {
            try_players();
            try_bodies();
        }
        return std::move(blocked_);
    }

private:
    /// Whether a sphere is near one that gives way.
    bool is_near(std::size_t part, const Sphere& sphere) const {
        const PartFrame frame(parts_[part].motion, 0);
        const double reach = sphere.radius + way_of(parts_[part], parts_[part].motion) + kTouching;
        return bool(closest(parts_[part].world(), frame.in(sphere.centre), reach));
    }
    bool is_near_any(const Sphere& sphere) const {
        for (const std::size_t part : yielding_)
            if (is_near(part, sphere)) return true;
        return false;
    }

    void try_players() {
        const Scene scene{game_.world, parts_};
        for (const GamePlayer& player : game_.players) {
            bool near = false;
            for (const Sphere& sphere : spheres_of_player(player)) near = near || is_near_any(sphere);
            if (!near) continue;
            const PlayerMove move =
                move_player(scene, player.shape, player.player, player.wish, 1.0 / game_.rate, player.rules);
            if (move.crushed_by < blocked_.size()) blocked_[move.crushed_by] = true;
        }
    }

    void try_bodies() {
        bool near = false;
        for (const Body& body : game_.bodies.slots)
            near = near || (body.shape.valid() && is_near_any({body.position, body.shape.reach()}));
        if (!near) return;
        Bodies tried = game_.bodies;
        if (firma::step(tried, Scene{game_.world, parts_}, 1.0 / game_.rate, game_.rules.bodies).crushed == 0) return;
        for (std::size_t slot = 0; slot < tried.slots.size(); ++slot) {
            if (!tried.slots[slot].crushed) continue;
            const Body& body = game_.bodies.slots[slot];
            for (const std::size_t part : yielding_)
                if (is_near(part, {body.position, body.shape.reach()})) blocked_[part] = true;
        }
    }

    const GameState& game_;
    std::vector<MovingPart> parts_;
    std::vector<std::size_t> yielding_;
    std::vector<bool> blocked_;
};

}  // namespace

void hold_blocked_parts(GameState& game, std::span<RigidMotion> motions) {
    const std::vector<bool> blocked = BlockedParts(game, motions).find();
    for (std::size_t k = 0; k < blocked.size(); ++k) {
        PartDrive& drive = game.drives[k];
        if (!blocked[k] || drive.when_blocked == WhenBlocked::kCrushes) continue;
        const double now = drive_seconds(game, drive, game.tick);
        const std::optional<double> back =
            drive.when_blocked == WhenBlocked::kReturns ? seconds_on_the_way_back(drive.path, now) : std::nullopt;
        if (back) {
            drive.ahead += *back - now;
            motions[k] = drive_motion(game, drive);
        } else {
            ++drive.held;
            motions[k] = part_motion(drive.path, now, now);
        }
    }
}

}  // namespace firma
