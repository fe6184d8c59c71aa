// SPDX-License-Identifier: MIT
// A renderer's meshes, one for each cube of space: which faces each has, which an edit changed, and each by itself.
#include "firma/region_meshes.h"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

#include "base/sort.h"
#include "geometry/triangulate_convex.h"
#include "index/box_tree.h"
#include "world/block_faces.h"
#include "world/changed_faces.h"
#include "world/corner_blends.h"
#include "world/facets_in_box.h"
#include "world/lay_texture.h"
#include "world/tile_of.h"
#include "world/world_data.h"

namespace firma {
namespace {

Error no_size() {
    return {ErrorCode::kInvalid, "size", "must be from 1 to 1024 m, in whole sixteenths of a metre"};
}

std::optional<Error> judge(const RegionMeshOptions& options) {
    if (!TileGrid::make(options.size)) return no_size();
    for (const std::array<double, 2>& size : options.texture_sizes)
        for (const double number : size)
            if (!is_finite(number) || number < 0)
                return Error{ErrorCode::kInvalid, "texture_sizes", "must be finite numbers, none below zero"};
    return {};
}

std::array<float, 3> floats_of(const Vec3& v) {
    return {float(v.x), float(v.y), float(v.z)};
}

/// Makes the meshes of one region after another.
class RegionMesher {
public:
    RegionMesher(const World& world, const RegionMeshOptions& options, const TileGrid& grid)
        : world_(world), options_(options), grid_(grid) {}

    RegionMesh make(const Tile& place) {
        made_ = {};
        made_.place = place;
        for (std::size_t axis = 0; axis < 3; ++axis) made_.origin[int(axis)] = place[axis] * options_.size;
        drawn_.clear();
        laid_.clear();
        const std::optional<GridBox> box = grid_.box_of(place);
        if (!box) return std::move(made_);
        facets_in_box(all_facets(world_.data()), *box, [&](const Block& block, std::uint32_t slot) {
            const FacetPlace face{&block, slot};
            if (grid_.tile_of(face) == place) take(face);
            return true;
        });
        sort_range(drawn_, [](const Drawn& a, const Drawn& b) { return a.run != b.run ? a.run < b.run : a.id < b.id; });

        GridBox cut;
        std::size_t vertices = 0;
        for (const Drawn& face : drawn_) {
            vertices += face.place.record().corner_count;
            if (face.place.record().edit != 0) cut.add(face.place.block->box_of(face.place.record()));
        }
        reserve(vertices);
        std::optional<CornerBlends> blends;
        if (options_.textures && cut.low.x <= cut.high.x) blends.emplace(world_.data(), cut);
        for (const Drawn& face : drawn_) add(face, blends ? &*blends : nullptr);
        return std::move(made_);
    }

private:
    struct Drawn {
        std::uint64_t run;  ///< what runs are in order of: material, cut, two-sided, unit
        FaceId id;
        std::uint32_t laid;  ///< index into laid_: of a face of the level
        FacetPlace place;
    };

    void take(const FacetPlace& place) {
        const FaceRecord& face = place.record();
        if (!(face.mask & options_.mask) || (!face.solid && !options_.castable_only)) return;
        auto unit = std::uint64_t(TextureUnit::kMetres);
        const auto laid = std::uint32_t(laid_.size());
        if (options_.textures && face.edit == 0) {
            FaceInfo info;
            info.source = face.source;
            info.material = face.material;
            info.normal = unit_normal_of(*place.block, face);
            corners_.clear();
            for (std::uint32_t k = 0; k < face.corner_count; ++k)
                corners_.push_back(to_metres(place.block->corner(face, k)));
            laid_.push_back(lay_texture(world_, info, corners_, options_.texture_sizes));
            unit = std::uint64_t(laid_.back().lies.unit);
        }
        const std::uint64_t run = std::uint64_t(face.material) << 32 | std::uint64_t(face.edit != 0) << 3 |
                                  std::uint64_t(face.two_sided) << 2 | unit;
        drawn_.push_back({run, face.id, laid, place});
    }

