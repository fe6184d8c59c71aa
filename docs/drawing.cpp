// SPDX-License-Identifier: MIT
// docs/drawing.md shows this program, and says what it prints.
#include <cstdio>
#include <map>

#include "firma/firma.h"

namespace {

/// In a game: a vertex buffer, an index buffer and the draw calls of one cube of the level.
struct Buffers {
    std::size_t vertices, triangles, draw_calls;
};

struct Renderer {
    std::map<firma::Tile, Buffers> regions;

    /// Puts in what is new, and takes out what is empty.
    void replace(const std::vector<firma::RegionMesh>& meshes) {
        for (const firma::RegionMesh& mesh : meshes) {
            if (mesh.empty())
                regions.erase(mesh.place);
            else
                regions[mesh.place] = {mesh.positions.size(), mesh.corners.size(), mesh.runs.size()};
        }
    }
    void print(const char* what) const {
        std::size_t triangles = 0, calls = 0;
        for (const auto& [place, buffers] : regions) {
            triangles += buffers.triangles;
            calls += buffers.draw_calls;
        }
        std::printf("%s: %zu regions, %zu triangles, %zu draw calls\n", what, regions.size(), triangles, calls);
    }
};

}  // namespace

int main() {
    const firma::Result<firma::BrushLevel> level = firma::read_brush_level("levels/depot.map");
    if (!level) return std::puts(level.error().text().c_str()), 1;
    const firma::World before = firma::make_world(level.value()).value();

    // All regions once. What stops only walkers is not to be seen.
    const firma::RegionMeshOptions options{.size = 8,
                                           .mask = firma::kStopsShots | firma::kStopsSight | firma::kStopsLiquid};
    const firma::Result<std::vector<firma::RegionMesh>> all = firma::region_meshes(before, options);
    if (!all) return std::puts(all.error().text().c_str()), 1;
    Renderer renderer;
    renderer.replace(all.value());
    renderer.print("the depot");

    // After a shot: those that it changed.
    const firma::Hit hit = firma::cast(before, firma::Ray{{18.75, 9.4, 1.5}, {-20, 2, 1}});
    const firma::Cutter crater = firma::make_crater(firma::CutterShape::kRocky, 1);
    const firma::World after =
        firma::carve(before, crater, {.position = hit.point, .scale = 2}, {.material = "rubble"}).world;
    const auto changed = firma::changed_region_meshes(before, after, options);
    renderer.replace(changed.value());
    renderer.print("after a shot");

    // What the shot made: triangles of faces of an edit are runs of their own.
    for (const firma::RegionMesh& mesh : changed.value())
        for (const firma::RegionMesh::Run& run : mesh.runs) {
            if (!run.cut) continue;
            const std::uint32_t vertex = mesh.corners[run.first_triangle][0];
            const auto& [x, y, z, own] = mesh.blends[vertex];
            std::printf("region %d %d %d: %u triangles of the edit, in %s; the first corner mixes %d %d %d %d\n",
                        mesh.place[0], mesh.place[1], mesh.place[2], run.triangle_count,
                        after.material_name(run.material).c_str(), x, y, z, own);
        }

    // Undo is the same the other way.
    const auto undone = firma::changed_region_meshes(after, before, options);
    renderer.replace(undone.value());
    renderer.print("undone");
}
