// SPDX-License-Identifier: MIT
// By making the same shape with larger numbers.
#include "tests/reference/grown_player.h"

#include "player/player_shape.h"

namespace firma::reference {
namespace {

SphereSet grown_spheres(const SphereSet& spheres, const Vec3& lower, double margin) {
    SphereSet grown = spheres;
    for (Sphere& sphere : grown) sphere = {sphere.centre + lower, sphere.radius + margin};
    return grown;
}

}  // namespace

PlayerShape grown_player(const PlayerShape& shape, double margin) {
    const PlayerShapeData& data = shape.data();
    if (data.kind == PlayerShapeData::Kind::kSpheres) {
        const Vec3 lower = shape.up() * margin;
        const auto of = [&](bool crouched) { return grown_spheres(data.postures[crouched].spheres, lower, margin); };
        return make_player_spheres(of(false), of(true), shape.up()).value();
    }
    PlayerSize size = data.given;
    size.radius += margin;
    size.height += 2 * margin;
    size.crouched_height += 2 * margin;
    const bool round = data.kind == PlayerShapeData::Kind::kCapsule;
    return round ? make_player_capsule(size).value() : make_player_box(size).value();
}

}  // namespace firma::reference
