// SPDX-License-Identifier: MIT
// What a world is made of: its table, and which matter a place or a face is of.
#include "firma/matter.h"

#include <cmath>
#include <cstdint>
#include <optional>

#include "solid/matter_pieces.h"
#include "world/world_data.h"

namespace firma {
namespace {

/// The nearest point of the surface grid; nothing outside the world.
std::optional<GridPoint> on_surface_grid(const Vec3& point) {
    GridPoint rounded;
    for (int axis = 0; axis < 3; ++axis) {
        const double at = std::floor(point[axis] * kSurfaceSteps + 0.5);
        if (!(at >= double(INT32_MIN) && at <= double(INT32_MAX))) return std::nullopt;
        rounded[axis] = std::int32_t(at);
    }
    return rounded;
}

/// Behind the middle of a facet: so far as no rounding reaches, and no wall is thin.
constexpr double kBehind = 1.0 / 1024;  // metres

}  // namespace

const MatterTable& matters_of(const World& world) {
    return world.data().matters ? world.data().matters->table : default_matters();
}

const Matter& matter(const World& world, std::uint32_t index) {
    const std::vector<Matter>& all = matters_of(world).matters;
    return all[index < all.size() ? index : 0];
}

std::uint32_t matter_at(const World& world, const Vec3& point) {
    const MatterPieces* pieces = world.data().matters.get();
    if (!pieces) return 0;
    const std::optional<GridPoint> at = on_surface_grid(point);
    if (!at) return pieces->rest;
    const std::optional<std::uint32_t> piece = piece_at(*pieces, *at, world.data().rules.get());
    return piece ? pieces->pieces[*piece].matter : pieces->rest;
}

std::optional<std::uint32_t> matter_of(const World& world, const FaceRef& ref) {
    const std::optional<Face> face = world.face(ref);
    if (!face) return std::nullopt;
    const MatterPieces* pieces = world.data().matters.get();
    if (!pieces) return 0;
    if (face->source_edit == 0) return pieces->of_source(face->source);
    Vec3 sum;
    for (const Vec3& corner : face->corners) sum = sum + corner;
    return matter_at(world, sum * (1.0 / double(face->corners.size())) - face->normal * kBehind);
}

MatterCounts count_matters(const World& world) {
    MatterCounts counts;
    counts.of_matter.resize(matters_of(world).matters.size());
    const MatterPieces* pieces = world.data().matters.get();
    if (!pieces) return counts;
    counts.rest = pieces->rest;
    counts.pieces = pieces->pieces.size();
    for (const MatterPiece& piece : pieces->pieces) {
        ++counts.of_matter[piece.matter];
        counts.protected_pieces += hardness_of(*pieces, piece, world.data().rules.get()) >= 1;
    }
    return counts;
}

}  // namespace firma
