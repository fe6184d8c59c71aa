// SPDX-License-Identifier: MIT
// Chunks of the depot as convex pieces: how many, how long it takes, how well hulls fit; beside V-HACD and HACD where
// they are found.
#include <algorithm>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "convex/convex_peer.h"
#include "convex/grid_hull.h"
#include "firma/brush_world.h"
#include "firma/convex_pieces.h"
#include "support/depot_rubble.h"
#include "support/race.h"
#include "support/settings.h"
#include "support/table.h"

namespace firma::bench {
namespace {

/// What one way made of one chunk.
struct Made {
    std::size_t pieces = 0, exact = 0;
    double hull_volume = 0;
};

struct Way {
    std::string name;
    std::function<Made(const Chunk&, const PeerMesh&)> run;
};

Made firma_pieces(const Chunk& chunk, double concavity) {
    const Result<ConvexPieces> result =
        convex_pieces(chunk.solid, {.max_pieces = kMaxConvexPieces, .max_concavity = concavity});
    Made made;
    if (!result) return std::fprintf(stderr, "%s\n", result.error().text().c_str()), made;
    made.pieces = result.value().pieces.size();
    made.exact = result.value().exact;
    for (const ConvexBody& piece : result.value().pieces) made.hull_volume += piece.hull_volume;
    return made;
}

/// Hulls of others, measured as ours are: their points to the nearest 1/262144 m.
[[maybe_unused]] Made measured(const PeerHulls& hulls) {
    Made made{hulls.size(), 0, 0};
    for (const std::vector<Vec3>& hull : hulls) {
        std::vector<GridPoint> points;
        for (const Vec3& point : hull) {
            GridPoint at;
            for (int axis = 0; axis < 3; ++axis) at[axis] = std::int32_t(point[axis] * kSurfaceSteps);
            points.push_back(at);
        }
        made.hull_volume += hull_of(std::move(points)).volume();
    }
    return made;
}

PeerMesh mesh_of(const Solid& solid) {
    const Cutter cutter = cutter_from_solid(solid).value();
    return {{cutter.vertices().begin(), cutter.vertices().end()},
            {cutter.triangles().begin(), cutter.triangles().end()}};
}

std::vector<Way> all_ways() {
    std::vector<Way> ways;
    ways.push_back({"exact", [](const Chunk& chunk, const PeerMesh&) { return firma_pieces(chunk, 0); }});
    for (const int centimetres : {1, 2, 5, 10})
        ways.push_back(
            {"hulls within " + std::to_string(centimetres) + " cm",
             [centimetres](const Chunk& chunk, const PeerMesh&) { return firma_pieces(chunk, centimetres / 100.0); }});
#if defined(FIRMA_WITH_VHACD)
    ways.push_back({"V-HACD, 400,000 voxels, 64 hulls",
                    [](const Chunk&, const PeerMesh& mesh) { return measured(vhacd_pieces(mesh, 400000, 64)); }});
    ways.push_back({"V-HACD, 50,000 voxels, 16 hulls",
                    [](const Chunk&, const PeerMesh& mesh) { return measured(vhacd_pieces(mesh, 50000, 16)); }});
#endif
#if defined(FIRMA_WITH_HACD)
    for (const int centimetres : {2, 5})
        ways.push_back({"HACD, concavity " + std::to_string(centimetres) + " cm",
                        [centimetres](const Chunk&, const PeerMesh& mesh) {
                            return measured(hacd_pieces(mesh, centimetres / 100.0));
                        }});
#endif
    return ways;
}

bool write_table(const DepotRubble& rubble, const std::vector<PeerMesh>& meshes, const Settings& settings) {
    Table table("convex", {"way", "pieces", "median of a chunk", "most", "convex exactly", "ms", "worst ms",
                           "hulls / chunk, volume"});
    for (const Way& way : all_ways()) {
        std::vector<double> milliseconds, pieces;
        Made sum;
        double volume = 0;
        for (std::size_t k = 0; k < meshes.size(); ++k) {
            const double before = thread_seconds();
            const Made made = way.run(rubble.chunks[k], meshes[k]);
            milliseconds.push_back((thread_seconds() - before) * 1e3);
            pieces.push_back(double(made.pieces));
            sum.pieces += made.pieces;
            sum.exact += made.exact;
            sum.hull_volume += made.hull_volume;
            volume += rubble.chunks[k].mass.volume;
        }
        table.add({way.name, count(sum.pieces), number(median(pieces)),
                   number(*std::max_element(pieces.begin(), pieces.end())), count(sum.exact),
                   number(median(milliseconds)), number(*std::max_element(milliseconds.begin(), milliseconds.end())),
                   number(sum.hull_volume / volume)});
    }
    return table.finish(settings.csv);
}

int measure(const Settings& settings) {
    const Result<World> depot = read_world(settings.repository + "/levels/depot.map");
    if (!depot) return std::fprintf(stderr, "%s\n", depot.error().text().c_str()), 1;
    const DepotRubble rubble = depot_rubble(depot.value(), settings.quick ? 2 : 24);
    std::vector<PeerMesh> meshes;
    std::size_t faces = 0, reflex = 0;
    for (const Chunk& chunk : rubble.chunks) {
        meshes.push_back(mesh_of(chunk.solid));
        faces += chunk.solid.face_count();
        reflex += convex_pieces(chunk.solid, {.max_pieces = kMaxConvexPieces}).value().reflex_edges;
    }
    std::printf("%zu chunks of %zu faces, %zu reflex edges\n", rubble.chunks.size(), faces, reflex);
    return write_table(rubble, meshes, settings) ? 0 : 1;
}

}  // namespace
}  // namespace firma::bench

int main(int argc, char** argv) {
    using namespace firma::bench;
    return measure(read_settings(argc, argv, "What convex pieces of a chunk take."));
}
