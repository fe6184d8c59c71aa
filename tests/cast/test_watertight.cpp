// SPDX-License-Identifier: MIT
// Rays and balls from inside closed meshes, aimed at where faces meet: none may get out.
#include <gtest/gtest.h>

#include <map>

#include "firma/world.h"
#include "tests/reference/escapes.h"

namespace {

using namespace firma;
using namespace firma::reference;

TEST(Watertight, NothingLeavesAClosedMesh) {
    EscapeTally total;
    for (std::uint64_t chunk = 0; chunk < 160; ++chunk) total.add(try_escapes(7, chunk));
    RecordProperty("casts", int(total.casts));
    EXPECT_EQ(total.casts, 160 * kEscapesAChunk);
    EXPECT_EQ(total.lost, 0u) << total.first_failure;
    EXPECT_EQ(total.wrong, 0u) << total.first_failure;
}

// What the claim rests on: every edge is used once each way.
TEST(Watertight, TheMeshesAreClosed) {
    scenes::Rng rng(11);
    for (int round = 0; round < 10; ++round)
        for (int kind = 0; kind < scenes::kMeshKinds; ++kind) {
            const scenes::ClosedMesh mesh = scenes::make_closed_mesh(scenes::MeshKind(kind), rng);
            std::map<std::pair<GridPoint, GridPoint>, int> uses;
            for (const scenes::GridPolygon& face : mesh.faces)
                for (std::size_t k = 0; k < face.size(); ++k) {
                    const GridPoint &a = face[k], &b = face[(k + 1) % face.size()];
                    ++uses[{a, b}];
                    --uses[{b, a}];
                }
            for (const auto& [edge, sum] : uses) EXPECT_EQ(sum, 0) << scenes::name_of(mesh.kind);
            EXPECT_GT(mesh.free_radius, 0) << scenes::name_of(mesh.kind);
        }
}

}  // namespace
