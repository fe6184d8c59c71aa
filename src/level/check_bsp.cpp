// SPDX-License-Identifier: MIT
// Checks the drawn surfaces of a .bsp by its floats: every float is an exact number, and so is every double that a
// patch's division comes to.
#include <array>
#include <utility>

#include "firma/mesh.h"
#include "level/bsp_mesh.h"
#include "level/check_mesh_core.h"

namespace firma {
namespace {

class ExactMeshMaker {
public:
    ExactMeshMaker(const BspSurfaces& surfaces, BspMesh mesh) : surfaces_(surfaces), from_(std::move(mesh)) {}

    ExactMesh make() {
        mesh_.base = 2;
        for (const Vec3& p : from_.positions) {
            mesh_.exact.push_back({exact_binary(p.x), exact_binary(p.y), exact_binary(p.z)});
        }
        for (const BspMesh::Polygon& polygon : from_.polygons) {
            const BspSurface& surface = surfaces_.surfaces[polygon.surface];
            const std::span<const std::uint32_t> corners = from_.corners_of(polygon);
            if (surface.kind == FaceKind::kPatch) {
                add_cell(corners, surface.face);
            } else {
                add(corners, surface.face);
            }
        }
        mesh_.nearest = std::move(from_.positions);
        mesh_.snapped = std::move(from_.snapped);
        return std::move(mesh_);
    }

private:
    void add(std::span<const std::uint32_t> corners, std::uint32_t source) {
        mesh_.faces.push_back({std::uint32_t(mesh_.corners.size()), std::uint32_t(corners.size()), source, 0});
        mesh_.corners.insert(mesh_.corners.end(), corners.begin(), corners.end());
    }

    // Two triangles, since a cell is seldom flat and nobody said it was; one or none where corners meet.
    void add_cell(std::span<const std::uint32_t> c, std::uint32_t source) {
        for (const auto& triangle : {std::array{c[0], c[1], c[2]}, std::array{c[0], c[2], c[3]}}) {
            const Vec3 &a = from_.positions[triangle[0]], &b = from_.positions[triangle[1]],
                       &d = from_.positions[triangle[2]];
            if (a != b && b != d && d != a) add(triangle, source);
        }
    }

    const BspSurfaces& surfaces_;
    BspMesh from_;
    ExactMesh mesh_;
};

// What becomes of a patch's cells says nothing about a face of the file.
void remove_patch_notes(MeshCheck& check, const BspSurfaces& surfaces) {
    auto surface = surfaces.surfaces.begin();
    std::erase_if(check.notes, [&](const MeshNotePlace& note) {
        while (surface->face < note.source) ++surface;
        return surface->kind == FaceKind::kPatch;
    });
}

}  // namespace

Result<MeshCheck> check_bsp(std::span<const std::byte> bytes, std::string name, const ReadOptions& options) {
    const Result<BspFile> file = BspFile::open(bytes, std::move(name));
    if (!file) return file.error();
    const Result<BspSurfaces> surfaces = read_surfaces(file.value(), options);
    if (!surfaces) return surfaces.error();
    Result<BspMesh> mesh = make_bsp_mesh(file.value(), surfaces.value(), options.patch_tolerance);
    if (!mesh) return mesh.error();
    MeshCheck check = check_exact_mesh(ExactMeshMaker(surfaces.value(), std::move(mesh).value()).make());
    check.faces = surfaces.value().face_count;  // not the pieces that they were judged in
    remove_patch_notes(check, surfaces.value());
    return check;
}

}  // namespace firma
