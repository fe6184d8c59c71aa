// SPDX-License-Identifier: MIT
// The brushes of one entity that moves: as solid as they would be if it stood still, and placed from its origin.
#include "brush/part_level.h"

#include <cmath>
#include <optional>

#include "brush/brush_kinds.h"
#include "brush/winding.h"

namespace firma {
namespace {

/// Whether a brush marks the origin: by its texture, whatever folder that is in.
bool marks_origin(const BrushLevel& level, const Brush& brush) {
    if (brush.side_count == 0) return false;
    const std::string& name = level.materials[level.sides[brush.first_side].material];
    const std::string_view last = std::string_view(name).substr(name.rfind('/') + 1);  // npos + 1 is 0
    return last == "origin" || last == "ORIGIN";
}

std::optional<Vec3> middle_of(const BrushLevel& level, const Brush& brush) {
    std::vector<FloatPlane> planes;
    for (std::uint32_t k = 0; k < brush.side_count; ++k) {
        const GridPoint(&p)[3] = level.sides[brush.first_side + k].points;
        if (const auto plane = float_plane(to_metres(p[0]), to_metres(p[1]), to_metres(p[2]))) planes.push_back(*plane);
    }
    Box box;
    for (std::size_t side = 0; side < planes.size(); ++side)
        for (const Vec3& corner : winding(planes, side, 4 * kWorldRim)) box.add(corner);
    if (box.empty()) return std::nullopt;
    return (box.low + box.high) * 0.5;
}

/// Where the frame is, and by how much its brushes are moved to be in it.
struct FrameOrigin {
    Vec3 position;
    GridPoint moved;
    bool given = false;
};

std::optional<FrameOrigin> origin_of(const BrushLevel& level, std::uint32_t number) {
    const std::optional<Vec3> key = entity_origin(level, level.entities[number]);
    if (level.placed_from_origins) {
        if (!key) return FrameOrigin{};
        return FrameOrigin{*key, {}, true};
    }
    std::optional<Vec3> middle;
    for (const Brush& brush : level.brushes)
        if (brush.entity == number && !middle && marks_origin(level, brush)) middle = middle_of(level, brush);
    if (!middle) middle = key;
    if (!middle) return FrameOrigin{};
    const std::optional<GridPoint> snapped = snap(*middle);
    if (!snapped) return std::nullopt;
    return FrameOrigin{to_metres(*snapped), *snapped, true};
}

/// @return whether it is still in the world
bool move_back(GridPoint& point, const GridPoint& by) {
    for (int axis = 0; axis < 3; ++axis) {
        const std::int64_t moved = std::int64_t(point[axis]) - by[axis];
        if (moved < INT32_MIN || moved > INT32_MAX) return false;
        point[axis] = std::int32_t(moved);
    }
    return true;
}

}  // namespace

PartLevel part_level(const BrushLevel& level, std::uint32_t entity) {
    PartLevel part;
    const std::optional<FrameOrigin> origin = origin_of(level, entity);
    if (!origin) {
        part.fault = "its origin lies outside the world";
        return part;
    }
    part.position = origin->position;
    part.has_origin = origin->given;
    part.level.name = level.name;
    part.level.entities.resize(1);
    part.level.materials = level.materials;
    part.level.textures = level.textures;
    part.level.metres_a_unit = level.metres_a_unit;
    for (TextureProjection& texture : part.level.textures) {
        texture.u_offset += dot(texture.u_axis, to_metres(origin->moved));
        texture.v_offset += dot(texture.v_axis, to_metres(origin->moved));
    }
    for (const Brush& from : level.brushes) {
        if (from.entity != entity || from.part_kind == BrushKind::kData || from.part_kind == BrushKind::kPortal)
            continue;
        Brush brush = from;
        brush.first_side = std::uint32_t(part.level.sides.size());
        brush.kind = from.part_kind;
        brush.part_kind = BrushKind::kData;
        brush.entity = 0;
        for (std::uint32_t k = 0; k < from.side_count; ++k) {
            BrushSide& side = part.level.sides.emplace_back(level.sides[from.first_side + k]);
            side.mask = side_mask(brush.kind, false);
            side.portal = false;
            for (GridPoint& point : side.points)
                if (!move_back(point, origin->moved)) part.fault = "it reaches too far from its origin";
        }
        part.level.brushes.push_back(brush);
    }
    if (part.level.brushes.empty()) part.fault = "it has no brush that anything meets";
    return part;
}

}  // namespace firma
