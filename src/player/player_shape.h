// SPDX-License-Identifier: MIT
// What a player's shape is made of, and what it asks of a world.
#pragma once

#include "firma/capsule.h"
#include "firma/hull.h"
#include "firma/moving_parts.h"
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
    PlayerSize given;     ///< what it was made with; of spheres `up` alone
};

/// A face of the level or of a part, where it is.
struct FaceThere {
    Vec3 normal;
    bool two_sided = false;
};
std::optional<FaceThere> face_there(const Scene& scene, std::uint32_t part, const FaceRef& face);

/// One posture of a shape in a scene whose parts stand: casts and overlaps with the feet anywhere.
class PostureIn {
public:
    /// @param scene  outlives this
    PostureIn(const Scene& scene, const PlayerShapeData& shape, bool crouched, std::uint32_t mask, double offset);

    double height() const { return posture_->height; }  ///< metres
    PartHit sweep(const Vec3& feet, const Vec3& path) const;
    /// The same, but what is met up to 16 contact offsets beyond the end counts, too, where keeping the offset from it
    /// ends the way before its end: then `fraction` may be above 1. What is met later than that is a miss.
    PartHit sweep_ahead(const Vec3& feet, const Vec3& path) const;
    bool overlaps(const Vec3& feet) const;
    /// The one that it is deepest in; depth 0 where there is none.
    PartOverlap deepest(const Vec3& feet) const {
        return deepest_where(feet, [](const PartOverlap&) { return true; });
    }
    /// The same of parts alone.
    PartOverlap deepest_of_parts(const Vec3& feet) const {
        return deepest_where(feet, [](const PartOverlap& overlap) { return overlap.part != kNoPart; });
    }
    Location where(const Vec3& feet) const;  ///< of its middle, in the level
    /// The first part whose solid its middle lies in: there overlaps tell nothing, as all faces are behind.
    std::uint32_t part_around(const Vec3& feet) const;

private:
    /// Of faces that can be met from where its middle is: of one-sided ones not from behind, as for casts.
    void each_overlap(const Vec3& feet, PartOverlapVisitor visit) const;
    PartOverlap deepest_where(const Vec3& feet, PartOverlapVisitor counts) const;
    bool is_behind(const Vec3& middle, const PartOverlap& overlap) const;

    const Scene* scene_;
    PlayerShapeData::Kind kind_;
    const Posture* posture_;
    CastOptions options_;
    NearOptions near_;
};

}  // namespace firma
