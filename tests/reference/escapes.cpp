// SPDX-License-Identifier: MIT
// Tries to get out of closed meshes.
#include "tests/reference/escapes.h"

#include <vector>

#include "firma/queries.h"
#include "firma/world.h"
#include "tests/reference/judge_scene.h"
#include "tests/source_of.h"

namespace firma::reference {

void EscapeTally::add(const EscapeTally& other) {
    casts += other.casts;
    lost += other.lost;
    judged += other.judged;
    wrong += other.wrong;
    if (first_failure.empty()) first_failure = other.first_failure;
}

EscapeTally try_escapes(std::uint64_t seed, std::uint64_t chunk) {
    scenes::Rng rng(seed * 0x9E3779B97F4A7C15ull ^ (chunk + 1) * 0xD1B54A32D192ED03ull);
    EscapeTally tally;
    tally.kind = scenes::MeshKind(chunk % scenes::kMeshKinds);
    const scenes::ClosedMesh mesh = scenes::make_closed_mesh(tally.kind, rng);
    WorldOptions options;
    options.tree.split = rng.chance(0.5) ? Split::kLongestAxis : Split::kSurfaceArea;
    const Result<World> world = make_world(scenes::level_of(mesh.faces), options);
    if (!world.ok()) {
        tally.first_failure = "make_world: " + world.error().text();
        tally.casts = tally.lost = kEscapesAChunk;
        return tally;
    }
    std::vector<std::vector<Vec3>> polygons;
    for (const scenes::GridPolygon& face : mesh.faces) polygons.push_back(scenes::to_metres(face));
    const ExactOracle oracle(polygons);
    for (std::uint64_t k = 0; k < kEscapesAChunk; ++k) {
        const scenes::CastQuery query = scenes::escaping_cast(mesh, k % 4 == 3, rng);
        const Hit hit = cast(world.value(), query.sphere, query.path);
        ++tally.casts;
        tally.lost += !hit.touched();
        if (hit.touched() && k % 64 != 0) continue;
        const Cast asked{query.sphere, query.path};
        Answer answer{hit, hit.touched() ? source_of(world.value(), hit) : 0, hit.touched() ? hit.safe_fraction : NAN,
                      0.001, true};
        const Verdict verdict = judge(oracle, asked, answer);
        ++tally.judged;
        tally.wrong += !verdict.ok();
        if (!verdict.ok() && tally.first_failure.empty()) {
            std::vector<std::uint32_t> faces = oracle.expect(asked).faces;
            if (hit.touched()) faces.push_back(answer.face);
            tally.first_failure = std::string(scenes::name_of(mesh.kind)) + ", " + name_of(verdict.fault) + ": " +
                                  verdict.text + "\n" + describe(oracle, asked, faces);
        }
    }
    return tally;
}

}  // namespace firma::reference
