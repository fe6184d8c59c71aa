// SPDX-License-Identifier: MIT
// The push of an explosion on bodies and players: weaker farther away, and by what stands before them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "firma/bodies.h"
#include "firma/export.h"
#include "firma/moving_parts.h"
#include "firma/polygon.h"
#include "firma/vec.h"
#include "firma/world.h"

namespace firma {

/// An explosion.
struct Blast {
    Vec3 at{};              ///< metres
    double radius = 6;      ///< metres, above zero: nothing is felt from there on
    double impulse = 3000;  ///< newton seconds a square metre that faces it, at `at`; >= 0
};

/// What is left of a blast at a distance: (1 - distance / radius)^2, 0 from the radius on and for what is not finite.
[[nodiscard]] FIRMA_EXPORT double blast_share(const Blast& blast, double distance);

/// Newton seconds that a blast gives to something, away from it.
/// @param point  metres, where it is felt; at Blast::at itself the push is up the z axis
/// @param area   square metres that face the blast
/// @param seen   0 to 1, the share of these that nothing covers: exposure()
/// @return zero for what is not finite or negative
[[nodiscard]] FIRMA_EXPORT Vec3 blast_impulse(const Blast& blast, const Vec3& point, double area, double seen = 1);

/// The share of points that are seen from a point: a ray to each meets no front of a face of the level or a part on the
/// way, nor a closed portal. Parts cover from where they are as the scene's stretch begins. What is behind a fence is
/// seen: give a mask (CastOptions::mask) of what stops a blast.
/// @return 0 for no points; a point that is not finite is not seen; nothing is in a scene that cannot be cast in
/// Never allocates. Costs a cast_any() a point: a wall is never missed.
[[nodiscard]] FIRMA_EXPORT double exposure(const Scene& scene, const Vec3& from, std::span<const Vec3> points,
                                           std::uint32_t mask = ~0u);
/// The same of spheres, as a player is made of: of each its middle and four points around it, nearly as far out as it
/// reaches across the view; spheres count by the areas that they show.
[[nodiscard]] FIRMA_EXPORT double exposure(const Scene& scene, const Vec3& from, std::span<const Sphere> spheres,
                                           std::uint32_t mask = ~0u);
/// In a world without parts.
[[nodiscard]] inline double exposure(const World& world, const Vec3& from, std::span<const Vec3> points,
                                     std::uint32_t mask = ~0u) {
    return exposure(Scene{world}, from, points, mask);
}
[[nodiscard]] inline double exposure(const World& world, const Vec3& from, std::span<const Sphere> spheres,
                                     std::uint32_t mask = ~0u) {
    return exposure(Scene{world}, from, spheres, mask);
}

struct PushOptions {
    std::uint32_t mask = ~0u;  ///< faces that stop a blast
    /// Metres a second: a push gives no body more, whatever its mass, nor does its turning give any point of it more;
    /// infinity is no limit.
    double max_speed = 30;
};

struct PushReport {
    std::size_t reached = 0;  ///< bodies with a sphere within the radius
    std::size_t pushed = 0;   ///< of these, that were not wholly covered; they wake
};

/// Pushes all bodies near a blast: each sphere at its middle, away from the blast, by its share of what the body shows
/// and by how much of it is seen, as exposure() says; so a body behind the edge of a wall turns. Other bodies cover
/// nothing.
/// @return all 0, and nothing pushed, for a blast or a limit that is not finite or out of range
/// The same bits on every machine. Costs five rays a sphere that is near enough.
FIRMA_EXPORT PushReport blast_push(const Scene& scene, Bodies& bodies, const Blast& blast,
                                   const PushOptions& options = {});
/// In a world without parts.
inline PushReport blast_push(const World& world, Bodies& bodies, const Blast& blast, const PushOptions& options = {}) {
    return blast_push(Scene{world}, bodies, blast, options);
}

}  // namespace firma
