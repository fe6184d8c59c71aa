// SPDX-License-Identifier: MIT
// Any bytes as a .gltf or .glb, and files made of them: an error with a place, or a sound level with sound
// portals, and a sound world of it.
#include <cstdint>
#include <string>

#include "firma/read_gltf.h"
#include "tests/fuzz/expect_sound_level.h"
#include "tests/fuzz/gltf_bytes.h"

using namespace firma;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string file = fuzz::gltf_bytes(data, size);
    const auto bytes = std::as_bytes(std::span(file));
    // Few triangles: what a file of a kilobyte may place over and over is no find.
    GltfOptions options;
    options.max_triangles = 1 << 14;
    for (const int up : {2, 0}) {
        options.up = up;
        options.scale = up == 2 ? 1 : 0.3;
        const Result<GltfLevel> read = read_gltf(bytes, "f.glb", options);
        if (!read) {
            fuzz::expect(read.error().place.starts_with("f.glb"), "errors have a place");
            fuzz::expect(read.error().text().size() < 400, "errors are short");
            continue;
        }
        const GltfLevel& gltf = read.value();
        fuzz::expect_sound(gltf.level);
        fuzz::expect(gltf.level.source_faces <= options.max_triangles, "no more triangles than asked for");
        fuzz::expect(gltf.note_places.size() == gltf.level.notes.size(), "a place for each note");
        for (const GltfPortal& portal : gltf.portals) {
            fuzz::expect(!portal.polygons.empty(), "portals have polygons");
            for (const std::vector<GridPoint>& polygon : portal.polygons) {
                std::vector<Vec3> corners;
                for (const GridPoint& point : polygon) corners.push_back(to_metres(point));
                fuzz::expect(check_polygon(corners) == PolygonFault::kNone, "polygons are convex, planar, with area");
            }
        }
        const Result<World> world = make_world(gltf);
        fuzz::expect(world.ok() == !gltf.level.faces.empty(), "every level of something makes a world");
        if (world) fuzz::expect(!check_world(world.value()), "a sound one, in rooms or not");
        const MeshCheck check = check_gltf(gltf).value();
        if (check.closed())
            fuzz::expect(fuzz::area_vector(gltf.level) == std::array<fuzz::Wide, 3>{}, "a closed mesh is closed");
    }
    return 0;
}
