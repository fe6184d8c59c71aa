// SPDX-License-Identifier: MIT
// A game is a value, so its frames are kept whole and drawn when the fight is over.
#include "cli/fight_pictures.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "cli/atomic_file.h"
#include "cli/find_camera.h"
#include "cli/progress.h"
#include "cli/tbb_tasks.h"
#include "draw/picture.h"

namespace firma::cli {

namespace {

constexpr int kFrameWidth = 400, kFrameHeight = 300, kStripColumns = 3;
constexpr double kFlashSeconds = 0.3, kDustSeconds = 1.6;
constexpr Vec3 kFire{1.0, 0.62, 0.25}, kDust{0.70, 0.66, 0.60}, kSmoke{0.82, 0.82, 0.82};
constexpr int kTrail = 8;               // puffs behind a rocket
constexpr double kTrailSeconds = 0.02;  // between them
constexpr double kLampUp = 2;           // metres above the camera

void add_rocket(draw::DrawnThings& things, const Projectile& rocket, const Vec3& from) {
    for (int k = 1; k <= kTrail; ++k) {
        const Vec3 back = rocket.velocity * (-kTrailSeconds * k);
        if (length(back) > length(rocket.position - from)) break;
        things.puffs.push_back(
            {rocket.position + back, 0.1 + 0.02 * k, kSmoke, 0.8 * (1 - double(k) / (kTrail + 1)), 0});
    }
    things.puffs.push_back({rocket.position, 0.3, kFire, 0.9, 1.2});
}

void add_flash(draw::DrawnThings& things, const FightFlash& flash, double age) {
    if (age < 0 || age > kDustSeconds) return;
    const double fades = 1 - age / kDustSeconds;
    things.puffs.push_back({flash.at, flash.radius * (1 + 0.9 * age), kDust, 0.75 * fades * fades, 0});
    if (age > kFlashSeconds) return;
    const double burns = 1 - age / kFlashSeconds;
    things.puffs.push_back({flash.at, flash.radius * (0.6 + 2 * age), kFire, 0.9 * burns, 1.6 * burns});
}

draw::DrawnThings things_of(const FightGame& game) {
    draw::DrawnThings things;
    const Bodies& bodies = game.state().bodies;
    for (std::uint32_t slot = 0; slot < bodies.slots.size(); ++slot) {
        const DebrisPiece* piece = game.state().debris.find(bodies, {slot, bodies.slots[slot].use});
        if (piece) things.solids.push_back({piece->solid, pose_of(bodies.slots[slot]), piece->matter});
    }
    const Player& player = game.player();
    const PlayerShape& shape = game.shape();
    things.players.push_back({player.position + shape.up() * shape.radius(),
                              player.position + shape.up() * (shape.height(player.crouched) - shape.radius()),
                              shape.radius()});
    for (std::size_t k = 0; k < game.state().projectiles.size(); ++k)
        add_rocket(things, game.state().projectiles[k], game.rockets()[k].from);
    for (const FightFlash& flash : game.flashes()) add_flash(things, flash, game.seconds() - flash.seconds);
    return things;
}

draw::Camera small_camera(const Vec3& eye, const Vec3& target) {
    draw::Camera camera;
    camera.eye = eye;
    camera.target = target;
    camera.width = kFrameWidth;
    camera.height = kFrameHeight;
    return camera;
}

/// Sees 103 degrees from left to right.
draw::Camera wide(draw::Camera camera) {
    camera.zoom = 0.8;
    return camera;
}

std::vector<double> evenly(double from, double to, int count) {
    std::vector<double> seconds;
    for (int k = 0; k < count; ++k) seconds.push_back(from + (to - from) * k / (count - 1));
    return seconds;
}

}  // namespace

std::vector<FightFilm> depot_films() {
    return {{"bridge",
             {0.70, 0.90, 1.40, 1.80, 2.00, 2.30, 2.50, 2.70, 4.00},
             small_camera({21.9, 7.4, 4.7}, {13.5, 7, 2.3}),
             Vec3{20, 5, 9.5}},
            {"fight",
             {0.8, 1.96, 3.15, 4.6, 6.45, 7.4, 9.3, 11.5, 19},
             wide(small_camera({25.3, 5.4, 5.4}, {16, 9, 1.8})),
             Vec3{20, 5, 9.5}}};
}

std::vector<FightFilm> roaming_films(double seconds) {
    return {{"fight", evenly(0.1 * seconds, 0.98 * seconds, 9), std::nullopt, std::nullopt}};
}

void FightCamera::look(const FightGame& game) {
    for (std::size_t k = 0; k < films_.size(); ++k) {
        std::vector<FightGame>& frames = frames_[k];
        if (frames.size() == films_[k].seconds.size() || game.seconds() < films_[k].seconds[frames.size()]) continue;
        frames.push_back(game);
    }
}

std::vector<std::string> FightCamera::develop(const std::string& folder) const {
    std::vector<std::string> names;
    std::size_t count = 0;
    for (const std::vector<FightGame>& frames : frames_) count += frames.size();
    Progress progress("drawing", count);
    const Tasks tasks{.run = run_by_tbb};
    for (std::size_t k = 0; k < films_.size(); ++k) {
        const std::vector<FightGame>& frames = frames_[k];
        if (frames.empty()) continue;
        std::optional<draw::Camera> camera = films_[k].camera;
        if (!camera) camera = find_camera(frames[0].level(), frames.back().world(), small_camera({}, {1, 0, 0}));
        if (!camera) continue;
        const Vec3 lamp = films_[k].lamp.value_or(camera->eye + Vec3{0, 0, kLampUp});
        std::vector<draw::Picture> pictures;
        for (const FightGame& frame : frames) {
            pictures.push_back(draw::draw_scene(frame.world(), things_of(frame), *camera, lamp, &tasks));
            progress.add(1);
        }
        names.push_back((std::filesystem::path(folder) / (films_[k].name + ".png")).string());
        AtomicFile file(names.back());
        file.write(png_bytes(draw::film_strip(pictures, kStripColumns)));
        file.commit();
    }
    return names;
}

}  // namespace firma::cli
