// SPDX-License-Identifier: MIT
// Makes polygons of surfaces, each kind its own way.
#include "level/bsp_mesh.h"

#include <array>
#include <numeric>
#include <tuple>
#include <utility>

#include "base/sort.h"
#include "level/divide_patches.h"
#include "level/join_triangles.h"
#include "level/tessellate_patch.h"

namespace firma {
namespace {

constexpr std::uint64_t kMostCells = std::uint64_t(1) << 22;  // of all patches together

// For each vertex the first one at the same position: the triangles of a surface hang together by position, and have
// vertices of their own for each texture.
std::vector<std::uint32_t> first_at_position(std::span<const Vec3> positions) {
    std::vector<std::uint32_t> order(positions.size()), first(positions.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto key = [&](std::uint32_t k) { return std::tuple(positions[k].x, positions[k].y, positions[k].z); };
    sort_range(order, [&](std::uint32_t a, std::uint32_t b) { return key(a) != key(b) ? key(a) < key(b) : a < b; });
    for (std::size_t k = 0; k < order.size(); ++k) {
        const bool again = k > 0 && key(order[k]) == key(order[k - 1]);
        first[order[k]] = again ? first[order[k - 1]] : order[k];
    }
    return first;
}

std::vector<Patch> gather_patches(const BspSurfaces& from) {
    std::vector<Patch> patches;
    for (const BspSurface& surface : from.surfaces) {
        if (surface.kind != FaceKind::kPatch) continue;
        Patch& patch = patches.emplace_back(Patch{surface.width, surface.height, {}});
        for (const std::uint32_t corner : from.corners_of(surface)) patch.control.push_back(from.positions[corner]);
    }
    return patches;
}

class BspMeshMaker {
public:
    explicit BspMeshMaker(const BspSurfaces& from)
        : from_(from), first_(first_at_position(from.positions)), own_(first_.size(), kNone) {
        mesh_.positions = from.positions;
        mesh_.snapped = from.snapped;
    }

    void begin(std::uint32_t surface) { surface_ = surface; }

    void add_triangles() {
        const std::span<const std::uint32_t> corners = from_.corners_of(from_.surfaces[surface_]);
        for (std::size_t k = 0; k < corners.size(); k += 3) push_own(corners.subspan(k, 3));
    }

    /// Triangles stay where corners in one place have different textures: there the picture has a seam.
    void add_flat() {
        const std::span<const std::uint32_t> corners = from_.corners_of(from_.surfaces[surface_]);
        bool has_seam = false;
        for (const std::uint32_t corner : corners) {
            std::uint32_t& own = own_[first_[corner]];
            if (own == kNone) own = corner;
            has_seam = has_seam || (own != corner && from_.uvs[own] != from_.uvs[corner]);
        }
        if (has_seam) {
            add_triangles();
        } else {
            for (const auto& outline : join_triangles(welded_corners(), mesh_.snapped)) {
                std::vector<std::uint32_t> own;
                for (const std::uint32_t corner : outline) own.push_back(own_[corner]);
                push_own(own);
            }
        }
        for (const std::uint32_t corner : corners) own_[first_[corner]] = kNone;
    }

    /// @return false when a point rounds to beyond the world's rim
    bool add_patch(const Patch& patch, const PatchDivision& division) {
        const std::vector<Vec3> uvs = tessellate_patch(uvs_of(patch), division);
        const auto start = std::uint32_t(mesh_.positions.size());
        for (const Vec3& point : tessellate_patch(patch, division)) {
            const std::optional<GridPoint> snapped = snap(point * from_.scale);
            if (!snapped) return false;
            mesh_.positions.push_back(point);
            mesh_.snapped.push_back(*snapped);
        }
        const std::uint32_t width = division.columns();
        for (std::uint32_t y = 0; y + 1 < division.rows(); ++y) {
            for (std::uint32_t x = 0; x + 1 < width; ++x) {
                const std::uint32_t at = start + y * width + x;
                for (const std::uint32_t corner : {at, at + 1, at + width + 1, at + width})
                    mesh_.uvs.push_back({uvs[corner - start].x, uvs[corner - start].y});
                push(std::array{at, at + 1, at + width + 1, at + width});
            }
        }
        return true;
    }

    BspMesh finish() { return std::move(mesh_); }

private:
    std::vector<std::uint32_t> welded_corners() const {
        std::vector<std::uint32_t> corners;
        for (const std::uint32_t corner : from_.corners_of(from_.surfaces[surface_])) corners.push_back(first_[corner]);
        return corners;
    }

    /// The control points' texture coordinates, as a patch.
    Patch uvs_of(const Patch& patch) const {
        Patch uvs{patch.width, patch.height, {}};
        for (const std::uint32_t corner : from_.corners_of(from_.surfaces[surface_]))
            uvs.control.push_back({from_.uvs[corner][0], from_.uvs[corner][1], 0});
        return uvs;
    }

    /// A polygon of the surface's own vertices.
    void push_own(std::span<const std::uint32_t> corners) {
        std::vector<std::uint32_t> welded;
        for (const std::uint32_t corner : corners) {
            welded.push_back(first_[corner]);
            mesh_.uvs.push_back(from_.uvs[corner]);
        }
        push(welded);
    }

    /// Their texture coordinates are there.
    void push(std::span<const std::uint32_t> corners) {
        mesh_.polygons.push_back({std::uint32_t(mesh_.corners.size()), std::uint32_t(corners.size()), surface_});
        mesh_.corners.insert(mesh_.corners.end(), corners.begin(), corners.end());
    }

    const BspSurfaces& from_;
    static constexpr std::uint32_t kNone = ~0u;

    std::vector<std::uint32_t> first_;
    std::vector<std::uint32_t> own_;  ///< by welded vertex: the first of the surface at hand there
    BspMesh mesh_;
    std::uint32_t surface_ = 0;
};

}  // namespace

Result<BspMesh> make_bsp_mesh(const BspFile& file, const BspSurfaces& surfaces, double patch_tolerance) {
    const std::vector<Patch> patches = gather_patches(surfaces);
    const auto divisions = divide_patches(patches, patch_tolerance / surfaces.scale, kMostCells);
    if (!divisions) {
        return file.fault(ErrorCode::kTooLarge, BspLump::kFaces,
                          "patches come to more than " + std::to_string(kMostCells) +
                              " cells at this tolerance; a larger patch_tolerance makes fewer");
    }
    BspMeshMaker maker(surfaces);
    std::size_t patch = 0;
    for (std::uint32_t k = 0; k < surfaces.surfaces.size(); ++k) {
        const BspSurface& surface = surfaces.surfaces[k];
        maker.begin(k);
        if (surface.kind != FaceKind::kPatch) {
            surface.flat ? maker.add_flat() : maker.add_triangles();
        } else if (!maker.add_patch(patches[patch], (*divisions)[patch])) {
            return file.fault(ErrorCode::kOutOfRange, BspLump::kFaces, surface.face,
                              "patch touches the rim of the world");
        } else {
            ++patch;
        }
    }
    return maker.finish();
}

}  // namespace firma
