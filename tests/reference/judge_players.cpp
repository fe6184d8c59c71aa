// SPDX-License-Identifier: MIT
// A player in a level that changes around it, judged frame by frame.
#include "tests/reference/judge_players.h"

#include <cmath>
#include <ctime>
#include <utility>

#include "scenes/level_cuts.h"
#include "scenes/rng.h"
#include "tests/reference/changing_level.h"
#include "tests/reference/grown_player.h"
#include "tests/reference/parts_near.h"
#include "tests/reference/player_overlap.h"

namespace firma::reference {
namespace {

constexpr double kEveryEvent = 2;  // seconds between changes of the world, about
constexpr double kEveryLife = 30;  // seconds after which the player begins elsewhere, about
constexpr double kEveryParts = 5;  // seconds after which the lift and the leaf are hung up anew, about
constexpr double kFreeWay = 0.1;   // metres
// In contact offsets: so wide are ways that are free, for a player raised by so much: from ground that keeps the offset
// it is 0.2 away, and from what leans by more than 45 degrees and keeps it the raise leads away by less than 0.5.
constexpr double kMargin = 1.5, kRaise = 0.7;
constexpr double kMostPushed = 0.012;  // metres: eight slides that back off by the contact offset each, and four more
constexpr double kFastest = 10;        // metres a second that are wished
constexpr int kRings = 10, kOnRing = 50;  // places that are tried where a player is stuck

class PlayerGame {
public:
    PlayerGame(const World& level, const PlayerShape& shape, const PlayerRun& run)
        : level_(level),
          shape_(shape),
          run_(run),
          offset_(level.tolerance().contact_offset),
          wide_(grown_player(shape, kMargin * offset_)),
          rng_(run.seed) {
        walls_ = scenes::cut_places(level).inside;
    }

    PlayerVerdict play() {
        begin_somewhere();
        for (; verdict_.frames < run_.frames && verdict_.fault.empty(); ++verdict_.frames) {
            if (rng_.chance(1 / (kEveryEvent * run_.rate)))
                level_.change(player_.position, player_.position + shape_.up() * (shape_.height() * 0.5), rng_);
            if (rng_.chance(1 / (kEveryLife * run_.rate))) begin_somewhere();
            if (rng_.chance(1 / (kEveryParts * run_.rate))) hang_parts();
            if (rng_.chance(1 / run_.rate)) wish_anew();
            move();
            if (verdict_.frames % 60 == 59 && verdict_.fault.empty() && !player_.stuck) try_ways();
        }
        const ChangingLevel::Counts& counts = level_.counts();
        verdict_.cuts = counts.cuts, verdict_.fills = counts.fills;
        verdict_.undone = counts.undone, verdict_.doors = counts.doors;
        return verdict_;
    }

private:
    void fail(const std::string& what) {
        if (!verdict_.fault.empty()) return;
        verdict_.fault = "frame " + std::to_string(verdict_.frames) + " at " + std::to_string(player_.position.x) +
                         ' ' + std::to_string(player_.position.y) + ' ' + std::to_string(player_.position.z) + ": " +
                         what;
    }

    bool is_inside(const Vec3& feet) const {
        return level_.is_inside(feet + shape_.up() * (shape_.height(player_.crouched) * 0.5));
    }

    void begin_somewhere() {
        player_ = {};
        for (;;) {
            parts_.remove();
            const LevelFace& face = walls_.faces[rng_.below(std::uint32_t(walls_.faces.size()))];
            const auto corner = [&](std::uint32_t k) {
                return to_metres(walls_.vertices[walls_.corners[face.first_corner + k]]);
            };
            const Vec3 a = corner(0), b = corner(1), c = corner(2), out = cross(b - a, c - a);
            const double i = rng_.uniform(0, 1), j = rng_.uniform(0, 1 - i), far = rng_.uniform(0.1, 2);
            player_.position = a + (b - a) * i + (c - a) * j + out * (far / length(out));
            if (!is_inside(player_.position)) continue;
            parts_.put(world(), player_.position, rng_);
            if (player_fits(now(), shape_, player_.position)) return;
        }
    }

