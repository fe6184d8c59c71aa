// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "brush/brush_kinds.h"
#include "firma/brush_level.h"
#include "firma/level.h"
#include "geometry/exact_plane.h"
#include "scenes/rng.h"
#include "tests/level/bsp_writer.h"

namespace firma {
namespace {

using test::BspWriter;
using namespace bsp_flags;

constexpr std::int32_t kMost = std::numeric_limits<std::int32_t>::max();

Result<BrushLevel> read(const BspWriter& writer, const ReadOptions& options = {}) {
    return read_bsp_brushes(writer.bytes(), "a.bsp", options);
}

std::string bsp_error_of(const BspWriter& writer, const ReadOptions& options = {}) {
    const auto level = read(writer, options);
    return level ? "" : level.error().text();
}

Plane plane_of(const BrushSide& side) {
    return plane_through(to_input(side.points[0]), to_input(side.points[1]), to_input(side.points[2]));
}

// Whether a point (in units of a 32nd of a metre) lies exactly on the plane.
bool holds(const Plane& plane, const std::array<std::int64_t, 3>& units) {
    Int128 sum = plane.offset();
    for (std::size_t axis = 0; axis < 3; ++axis) sum += Int128(plane.normal[axis]) * (128 * units[axis]);
    return sum == 0;
}

BspWriter one_box() {
    BspWriter writer;
    writer.box({0, 0, 0}, {64, 32, 96}, writer.shader("textures/base/wall", 0, kSolid));
    return writer;
}

TEST(ReadBspBrushes, BoxFacesOutwardInMetres) {
    const BrushLevel level = read(one_box()).value();
    ASSERT_EQ(level.brushes.size(), 1u);
    EXPECT_EQ(level.brushes[0].kind, BrushKind::kSolid);
    EXPECT_EQ(level.brushes[0].line, 0u);
    ASSERT_EQ(level.brushes[0].side_count, 6u);
    const double limits[] = {0, 2, 0, 1, 0, 3};
    for (std::uint32_t k = 0; k < 6; ++k) {
        const BrushSide& side = level.sides[k];
        const Plane plane = plane_of(side);
        const std::int32_t axis = std::int32_t(k / 2);
        EXPECT_EQ(plane.normal[axis], k % 2 ? 1 : -1);
        EXPECT_EQ(to_metres(side.points[0])[axis], limits[k]);
        EXPECT_EQ(side.mask, kStopsSolid);
        EXPECT_FALSE(side.portal);
        EXPECT_EQ(level.materials[side.material], "textures/base/wall");
    }
    EXPECT_EQ(level.max_shift, 0);
    EXPECT_TRUE(level.notes.empty());
    EXPECT_EQ(level.name, "a.bsp");
    EXPECT_EQ(level.metres_a_unit, 1.0 / 32);
    EXPECT_EQ(level.entities[0].value("classname"), "worldspawn");
    EXPECT_EQ(to_metres(read(one_box(), {.scale = 0.5}).value().sides[5].points[0]).z, 48);
    EXPECT_EQ(bsp_error_of(one_box(), {.scale = -1}), "a.bsp: scale -1 is not a positive number");
    EXPECT_EQ(bsp_error_of(one_box(), {.patch_tolerance = 0}), "a.bsp: patch tolerance 0 is not a positive number");
}

TEST(ReadBspBrushes, AxialPlanesSnapTheirDistance) {
    BspWriter writer;
    writer.box({0.1, 0, 0}, {64, 32, 96}, writer.shader("a", 0, kSolid));
    const BrushLevel level = read(writer).value();
    EXPECT_EQ(level.sides[0].points[0].x, 13 * 64);  // 12.8 steps
    EXPECT_NEAR(level.max_shift, 0.2 / 4096, 1e-9);
}

// A pyramid with corners at whole units, its planes rounded to float.
struct Pyramid {
    std::array<std::int64_t, 3> corners[5] = {
        {-900, -871, 3}, {-700, -871, 3}, {-700, -600, 3}, {-900, -600, 3}, {-811, -733, 250}};

    static Vec3 at(const std::array<std::int64_t, 3>& p) { return {double(p[0]), double(p[1]), double(p[2])}; }

