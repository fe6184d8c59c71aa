// SPDX-License-Identifier: MIT
// What a player's shape is made of, and what it asks of a world.
#pragma once

#include "firma/capsule.h"
#include "firma/hull.h"
#include "firma/players.h"
#include "firma/rooms.h"

namespace firma {

/// In one posture, with the feet at the origin.
struct Posture {
    double height = 0;
    Vec3 middle;  ///< half way up
    Capsule capsule;
    Hull box;
    SphereSet spheres;
};

struct PlayerShapeData {
    enum class Kind : std::uint8_t { kCapsule, kBox, kSpheres } kind = Kind::kCapsule;
    double radius = 0;
    Vec3 up;
    Posture postures[2];  ///< standing, crouched
};

/// One posture of a shape in a world: casts and overlaps with the feet anywhere.
class PostureIn {
public:
    PostureIn(const World& world, const PlayerShapeData& shape, bool crouched, std::uint32_t mask, double offset);

    Hit sweep(const Vec3& feet, const Vec3& path) const;
    bool overlaps(const Vec3& feet) const;
    /// The one that it is deepest in; depth 0 where there is none.
    Overlap deepest(const Vec3& feet) const;
    Location where(const Vec3& feet) const;  ///< of its middle

private:
    /// Of faces that can be met from where its middle is: of one-sided ones not from behind, as for casts.
    void each_overlap(const Vec3& feet, OverlapVisitor visit) const;
    bool is_behind(const Vec3& middle, const Overlap& overlap) const;

    const World* world_;
    PlayerShapeData::Kind kind_;
    const Posture* posture_;
    CastOptions options_;
    NearOptions near_;
};

}  // namespace firma