    void reserve(std::size_t vertices) {
        const std::size_t triangles = vertices - 2 * drawn_.size();
        made_.positions.reserve(vertices);
        made_.normals.reserve(vertices);
        if (options_.textures) {
            made_.tangents.reserve(vertices);
            made_.uvs.reserve(vertices);
            made_.blends.reserve(vertices);
        }
        made_.corners.reserve(triangles);
        made_.faces.reserve(triangles);
        made_.parts.reserve(drawn_.size());
    }

    void add(const Drawn& drawn, CornerBlends* blends) {
        const Block& block = *drawn.place.block;
        const FaceRecord& face = drawn.place.record();
        grid_corners_.clear();
        for (std::uint32_t k = 0; k < face.corner_count; ++k) grid_corners_.push_back(block.corner(face, k));
        divided_.clear();
        triangulate_convex(grid_corners_, divided_);
        if (divided_.empty()) return;  // rounding flattened it: all of it lies on its neighbours

        const auto first_vertex = std::uint32_t(made_.positions.size());
        const auto first_triangle = std::uint32_t(made_.corners.size());
        const auto vertices = std::uint32_t(grid_corners_.size()), triangles = std::uint32_t(divided_.size());
        const Vec3 exact_normal = unit_normal_of(block, face);
        const std::array<float, 3> normal = floats_of(exact_normal);
        LaidTexture laid;
        std::array<float, 4> tangent{};
        if (options_.textures) {
            laid = face.edit == 0 ? laid_[drawn.laid] : LaidTexture{box_projection(exact_normal)};
            tangent = tangent_of(laid.lies, exact_normal);
        }
        for (const GridPoint& corner : grid_corners_) {
            const Vec3 at = to_metres(corner);
            made_.bounds.add(at);
            made_.positions.push_back(floats_of(at - made_.origin));
            made_.normals.push_back(normal);
            if (!options_.textures) continue;
            made_.tangents.push_back(tangent);
            made_.uvs.push_back(laid.at(at));
            made_.blends.push_back(face.edit != 0 ? blends->at(corner, face.id) : kOwnPicture);
        }
        for (const auto& [a, b, c] : divided_) {
            made_.corners.push_back({first_vertex + a, first_vertex + b, first_vertex + c});
            made_.faces.push_back(face.id);
        }
        made_.parts.push_back({{face.id, grid_corners_[0]},
                               face.source,
                               face.edit,
                               face.mask,
                               face.two_sided != 0,
                               face.solid != 0,
                               first_triangle,
                               triangles,
                               first_vertex,
                               vertices});
        if (made_.runs.empty() || drawn.run != last_run_)
            made_.runs.push_back({face.material, face.edit != 0, face.two_sided != 0, TextureUnit(drawn.run & 3),
                                  first_triangle, 0, first_vertex, 0});
        made_.runs.back().triangle_count += triangles;
        made_.runs.back().vertex_count += vertices;
        last_run_ = drawn.run;
    }

