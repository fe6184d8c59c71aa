// SPDX-License-Identifier: MIT
// Tessellates patches into a Level.
#include "brush/patch_level.h"

#include <array>
#include <optional>
#include <utility>

#include "level/divide_patches.h"
#include "level/divide_polygon.h"
#include "level/judge_input.h"
#include "level/level_builder.h"
#include "level/shared_vertices.h"
#include "level/tessellate_patch.h"

namespace firma {
namespace {

constexpr std::uint64_t kMostCells = std::uint64_t(1) << 22;  // of all patches together

std::optional<Error> judge_control(const PatchSurface& surface, double scale) {
    const std::vector<Vec3>& control = surface.patch.control;
    for (std::size_t k = 0; k < control.size(); ++k) {
        if (!snap(control[k] * scale)) {
            return Error{ErrorCode::kOutOfRange, surface.place,
                         "control point " + std::to_string(k) + ": " + point_fault(control[k], scale)};
        }
    }
    return std::nullopt;
}

class PatchFaces {
public:
    PatchFaces(std::string name, double scale, double patch_tolerance)
        : builder_(std::move(name)), vertices_(builder_), scale_(scale) {
        info_.texture_slack = patch_tolerance;  // the picture may be off by as much as the surface
    }

    std::optional<Error> add(const PatchSurface& surface, const PatchDivision& division) {
        points_.clear();
        for (const Vec3& point : tessellate_patch(surface.patch, division)) {
            const std::optional<GridPoint> snapped = snap(point * scale_);
            if (!snapped) return Error{ErrorCode::kOutOfRange, surface.place, "patch touches the rim of the world"};
            points_.push_back(*snapped);
        }
        uvs_.clear();
        if (!surface.uvs.control.empty())
            for (const Vec3& uv : tessellate_patch(surface.uvs, division)) uvs_.push_back({uv.x, uv.y});
        info_.source = surface.source;
        info_.line = surface.line;
        info_.material = builder_.material(surface.texture);
        info_.group = builder_.group("patches");
        info_.kind = FaceKind::kPatch;
        info_.mask = surface.mask;
        const std::size_t width = division.columns();
        std::size_t pieces = 0;
        for (std::size_t y = 0; y + 1 < division.rows(); ++y) {
            for (std::size_t x = 0; x + 1 < width; ++x) {
                const std::size_t at = y * width + x;
                pieces += add_cell({at, at + 1, at + width + 1, at + width});
            }
        }
        if (pieces == 0) builder_.add_face({}, info_);  // notes that it has no area
        return std::nullopt;
    }

    Level finish(std::uint32_t source_end) { return builder_.finish(source_end, 0); }

private:
    // A cell is ours, not the file's: when it has to be divided, no face of the file is. Corners may be in one place.
    bool add_cell(const std::array<std::size_t, 4>& cell) {
        corners_.clear();
        cell_uvs_.clear();
        for (const std::size_t at : cell) {
            if (!corners_.empty() && corners_.back() == points_[at]) continue;
            corners_.push_back(points_[at]);
            if (!uvs_.empty()) cell_uvs_.push_back(uvs_[at]);
        }
        while (corners_.size() > 1 && corners_.back() == corners_.front()) corners_.pop_back();
        if (!uvs_.empty()) cell_uvs_.resize(corners_.size());
        const Division division = divide_polygon(corners_);
        if (division.what == Division::What::kNoArea) return false;
        outline_.clear();
        for (const GridPoint& point : corners_) outline_.push_back(vertices_.at(point));
        if (division.what == Division::What::kWhole) builder_.add_face(outline_, info_, cell_uvs_);
        for (const auto& [a, b, c] : division.triangles) {
            const std::array corners{outline_[a], outline_[b], outline_[c]};
            if (uvs_.empty())
                builder_.add_face(corners, info_);
            else
                builder_.add_face(corners, info_, std::array{cell_uvs_[a], cell_uvs_[b], cell_uvs_[c]});
        }
        return true;
    }

    LevelBuilder builder_;
    SharedVertices vertices_;
    double scale_;
    LevelBuilder::FaceInfo info_;
    std::vector<GridPoint> points_, corners_;
    std::vector<TexturePoint> uvs_, cell_uvs_;  ///< of these
    std::vector<std::uint32_t> outline_;
};

}  // namespace

Result<Level> make_patch_level(std::span<const PatchSurface> patches, std::string name, std::uint32_t source_end,
                               double scale, double patch_tolerance) {
    std::vector<Patch> nets;
    for (const PatchSurface& surface : patches) {
        if (auto error = judge_control(surface, scale)) return *std::move(error);
        nets.push_back(surface.patch);
    }
    const auto divisions = divide_patches(nets, patch_tolerance / scale, kMostCells);
    if (!divisions) {
        return Error{ErrorCode::kTooLarge, std::move(name),
                     "patches come to more than " + std::to_string(kMostCells) +
                         " cells at this tolerance; a larger patch_tolerance makes fewer"};
    }
    PatchFaces faces(std::move(name), scale, patch_tolerance);
    for (std::size_t k = 0; k < patches.size(); ++k)
        if (auto error = faces.add(patches[k], (*divisions)[k])) return *std::move(error);
    return faces.finish(source_end);
}

}  // namespace firma
