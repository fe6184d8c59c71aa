// SPDX-License-Identifier: MIT
#include "level/bsp_file.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/level/bsp_writer.h"

namespace firma {
namespace {

using test::BspWriter;

BspWriter one_triangle() {
    BspWriter writer;
    writer.polygon({{0, 0, 0}, {32, 0, 0}, {0, 32, 0}});
    return writer;
}

std::string error_of(const std::vector<std::byte>& bytes) {
    const auto file = BspFile::open(bytes, "map.bsp");
    return file ? "" : file.error().text();
}

TEST(BspFile, DecodesRecords) {
    BspWriter writer = one_triangle();
    writer.models.push_back({1, 0});
    const auto bytes = writer.bytes();
    const auto file = BspFile::open(bytes, "map.bsp");
    ASSERT_TRUE(file.ok()) << file.error().text();
    EXPECT_EQ(file.value().name(), "map.bsp");
    EXPECT_EQ(file.value().records<BspModel>().size(), 2u);
    EXPECT_EQ(file.value().records<BspModel>()[1].first_face, 1);
    EXPECT_EQ(file.value().records<BspShader>()[0].name, "textures/tests/wall");
    EXPECT_EQ(file.value().records<BspVertex>()[1].position, (std::array<float, 3>{32, 0, 0}));
    EXPECT_EQ(file.value().records<BspMeshVertex>()[1].vertex, 2);
    const BspFace face = file.value().records<BspFace>()[0];
    EXPECT_EQ(face.type, BspFace::kPlanar);
    EXPECT_EQ(face.vertex_count, 3);
    EXPECT_EQ(face.mesh_vertex_count, 3);
    EXPECT_EQ(face.normal, (std::array<float, 3>{0, 0, 1}));
    EXPECT_EQ(file.value().lump(BspLump::kVisibility).size(), 9u);
}

TEST(BspFile, ReadsFromAnyAddress) {
    std::vector<std::byte> shifted(1);
    const auto bytes = one_triangle().bytes();
    shifted.insert(shifted.end(), bytes.begin(), bytes.end());
    const auto file = BspFile::open(std::span<const std::byte>(shifted).subspan(1), "map.bsp");
    ASSERT_TRUE(file.ok());
    EXPECT_EQ(file.value().records<BspVertex>()[2].position, (std::array<float, 3>{0, 32, 0}));
}

TEST(BspFile, NameMayFillItsSixtyFourBytes) {
    BspWriter writer = one_triangle();
    writer.shaders[0] = std::string(64, 'n');
    writer.shader("");
    const auto bytes = writer.bytes();
    const auto file = BspFile::open(bytes, "map.bsp").value();
    EXPECT_EQ(file.records<BspShader>()[0].name, std::string(64, 'n'));
    EXPECT_EQ(file.records<BspShader>()[1].name, "");
}

TEST(BspFile, NamesRelativesAndVersions) {
    BspWriter writer = one_triangle();
    writer.version = 47;
    EXPECT_EQ(error_of(writer.bytes()), "map.bsp: is IBSP version 47; only version 46 (Quake 3) is read");
    EXPECT_EQ(BspFile::open(writer.bytes(), "").error().code, ErrorCode::kUnsupported);
    writer.magic = "VBSP";
    EXPECT_EQ(error_of(writer.bytes()), "map.bsp: is of kind VBSP; only IBSP version 46 (Quake 3) is read");
    EXPECT_EQ(BspFile::open(writer.bytes(), "").error().code, ErrorCode::kUnsupported);
    writer.magic = "PK\3\4";
    EXPECT_EQ(error_of(writer.bytes()), "map.bsp: is no .bsp of Quake 3: it does not begin with IBSP");
    EXPECT_EQ(BspFile::open(writer.bytes(), "").error().code, ErrorCode::kMalformed);
}

TEST(BspFile, EveryTruncationIsAnError) {
    const auto bytes = one_triangle().bytes();
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        const auto file = BspFile::open(std::span(bytes).first(size), "map.bsp");
        ASSERT_FALSE(file.ok()) << size;
        EXPECT_EQ(file.error().code, ErrorCode::kMalformed);
        EXPECT_TRUE(file.error().place.starts_with("map.bsp"));
    }
    EXPECT_EQ(error_of({bytes.begin(), bytes.begin() + 100}), "map.bsp: ends within the header: 100 of 144 bytes");
}

// Offsets and lengths that are negative, beyond the end, just beyond the end, or overflow when added.
TEST(BspFile, EveryBadDirectoryEntryIsNamed) {
    constexpr std::int32_t kMost = std::numeric_limits<std::int32_t>::max(),
                           kLeast = std::numeric_limits<std::int32_t>::min();
    const auto sound = one_triangle().bytes();
    const auto file = BspFile::open(sound, "map.bsp").value();
    for (std::size_t k = 0; k < kBspLumps; ++k) {
        const auto lump = BspLump(k);
        const auto expect_named = [&](const std::vector<std::byte>& bytes) {
            const auto broken = BspFile::open(bytes, "map.bsp");
            ASSERT_FALSE(broken.ok()) << k;
            EXPECT_EQ(broken.error().code, ErrorCode::kMalformed);
            EXPECT_TRUE(broken.error().place.starts_with("map.bsp: lump " + std::to_string(k) + " ("))
                << broken.error().text();
        };
        const std::size_t entry = test::directory_entry(lump);
        const auto size = std::int32_t(sound.size());
        for (const std::int32_t length : {-1, kLeast, kMost, kMost - 7, size, size + 1}) {
            auto bytes = sound;
            test::poke(bytes, entry + 4, length);
            expect_named(bytes);
        }
        if (file.lump(lump).empty()) continue;  // lies nowhere, so it cannot lie wrong
        for (const std::int32_t offset : {-1, kLeast, kMost, size, size - 1}) {
            auto bytes = sound;
            test::poke(bytes, entry, offset);
            if (offset == size - 1 && file.lump(lump).size() == 1) continue;
            expect_named(bytes);
        }
    }
}

TEST(BspFile, LumpsHoldWholeRecords) {
    auto bytes = one_triangle().bytes();
    test::poke(bytes, test::directory_entry(BspLump::kFaces) + 4, 103);
    EXPECT_EQ(error_of(bytes), "map.bsp: lump 13 (faces): 103 bytes are not whole records of 104");
}

TEST(BspFile, RangesAreToldInWords) {
    EXPECT_FALSE(bad_range("vertices", 0, 12, 12));
    EXPECT_FALSE(bad_range("vertices", -5, 0, 12));
    EXPECT_EQ(bad_range("vertices", 10, 3, 12).value(), "3 vertices from number 10 on, of 12");
    EXPECT_EQ(bad_range("vertices", -1, 3, 12).value(), "3 vertices from number -1 on, of 12");
    EXPECT_EQ(bad_range("vertices", 0, -3, 12).value(), "-3 vertices");
    EXPECT_TRUE(bad_range("vertices", 2147483647, 2147483647, 12));
}

}  // namespace
}  // namespace firma
