// SPDX-License-Identifier: MIT
// Makes a Level of a file's vertices and faces.
#include "level/level_builder.h"

#include <utility>
#include <vector>

#include "geometry/triangulate_convex.h"
#include "level/divide_polygon.h"
#include "level/mend_dropped.h"

namespace firma {
namespace {

std::uint32_t index_of(std::string_view name, std::vector<std::string>& names,
                       std::unordered_map<std::string, std::uint32_t>& index) {
    const auto [entry, is_new] = index.try_emplace(std::string(name), std::uint32_t(names.size()));
    if (is_new) names.emplace_back(name);
    return entry->second;
}

}  // namespace

LevelBuilder::LevelBuilder(std::string name) {
    level_.name = std::move(name);
    material("");
    group("");
}

std::optional<std::uint32_t> LevelBuilder::add_vertex(const Vec3& position) {
    const auto point = snap(position);
    if (!point) return std::nullopt;
    level_.vertices.push_back(*point);
    return std::uint32_t(level_.vertices.size() - 1);
}

std::uint32_t LevelBuilder::material(std::string_view name) {
    return index_of(name, level_.materials, material_index_);
}

std::uint32_t LevelBuilder::group(std::string_view name) {
    return index_of(name, level_.groups, group_index_);
}

void LevelBuilder::add_face(std::span<const std::uint32_t> outline, const FaceInfo& info,
                            std::span<const TexturePoint> uvs) {
    outline_.clear();
    for (const std::uint32_t corner : outline) outline_.push_back(level_.vertices[corner]);
    Division division = divide_polygon(outline_);
    std::uint32_t texture = kNoTexture;
    switch (division.what) {
        case Division::What::kNoArea:
            level_.notes.push_back({FaceNote::kNoArea, info.source, info.line});
            if (mends_) dropped_.emplace_back(outline.begin(), outline.end());
            return;
        case Division::What::kWhole:
            texture = add_texture(outline, uvs, info);
            if (uvs.empty() || outline.size() == 3 || texture != kNoTexture) {
                add_piece(outline, info, texture);
                return;
            }
            triangulate_convex(outline_, division.triangles);
            // A cell of a patch is no face of the file.
            if (info.kind != FaceKind::kPatch) level_.notes.push_back({FaceNote::kTexture, info.source, info.line});
            break;
        case Division::What::kSplit:
            level_.notes.push_back({FaceNote::kSplit, info.source, info.line});
            texture = add_texture(outline, uvs, info);
            break;
        case Division::What::kCrossing:
            level_.notes.push_back({FaceNote::kCrossing, info.source, info.line});
            texture = add_texture(outline, uvs, info);
            break;
    }
    for (const auto& [a, b, c] : division.triangles) {
        const std::array<std::uint32_t, 3> corners{outline[a], outline[b], outline[c]};
        if (uvs.empty() || texture != kNoTexture)
            add_piece(corners, info, texture);
        else
            add_piece(corners, info, add_texture(corners, std::array{uvs[a], uvs[b], uvs[c]}, info));
    }
}

/// kNoTexture where no one map gives the coordinates, or none are given.
std::uint32_t LevelBuilder::add_texture(std::span<const std::uint32_t> corners, std::span<const TexturePoint> uvs,
                                        const FaceInfo& info) {
    if (uvs.empty()) return kNoTexture;
    metres_.clear();
    for (const std::uint32_t corner : corners) metres_.push_back(to_metres(level_.vertices[corner]));
    const std::optional<TextureProjection> fitted = fit_texture(metres_, uvs, info.texture_slack);
    if (!fitted) return kNoTexture;
    if (level_.textures.empty() || level_.textures.back() != *fitted) level_.textures.push_back(*fitted);
    return std::uint32_t(level_.textures.size() - 1);
}

void LevelBuilder::add_piece(std::span<const std::uint32_t> corners, const FaceInfo& info, std::uint32_t texture) {
    LevelFace face;
    face.first_corner = std::uint32_t(level_.corners.size());
    face.corner_count = std::uint32_t(corners.size());
    face.source = info.source;
    face.material = info.material;
    face.group = info.group;
    face.kind = info.kind;
    face.two_sided = info.two_sided;
    face.mask = info.mask;
    face.texture = texture;
    level_.corners.insert(level_.corners.end(), corners.begin(), corners.end());
    level_.faces.push_back(face);
}

Level LevelBuilder::finish(std::uint32_t source_faces, std::uint64_t ignored_entries, std::vector<Omission> omissions) {
    level_.omissions = std::move(omissions);
    for (const LevelNote& note : level_.notes) {
        if (note.what != FaceNote::kNoArea) continue;
        const std::string first = note.line == 0 ? level_.name + ": face " + std::to_string(note.source)
                                                 : level_.name + ":" + std::to_string(note.line);
        level_.omissions.push_back({"faces without area", level_.count(FaceNote::kNoArea), first});
        break;
    }
    level_.source_faces = source_faces;
    level_.ignored_entries = ignored_entries;
    if (!dropped_.empty()) mend_dropped(std::exchange(dropped_, {}), level_);
    Level finished = std::exchange(level_, Level{});
    material_index_.clear();
    group_index_.clear();
    return finished;
}

}  // namespace firma
