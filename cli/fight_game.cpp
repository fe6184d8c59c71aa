// SPDX-License-Identifier: MIT
// Rockets first, then what they blow up, bodies, debris, the player; last, rays that must not get out of the level.
#include "cli/fight_game.h"
#include "firma/queries.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <ctime>
#include <utility>

#include "base/random.h"
#include "cli/rooms_outside.h"
#include "firma/level.h"
#include "firma/rooms.h"
#include "scenes/rng.h"

namespace firma::cli {

namespace {

constexpr double kFrame = 1 / kFightRate;
constexpr Vec3 kRocketGravity{0, 0, -2};  // metres a second squared: its motor carries most of it
constexpr double kRocketMass = 4;         // kilograms
constexpr double kBeforeFace = 0.15;      // metres: a blast happens so far before what the rocket met
constexpr double kBlastRadius = 6, kBlastImpulse = 1200;
constexpr double kMaxPushSpeed = 9;                     // metres a second, of bodies
constexpr double kPlayerMass = 80, kMaxPlayerPush = 5;  // kilograms; metres a second
constexpr double kPlayerArea = 0.7;                     // square metres that face a blast
constexpr double kEyeHeight = 1.62;                     // metres above the feet
constexpr std::size_t kMaxFightBodies = 500;
constexpr std::size_t kSightRays = 256;  // a frame
constexpr std::size_t kFightSpheres = 10;

enum PhaseNumber : std::size_t { kCasts, kCuts, kBodies, kDebris, kPlayer };

/// Adds the processor time that passes while it lives. All of the game runs on one thread.
class PhaseTimer {
public:
    explicit PhaseTimer(double& seconds) : seconds_(seconds), start_(std::clock()) {}
    ~PhaseTimer() { seconds_ += double(std::clock() - start_) / CLOCKS_PER_SEC; }
    PhaseTimer(const PhaseTimer&) = delete;
    PhaseTimer& operator=(const PhaseTimer&) = delete;

private:
    double& seconds_;
    const std::clock_t start_;
};

std::uint64_t with_bits(std::uint64_t hash, std::uint64_t bits) {
    return mix_bits(hash * 0x9E3779B97F4A7C15ull + bits);
}

std::uint64_t with_numbers(std::uint64_t hash, const Vec3& numbers) {
    for (int axis = 0; axis < 3; ++axis) {
        const double number = numbers[axis];
        std::uint64_t bits = 0;
        std::memcpy(&bits, &number, sizeof bits);
        hash = with_bits(hash, bits);
    }
    return hash;
}

/// What of the player a blast sees.
std::array<Sphere, 3> player_spheres(const Player& player, const PlayerShape& shape) {
    const double radius = shape.radius(), height = shape.height(player.crouched);
    const auto at = [&](double above) { return Sphere{player.position + shape.up() * above, radius}; };
    return {at(radius), at(height / 2), at(height - radius)};
}

}  // namespace

FightGame::FightGame(World level, const Vec3& start, std::uint64_t seed)
    : level_(std::move(level)), state_{level_, {}, {}, {}, {}}, shape_(make_player_capsule().value()), seed_(seed) {
    const Box box = level_.bounds();
    diagonal_ = box.empty() ? 1 : length(box.high - box.low);
    state_.player.position = start;
    state_.player.mask = kStopsWalk;
    const Location at = locate(level_, middle());
    kept_in_ = at.where == Where::kAir && !rooms_outside(level_)[at.room.value];
    note_place();
}

Vec3 FightGame::eye() const {
    return state_.player.position + shape_.up() * std::min(kEyeHeight, 0.9 * shape_.height(state_.player.crouched));
}

Vec3 FightGame::middle() const {
    return state_.player.position + shape_.up() * (0.5 * shape_.height(state_.player.crouched));
}

void FightGame::advance(const FightOrders& orders) {
    std::array<double, 5> before;
    for (std::size_t k = 0; k < before.size(); ++k) before[k] = figures_.phases[k].total;
    for (const FightShot& shot : orders.fire) fire(shot);
    fly_rockets();
    move_bodies();
    tend();
    move(orders.wish);
    look_around();
    ++figures_.frames;
    for (std::size_t k = 0; k < before.size(); ++k) {
        FightPhase& phase = figures_.phases[k];
        phase.worst = std::max(phase.worst, phase.total - before[k]);
    }
}

void FightGame::fire(const FightShot& shot) {
    const Vec3 from = shot.by_player ? eye() : shot.from, path = shot.at - from;
    const double seconds = length(path) / shot.speed;
    if (!(seconds > 0)) return;
    Projectile rocket;
    rocket.position = from;
    rocket.velocity = path * (1 / seconds) - kRocketGravity * (seconds / 2);
    rocket.mass = kRocketMass;
    rocket.mask = kStopsShots;
    state_.projectiles.push_back(rocket);
    rockets_.push_back({shot, from});
    ++figures_.shots;
}

void FightGame::fly_rockets() {
    {
        const PhaseTimer timer(figures_.phases[kCasts].total);
        FlyOptions options;
        options.gravity = kRocketGravity;
        options.other = {.ricochet_below = 0};
        options.bodies = {.ricochet_below = 0};
        if (!fly(state_.projectiles, state_.world, kFrame, events_, options, &state_.bodies)) return;
    }
    for (const ShotEvent& event : events_.events)
        if (event.kind == ShotEventKind::kStopped) blow(rockets_[event.projectile], event);
    std::size_t kept = 0;
    for (std::size_t k = 0; k < state_.projectiles.size(); ++k) {
        if (state_.projectiles[k].state != ProjectileState::kFlying) continue;
        state_.projectiles[kept] = state_.projectiles[k];
        rockets_[kept++] = rockets_[k];
    }
    state_.projectiles.resize(kept);
    rockets_.resize(kept);
}

void FightGame::blow(const FightRocket& rocket, const ShotEvent& event) {
    const PhaseTimer timer(figures_.phases[kCuts].total);
    const FightShot& shot = rocket.shot;
    const Vec3 way = (event.point - rocket.from) * (1 / std::max(length(event.point - rocket.from), 1e-9));
    firma::Blast blast;
    blast.at = event.point - way * kBeforeFace;
    blast.radius = kBlastRadius;
    blast.impulse = kBlastImpulse;
    BlastOptions options;
    options.carve.from = rocket.from;
    options.break_radius = shot.break_radius;
    options.max_pieces = shot.pieces;
    options.max_spheres = kFightSpheres;
    options.seed = mix_bits(seed_ + shot.seed);
    options.push.max_speed = kMaxPushSpeed;
    Pose pose;
    pose.position = event.point + way * shot.into;
    pose.scale = shot.radius;
    const Cutter crater = make_crater(CutterShape::kRocky, shot.seed);
    ++figures_.hits;
    const Bodies bodies = state_.bodies;
    const Debris debris = state_.debris;
    BlastResult result = explode(state_.world, state_.bodies, state_.debris, blast, crater, pose, options);
    if (kept_in_ && opens_way_out(state_.world, result.carve.world)) {
        // As if it had not been: world and bodies are values.
        state_.bodies = bodies;
        state_.debris = debris;
        ++figures_.undone;
        result = explode(state_.world, state_.bodies, state_.debris, blast, {}, pose, options);
        result.carve.status = CarveStatus::kRefused;
    }
    state_.world = result.carve.world;
    figures_.craters += result.carve.done();
    figures_.nothing += result.carve.status == CarveStatus::kNothing;
    figures_.refused += result.carve.status == CarveStatus::kRefused;
    const std::size_t loose = result.carve.chunks.size() - result.unfit;
    figures_.loose += loose;
    figures_.broken += result.broken;
    figures_.dust += result.dust;
    figures_.unfit += result.unfit;
    figures_.pushed += result.push.pushed;
    push_player(blast);
    flashes_.push_back({blast.at, shot.radius, seconds(), result.carve.status, loose, result.broken});
}

void FightGame::push_player(const firma::Blast& blast) {
    const std::array<Sphere, 3> spheres = player_spheres(state_.player, shape_);
    const double seen = exposure(state_.world, blast.at, spheres);
    const Vec3 push = blast_impulse(blast, middle(), kPlayerArea, seen) * (1 / kPlayerMass);
    const double speed = length(push);
    if (speed == 0) return;
    state_.player.velocity = state_.player.velocity + push * std::min(1.0, kMaxPlayerPush / speed);
    state_.player.on_ground = false;
    ++figures_.player_pushed;
}

void FightGame::move_bodies() {
    const PhaseTimer timer(figures_.phases[kBodies].total);
    step(state_.bodies, state_.world, kFrame);
}

void FightGame::tend() {
    const PhaseTimer timer(figures_.phases[kDebris].total);
    DebrisRules rules;
    rules.max_bodies = kMaxFightBodies;
    rules.max_spheres = kMaxFightBodies * kFightSpheres;
    rules.max_asleep = INFINITY;
    figures_.removed += tend_debris(state_.world, state_.bodies, state_.debris, kFrame, rules).removed.size();
    std::size_t bodies = 0;
    for (const Body& body : state_.bodies.slots) bodies += body.shape.valid();
    figures_.most_bodies = std::max(figures_.most_bodies, bodies);
}

void FightGame::move(const PlayerWish& wish) {
    const Vec3 before = state_.player.position;
    {
        const PhaseTimer timer(figures_.phases[kPlayer].total);
        state_.player = move_player(state_.world, shape_, state_.player, wish, kFrame).player;
    }
    figures_.player_way += length(state_.player.position - before);
    note_place();
}

void FightGame::note_place() {
    const Location was = locate(level_, middle());
    const bool in_hole = was.where == Where::kSolid;
    figures_.holes += in_hole && !in_hole_;
    in_hole_ = in_hole;
    if (was.where != Where::kAir) return;
    const std::optional<RoomInfo> info = room_info(level_, was.room);
    std::string name = info && !info->name.empty() ? std::string(info->name) : std::to_string(was.room.value);
    if (figures_.rooms.empty() || figures_.rooms.back() != name) figures_.rooms.push_back(std::move(name));
}

void FightGame::look_around() {
    const PhaseTimer timer(figures_.phases[kCasts].total);
    scenes::Rng rng(mix_bits(seed_ + figures_.frames));
    CastOptions both;
    both.sides = Sides::kBoth;
    for (std::size_t k = 0; k < kSightRays; ++k) {
        const Vec3 path = rng.direction() * (2 * diagonal_);
        ++figures_.rays;
        if (cast(state_.world, Ray{eye(), path}, both).touched()) continue;
        figures_.escaped += cast(level_, Ray{eye(), path}, both).touched();
    }
}

std::uint64_t hash_fight(const FightState& state) {
    std::uint64_t hash = with_bits(hash_world(state.world), hash_bodies(state.bodies));
    hash = with_bits(hash, hash_debris(state.debris));
    hash = with_bits(hash, hash_projectiles(state.projectiles));
    return with_numbers(with_numbers(hash, state.player.position), state.player.velocity);
}

}  // namespace firma::cli
