// SPDX-License-Identifier: MIT
// Makes a Level of a .bsp's drawn surfaces.
#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "firma/level.h"
#include "level/bsp_mesh.h"
#include "level/divide_polygon.h"
#include "level/level_builder.h"
#include "level/shared_vertices.h"

namespace firma {
namespace {

/// Units. Compilers move corners to eighths, after they laid the texture.
constexpr double kCompilerStep = 1.0 / 8;

class BspLevelMaker {
public:
    BspLevelMaker(const BspFile& file, const BspSurfaces& surfaces, const BspMesh& mesh, double patch_tolerance)
        : surfaces_(surfaces),
          mesh_(mesh),
          patch_tolerance_(patch_tolerance),
          builder_(file.name()),
          vertices_(builder_) {}

    Level make() {
        auto polygon = mesh_.polygons.begin();
        for (std::uint32_t k = 0; k < surfaces_.surfaces.size(); ++k) {
            begin(surfaces_.surfaces[k]);
            for (; polygon != mesh_.polygons.end() && polygon->surface == k; ++polygon) add(*polygon);
            // One note for a surface that came to nothing, however many pieces it had.
            if (pieces_ == 0) builder_.add_face({}, info_);
        }
        std::vector<Omission> omissions;
        if (surfaces_.of_other_models > 0)
            omissions.push_back({"surfaces of models other than the first", surfaces_.of_other_models, ""});
        return builder_.finish(surfaces_.face_count, surfaces_.ignored, std::move(omissions));
    }

private:
    void begin(const BspSurface& surface) {
        info_.source = surface.face;
        info_.material = builder_.material(surfaces_.shaders[surface.shader]);
        info_.group = builder_.group("model 0");
        info_.kind = surface.kind;
        info_.texture_slack = surface.kind == FaceKind::kPatch ? patch_tolerance_ : kCompilerStep * surfaces_.scale;
        pieces_ = 0;
    }

    void add(const BspMesh::Polygon& polygon) {
        points_.clear();
        outline_.clear();
        uvs_.clear();
        const std::span<const std::uint32_t> corners = mesh_.corners_of(polygon);
        const std::span<const TexturePoint> uvs = mesh_.uvs_of(polygon);
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const GridPoint& point = mesh_.snapped[corners[k]];
            if (!points_.empty() && points_.back() == point) continue;
            points_.push_back(point);
            uvs_.push_back(uvs[k]);
        }
        while (points_.size() > 1 && points_.back() == points_.front()) points_.pop_back();
        uvs_.resize(points_.size());
        const auto finite = [](const TexturePoint& uv) { return is_finite(uv[0]) && is_finite(uv[1]); };
        if (!std::all_of(uvs_.begin(), uvs_.end(), finite)) uvs_.clear();
        const Division division = divide_polygon(points_);
        if (division.what == Division::What::kNoArea) return;
        ++pieces_;
        for (const GridPoint& point : points_) outline_.push_back(vertices_.at(point));
        if (info_.kind == FaceKind::kPatch) {
            add_cell(division);
        } else {
            builder_.add_face(outline_, info_, uvs_);
        }
    }

    // A cell is ours, not the file's: when it has to be divided, no face of the file is.
    void add_cell(const Division& division) {
        if (division.what == Division::What::kWhole) builder_.add_face(outline_, info_, uvs_);
        for (const auto& [a, b, c] : division.triangles) {
            const std::array corners{outline_[a], outline_[b], outline_[c]};
            if (uvs_.empty())
                builder_.add_face(corners, info_);
            else
                builder_.add_face(corners, info_, std::array{uvs_[a], uvs_[b], uvs_[c]});
        }
    }

    const BspSurfaces& surfaces_;
    const BspMesh& mesh_;
    const double patch_tolerance_;
    LevelBuilder builder_;
    SharedVertices vertices_;

    LevelBuilder::FaceInfo info_;  // of the surface at hand
    std::size_t pieces_ = 0;
    std::vector<GridPoint> points_;  // of the polygon at hand
    std::vector<TexturePoint> uvs_;  // of these; empty where they are no numbers
    std::vector<std::uint32_t> outline_;
};

}  // namespace

Result<Level> read_bsp(std::span<const std::byte> bytes, std::string name, const ReadOptions& options) {
    const Result<BspFile> file = BspFile::open(bytes, std::move(name));
    if (!file) return file.error();
    const Result<BspSurfaces> surfaces = read_surfaces(file.value(), options);
    if (!surfaces) return surfaces.error();
    const Result<BspMesh> mesh = make_bsp_mesh(file.value(), surfaces.value(), options.patch_tolerance);
    if (!mesh) return mesh.error();
    return BspLevelMaker(file.value(), surfaces.value(), mesh.value(), options.patch_tolerance).make();
}

}  // namespace firma
