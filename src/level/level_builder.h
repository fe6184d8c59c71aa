// SPDX-License-Identifier: MIT
// Makes a Level of a file's vertices and faces: snaps, drops what has no area, divides what is not convex and planar.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "firma/level.h"
#include "level/fit_texture.h"

namespace firma {

class LevelBuilder {
public:
    explicit LevelBuilder(std::string name);

    /// Snaps a vertex (metres, already scaled) and returns its index; nothing when it is not finite or outside the
    /// world, and then nothing is added.
    std::optional<std::uint32_t> add_vertex(const Vec3& position);

    /// Index of a material or group of this name, added when new.
    std::uint32_t material(std::string_view name);
    std::uint32_t group(std::string_view name);

    /// What all pieces of one face of the file share.
    struct FaceInfo {
        std::uint32_t source = 0;
        std::uint32_t line = 0;  ///< 0 where the format has none
        std::uint32_t material = 0;
        std::uint32_t group = 0;
        FaceKind kind = FaceKind::kPolygon;
        bool two_sided = false;
        std::uint32_t mask = ~0u;
        double texture_slack = kTextureSlack;  ///< see fit_texture()
    };

    /// Adds a face by its outline (vertex indices, >= 3): whole when convex and exactly planar after the snap, else in
    /// triangles on its own outline; without area it is dropped. Notes say which.
    ///
    /// @param uvs  empty, or the texture coordinates of each corner, in repeats: what no one map gives is divided into
    ///             triangles too, each with its own map
    void add_face(std::span<const std::uint32_t> outline, const FaceInfo& info, std::span<const TexturePoint> uvs = {});

    /// Keeps the outlines of faces without area, and mends what dropping them leaves open: see mend_dropped.h.
    void mend_what_is_dropped() { mends_ = true; }

    /// The level; the builder is empty afterwards.
    /// @param omissions  what the reader left out beside faces without area
    Level finish(std::uint32_t source_faces, std::uint64_t ignored_entries, std::vector<Omission> omissions = {});

    std::size_t vertex_count() const { return level_.vertices.size(); }
    std::size_t corner_count() const { return level_.corners.size(); }
    /// What a Level can index; whoever reads a file stops when a count exceeds it.
    static constexpr std::size_t kMaxCount = std::size_t(1) << 31;

private:
    void add_piece(std::span<const std::uint32_t> corners, const FaceInfo& info, std::uint32_t texture);
    std::uint32_t add_texture(std::span<const std::uint32_t> corners, std::span<const TexturePoint> uvs,
                              const FaceInfo& info);

    Level level_;
    std::vector<GridPoint> outline_;  ///< of the face at hand
    std::vector<Vec3> metres_;        ///< of the corners at hand
    bool mends_ = false;
    std::vector<std::vector<std::uint32_t>> dropped_;
    std::unordered_map<std::string, std::uint32_t> material_index_, group_index_;
};

}  // namespace firma
