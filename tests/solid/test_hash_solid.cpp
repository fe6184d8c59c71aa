// SPDX-License-Identifier: MIT
// Equal solids have equal hashes, however they came about; others do not.

#include <gtest/gtest.h>

#include <array>

#include <set>

#include "scenes/rng.h"
#include "tests/solid/solid_levels.h"
#include "tests/solid/tiled_hall.h"

namespace firma {
namespace {

struct Edit {
    CutterShape shape = CutterShape::kRocky;
    std::uint64_t seed = 0;
    Pose pose;
    std::string material;
};

World after(World world, const std::vector<Edit>& edits) {
    for (const Edit& edit : edits) {
        const CarveResult result =
            carve(world, make_crater(edit.shape, edit.seed), edit.pose, {.material = edit.material});
        EXPECT_EQ(result.status, CarveStatus::kDone) << result.error.reason;
        world = result.world;
    }
    EXPECT_FALSE(check_solid(world));
    return world;
}

TEST(HashSolid, DisjointEditsInAnyOrder) {
    const World block = make_world(test::box_level({-3, -3, -3}, {3, 3, 3})).value();
    const Edit lid{CutterShape::kRocky, 1, {.position = {1, 1, 3}}, "iron"};
    const Edit bottom{CutterShape::kSpiky, 2, {.position = {-1, -1, -3}}, "lead"};
    const World one = after(block, {lid, bottom}), other = after(block, {bottom, lid});
    EXPECT_EQ(hash_solid(one), hash_solid(other));
    EXPECT_NE(hash_solid(one), hash_solid(block));
    EXPECT_NE(hash_solid(one), hash_solid(after(block, {lid}))) << "one cut less";
}

TEST(HashSolid, DisjointEditsInAnyOrderWhereFacesAreTiled) {
    const World world = make_world(test::tiled_hall()).value();
    ASSERT_FALSE(check_solid(world));
    ASSERT_LT(measure_solid(world).volume, 0) << "rock around it";
    // Along the floor, at an edge between floor and wall, and in a corner.
    const std::vector<Vec3> places = {{20, 20, 0.3},   {45, 30, 0.4},   {30, 2, 0.4},
                                      {0.5, 0.5, 0.2}, {58.4, 47.8, 6}, {30, 46, 9}};
    std::set<std::uint64_t> hashes;
    for (std::size_t a = 0; a < places.size(); ++a)
        for (std::size_t b = a + 1; b < places.size(); ++b) {
            const Edit one{CutterShape::kRocky, a, {.position = places[a], .scale = 1.5}, ""};
            const Edit two{CutterShape::kSpiky, b, {.position = places[b], .scale = 1.2}, ""};
            const std::uint64_t hash = hash_solid(after(world, {one, two}));
            EXPECT_EQ(hash, hash_solid(after(world, {two, one}))) << a << " " << b;
            hashes.insert(hash);
        }
    EXPECT_EQ(hashes.size(), 15u);
}

/// Three of these pairs once differed: the box of a slanted face met that of a far cutter, the boxes of its facets,
/// once the neighbour's cut had split an edge, did not.
TEST(HashSolid, DisjointEditsAnywhereInAnyOrder) {
    const World world = make_world(test::tiled_hall()).value();
    scenes::Rng rng(1);
    int compared = 0;
    for (std::uint64_t k = 0; k < 130; ++k) {
        Edit edits[2] = {{CutterShape::kRocky, k, {}, ""}, {CutterShape::kSpiky, k, {}, ""}};
        for (Edit& edit : edits) {
            edit.pose.position.x = rng.below(100000) / 100000.0 * 60;
            edit.pose.position.y = rng.below(100000) / 100000.0 * 47;
            edit.pose.position.z = rng.below(100000) / 100000.0 * 15;
            edit.pose.scale = 1 + rng.below(1000) / 500.0;
            edit.pose.rotation = random_turn(rng.below(1 << 30));
        }
        if (length(edits[0].pose.position - edits[1].pose.position) < 9) continue;
        const auto touches = [&](const Edit& edit) {
            return carve(world, make_crater(edit.shape, edit.seed), edit.pose).done();
        };
        if (!touches(edits[0]) || !touches(edits[1])) continue;
        ++compared;
        EXPECT_EQ(hash_solid(after(world, {edits[0], edits[1]})), hash_solid(after(world, {edits[1], edits[0]}))) << k;
    }
    EXPECT_GT(compared, 30);
}

TEST(HashSolid, UntouchedAndStoredFacesAreTheSame) {
    const World block = make_world(test::box_level({-3, -3, -3}, {3, 3, 3})).value();
    // Every face becomes a stored one; same loops, other starts.
    const Boundary boundary = test::boundary_of(block);
    test::Parts parts(block);
    SolidPatch patch = boundary.patch;
    for (std::uint32_t e = 0; e < patch.edges.size(); ++e) patch.settle_planes(e);
    std::vector<Ref<const SolidVertex>> vertices;
    for (const PatchVertex& vertex : patch.vertices)
        vertices.emplace_back(new SolidVertex(vertex.point, vertex.planes));
    std::vector<Ref<const SolidEdge>> edges;
    for (const PatchEdge& edge : patch.edges) {
        Ref<SolidEdge> made(new SolidEdge);
        for (int k = 0; k < 2; ++k) {
            made->vertex[k] = vertices[edge.vertex[k]];
            made->plane[k] = Ref<const SolidPlane>(edge.plane[k]);
        }
        edges.emplace_back(made.get());
    }
    for (std::uint32_t f = 0; f < patch.faces.size(); ++f) {
        Ref<SolidFace> made(new SolidFace);
        made->plane = Ref<const SolidPlane>(patch.faces[f].plane);
        for (const PatchUse& use : patch.uses(patch.faces[f])) made->uses.emplace_back(edges[use.edge], use.reversed);
        std::rotate(made->uses.begin(), made->uses.begin() + f % 4, made->uses.end());
        made->set_loop_ends(std::array{4u});
        const Plane& plane = made->plane->plane;
        made->normal = plane.direction();
        made->box = patch.faces[f].box;
        const FaceId id = patch.faces[f].facet.record().id;
        std::find_if(parts.set.faces.begin(), parts.set.faces.end(), [&](const auto& e) { return e.id == id; })->owner =
            made.get();
        parts.faces.push_back(made);
    }
    std::reverse(parts.set.faces.begin(), parts.set.faces.end());
    const World stored = parts.world();
    EXPECT_FALSE(check_solid(stored));
    EXPECT_EQ(hash_solid(stored), hash_solid(block));
}

TEST(HashSolid, IdsBlocksAndMaterialsDoNotCount) {
    const World block = make_world(test::box_level({-3, -3, -3}, {3, 3, 3})).value();
    test::Parts parts(after(block, {{CutterShape::kRocky, 1, {.position = {1, 1, 3}}, "iron"}}));
    const std::uint64_t hash = hash_solid(parts.world());
    std::uint32_t id = 1000;
    for (FaceSet::Entry& entry : parts.set.faces) {
        entry.id = {id--};
        entry.source += 7;
        entry.edit += 1;
    }
    std::reverse(parts.set.faces.begin(), parts.set.faces.end());
    EXPECT_EQ(hash_solid(parts.world()), hash);
    parts.untouched().material = 1;
    EXPECT_EQ(hash_solid(parts.world()), hash);
    const std::uint64_t of_world = hash_world(parts.world());
    parts.untouched().material = 2;
    EXPECT_NE(hash_world(parts.world()), of_world) << "materials are the world's";
}

TEST(HashSolid, CutsThatChangeNothing) {
    const World block = make_world(test::box_level({-30, -30, -30}, {30, 30, 30})).value();
    const World pit = after(block, {{CutterShape::kRocky, 1, {.position = {1, 1, 30}}, ""}});
    const CarveResult nothing = carve(pit, make_crater(CutterShape::kRocky, 1), {.position = {1, 1, 32}});
    EXPECT_EQ(nothing.status, CarveStatus::kNothing);
    EXPECT_EQ(hash_solid(nothing.world), hash_solid(pit));
    EXPECT_NE(hash_solid(pit), hash_solid(block));
    EXPECT_EQ(hash_solid(block), hash_solid(make_world(test::box_level({-30, -30, -30}, {30, 30, 30})).value()))
        << "undone: the world before is as it was";
}

}  // namespace
}  // namespace firma
