// SPDX-License-Identifier: MIT
// What a ray, a sphere or a set of spheres meets of bodies.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "firma/bodies.h"
#include "firma/export.h"
#include "firma/motion.h"
#include "firma/polygon.h"
#include "firma/sphere_set.h"

namespace firma {

/// The first touch with a body.
struct BodyHit {
    Status status = Status::kMiss;
    double fraction = 1;              ///< of the way
    double safe_fraction = 1;         ///< the contact offset before it, by the speed along the normal; at least 0
    BodyId body{};                    ///< of several at one fraction that of the lowest slot
    std::uint32_t body_sphere = ~0u;  ///< of the body's shape
    std::uint32_t sphere = ~0u;       ///< of the set that was cast; 0 of a ray or a sphere
    Vec3 centre{};                    ///< of that sphere at the touch, metres
    Vec3 point{}, normal{};           ///< metres; unit, from the body toward what was cast
    Vec3 surface_velocity{};          ///< of the body there, metres a second

    [[nodiscard]] bool touched() const { return status == Status::kHit || status == Status::kInitialOverlap; }
};

struct BodyCastOptions {
    std::uint32_t mask = ~0u;  ///< bodies that share a bit are met
    BodyId except{};           ///< is not: who casts
    /// Metres for safe_fraction; not finite or below 0 counts as 0.
    double contact_offset = 0.001;
};

/// Where bodies are, or go within a time, for many casts. Holds what it needs of them: they may change meanwhile.
class BodyIndex {
public:
    /// @param seconds  bodies go on as they move for so long while a cast goes along its way, straight and turning
    /// evenly, whatever they meet; 0: they stand. Not finite or below 0 counts as 0.
    /// Bodies with numbers that are not finite or beyond 2^200 are left out. Costs a sort of the bodies.
    FIRMA_EXPORT explicit BodyIndex(const Bodies& bodies, double seconds = 0);

    /// A ray meets spheres, not the solids that these stand for. What begins in a sphere meets it where it comes nearer
    /// to its middle, else not at all.
    /// @return kMiss with fractions of 1; kInvalid, with 0, for numbers that are not finite, a negative radius, or a
    /// turn beyond kMaxAngle. Of sets and bodies that turn a touch may be early by what cast_set.h says, never late
    /// Never allocates. Cost grows with the logarithm of the bodies, and with the spheres of those near the way.
    [[nodiscard]] FIRMA_EXPORT BodyHit cast(const Ray& ray, const BodyCastOptions& options = {}) const;
    [[nodiscard]] FIRMA_EXPORT BodyHit cast(const Sphere& sphere, const Vec3& path,
                                            const BodyCastOptions& options = {}) const;
    [[nodiscard]] FIRMA_EXPORT BodyHit cast(std::span<const Sphere> spheres, const RigidMotion& motion,
                                            const BodyCastOptions& options = {}) const;

private:
    struct Data;
    std::shared_ptr<const Data> data_;
};

}  // namespace firma
