// SPDX-License-Identifier: MIT
// Makes a Level of a file's vertices and faces.
#include "level/level_builder.h"

#include <utility>
#include <vector>

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

void LevelBuilder::add_face(std::span<const std::uint32_t> outline, const FaceInfo& info) {
    outline_.clear();
    for (const std::uint32_t corner : outline) outline_.push_back(level_.vertices[corner]);
    const Division division = divide_polygon(outline_);
    switch (division.what) {
        case Division::What::kWhole:
            add_piece(outline, info);
            return;
        case Division::What::kNoArea:
            level_.notes.push_back({FaceNote::kNoArea, info.source, info.line});
            if (mends_) dropped_.emplace_back(outline.begin(), outline.end());
            return;
        case Division::What::kSplit:
            level_.notes.push_back({FaceNote::kSplit, info.source, info.line});
            break;
        case Division::What::kCrossing:
            level_.notes.push_back({FaceNote::kCrossing, info.source, info.line});
            break;
    }
    for (const auto& [a, b, c] : division.triangles) {
        const std::array<std::uint32_t, 3> corners{outline[a], outline[b], outline[c]};
        add_piece(corners, info);
    }
}

void LevelBuilder::add_piece(std::span<const std::uint32_t> corners, const FaceInfo& info) {
    LevelFace face;
    face.first_corner = std::uint32_t(level_.corners.size());
    face.corner_count = std::uint32_t(corners.size());
    face.source = info.source;
    face.material = info.material;
    face.group = info.group;
    face.kind = info.kind;
    face.two_sided = info.two_sided;
    face.mask = info.mask;
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
