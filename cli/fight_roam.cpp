// SPDX-License-Identifier: MIT
// Asks the world by casts alone, and draws from seeded numbers: the same fight every time.
#include "firma/queries.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "base/random.h"
#include "cli/demo_casts.h"
#include "cli/fight_plans.h"
#include "cli/rooms_outside.h"
#include "firma/capsule.h"
#include "firma/level.h"
#include "firma/rooms.h"

namespace firma::cli {

namespace {

constexpr double kWalk = 4;                         // metres a second
constexpr double kNearWall = 0.5;                   // metres: so near to a wall the player turns
constexpr double kSlow = 0.3;                       // of its speed: what is slower is held by something
constexpr std::size_t kSlowFrames = 20;             // that it lasts
constexpr int kWays = 16;                           // that it chooses from
constexpr double kLookFar = 20;                     // metres
constexpr double kShotNear = 3.5, kShotFar = 25;    // metres
constexpr double kShotEvery = 0.8;                  // seconds
constexpr double kLastShots = 5;                    // seconds before the end, when it fires no more
constexpr double kBeyondHole = 2.5, kHoleFar = 14;  // metres
constexpr double kStepRoom = 0.5;                   // metres above the feet that a look ahead leaves out
constexpr double kWholeTurn = 6.283185307179586;
constexpr std::size_t kStarts = 4000;

}  // namespace

double RoamingFight::random(double low, double high) {
    Random draw(state_);
    state_ = draw.next();
    return Random(state_).uniform(low, high);
}

Vec3 RoamingFight::random_way() {
    const SineCosine angle = sine_cosine(random(0, kWholeTurn));
    return {angle.cosine, angle.sine, 0};
}

/// How far the player could go, as a capsule that leaves steps out.
double RoamingFight::room_ahead(const FightGame& game, const World& world, const Vec3& way, double far) const {
    const PlayerShape& shape = game.shape();
    const double radius = shape.radius();
    const Vec3 feet = game.player().position;
    const Capsule body(feet + shape.up() * (kStepRoom + radius), feet + shape.up() * (shape.height() - radius),
                       radius * 0.95);
    CastOptions options;
    options.mask = kStopsWalk;
    const Hit hit = cast(world, body, way * far, options);
    return hit.touched() ? far * hit.fraction : far;
}

void RoamingFight::turn_about(const FightGame& game) {
    double best = -1;
    Vec3 chosen = way_;
    for (int k = 0; k < kWays; ++k) {
        const Vec3 way = random_way();
        const double worth = room_ahead(game, game.world(), way, kLookFar) * random(0.3, 1);
        if (worth <= best) continue;
        best = worth;
        chosen = way;
    }
    way_ = chosen;
}

/// Whether the last blast opened a way that was none.
void RoamingFight::look_for_hole(const FightGame& game) {
    if (game.flashes().size() == blasts_seen_) return;
    blasts_seen_ = game.flashes().size();
    Vec3 path = game.flashes().back().at - game.player().position;
    path.z = 0;
    const double far = length(path);
    if (far < 1 || far > kHoleFar) return;
    const Vec3 way = path * (1 / far);
    const double wanted = far + kBeyondHole;
    if (room_ahead(game, game.world(), way, wanted) < wanted) return;
    if (room_ahead(game, game.level(), way, wanted) >= wanted) return;
    hole_ = game.player().position + way * wanted;
    hole_until_ = game.seconds() + 2 * wanted / kWalk;
}

std::optional<FightShot> RoamingFight::aim(const FightGame& game) {
    if (game.seconds() < next_shot_ || game.seconds() > seconds_ - kLastShots) return std::nullopt;
    Vec3 way = random_way();
    if (random(0, 1) < 0.5) {
        way.z = random(-0.3, 0.9);  // up to ceilings and bridges; else straight at a wall, for a hole to walk through
    } else {
        way.z = -0.03;
    }
    CastOptions options;
    options.mask = kStopsShots;
    const Hit hit = cast(game.world(), Ray{game.eye(), way * kShotFar}, options);
    const double far = length(way) * kShotFar * hit.fraction;
    if (!hit.touched() || far < kShotNear) return std::nullopt;
    next_shot_ = game.seconds() + kShotEvery;
    FightShot shot;
    shot.seconds = game.seconds();
    shot.by_player = true;
    shot.at = hit.point;
    shot.radius = random(0.9, 1.8);
    shot.into = shot.radius * 0.4;
    shot.break_radius = 4;
    shot.seed = game.figures().shots + 1;
    return shot;
}

FightOrders RoamingFight::next(const FightGame& game) {
    FightOrders orders;
    const Player& player = game.player();
    if (const std::optional<FightShot> shot = aim(game)) orders.fire.push_back(*shot);
    look_for_hole(game);
    Vec3 moved = player.position - last_;
    moved.z = 0;
    last_ = player.position;
    slow_ = length(moved) < kSlow * kWalk / kFightRate ? slow_ + 1 : 0;
    if (hole_) {
        Vec3 path = *hole_ - player.position;
        path.z = 0;
        if (length(path) < 0.4 || game.seconds() > hole_until_) {
            hole_.reset();
            turn_about(game);
        } else {
            way_ = path * (1 / length(path));
        }
    } else if (slow_ > kSlowFrames || room_ahead(game, game.world(), way_, 1) < kNearWall) {
        turn_about(game);
        slow_ = 0;
    }
    orders.wish.velocity = way_ * kWalk;
    orders.wish.careful = !hole_;
    return orders;
}

std::optional<Vec3> find_start(const World& world, const BrushLevel* level, std::uint64_t seed) {
    const PlayerShape shape = make_player_capsule().value();
    const std::vector<bool> outside = rooms_outside(world);
    const bool rooms = std::find(outside.begin(), outside.end(), false) != outside.end();
    const auto is_good = [&](const Vec3& feet) {
        if (!player_fits(world, shape, feet, false, kStopsWalk)) return false;
        const Location at = locate(world, feet + shape.up() * (shape.height() / 2));
        return at.where == Where::kAir && !(rooms && outside[at.room.value]);
    };
    if (level)
        for (const Entity& entity : level->entities) {
            const std::optional<Vec3> origin = entity_origin(*level, entity);
            if (!origin || entity.value("classname").substr(0, 11) != "info_player") continue;
            for (const double above : {-0.7, -0.3, 0.0, 0.3, 0.7, 1.2})
                if (is_good(*origin + Vec3{0, 0, above})) return *origin + Vec3{0, 0, above};
        }
    for (const Query& query : make_demo_casts(world, kStarts, seed))
        if (is_good(query.sphere.centre)) return query.sphere.centre;
    return std::nullopt;
}

}  // namespace firma::cli
