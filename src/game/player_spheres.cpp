// SPDX-License-Identifier: MIT
// A player as spheres in the world.
#include "game/player_spheres.h"

#include <algorithm>
#include <cmath>

#include "player/player_shape.h"

namespace firma {
namespace {

constexpr int kMaxInRow = 64;

/// Balls that touch each other's middles, from foot to head.
SphereSet row_of_spheres(const Vec3& feet, const Vec3& up, double radius, double height) {
    const double ball = std::min(radius, height * 0.5), way = height - 2 * ball;
    const int gaps = std::clamp(int(std::ceil(way / ball)), 1, kMaxInRow);
    SphereSet spheres;
    for (int k = 0; k <= gaps; ++k) spheres.push_back({feet + up * (ball + way * k / gaps), ball});
    return spheres;
}

const Posture& posture_of(const GamePlayer& player) {
    return player.shape.data().postures[player.player.crouched];
}

}  // namespace

SphereSet spheres_of_player(const GamePlayer& player) {
    const PlayerShapeData& shape = player.shape.data();
    const Vec3& feet = player.player.position;
    if (shape.kind != PlayerShapeData::Kind::kSpheres)
        return row_of_spheres(feet, shape.up, shape.radius, posture_of(player).height);
    SphereSet spheres = posture_of(player).spheres;
    for (Sphere& sphere : spheres) sphere.centre += feet;
    return spheres;
}

Vec3 middle_of_player(const GamePlayer& player) {
    return player.player.position + posture_of(player).middle;
}

}  // namespace firma
