// SPDX-License-Identifier: MIT
// A solid is a value of its own: carved without a world it is, face for face, what the solid of a world carved the same
// way is.
#include "firma/solid.h"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "firma/brush_world.h"
#include "firma/carve.h"
#include "firma/level.h"
#include "firma/queries.h"
#include "scenes/level_cuts.h"
#include "solid/solid_data.h"
#include "solid/solid_face.h"
#include "tests/reference/judge_index.h"
#include "tests/sample.h"
#include "tests/solid/solid_levels.h"
#include "world/world_data.h"

namespace firma {
namespace {

using scenes::CutOrder;

/// All that a facet is: corners, source, edit, material, mask, flags, the exact face above it.
using Facet = std::tuple<std::vector<GridPoint>, std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t, bool, bool,
                         std::uint64_t>;

std::map<std::uint32_t, Facet> facets_of(const Solid& solid) {
    std::map<std::uint32_t, Facet> facets;
    if (const Node* root = solid.data().faces.root.get())
        for_each_block(*root, [&](const Block& block) {
            for (const FaceRecord& face : block.faces) {
                std::vector<GridPoint> corners;
                for (std::size_t k = 0; k < face.corner_count; ++k) corners.push_back(block.corner(face, k));
                const FaceOwner* owner = block.owner_of(face);
                const bool is_new =
                    facets
                        .emplace(face.id.value, Facet{corners, face.source, face.edit, face.material, face.mask,
                                                      face.two_sided, face.solid, owner ? owner->hash : 0})
                        .second;
                EXPECT_TRUE(is_new) << "face " << face.id.value << " twice";
            }
        });
    return facets;
}

void expect_same(const Solid& one, const Solid& two) {
    ASSERT_EQ(one.face_count(), two.face_count());
    ASSERT_EQ(hash_solid(one), hash_solid(two));
    ASSERT_EQ(hash_regions(one), hash_regions(two));
    ASSERT_EQ(one.edits(), two.edits());
    ASSERT_EQ(one.rock_outside(), two.rock_outside());
    ASSERT_EQ(one.data().next_face, two.data().next_face);
    ASSERT_EQ(one.data().faces.hash, two.data().faces.hash);
    ASSERT_TRUE(facets_of(one) == facets_of(two));
}

void expect_same_measures(const Solid& one, const Solid& two) {
    const SolidMeasures a = measure_solid(one), b = measure_solid(two);
    EXPECT_EQ(a.volume, b.volume);
    EXPECT_EQ(a.area, b.area);
    EXPECT_EQ(a.facet_volume, b.facet_volume);
    EXPECT_EQ(a.faces, b.faces);
    EXPECT_EQ(a.facets, b.facets);
}

SolidResult cut_alone(const Solid& solid, const CutOrder& order, const SolidCutOptions& options) {
    return order.kind == CarveKind::kFill ? unite(solid, order.cutter, order.pose, options)
                                          : subtract(solid, order.cutter, order.pose, options);
}

CarveResult cut_within(const World& world, const CutOrder& order, const CarveOptions& options) {
    return order.kind == CarveKind::kFill ? fill(world, order.cutter, order.pose, options)
                                          : carve(world, order.cutter, order.pose, options);
}

void expect_same(const SolidResult& alone, const CarveResult& within) {
    ASSERT_EQ(alone.status, within.status);
    ASSERT_EQ(alone.error.text(), within.error.text());
    const CarveReport &a = alone.report, &b = within.report;
    ASSERT_EQ(a.candidate_faces, b.candidate_faces);
    ASSERT_EQ(a.faces_cut, b.faces_cut);
    ASSERT_EQ(a.faces_removed, b.faces_removed);
    ASSERT_EQ(a.faces_added, b.faces_added);
    ASSERT_EQ(a.retries, b.retries);
    ASSERT_EQ(a.scale, b.scale);
    ASSERT_EQ(a.volume, b.volume);
    expect_same(alone.solid, within.world.solid());
}

/// One solid, and worlds around it, all cut in the same way; new faces get the first material everywhere.
struct Side {
    World world;
    std::string material;  ///< the name of its first
};

/// Where rooms meet, faces may be divided otherwise.
void expect_same_points(const SolidResult& alone, const CarveResult& within) {
    ASSERT_EQ(alone.status, within.status);
    ASSERT_EQ(alone.error.text(), within.error.text());
    ASSERT_EQ(hash_solid(alone.solid), hash_solid(within.world));
    ASSERT_TRUE(same_solid(alone.solid, within.world.solid()));
}

int cut_all(Solid solid, std::vector<Side> sides, const std::vector<CutOrder>& cuts, const CarveRules* rules) {
    int done = 0;
    for (std::size_t k = 0; k < cuts.size(); ++k) {
        SCOPED_TRACE("cut " + std::to_string(k));
        const SolidResult alone = cut_alone(solid, cuts[k], {.material = 0, .rules = rules});
        for (Side& side : sides) {
            const CarveResult within = cut_within(side.world, cuts[k], {side.material});
            side.world.room_count() > 1 ? expect_same_points(alone, within) : expect_same(alone, within);
            if (testing::Test::HasFatalFailure()) return done;
            side.world = within.world;
        }
        done += alone.done();
        solid = alone.solid;
        if (k % 20 != 0) continue;
        for (const Side& side : sides)
            if (side.world.room_count() == 1) expect_same_measures(solid, side.world.solid());
    }
    EXPECT_FALSE(check_solid(solid));
    for (const Side& side : sides) {
        if (side.world.room_count() == 1) expect_same_measures(solid, side.world.solid());
        EXPECT_NEAR(measure_solid(solid).volume, measure_solid(side.world).volume, 1e-9);
        EXPECT_FALSE(check_world(side.world));
    }
    return done;
}

TEST(Solid, CarvedAloneIsWhatIsCarvedInAWorld) {
    const Level level = read_level(FIRMA_ROOT "/levels/first.obj").value();
    const Solid solid = make_solid(level).value();
    // Of one matter, so that a material without a name is one that can be asked for.
    WorldOptions plain;
    plain.matters.emplace();
    const World of_level = make_world(level, plain).value(), of_solid = make_world(solid).value();
    expect_same(solid, of_level.solid());
    expect_same(solid, of_solid.solid());
    const std::vector<CutOrder> cuts = reference::cuts_of_our_level(level, 11, std::size_t(test::sample(80)));
    const int done =
        cut_all(solid, {{of_level, of_level.material_name(0)}, {of_solid, of_solid.material_name(0)}}, cuts, nullptr);
    EXPECT_GE(done, test::sample(50));
}

/// A world around a solid alone has no names of its materials, but their numbers: one that a cut adds is none of them.
TEST(Solid, MaterialsKeepTheirNumbersInAWorldOfItAlone) {
    const World level = make_world(read_level(FIRMA_ROOT "/levels/first.obj").value()).value();
    const World bare = make_world(level.solid()).value();
    const Hit floor = cast(bare, {{35, 29, 1}, 0}, {0, 0, -9});
    ASSERT_TRUE(floor.touched());
    CarveOptions options;
    options.material = "inside";
    const CarveResult cut = carve(bare, make_crater(CutterShape::kRocky, 1), {.position = floor.point}, options);
    ASSERT_TRUE(cut.done());
    for (const Face& face : cut.world.faces()) {
        EXPECT_EQ(cut.world.material_name(face.material), face.source_edit > 0 ? "inside" : "") << face.id.value;
        const auto before = level.find_face(face.id);
        EXPECT_TRUE(!before || face.material == before->material) << face.id.value;
    }
}

TEST(Solid, FacesBesideItChangeNothing) {
    Level level = test::box_level({-12, -12, -4}, {12, 12, 4}, true);
    test::add_box(level, {-6, -6, -2}, {-2, -2, 2});
    for (int k = 0; k < 5; ++k)  // sheets without a back, across where it is cut
        test::add_polygon(level, {{2.0 * k, -5, -3}, {2.0 * k, 5, -3}, {2.0 * k, 5, 3}});
    const Solid solid = make_solid(level).value();
    CarveRules rules;
    rules.open_faces = false;
    const World world = with_rules(make_world(level).value(), rules).value();
    ASSERT_EQ(world.face_count() - solid.face_count(), 5u);
    scenes::Rng rng(7);
    std::vector<CutOrder> cuts;
    for (int k = 0; k < 110; ++k) {
        CutOrder& order = cuts.emplace_back();
        order.cutter = scenes::any_cutter(rng);
        for (int axis = 0; axis < 3; ++axis) order.pose.position[axis] = rng.uniform(-10, 10) * (axis == 2 ? 0.4 : 1);
        order.pose.scale = rng.uniform(0.5, 2);
        order.kind = k % 5 == 4 ? CarveKind::kFill : CarveKind::kCarve;
    }
    EXPECT_GE(cut_all(solid, {{world, world.material_name(0)}}, cuts, nullptr), 60);
}

TEST(Solid, RoomsAroundItChangeNothing) {
    // A solid alone has no pieces, and the depot's sky is one that may not be carved: here it may.
    CarveRules rules;
    rules.hardness.assign(64, 0.0);
    const World depot =
        with_rules(make_world(read_brush_level(FIRMA_ROOT "/levels/depot.map").value()).value(), rules).value();
    ASSERT_GT(depot.room_count(), 1u);
    std::vector<CutOrder> cuts;
    const scenes::CutPlaces places = scenes::cut_places(depot);
    for (std::size_t kind = 0; kind < scenes::kLevelCutNames.size(); ++kind)
        for (const CutOrder& order : scenes::level_cuts(places, scenes::LevelCuts(kind), 2, 0))
            if (cuts.size() < std::size_t(test::sample(10)) * (kind + 1)) cuts.push_back(order);
    const World bare = with_rules(make_world(depot.solid()).value(), rules).value();
    const int done =
        cut_all(depot.solid(), {{depot, depot.material_name(0)}, {bare, bare.material_name(0)}}, cuts, &rules);
    EXPECT_GE(done, test::sample(30));
}

}  // namespace
}  // namespace firma
