// SPDX-License-Identifier: MIT
// Which sides of faces and portals bound the same room. Other than for brushes rock may reach to infinity, so rays go
// from a side to the first thing that it sees, rather than from infinity inward.
#include "gltf/room_sides.h"

#include <algorithm>

#include "geometry/grid_box.h"
#include "world/assemble_world.h"

namespace firma::gltf {
namespace {

__extension__ using Wide = __int128;

constexpr double kRayLength = 4 * kWorldRim;
constexpr double kOff = 1e-6;  ///< metres off a facet that a ray begins: more than rounding its middle, less than gaps

/// Turns of a facet's normal; the first is none.
constexpr Vec3 kTurns[] = {{0, 0, 0},           {0.31, -0.12, 0.22},  {-0.27, 0.35, 0.08},
                           {0.11, 0.24, -0.37}, {-0.18, -0.33, 0.29}, {0.42, 0.19, 0.05},
                           {-0.07, 0.28, 0.41}, {0.23, -0.39, -0.16}};

Vec3 middle_of(std::span<const GridPoint> corners) {
    Vec3 sum;
    for (const GridPoint& corner : corners) sum = sum + to_metres(corner);
    return sum * (1.0 / double(corners.size()));
}

Vec3 normal_of(std::span<const GridPoint> corners) {
    Vec3 normal;
    for (std::size_t k = 2; k < corners.size(); ++k)
        normal = normal + cross(to_metres(corners[k - 1]) - to_metres(corners[0]),
                                to_metres(corners[k]) - to_metres(corners[0]));
    return normal * (1 / length(normal));
}

/// Six times the volume between a facet and the origin, in cubic surface steps.
Wide cone_of(std::span<const GridPoint> corners) {
    Wide sum = 0;
    const GridPoint& a = corners[0];
    for (std::size_t k = 2; k < corners.size(); ++k) {
        const GridPoint &b = corners[k - 1], &c = corners[k];
        sum += Wide(a.x) * (Wide(b.y) * c.z - Wide(b.z) * c.y);
        sum += Wide(a.y) * (Wide(b.z) * c.x - Wide(b.x) * c.z);
        sum += Wide(a.z) * (Wide(b.x) * c.y - Wide(b.y) * c.x);
    }
    return sum;
}

World probe_of(std::size_t faces, const JoinFacets& facets) {
    WorldParts parts;
    FaceSet& set = parts.rooms.emplace_back().faces;
    for (std::uint32_t polygon = 0; polygon + 1 < facets.first.size(); ++polygon)
        for (std::uint32_t k = facets.first[polygon]; k < facets.first[polygon + 1]; ++k) {
            FaceSet::Entry face;
            face.id = {k};
            face.source = polygon;
            face.two_sided = polygon >= faces;
            face.first_corner = std::uint32_t(set.corners.size());
            face.corner_count = std::uint32_t(facets.corners[k].size());
            for (const GridPoint& corner : facets.corners[k]) {
                set.corners.push_back(std::uint32_t(set.vertices.size()));
                set.vertices.push_back(corner);
            }
            set.faces.push_back(face);
        }
    const Result<World> world = assemble_world(std::move(parts));
    return world ? world.value() : World();
}

}  // namespace

RoomSides::RoomSides(std::size_t faces, std::size_t portals, const JoinFacets& facets, bool rock_outside)
    : faces_(faces),
      sides_(faces + 2 * portals),
      facets_(facets),
      rock_outside_(rock_outside),
      probe_(probe_of(faces, facets)) {}

std::uint32_t RoomSides::polygon_of(std::uint32_t side) const {
    return side < faces_ ? side : std::uint32_t(faces_ + (side - faces_) / 2);
}

/// The side that is met first, or the one of infinity; nothing where an edge is met, which has several.
std::optional<std::uint32_t> RoomSides::seen_along(const Vec3& from, const Vec3& way) const {
    const Vec3 path = way * (kRayLength / length(way));
    const Hit hit = cast(probe_, {from, 0}, path);
    if (hit.status == Status::kMiss) return rock_outside_ ? std::nullopt : std::optional(std::uint32_t(sides_));
    if (hit.status != Status::kHit || hit.feature != Feature::kFace) return std::nullopt;
    if (hit.source < faces_) return hit.source;
    const Vec3 normal = normal_of(facets_.corners[facets_.first[hit.source]]);
    return std::uint32_t(faces_ + 2 * (hit.source - faces_)) + (dot(normal, path) > 0);
}

bool RoomSides::hang(std::uint32_t side, DisjointSets& sides) const {
    const std::uint32_t polygon = polygon_of(side);
    const double facing = side >= faces_ && ((side - faces_) & 1) ? -1 : 1;
    for (const Vec3& turn : kTurns)
        for (std::uint32_t k = facets_.first[polygon]; k < facets_.first[polygon + 1]; ++k) {
            const Vec3 normal = normal_of(facets_.corners[k]) * facing;
            const Vec3 way = normal + turn;
            const auto seen = seen_along(middle_of(facets_.corners[k]) + normal * kOff, way);
            if (!seen) continue;
            sides.join(side, *seen);
            return true;
        }
    return false;
}

std::vector<std::uint32_t> RoomSides::rooms(DisjointSets seen_together, std::uint32_t& count) const {
    DisjointSets all(sides_ + 1);
    for (std::uint32_t side = 0; side < sides_; ++side) all.join(side, seen_together.find(side));
    // A shell whose fronts look outward hangs in the air of another, or in that outside of all. From its largest side.
    std::vector<Wide> volume(sides_);
    std::vector<std::uint32_t> largest(sides_, ~0u);
    std::vector<double> size(sides_);
    for (std::uint32_t side = 0; side < sides_; ++side) {
        const bool back = side >= faces_ && ((side - faces_) & 1);
        const std::uint32_t shell = seen_together.find(side), polygon = polygon_of(side);
        for (std::uint32_t k = facets_.first[polygon]; k < facets_.first[polygon + 1]; ++k) {
            const Wide cone = cone_of(facets_.corners[k]);
            volume[shell] += back ? -cone : cone;
            GridBox box;
            for (const GridPoint& corner : facets_.corners[k]) box.add(corner);
            if (largest[shell] != ~0u && box.half_area() <= size[shell]) continue;
            largest[shell] = side;
            size[shell] = box.half_area();
        }
    }
    for (std::uint32_t side = 0; side < sides_; ++side)
        if (largest[side] != ~0u && volume[side] >= 0) hang(largest[side], all);

    std::vector<std::uint32_t> number(sides_ + 1, ~0u), of_side;
    const std::uint32_t outside = all.find(std::uint32_t(sides_));
    count = 0;
    for (std::uint32_t side = 0; side < sides_; ++side) {
        const std::uint32_t set = all.find(side);
        if (set != outside && number[set] == ~0u) number[set] = count++;
    }
    if (!rock_outside_) number[outside] = count++;
    for (std::uint32_t side = 0; side < sides_; ++side) of_side.push_back(number[all.find(side)]);
    return of_side;
}

std::uint32_t RoomSides::room_seen_from(std::span<const GridPoint> corners, std::span<const std::uint32_t> room_of_side,
                                        std::uint32_t count) const {
    const Vec3 normal = normal_of(corners), middle = middle_of(corners);
    for (const Vec3& turn : kTurns) {
        const auto seen = seen_along(middle + normal * kOff, normal + turn);
        if (seen && *seen < sides_) return room_of_side[*seen];
    }
    return count - 1;
}

}  // namespace firma::gltf