    const World& world_;
    const RegionMeshOptions& options_;
    const TileGrid& grid_;
    std::vector<Drawn> drawn_;
    std::vector<LaidTexture> laid_;
    std::vector<Vec3> corners_;
    std::vector<GridPoint> grid_corners_;
    std::vector<std::array<std::uint32_t, 3>> divided_;
    std::uint64_t last_run_ = 0;
    RegionMesh made_;
};

std::vector<Tile> find_all(const WorldData& data, const TileGrid& grid) {
    std::vector<Tile> tiles;
    std::size_t sorted = 0;
    for_each_block_of(data, [&](const Block& block) {
        for (std::uint32_t slot = 0; slot < block.faces.size(); ++slot) {
            const Tile tile = grid.tile_of(FacetPlace{&block, slot});
            if (tiles.empty() || tiles.back() != tile) tiles.push_back(tile);
        }
        if (tiles.size() < 2 * sorted + 1000) return;
        sort_once(tiles);
        sorted = tiles.size();
    });
    sort_once(tiles);
    return tiles;
}

/// The regions that faces left or came to, and those of faces whose blends may differ.
std::vector<Tile> find_changed(const WorldData& before, const WorldData& after, const TileGrid& grid) {
    const ChangedFaces changed = changed_faces(before, after);
    std::vector<Tile> tiles;
    struct CutCorner {
        Tile tile;  ///< of the face that has it
        GridPoint at;
        auto operator<=>(const CutCorner&) const = default;
    };
    std::vector<CutCorner> corners;
    for (const std::vector<ChangedFace>* faces : {&changed.removed, &changed.added})
        for (const ChangedFace& face : *faces) {
            const Tile tile = grid.tile_of(face.place);
            if (tiles.empty() || tiles.back() != tile) tiles.push_back(tile);
            if (face.record().edit == 0) continue;
            for (std::uint32_t k = 0; k < face.record().corner_count; ++k)
                corners.push_back({tile, face.place.block->corner(face.record(), k)});
        }
    sort_once(corners);
    // What is near each other is looked for together.
    for (auto first = corners.begin(), end = first; first != corners.end(); first = end) {
        GridBox box;
        for (; end != corners.end() && end->tile == first->tile; ++end) box.add(end->at);
        facets_in_box(all_facets(after), box, [&](const Block& block, std::uint32_t slot) {
            const FaceRecord& face = block.faces[slot];
            if (face.edit == 0 || !boxes_meet(block.box_of(face), box)) return true;
            const Tile tile = grid.tile_of(FacetPlace{&block, slot});
            if (tile == first->tile) return true;
            for (std::uint32_t k = 0; k < face.corner_count; ++k)
                if (std::binary_search(first, end, CutCorner{first->tile, block.corner(face, k)})) {
                    tiles.push_back(tile);
                    break;
                }
            return true;
        });
    }
    sort_once(tiles);
    return tiles;
}

}  // namespace

Result<std::vector<Tile>> regions_of(const World& world, double size) {
    const std::optional<TileGrid> grid = TileGrid::make(size);
    if (!grid) return no_size();
    return find_all(world.data(), *grid);
}

Result<std::vector<Tile>> changed_regions(const World& before, const World& after, double size) {
    const std::optional<TileGrid> grid = TileGrid::make(size);
    if (!grid) return no_size();
    return find_changed(before.data(), after.data(), *grid);
}

Result<RegionMesh> region_mesh(const World& world, const Tile& place, const RegionMeshOptions& options) {
    if (const std::optional<Error> error = judge(options)) return *error;
    return RegionMesher(world, options, *TileGrid::make(options.size)).make(place);
}

Result<std::vector<RegionMesh>> region_meshes(const World& world, const RegionMeshOptions& options) {
    if (const std::optional<Error> error = judge(options)) return *error;
    const TileGrid grid = *TileGrid::make(options.size);
    std::vector<RegionMesh> meshes;
    RegionMesher mesher(world, options, grid);
    for (const Tile& tile : find_all(world.data(), grid))
        if (RegionMesh mesh = mesher.make(tile); !mesh.empty()) meshes.push_back(std::move(mesh));
    return meshes;
}

Result<std::vector<RegionMesh>> changed_region_meshes(const World& before, const World& after,
                                                      const RegionMeshOptions& options) {
    if (const std::optional<Error> error = judge(options)) return *error;
    const TileGrid grid = *TileGrid::make(options.size);
    std::vector<RegionMesh> meshes;
    RegionMesher mesher(after, options, grid);
    for (const Tile& tile : find_changed(before.data(), after.data(), grid)) meshes.push_back(mesher.make(tile));
    return meshes;
}

}  // namespace firma