    std::vector<std::int32_t> add_to(BspWriter& writer) const {
        std::vector<std::int32_t> of{writer.plane({0, 0, 1}, 3) + 1};
        for (std::size_t k = 0; k < 4; ++k) {
            const Vec3 a = at(corners[k]), b = at(corners[(k + 1) % 4]), c = at(corners[4]);
            Vec3 normal = cross(b - a, c - a);
            normal = normal * (1 / length(normal));
            of.push_back(writer.plane(normal, dot(normal, a)));
        }
        return of;
    }
};

TEST(ReadBspBrushes, PlanesThroughWholeUnitsAreRestored) {
    const Pyramid pyramid;
    BspWriter writer;
    writer.brush(pyramid.add_to(writer), writer.shader("a", 0, kSolid));
    const BrushLevel level = read(writer).value();
    ASSERT_EQ(level.sides.size(), 5u);
    for (std::size_t k = 0; k < 4; ++k) {
        const Plane plane = plane_of(level.sides[k + 1]);
        EXPECT_TRUE(holds(plane, pyramid.corners[k]));
        EXPECT_TRUE(holds(plane, pyramid.corners[(k + 1) % 4]));
        EXPECT_TRUE(holds(plane, pyramid.corners[4]));  // all four planes still meet in the tip
        EXPECT_GT(plane.normal[2], 0);
    }
    EXPECT_LT(level.max_shift, 1e-4);
}

TEST(ReadBspBrushes, PlaneAndNegativeAreOne) {
    const Pyramid pyramid;
    BspWriter writer;
    const std::int32_t shader = writer.shader("a", 0, kSolid);
    const std::vector<std::int32_t> of = pyramid.add_to(writer);
    writer.brush(of, shader);
    // Beyond the pyramid's first slope, on the same plane: sixteen units thick and not at whole units.
    std::vector<std::int32_t> other{of[1] + 1};
    const BspPlane slope = writer.planes[std::size_t(of[1])];
    const Vec3 normal = {slope.normal[0], slope.normal[1], slope.normal[2]};
    other.push_back(writer.plane(normal, slope.distance + 16));
    other.push_back(writer.plane({1, 0, 0}, -750.3));
    other.push_back(writer.plane({1, 0, 0}, -860.7) + 1);
    other.push_back(writer.plane({0, 0, 1}, 190.9));
    other.push_back(writer.plane({0, 0, 1}, 10.1) + 1);
    writer.brush(other, shader);
    const BrushLevel level = read(writer).value();
    ASSERT_EQ(level.sides.size(), 11u);
    const BrushSide &one = level.sides[1], &two = level.sides[5];
    EXPECT_EQ(one.points[0], two.points[0]);
    EXPECT_EQ(one.points[1], two.points[2]);
    EXPECT_EQ(one.points[2], two.points[1]);
    EXPECT_EQ(plane_of(two), flipped(plane_of(one)));
}

TEST(ReadBspBrushes, PlanesOfNoLatticeAreNearest) {
    scenes::Rng rng(5);
    for (int round = 0; round < 40; ++round) {
        BspWriter writer;
        Vec3 middle;
        for (int axis = 0; axis < 3; ++axis) middle[axis] = rng.uniform(-3000, 3000);
        std::vector<std::int32_t> of;
        for (int k = 0; k < 14; ++k) {
            const Vec3 normal = rng.direction();
            const double size = rng.uniform(50, 200);
            of.push_back(writer.plane(normal, dot(normal, middle) + size));
        }
        writer.brush(of, writer.shader("a", 0, kSolid));
        const BrushLevel level = read(writer).value();
        EXPECT_GT(level.max_shift, 1e-6);
        EXPECT_LT(level.max_shift, 0.0005);
        // Sides keep their order; those without a face are gone.
        std::size_t next = 0;
        for (const BrushSide& side : level.sides) {
            const Plane plane = plane_of(side);
            const Vec3 normal = plane.direction() * (1 / length(plane.direction()));
            bool found = false;
            for (; next < of.size() && !found; ++next) {
                const BspPlane& from = writer.planes[std::size_t(of[next])];
                found = dot(normal, {from.normal[0], from.normal[1], from.normal[2]}) > 0.999;
            }
            EXPECT_TRUE(found);
        }
    }
}

// The box around a pyramid, as compilers add it, and a plane that touches the tip.
TEST(ReadBspBrushes, PlanesThatOnlyTouchAreLeftOut) {
    const Pyramid pyramid;
    BspWriter writer;
    std::vector<std::int32_t> of = pyramid.add_to(writer);
    of.push_back(writer.plane({1, 0, 0}, -700.003));
    of.push_back(writer.plane({1, 0, 0}, -900) + 1);
    of.push_back(writer.plane({0, 1, 0}, -600));
    of.push_back(writer.plane({0, 1, 0}, -871) + 1);
    of.push_back(writer.plane({0, 0, 1}, 249.995));
    of.push_back(writer.plane({0.6, 0, 0.8}, -0.6 * 811 + 0.8 * 250));
    writer.brush(of, writer.shader("a", 0, kSolid));
    const BrushLevel level = read(writer).value();
    EXPECT_EQ(level.brushes[0].side_count, 5u);
    EXPECT_NEAR(level.max_shift, 0.005 / 32, 0.001 / 32);
    // One that cuts the tip off for good is kept.
    writer.planes[std::size_t(of[9])].distance = 249;
    EXPECT_EQ(read(writer).value().brushes[0].side_count, 6u);
}

BrushLevel of_contents(std::uint32_t contents, std::int32_t surface = 0) {
    BspWriter writer;
    writer.box({0, 0, 0}, {64, 32, 96}, writer.shader("a", surface, contents));
    return read(writer).value();
}

TEST(ReadBspBrushes, KindsAndMasksByContents) {
    const auto expect = [](std::uint32_t contents, std::int32_t surface, BrushKind kind, std::uint32_t mask) {
        const BrushLevel level = of_contents(contents, surface);
        EXPECT_EQ(level.brushes[0].kind, kind) << contents;
        EXPECT_EQ(level.sides[0].mask, mask) << contents;
    };
    expect(kSolid, 0, BrushKind::kSolid, kStopsSolid);
    expect(kSolid | kPlayerClip | kDetail, 0x4000, BrushKind::kSolid, kStopsSolid);
    expect(kSolid, 4, BrushKind::kSky, kStopsSolid | kIsSky);
    expect(kSolid | kTranslucent, 0, BrushKind::kGlass, kStopsWalk | kStopsShots);
    expect(kPlayerClip, 0xb0, BrushKind::kPlayerClip, kStopsWalk);
    expect(kWater | kTranslucent, 0, BrushKind::kLiquid, kStopsLiquid);
    expect(kLava | kFog | kNoDrop, 0, BrushKind::kLiquid, kStopsLiquid);
    expect(kSlime, 0, BrushKind::kLiquid, kStopsLiquid);
    expect(kFog | kTranslucent, 0, BrushKind::kData, 0);
    expect(kTrigger, 0, BrushKind::kData, 0);
    expect(kNoDrop | kTranslucent, 0, BrushKind::kData, 0);
    expect(kTranslucent, 0x80, BrushKind::kData, 0);
    expect(0, 0, BrushKind::kData, 0);
    expect(kAreaPortal | kTranslucent, 0x80, BrushKind::kPortal, 0);
    expect(kTranslucent, 0x100, BrushKind::kPortal, 0);
    EXPECT_TRUE(of_contents(kSolid | kDetail).brushes[0].detail);
    EXPECT_FALSE(of_contents(kSolid).brushes[0].detail);
}

TEST(ReadBspBrushes, PortalsAreTheMarkedSidesOrTheLargest) {
    BspWriter writer;
    const std::int32_t skip = writer.shader("skip", 0x280, kTranslucent),
                       hint = writer.shader("hint", 0x180, kTranslucent);
    writer.box({0, 0, 0}, {64, 32, 96}, hint);
    writer.box({0, 0, 0}, {64, 32, 96}, hint);
    for (std::size_t k = 6; k < 12; ++k) writer.brush_sides[k].shader = k == 7 || k == 10 ? hint : skip;
    const BrushLevel level = read(writer).value();
    std::string marks;
    for (const BrushSide& side : level.sides) marks += side.portal ? '1' : '0';
    EXPECT_EQ(marks,
              "001000"
              "010010");
}

TEST(ReadBspBrushes, SubmodelsBelongToTheirEntities) {
    BspWriter writer = one_box();
    for (int k = 0; k < 5; ++k) writer.box({0, 0, 0}, {8, 8, 8}, 1);
    writer.models = {{0, 0, 0, 2}, {0, 0, 2, 1}, {0, 0, 3, 1}, {0, 0, 4, 1}};
    writer.entities =
        "{ \"classname\" \"worldspawn\" }\n{ \"classname\" \"func_door\" \"model\" \"*1\" }\n"
        "{ \"classname\" \"func_static\" \"model\" \"*2\" }\n{ \"classname\" \"light\" \"model\" \"*9\" }\n"
        "{ \"classname\" \"misc\" \"model\" \"*1x\" }\n";
    const BrushLevel level = read(writer).value();
    ASSERT_EQ(level.brushes.size(), 6u);
    const auto kind = [&](std::size_t k) { return level.brushes[k].kind; };
    EXPECT_EQ(kind(0), BrushKind::kSolid);
    EXPECT_EQ(kind(1), BrushKind::kSolid);
    EXPECT_EQ(kind(2), BrushKind::kData);
    EXPECT_EQ(level.brushes[2].entity, 1u);
    EXPECT_EQ(kind(3), BrushKind::kSolid);
    EXPECT_EQ(level.brushes[3].entity, 2u);
    EXPECT_EQ(kind(4), BrushKind::kData);
    EXPECT_EQ(level.brushes[4].entity, 0u);
    EXPECT_EQ(kind(5), BrushKind::kData);
    EXPECT_EQ(level.notes,
              (std::vector<std::string>{
                  "brushes of 'func_door' are kept as data: a.bsp: lump 8 (brushes), entry 2",
                  "brushes of models that no entity names are kept as data: a.bsp: lump 8 (brushes), entry 4",
                  "brush of no model is kept as data: a.bsp: lump 8 (brushes), entry 5"}));
    ASSERT_EQ(level.omissions.size(), 3u);
    EXPECT_EQ(level.omissions[0].what, "brushes of 'func_door'");
    EXPECT_EQ(level.omissions[1].what, "brushes of models that no entity names");
    EXPECT_EQ(level.omissions[2].what, "brushes of no model");
    EXPECT_EQ(level.omissions[2].first, "a.bsp: lump 8 (brushes), entry 5");
    // An origin moves it from where its planes are.
    writer.entities.insert(writer.entities.find("\"*2\"") + 4, " \"origin\" \"1 2 3\"");
    EXPECT_EQ(read(writer).value().brushes[3].kind, BrushKind::kData);
    // A trigger is there to be walked through, wherever it is.
    writer.entities.replace(writer.entities.find("func_static"), 11, "trigger_hurt");
    EXPECT_EQ(read(writer).value().brushes[3].kind, BrushKind::kData);
    EXPECT_EQ(read(writer).value().omissions.size(), 3u);
}

TEST(ReadBspBrushes, BrushThatEnclosesNothingIsData) {
    BspWriter writer;
    const std::int32_t solid = writer.shader("a", 0, kSolid);
    writer.box({0, 0, 0}, {-8, 8, 8}, solid);
    writer.brush({writer.plane({1, 0, 0}, 5)}, solid);
    writer.brush({}, solid);
    const BrushLevel level = read(writer).value();
    ASSERT_EQ(level.brushes.size(), 3u);
    for (const Brush& brush : level.brushes) EXPECT_EQ(brush.kind, BrushKind::kData);
    EXPECT_EQ(level.notes, (std::vector<std::string>{"brush that encloses nothing is kept as data: first a.bsp: lump 8 "
                                                     "(brushes), entry 0, 3 in all"}));
}

TEST(ReadBspBrushes, PatchesAreSurfaces) {
    BspWriter writer = one_box();
    const std::int32_t solid = writer.shader("curve", 0, kSolid), air = writer.shader("air", 0x4000, 0),
                       water = writer.shader("water", 0, kWater);
    std::vector<Vec3> control;
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 3; ++x) control.push_back({64.0 * x, 32.0 * y, 16});
    writer.polygon({{0, 0, 0}, {32, 0, 0}, {0, 64, 0}});  // drawn, not met
    writer.patch(3, 3, control).shader = solid;
    writer.patch(3, 3, control).shader = air;
    writer.patch(3, 3, control).shader = water;
    const BrushLevel level = read(writer).value();
    ASSERT_EQ(level.surfaces.faces.size(), 2u);
    EXPECT_EQ(level.surfaces.faces[0].source, 6u);
    EXPECT_EQ(level.surfaces.faces[0].mask, kStopsSolid);
    EXPECT_EQ(level.surfaces.materials[level.surfaces.faces[0].material], "curve");
    EXPECT_EQ(level.surfaces.faces[1].source, 7u);
    EXPECT_EQ(level.surfaces.faces[1].mask, kStopsLiquid);
    EXPECT_EQ(level.notes,
              (std::vector<std::string>{"patch that nothing meets is left out: a.bsp: lump 13 (faces), entry 2"}));
    EXPECT_TRUE(level.omissions.empty());  // nothing meets it in the game either
    writer.models = {{0, 3, 0, 1}, {3, 1, 1, 0}};
    const BrushLevel moves = read(writer).value();
    EXPECT_EQ(moves.surfaces.faces.size(), 1u);
    ASSERT_EQ(moves.omissions.size(), 1u);
    EXPECT_EQ(moves.omissions[0].what, "patches of models other than the first");
    EXPECT_EQ(moves.omissions[0].first, "a.bsp: lump 13 (faces), entry 3");
}

TEST(ReadBspBrushes, ErrorsNameLumpAndEntry) {
    const auto broken = [](auto&& change) {
        BspWriter writer = one_box();
        writer.patch(3, 3, std::vector<Vec3>(9, Vec3{1, 2, 3})).shader = 1;
        change(writer);
        return bsp_error_of(writer);
    };
    EXPECT_EQ(broken([](BspWriter&) {}), "");
    EXPECT_EQ(broken([](BspWriter& w) { w.entities = "{\n\"a\" }"; }),
              "a.bsp: lump 0 (entities), line 2: expected a value for the key 'a' of entity 0, found '}'");
    EXPECT_EQ(broken([](BspWriter& w) { w.entities = ""; }), "a.bsp: lump 0 (entities): holds no entity");
    EXPECT_EQ(broken([](BspWriter& w) { w.models.clear(); }),
              "a.bsp: lump 7 (models): is empty; the first model is the level");
    EXPECT_EQ(broken([](BspWriter& w) { w.models[0].brush_count = 2; }),
              "a.bsp: lump 7 (models), entry 0: 2 brushes from number 0 on, of 1");
    EXPECT_EQ(broken([](BspWriter& w) { w.models.push_back({0, 0, 0, 1}); }),
              "a.bsp: lump 7 (models), entry 1: brush 0 is that of model 0 already");
    EXPECT_EQ(broken([](BspWriter& w) { w.models[0].face_count = 2; }),
              "a.bsp: lump 7 (models), entry 0: 2 faces from number 0 on, of 1");
    EXPECT_EQ(broken([](BspWriter& w) { w.brushes[0].side_count = 7; }),
              "a.bsp: lump 8 (brushes), entry 0: 7 brush sides from number 0 on, of 6");
    EXPECT_EQ(broken([](BspWriter& w) { w.brushes[0].side_count = -1; }),
              "a.bsp: lump 8 (brushes), entry 0: -1 brush sides");
    EXPECT_EQ(broken([](BspWriter& w) { w.brushes[0].first_side = kMost; }),
              "a.bsp: lump 8 (brushes), entry 0: 6 brush sides from number 2147483647 on, of 6");
    EXPECT_EQ(broken([](BspWriter& w) { w.brushes[0].shader = 2; }), "a.bsp: lump 8 (brushes), entry 0: shader 2 of 2");
    EXPECT_EQ(broken([](BspWriter& w) { w.brush_sides[3].shader = -1; }),
              "a.bsp: lump 9 (brush sides), entry 3: shader -1 of 2");
    EXPECT_EQ(broken([](BspWriter& w) { w.brush_sides[3].plane = 12; }),
              "a.bsp: lump 9 (brush sides), entry 3: plane 12 of 12");
    EXPECT_EQ(broken([](BspWriter& w) { w.planes[5].normal[1] = NAN; }),
              "a.bsp: lump 2 (planes), entry 5: a number is not finite");
    EXPECT_EQ(broken([](BspWriter& w) { w.planes[5].distance = -INFINITY; }),
              "a.bsp: lump 2 (planes), entry 5: a number is not finite");
    EXPECT_EQ(broken([](BspWriter& w) { w.planes[2].normal = {}; }),
              "a.bsp: lump 2 (planes), entry 2: a plane without a normal is used");
    EXPECT_EQ(broken([](BspWriter& w) { w.planes[2].distance = 262144; }),
              "a.bsp: lump 2 (planes), entry 2: a brush's plane lies outside the world");
    EXPECT_EQ(broken([](BspWriter& w) { w.faces[0].shader = 2; }), "a.bsp: lump 13 (faces), entry 0: shader 2 of 2");
    EXPECT_EQ(broken([](BspWriter& w) { w.faces[0].first_vertex = 1; }),
              "a.bsp: lump 13 (faces), entry 0: 9 vertices from number 1 on, of 9");
    EXPECT_EQ(broken([](BspWriter& w) { w.faces[0].patch_width = 4; }),
              "a.bsp: lump 13 (faces), entry 0: patch of 4 x 3 control points; both must be odd and 3 or more");
    EXPECT_EQ(broken([](BspWriter& w) { w.faces[0].patch_width = kMost; }),
              "a.bsp: lump 13 (faces), entry 0: patch of 2147483647 x 3 control points, but 9 vertices");
    EXPECT_EQ(broken([](BspWriter& w) { w.vertices[4].y = NAN; }),
              "a.bsp: lump 13 (faces), entry 0: control point 4: y is nan");
}

// A small file whose brushes share their sides, and ask for much.
TEST(ReadBspBrushes, WorkIsLimitedBeforeItIsDone) {
    BspWriter writer;
    const std::int32_t solid = writer.shader("a", 0, kSolid);
    scenes::Rng rng(9);
    std::vector<std::int32_t> of;
    for (int k = 0; k < 1025; ++k) of.push_back(writer.plane(rng.direction(), 100));
    writer.brush(of, solid);
    EXPECT_EQ(bsp_error_of(writer), "a.bsp: lump 8 (brushes), entry 0: 1025 sides, more than 1024");
    writer.brushes.assign(100, {0, 1000, solid});
    EXPECT_EQ(
        bsp_error_of(writer),
        "a.bsp: lump 8 (brushes), entry 67: brushes have more than 1048576 sides, or more than 2^26 pairs of them");
}

TEST(ReadBspBrushes, HostileBytes) {
    const Pyramid pyramid;
    BspWriter writer = one_box();
    writer.brush(pyramid.add_to(writer), 1);
    writer.patch(3, 3, std::vector<Vec3>(9, Vec3{1, 2, 3})).shader = 1;
    const std::vector<std::byte> bytes = writer.bytes();
    const auto judge = [](std::span<const std::byte> file) {
        const auto level = read_bsp_brushes(file, "a.bsp");
        if (!level.ok()) {
            ASSERT_TRUE(level.error().place.starts_with("a.bsp"));
            return;
        }
        for (const BrushSide& side : level.value().sides) ASSERT_TRUE(plane_of(side).valid());
    };
    for (std::size_t k = 0; k < bytes.size(); ++k) judge(std::span(bytes).first(k));
    scenes::Rng rng(12);
    for (int round = 0; round < 4000; ++round) {
        std::vector<std::byte> changed = bytes;
        for (int change = 0; change < 1 + round % 3; ++change) {
            const std::uint32_t at = rng.below(std::uint32_t(changed.size()));
            changed[at] = std::byte(rng.below(256));
        }
        judge(changed);
    }
}

}  // namespace
}  // namespace firma
