// SPDX-License-Identifier: MIT
// The maps of OpenArena, where they are.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <utility>

#include "firma/brush_level.h"
#include "firma/firma.h"
#include "geometry/exact_plane.h"
#include "level/bsp_file.h"
#include "tests/level/face_corners.h"
#include "tests/openarena_maps.h"
#include "tests/sample.h"

namespace firma {
namespace {

struct Map {
    std::string name;
    std::vector<char> bytes;

    std::span<const std::byte> span() const { return std::as_bytes(std::span(bytes)); }
};

std::vector<Map> load_maps() {
    std::vector<Map> maps;
    for (const std::filesystem::path& path : test::sampled(openarena_maps())) {
        std::vector<char> bytes(std::filesystem::file_size(path));
        std::ifstream(path, std::ios::binary).read(bytes.data(), std::streamsize(bytes.size()));
        maps.push_back({path.filename().string(), std::move(bytes)});
    }
    return maps;
}

#define LOAD_MAPS_OR_SKIP(maps)                \
    const std::vector<Map> maps = load_maps(); \
    if (maps.empty()) GTEST_SKIP() << kNoOpenArena

TEST(OpenArena, EveryMapIsReadAndEveryFaceIsSound) {
    LOAD_MAPS_OR_SKIP(maps);
    for (const Map& map : maps) {
        const auto level = read_bsp(map.span(), map.name);
        ASSERT_TRUE(level.ok()) << level.error().text();
        EXPECT_EQ(level.value().count(FaceNote::kNoArea), 0u) << map.name;
        std::vector<bool> seen(level.value().source_faces);
        for (const LevelFace& face : level.value().faces) {
            ASSERT_EQ(check_polygon(test::corners_of(level.value(), face)), PolygonFault::kNone) << map.name;
            seen[face.source] = true;
        }
        const auto surfaces = std::size_t(std::count(seen.begin(), seen.end(), true));
        EXPECT_EQ(surfaces + level.value().ignored_entries, level.value().source_faces) << map.name;
    }
}

// What each planar face comes to points where the file says, and so does every piece of it, but for slivers that are
// folded in the file itself.
TEST(OpenArena, PlanarFacesFaceAsTheFileSays) {
    LOAD_MAPS_OR_SKIP(maps);
    constexpr double kSliver = 32 / 1024.0;  // square metres: 32 square units
    double area = 0, folded_area = 0;
    std::size_t faces = 0, pieces = 0, folded = 0;
    for (const Map& map : maps) {
        const auto file = BspFile::open(map.span(), map.name).value();
        const auto in_file = file.records<BspFace>();
        const Level level = read_bsp(map.span(), map.name).value();
        std::map<std::uint32_t, Vec3> sums;
        for (const LevelFace& face : level.faces) {
            const auto [x, y, z] = in_file[face.source].normal;
            if (face.kind != FaceKind::kPolygon || (x == 0 && y == 0 && z == 0)) continue;
            const Vec3 piece = test::twice_area(test::corners_of(level, face)) * 0.5;
            sums[face.source] = sums[face.source] + piece;
            area += length(piece);
            ++pieces;
            if (dot(piece, {x, y, z}) > 0) continue;
            ++folded;
            folded_area += length(piece);
            EXPECT_LT(length(piece), kSliver) << map.name << " face " << face.source;
        }
        for (const auto& [source, sum] : sums) {
            const auto [x, y, z] = in_file[source].normal;
            ++faces;
            if (length(sum) <= kSliver) continue;
            EXPECT_GT(dot(sum, {x, y, z}), 0.99 * length(sum)) << map.name << " face " << source;
        }
    }
    // 0.0019 of all maps' pieces; a few maps by themselves may have some more.
    const bool all = test::sample(5) == 5;
    EXPECT_LT(double(folded), (all ? 0.002 : 0.0025) * double(pieces));
    EXPECT_LT(folded_area, 1e-5 * area);
    RecordProperty("planar_faces", int(faces));
    RecordProperty("folded_slivers", int(folded));
}

TEST(OpenArena, PatchesFaceAsTheirNormalsSay) {
    LOAD_MAPS_OR_SKIP(maps);
    std::size_t agree = 0, against = 0;
    for (const Map& map : maps) {
        const auto file = BspFile::open(map.span(), map.name).value();
        const auto in_file = file.records<BspFace>();
        const auto vertices = file.records<BspVertex>();
        const Level level = read_bsp(map.span(), map.name).value();
        std::map<std::uint32_t, Vec3> sums;
        for (const LevelFace& face : level.faces) {
            if (face.kind == FaceKind::kPatch)
                sums[face.source] = sums[face.source] + test::twice_area(test::corners_of(level, face)) * 0.5;
        }
        for (const auto& [source, sum] : sums) {
            Vec3 normal;
            const BspFace face = in_file[source];
            for (std::int32_t k = 0; k < face.vertex_count; ++k) {
                const auto [x, y, z] = vertices[std::size_t(face.first_vertex + k)].normal;
                normal = normal + Vec3{x, y, z};
            }
            // A patch that goes all round has no one direction.
            if (length(normal) < 0.3 * face.vertex_count) continue;
            (dot(sum, normal) > 0 ? agree : against) += 1;
        }
    }
    EXPECT_GT(agree, unsigned(test::sample(100)));
    EXPECT_EQ(against, 0u);
}

TEST(OpenArena, EveryMapMakesASoundWorld) {
    LOAD_MAPS_OR_SKIP(maps);
    for (const Map& map : maps) {
        const auto world = make_world(read_bsp(map.span(), map.name).value());
        ASSERT_TRUE(world.ok()) << world.error().text();
        const auto fault = check_world(world.value());
        EXPECT_FALSE(fault.has_value()) << map.name << ": " << fault->what;
    }
}

TEST(OpenArena, EveryMapsBrushesAreRead) {
    LOAD_MAPS_OR_SKIP(maps);
    std::size_t solid = 0, portals = 0;
    double greatest = 0;
    for (const Map& map : maps) {
        const auto level = read_bsp_brushes(map.span(), map.name);
        ASSERT_TRUE(level.ok()) << level.error().text();
        for (const BrushSide& side : level.value().sides) {
            ASSERT_TRUE(
                plane_through(to_input(side.points[0]), to_input(side.points[1]), to_input(side.points[2])).valid());
        }
        for (const Brush& brush : level.value().brushes) {
            solid += brush.kind == BrushKind::kSolid;
            portals += brush.kind == BrushKind::kPortal;
            EXPECT_TRUE(brush.side_count >= 4 || brush.kind == BrushKind::kData) << map.name;
        }
        for (const LevelFace& face : level.value().surfaces.faces) {
            ASSERT_EQ(check_polygon(test::corners_of(level.value().surfaces, face)), PolygonFault::kNone) << map.name;
        }
        greatest = std::max(greatest, level.value().max_shift);
    }
    EXPECT_LT(greatest, 0.0005);
    const bool all = maps.size() == openarena_maps().size();
    EXPECT_GT(solid, all ? 60000u : 8000u);
    EXPECT_GT(portals, all ? 400u : 20u);
}

TEST(OpenArena, EveryMapIsChecked) {
    LOAD_MAPS_OR_SKIP(maps);
    for (const Map& map : maps) {
        const auto check = check_bsp(map.span(), map.name);
        ASSERT_TRUE(check.ok()) << check.error().text();
        EXPECT_GT(check.value().vertices, 100u);
    }
}

}  // namespace
}  // namespace firma
