// SPDX-License-Identifier: MIT
// By overlap_each() of the posture's shapes.
#include "tests/reference/player_overlap.h"

#include <optional>

#include "player/player_shape.h"

namespace firma::reference {

std::string player_overlap(const Scene& scene, const PlayerShape& shape, const Vec3& feet, bool crouched) {
    constexpr double kRounding = 1e-9;  // metres
    const Posture& posture = shape.data().postures[crouched];
    const Vec3 middle = feet + posture.middle;
    std::string what;
    const auto look = [&](const PartOverlap& overlap) {
        if (overlap.depth <= kRounding) return true;
        const std::string depth = " by " + std::to_string(overlap.depth * 1e6) + " um";
        if (overlap.part != kNoPart) {
            what = "part " + std::to_string(overlap.part) + depth;
            return true;
        }
        const std::optional<FaceInfo> face = scene.world.face_info(overlap.face);
        const bool in_front = !face || dot(middle - overlap.point, face->normal) > 0;
        if ((!face || face->solid) && in_front) what = "the level" + depth;
        return true;
    };
    const Capsule& capsule = posture.capsule;
    switch (shape.data().kind) {
        case PlayerShapeData::Kind::kCapsule:
            overlap_each(scene, Capsule{capsule.from + feet, capsule.to + feet, capsule.radius}, look);
            break;
        case PlayerShapeData::Kind::kBox:
            overlap_each(scene, posture.box, middle, look);
            break;
        case PlayerShapeData::Kind::kSpheres:
            for (const Sphere& sphere : posture.spheres)
                overlap_each(scene, Sphere{sphere.centre + feet, sphere.radius}, look);
    }
    return what;
}

}  // namespace firma::reference