    /// Where it is by now, if there is room for it among them.
    void hang_parts() {
        if (player_.stuck || crushed_ || player_.ground_part != kNoPart) return;
        parts_.put(world(), player_.position, rng_);
        if (!player_fits(now(), shape_, player_.position, player_.crouched)) parts_.remove();
    }

    void wish_anew() {
        wish_ = {};
        if (rng_.chance(0.1)) return;
        Vec3 way = rng_.direction();
        way.z = 0;
        wish_.velocity = way * rng_.uniform(0, kFastest);
        wish_.jump = rng_.chance(0.3);
        wish_.crouch = rng_.chance(0.2);
        wish_.careful = rng_.chance(0.2);
    }

    void move() {
        const Player before = player_;
        parts_.go_on(1 / run_.rate);
        const Scene scene{world(), parts_.moving()};
        const std::clock_t start = std::clock();
        const PlayerMove moved = move_player(scene, shape_, before, wish_, 1 / run_.rate, rules_);
        verdict_.seconds += double(std::clock() - start) / CLOCKS_PER_SEC;
        player_ = moved.player;
        verdict_.jumps += moved.jumped;
        verdict_.steps += moved.stepped;
        verdict_.landings += moved.landed_speed > 0;
        verdict_.pushed += length(moved.pushed) > 0.01;
        if (!moved.valid) return fail("refused");
        if (player_.stuck) {
            verdict_.stuck += !before.stuck;
            if (!(player_.position == before.position)) fail("stuck and moved");
            if (!before.stuck || before.world_hash != player_.world_hash) look_for_free_places(scene);
            return;
        }
        crushed_ = moved.crushed_by != kNoPart;
        verdict_.ridden += player_.ground_part != kNoPart;
        verdict_.shoved += moved.pushed_by != kNoPart;
        verdict_.crushed += crushed_;
        if (!is_inside(player_.position)) return fail("out of the level, or in solid");
        // Parts too, but where they crush it.
        const Scene around = crushed_ ? Scene{world()} : now();
        if (const std::string what = player_overlap(around, shape_, player_.position, player_.crouched); !what.empty())
            return fail("overlaps " + what);
        const Vec3 way = player_.position - before.position - moved.pushed - moved.carried;
        const double far = std::hypot(way.x, way.y);
        verdict_.travelled += far;
        // What is moved out of what came may have to come down again.
        const bool walked = before.on_ground && player_.on_ground && !moved.jumped && !(moved.landed_speed > 0);
        double had = std::hypot(before.velocity.x, before.velocity.y);
        if (!walked) {  // slopes and ceilings turn what it rises and falls by sideways
            had = length(before.velocity) + (rules_.gravity + rules_.air_acceleration) / run_.rate;
            if (moved.jumped) had += rules_.jump_speed;
        }
        if (before.ground_part != kNoPart && (!walked || player_.ground_part != before.ground_part)) {
            const RigidMotion& motion = scene.parts[before.ground_part].motion;  // whose speed it keeps
            had += length(before.ground_velocity) + length(velocity_at(motion, 1, player_.position)) * run_.rate;
        }
        // In another world it may come to stand on a part, which then goes away under it.
        const bool same_world = !before.stuck && before.world_hash == player_.world_hash;
        if (before.on_ground && !same_world)
            for (const MovingPart& part : scene.parts)
                had += length(velocity_at(part.motion, 0, before.position)) * run_.rate;
        const double asked = std::max(std::hypot(wish_.velocity.x, wish_.velocity.y), had) / run_.rate;
        if (same_world && length(moved.pushed) > kMostPushed)
            fail("was pushed by " + std::to_string(length(moved.pushed)) + " m by nothing that came");
        if (far > asked * (1 + 1e-9) + 1e-9 + (moved.stepped ? 2 * world().tolerance().contact_offset : 0))
            fail("went " + std::to_string(far) + " m sideways where " + std::to_string(asked) + " were asked");
    }

