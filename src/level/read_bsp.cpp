// SPDX-License-Identifier: MIT
// Makes a Level of a .bsp's drawn surfaces.
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

class BspLevelMaker {
public:
    BspLevelMaker(const BspFile& file, const BspSurfaces& surfaces, const BspMesh& mesh)
        : surfaces_(surfaces), mesh_(mesh), builder_(file.name()), vertices_(builder_) {}

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
        pieces_ = 0;
    }

    void add(const BspMesh::Polygon& polygon) {
        points_.clear();
        outline_.clear();
        for (const std::uint32_t corner : mesh_.corners_of(polygon)) {
            const GridPoint& point = mesh_.snapped[corner];
            if (!points_.empty() && points_.back() == point) continue;
            points_.push_back(point);
        }
        while (points_.size() > 1 && points_.back() == points_.front()) points_.pop_back();
        const Division division = divide_polygon(points_);
        if (division.what == Division::What::kNoArea) return;
        ++pieces_;
        for (const GridPoint& point : points_) outline_.push_back(vertices_.at(point));
        if (info_.kind == FaceKind::kPatch) {
            add_cell(division);
        } else {
            builder_.add_face(outline_, info_);
        }
    }

    // A cell is ours, not the file's: when it has to be divided, no face of the file is.
    void add_cell(const Division& division) {
        if (division.what == Division::What::kWhole) builder_.add_face(outline_, info_);
        for (const auto& [a, b, c] : division.triangles) {
            builder_.add_face(std::array{outline_[a], outline_[b], outline_[c]}, info_);
        }
    }

    const BspSurfaces& surfaces_;
    const BspMesh& mesh_;
    LevelBuilder builder_;
    SharedVertices vertices_;

    LevelBuilder::FaceInfo info_;  // of the surface at hand
    std::size_t pieces_ = 0;
    std::vector<GridPoint> points_;  // of the polygon at hand
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
    return BspLevelMaker(file.value(), surfaces.value(), mesh.value()).make();
}

}  // namespace firma
