// SPDX-License-Identifier: MIT
// By overlap_each() of the posture's shapes.
#include "tests/reference/player_overlap.h"

#include <optional>

#include "player/player_shape.h"
#include "tests/reference/grown_player.h"

namespace firma::reference {

namespace {

constexpr double kRounding = 1e-9;  // metres

void each_overlap(const Scene& scene, const PlayerShape& shape, const Vec3& feet, bool crouched,
                  PartOverlapVisitor look) {
    const Posture& posture = shape.data().postures[crouched];
    const Capsule& capsule = posture.capsule;
    switch (shape.data().kind) {
        case PlayerShapeData::Kind::kCapsule:
            overlap_each(scene, Capsule{capsule.from + feet, capsule.to + feet, capsule.radius}, look);
            break;
        case PlayerShapeData::Kind::kBox:
            overlap_each(scene, posture.box, feet + posture.middle, look);
            break;
        case PlayerShapeData::Kind::kSpheres:
            for (const Sphere& sphere : posture.spheres)
                overlap_each(scene, Sphere{sphere.centre + feet, sphere.radius}, look);
    }
}

}  // namespace

std::string player_overlap(const Scene& scene, const PlayerShape& shape, const Vec3& feet, bool crouched) {
    // Of the shape without its outermost: what is but touched from behind, at an edge, is deep behind a face at once.
    const PlayerShape inner = grown_player(shape, -kRounding);
    const Vec3 raised = feet + shape.up() * kRounding, middle = feet + shape.data().postures[crouched].middle;
    std::string what;
    each_overlap(scene, inner, raised, crouched, [&](const PartOverlap& overlap) {
        const std::string depth = " by " + std::to_string(overlap.depth * 1e6) + " um";
        if (overlap.part != kNoPart) {
            what = "part " + std::to_string(overlap.part) + depth;
            return true;
        }
        const std::optional<FaceInfo> face = scene.world.face_info(overlap.face);
        const bool in_front = !face || dot(middle - overlap.point, face->normal) > 0;
        if ((!face || face->solid) && in_front) what = "the level" + depth;
        return true;
    });
    return what;
}

bool is_held_by_sheet(const Scene& scene, const PlayerShape& shape, const Vec3& feet, bool crouched, const Vec3& way) {
    bool held = false;
    each_overlap(scene, shape, feet, crouched, [&](const PartOverlap& overlap) {
        if (overlap.part != kNoPart || overlap.depth <= kRounding) return true;
        const std::optional<FaceInfo> face = scene.world.face_info(overlap.face);
        held = face && !face->solid && !face->two_sided && dot(way, face->normal) < 0;
        return !held;
    });
    return held;
}

}  // namespace firma::reference