    const World& world() const { return level_.world(); }
    /// The parts standing where they have come to.
    Scene now() const { return {world(), parts_.standing()}; }

    /// A stuck one has no room: not where it is, nor at any of the places all around it, as far as it may be moved.
    void look_for_free_places(const Scene& scene) {
        const auto is_free = [&](const Vec3& place) {
            return is_inside(place) && player_fits(scene, shape_, place, player_.crouched) &&
                   player_fits(now(), shape_, place, player_.crouched);
        };
        if (is_free(player_.position)) fail("stuck where it fits");
        constexpr double kGolden = 2.399963229728653;  // radians
        for (int ring = 1; ring <= kRings; ++ring)
            for (int k = 0; k < kOnRing; ++k) {
                const double z = 1 - (2 * k + 1.0) / kOnRing;
                const SineCosine turn = sine_cosine(kGolden * k);
                const Vec3 way = Vec3{turn.cosine, turn.sine, 0} * std::sqrt(1 - z * z) + Vec3{0, 0, z};
                const double far = rules_.max_push * ring / kRings;
                if (!is_free(player_.position + way * far)) continue;
                ++verdict_.missed;
                return fail("stuck, and " + std::to_string(far) + " m away a place is free");
            }
    }

    /// Of eight ways around: where one is free for a bit, with room for the contact offset on all sides, a second of
    /// walking leads there, or somewhere. In the air where it has hung at one place since the last time.
    void try_ways() {
        const Vec3 before = std::exchange(tried_at_, player_.position);
        if (crushed_) return;
        Vec3 way{1, 0, 0};
        if (player_.on_ground) {
            way = rng_.direction();
            way.z = 0;
            if (length(way) < 0.1) return;
            way *= 1 / length(way);
        } else if (length(player_.position - before) > kFreeWay * 0.5) {
            return;
        }
        const double half = std::sqrt(0.5);
        for (int k = 0; k < 8; ++k) {
            try_way(way);
            way = Vec3{way.x - way.y, way.x + way.y, 0} * half;
        }
    }

    void try_way(const Vec3& way) {
        if (is_held_by_sheet(now(), shape_, player_.position, player_.crouched, way)) return;
        const Vec3 low = player_.position - shape_.up() * ((kMargin - kRaise) * offset_);
        for (int k = 1; k <= 16; ++k)
            if (!player_fits(now(), wide_, low + way * (kFreeWay * k / 16), player_.crouched)) return;
        ++verdict_.tried;
        Player walker = player_;
        for (int k = 0; k < int(run_.rate); ++k) {
            PlayerWish wish;
            wish.velocity = way * 2;
            wish.crouch = player_.crouched;
            walker = move_player(now(), shape_, walker, wish, 1 / run_.rate, rules_).player;
            if (length(walker.position - player_.position) >= kFreeWay * 0.5) return;
        }
        fail("held, where " + std::to_string(way.x) + ' ' + std::to_string(way.y) + " is free");
    }

    ChangingLevel level_;
    const PlayerShape& shape_;
    const PlayerRun& run_;
    const double offset_;
    const PlayerShape wide_;
    const PlayerRules rules_;
    scenes::Rng rng_;
    Level walls_;
    PartsNear parts_;
    Player player_;
    PlayerWish wish_;
    Vec3 tried_at_;         // where it was when ways were last tried
    bool crushed_ = false;  // by a part, in the last move
    PlayerVerdict verdict_;
};

}  // namespace

PlayerVerdict judge_player(const World& level, const PlayerShape& shape, const PlayerRun& run) {
    return PlayerGame(level, shape, run).play();
}

}  // namespace firma::reference
