// SPDX-License-Identifier: MIT
// Puts brushes together into a BrushLevel.
#include "brush/brush_builder.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "brush/brush_kinds.h"

namespace firma {
namespace {

// The largest side; areas that differ by rounding alone are equal.
std::size_t largest_side(std::span<const BrushBuilder::Side> sides) {
    constexpr double kMore = 1 + 1.0 / (1 << 20);
    std::size_t best = 0;
    for (std::size_t k = 1; k < sides.size(); ++k)
        if (sides[k].area > sides[best].area * kMore) best = k;
    return best;
}

}  // namespace

BrushBuilder::BrushBuilder(std::string name, double scale) : scale_(scale) {
    level.name = std::move(name);
    level.metres_a_unit = scale;
    material("");
}

std::uint32_t BrushBuilder::material(std::string_view name) {
    const auto [entry, is_new] = material_index_.try_emplace(std::string(name), std::uint32_t(level.materials.size()));
    if (is_new) level.materials.emplace_back(name);
    return entry->second;
}

std::uint32_t BrushBuilder::texture(const TextureProjection& projection) {
    std::string key(1, char(projection.unit));
    for (const double number : {projection.u_axis.x, projection.u_axis.y, projection.u_axis.z, projection.u_offset,
                                projection.v_axis.x, projection.v_axis.y, projection.v_axis.z, projection.v_offset}) {
        const float rounded = float(number) + 0.0f;  // of two zeros one
        char bytes[sizeof rounded];
        std::memcpy(bytes, &rounded, sizeof rounded);
        key.append(bytes, sizeof bytes);
    }
    const auto [entry, is_new] = texture_index_.try_emplace(std::move(key), std::uint32_t(level.textures.size()));
    if (is_new) level.textures.push_back(projection);
    return entry->second;
}

void BrushBuilder::add(Brush brush, std::span<const Side> sides) {
    brush.first_side = std::uint32_t(level.sides.size());
    brush.side_count = std::uint32_t(sides.size());
    const bool is_portal = brush.kind == BrushKind::kPortal && !sides.empty();
    const bool all = is_portal && std::all_of(sides.begin(), sides.end(),
                                              [&](const Side& side) { return side.portal == sides[0].portal; });
    const std::size_t largest = all ? largest_side(sides) : sides.size();
    for (std::size_t k = 0; k < sides.size(); ++k) {
        BrushSide& side = level.sides.emplace_back(sides[k].side);
        side.mask = side_mask(brush.kind, sides[k].sky);
        side.portal = is_portal && (all ? k == largest : sides[k].portal);
    }
    level.brushes.push_back(brush);
}

void BrushBuilder::shift(double metres, std::string_view place) {
    level.max_shift = std::max(level.max_shift, metres);
    if (metres > kNotableShift) notes.add("plane moved by more than 1 mm onto the grid", place);
}

void BrushBuilder::add_patch(PatchSurface patch) {
    if (patch.mask == 0) {
        notes.add("patch that nothing meets is left out", patch.place);
        return;
    }
    patches_.push_back(std::move(patch));
}

Result<BrushLevel> BrushBuilder::finish(double patch_tolerance) {
    const auto first_source = std::uint32_t(level.sides.size());
    for (std::uint32_t k = 0; k < patches_.size(); ++k) patches_[k].source = first_source + k;
    Result<Level> surfaces =
        make_patch_level(patches_, level.name, first_source + std::uint32_t(patches_.size()), scale_, patch_tolerance);
    if (!surfaces) return surfaces.error();
    level.surfaces = std::move(surfaces).value();
    level.notes = notes.texts();
    level.omissions = notes.omissions();
    return std::move(level);
}

}  // namespace firma
