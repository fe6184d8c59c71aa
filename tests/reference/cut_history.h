// SPDX-License-Identifier: MIT
// Where a point must lie after a level's cuts, from the level's faces and the cutters alone: no cut is looked at, so
// what one of them did wrong shows in every later one.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "carve/place_cutter.h"
#include "firma/carve.h"
#include "firma/world.h"
#include "scenes/rng.h"

namespace firma::reference {

using Triangle = std::array<Vec3, 3>;

/// All facets that bound the solid, as triangles.
std::vector<Triangle> triangles_of(const World& world);
std::vector<Triangle> triangles_of(const PlacedCutter& cutter);
/// How often a closed surface winds around a point, by solid angles in double.
double winding(std::span<const Triangle> surface, const Vec3& point);

class CutHistory {
public:
    /// @param level  before any cut
    explicit CutHistory(const World& level);

    /// The next cut. One that was refused is not told.
    void add(const PlacedCutter& cutter, CarveKind kind);

    /// Whether a point is solid; nothing for a point nearer than 20 um to the plane of a face: facets are rounded by up
    /// to 3.3 um.
    std::optional<bool> solid_at(const Vec3& point) const;

    /// A point just beside the surface of one of the last cutters or of the level near it: on a corner, an edge or the
    /// inside of a triangle, and 2^-5 to 2^-12 m away from it.
    Vec3 point_beside(scenes::Rng& rng) const;

private:
    struct Shape {
        std::vector<Triangle> surface;
        std::vector<Vec3> normals;  ///< unit
        CarveKind kind;
        Box box;
    };
    static Shape shape_of(std::vector<Triangle> surface, CarveKind kind);
    std::vector<Shape> shapes_;  ///< the level, then the cutters
    bool rock_outside_;
};

}  // namespace firma::reference
