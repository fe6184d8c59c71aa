// SPDX-License-Identifier: MIT
// Reading .obj: what the format allows, and what is refused, with line and reason.
#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "firma/level.h"
#include "firma/polygon.h"
#include "level/read_file.h"
#include "scenes/rng.h"

namespace firma {
namespace {

constexpr std::string_view kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

std::string with_triangle(std::string_view rest) {
    return std::string(kTriangle) + std::string(rest);
}

Level read(const std::string& text, const ReadOptions& options = {}) {
    Result<Level> level = read_obj(text, "t.obj", options);
    EXPECT_TRUE(level.ok()) << level.error().text();
    return level.ok() ? std::move(level).value() : Level{};
}

Error refusal(const std::string& text, const ReadOptions& options = {}) {
    const Result<Level> level = read_obj(text, "t.obj", options);
    EXPECT_FALSE(level.ok()) << text;
    return level.ok() ? Error{} : level.error();
}

GridPoint metres(double x, double y, double z) {
    return *snap({x, y, z});
}

std::vector<std::uint32_t> numbers_of(const Level& level, std::size_t face) {
    const auto first = level.corners.begin() + level.faces[face].first_corner;
    return {first, first + level.faces[face].corner_count};
}

/// What every reader promises.
void expect_sound(const Level& level) {
    std::uint32_t last_source = 0;
    for (const LevelFace& face : level.faces) {
        ASSERT_LE(face.first_corner + face.corner_count, level.corners.size());
        std::vector<Vec3> corners;
        for (std::uint32_t k = 0; k < face.corner_count; ++k) {
            ASSERT_LT(level.corners[face.first_corner + k], level.vertices.size());
            corners.push_back(to_metres(level.vertices[level.corners[face.first_corner + k]]));
        }
        EXPECT_EQ(check_polygon(corners), PolygonFault::kNone);
        EXPECT_LE(corners.size(), 64u);
        EXPECT_LT(face.source, level.source_faces);
        EXPECT_GE(face.source, last_source);
        EXPECT_LT(face.material, level.materials.size());
        EXPECT_LT(face.group, level.groups.size());
        last_source = face.source;
    }
}

TEST(ReadObj, ReadsVerticesAndFaces) {
    const Level level = read(with_triangle("v 1.5 -2.25 1e1\nf 1 2 3\nf 1 3 4\n"));
    EXPECT_EQ(level.name, "t.obj");
    ASSERT_EQ(level.vertices.size(), 4u);
    EXPECT_EQ(level.vertices[3], metres(1.5, -2.25, 10));
    EXPECT_EQ(level.source_faces, 2u);
    ASSERT_EQ(level.faces.size(), 2u);
    EXPECT_EQ(numbers_of(level, 1), (std::vector<std::uint32_t>{0, 2, 3}));
    EXPECT_EQ(level.faces[1].source, 1u);
    EXPECT_EQ(level.materials, std::vector<std::string>{""});
    EXPECT_EQ(level.groups, std::vector<std::string>{""});
    EXPECT_TRUE(level.notes.empty());
    expect_sound(level);
}

TEST(ReadObj, TakesEveryFormOfIndex) {
    const Level level =
        read(with_triangle("f 1/7 2/8 3/9\nf 1//4 2//5 3//6\nf 1/1/1 2/2/2 3/3/3\nf -3 -2 -1\n"
                           "f -3/-1 -2//-1 -1/-1/-1\nf 1 2/3 3//4\nv 5 5 5\nf -4 -3 -1\n"));
    ASSERT_EQ(level.faces.size(), 7u);
    for (std::size_t face = 0; face < 6; ++face)
        EXPECT_EQ(numbers_of(level, face), (std::vector<std::uint32_t>{0, 1, 2}));
    EXPECT_EQ(numbers_of(level, 6), (std::vector<std::uint32_t>{0, 1, 3}));
}

TEST(ReadObj, TakesNumbersAsAnyoneWritesThem) {
    const Level level = read(
        "v +1 -1. .5\nv 1e0 1E+0 1e-0\nv 000001.50 -.5e1 +0\nv 1 2 3 1\nv 1 2 3 0.5 0.5 1\n"
        "v 1e-400 0e999999999999 -0.0\nv 0.1000000000000000000000000000000000001 0 0\nf 1 2 3\n");
    EXPECT_EQ(level.vertices[0], metres(1, -1, 0.5));
    EXPECT_EQ(level.vertices[1], metres(1, 1, 1));
    EXPECT_EQ(level.vertices[2], metres(1.5, -5, 0));
    EXPECT_EQ(level.vertices[3], metres(1, 2, 3));
    EXPECT_EQ(level.vertices[4], metres(1, 2, 3));
    EXPECT_EQ(level.vertices[5], metres(0, 0, 0));
    EXPECT_EQ(level.vertices[6], metres(0.1, 0, 0));
}

TEST(ReadObj, RefusesWhatIsNoNumber) {
    for (const char* word :
         {"x",   "1x",   "1,5",      "0x10", "1_000", "--1", "+-1",      "-+1",       "++1",   "+",    "-",
          ".",   "1e",   "1e+",      "e5",   "1.2.3", "1d5", "1f",       "nan",       "NaN",   "-nan", "nan(1)",
          "inf", "-inf", "infinity", "+inf", "1/2",   "'1'", "\xD9\xA1", "1\xC2\xA0", "1e5.0", "\"",   "1\\2"}) {
        const Error error = refusal(with_triangle("v 1 " + std::string(word) + " 1\nf 1 2 3\n"));
        EXPECT_EQ(error.code, ErrorCode::kMalformed) << word;
        EXPECT_EQ(error.place, "t.obj:4") << word;
        EXPECT_NE(error.reason.find("y of vertex 4"), std::string::npos) << error.reason;
    }
    EXPECT_EQ(refusal("v 0 0 z\n").reason, "'z' as z of vertex 1 is not a number");
    EXPECT_EQ(refusal("v 0 0 0 w\n").code, ErrorCode::kMalformed);
    EXPECT_EQ(refusal("v 0 0 0 1 1 blue\n").code, ErrorCode::kMalformed);
    EXPECT_EQ(refusal("v 1e999 0 0\n").code, ErrorCode::kOutOfRange);
    EXPECT_EQ(refusal("v 0 0 0 -1e999\n").code, ErrorCode::kOutOfRange);
}

TEST(ReadObj, RefusesAWrongCountOfNumbers) {
    for (const char* line : {"v", "v 1", "v 1 2", "v 1 2 3 4 5", "v 1 2 3 4 5 6 7", "v # 1 2 3"}) {
        const Error error = refusal(with_triangle(std::string(line) + "\nf 1 2 3\n"));
        EXPECT_EQ(error.code, ErrorCode::kMalformed) << line;
        EXPECT_EQ(error.place, "t.obj:4") << line;
    }
}

TEST(ReadObj, SaysWhichVertexLiesOutside) {
    const Error error = refusal(with_triangle("# comment\nv 1 2 3\nv 1 -8192.5 3\nf 1 2 3\n"));
    EXPECT_EQ(error.code, ErrorCode::kOutOfRange);
    EXPECT_EQ(error.text(),
              "t.obj:6: vertex 5 lies outside the world: y = -8192.5 m is not within -8192 m <= y < 8192 m");
    EXPECT_EQ(refusal("v 0 0 8192\n").code, ErrorCode::kOutOfRange);
    EXPECT_EQ(
        refusal("v 0 0 8191.9999\n").text(),
        "t.obj:1: vertex 1 lies outside the world: z = 8191.9999 m, rounded to 1/4096 m, is not within -8192 m <= z "
        "< 8192 m");
    EXPECT_EQ(read(with_triangle("v -8192 8191.99975 0\nf 1 2 3\n")).vertices[3].x, -2147483647 - 1);
}

TEST(ReadObj, ScalesBeforeTheSnap) {
    ReadOptions options;
    options.scale = 1.0 / 32;
    const Level level = read("v 32 0 0\nv 0 64 0\nv 0 0 100000\nf 1 2 3\n", options);
    EXPECT_EQ(level.vertices[0], metres(1, 0, 0));
    EXPECT_EQ(level.vertices[2], metres(0, 0, 3125));
    const Error error = refusal("v 0 300000 0\n", options);
    EXPECT_EQ(
        error.text(),
        "t.obj:1: vertex 1 lies outside the world: y = 9375 m ('300000' times 0.03125) is not within -8192 m <= y < "
        "8192 m");
    options.scale = 1e300;
    EXPECT_EQ(refusal("v 1e300 0 0\n", options).code, ErrorCode::kOutOfRange);
    for (const double scale : {-1.0, std::nan(""), HUGE_VAL, -HUGE_VAL}) {
        options.scale = scale;
        EXPECT_EQ(refusal(with_triangle("f 1 2 3\n"), options).code, ErrorCode::kInvalid);
    }
}

TEST(ReadObj, RefusesBadIndices) {
    for (const char* word : {"x", "1.0", "+1", "1e0", "/1", "//1", "1/", "1//", "1/1/", "1/x", "1/x/1", "1/1/1/1",
                             "1/1/1/", "--1", "-", "1/-", "0x1", "1\\1"}) {
        const Error error = refusal(with_triangle("f 1 2 " + std::string(word) + "\n"));
        EXPECT_EQ(error.code, ErrorCode::kMalformed) << word;
        EXPECT_EQ(error.place, "t.obj:4") << word;
    }
    for (const char* word :
         {"0", "-0", "4", "-4", "99999999999999999999", "-99999999999999999999", "4294967297", "0/1", "00"}) {
        const Error error = refusal(with_triangle("f 1 2 " + std::string(word) + "\n"));
        EXPECT_EQ(error.code, ErrorCode::kOutOfRange) << word;
        EXPECT_NE(error.reason.find("'" + std::string(word) + "'"), std::string::npos) << error.reason;
    }
    EXPECT_EQ(refusal("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n").reason, "corner '1' names no vertex; 0 come before it");
    EXPECT_EQ(refusal(with_triangle("f\n")).code, ErrorCode::kMalformed);
    EXPECT_EQ(refusal(with_triangle("f 1 2 # 3\n")).reason, "face of 2 corners; it takes at least 3");
}

TEST(ReadObj, LimitsTheCornersOfAFace) {
    std::string vertices, face = "f";
    for (int k = 0; k < 4097; ++k) vertices += "v " + std::to_string(k) + " " + std::to_string(k % 2) + " 0\n";
    for (int k = 0; k < 4096; k += 2) face += " " + std::to_string(k + 1);
    for (int k = 4095; k > 0; k -= 2) face += " " + std::to_string(k + 1);
    const Level level = read(vertices + face + "\n");
    expect_sound(level);
    EXPECT_EQ(level.faces.size(), 4094u);
    const Error error = refusal(vertices + face + " 4097\n");
    EXPECT_EQ(error.code, ErrorCode::kTooLarge);
    EXPECT_EQ(error.place, "t.obj:4098");
}

TEST(ReadObj, TakesLinesOfEveryKind) {
    const std::string line_feeds = with_triangle("# c\n\n  f\t1 \t2 3 # a face\nusemtl a b\nf 1 2 3\n");
    std::string windows, mac;
    for (const char c : line_feeds) {
        windows += c == '\n' ? "\r\n" : std::string(1, c);
        mac += c == '\n' ? '\r' : c;
    }
    for (const std::string& text :
         {line_feeds, windows, mac, "\xEF\xBB\xBF" + line_feeds, line_feeds.substr(0, line_feeds.size() - 1)}) {
        const Level level = read(text);
        ASSERT_EQ(level.faces.size(), 2u);
        EXPECT_EQ(level.materials, (std::vector<std::string>{"", "a b"}));
        EXPECT_EQ(level.ignored_entries, 0u);
    }
    for (const char* end : {"\n", "\r\n", "\r"}) {
        const Error error = refusal("v 0 0 0" + std::string(end) + end + "#" + end + "v x" + end);
        EXPECT_EQ(error.place, "t.obj:4");
    }
}

TEST(ReadObj, ContinuesLines) {
    EXPECT_EQ(read(with_triangle("f 1 \\\n2 \\\r\n 3\nf 1 2\\\n3\nf \\\n\\\n\\\n1 2 3 \\\n\nf 1 2 3\\")).faces.size(),
              4u);
    EXPECT_EQ(read(with_triangle("# a comment is not continued \\\nf 1 2 3 # nor here \\\nf 1 2 3\n")).faces.size(),
              2u);
    EXPECT_EQ(refusal(with_triangle("f 1 \\\n2 \\\n9\n")).place, "t.obj:6");
    EXPECT_EQ(refusal(with_triangle("f 1 2 3 \\\n\\\n\nf 1 2\n")).place, "t.obj:7");
    const Level level = read(with_triangle("usemtl a \\\n b\nf 1 2 3\n"));
    EXPECT_EQ(level.materials[1], "a   b");
}

TEST(ReadObj, KeepsNames) {
    const Level level =
        read(with_triangle("usemtl  Gr\xC3\xBCner  Stein \nf 1 2 3\ng one two\nf 1 2 3\no thing # not it\nf 1 2 3\n"
                           "usemtl Material #25\nf 1 2 3\nusemtl Gr\xC3\xBCner  Stein\ng\nf 1 2 3\nusemtl\nf 1 2 3\n"
                           "usemtl C:\\a\\b c\nf 1 2 3\nusemtl # nothing\nf 1 2 3\n"));
    EXPECT_EQ(level.materials, (std::vector<std::string>{"", "Gr\xC3\xBCner  Stein", "Material #25", "C:\\a\\b c"}));
    EXPECT_EQ(level.groups, (std::vector<std::string>{"", "one two", "thing"}));
    std::vector<std::uint32_t> materials, groups;
    for (const LevelFace& face : level.faces) {
        materials.push_back(face.material);
        groups.push_back(face.group);
    }
    EXPECT_EQ(materials, (std::vector<std::uint32_t>{1, 1, 1, 2, 1, 0, 3, 0}));
    EXPECT_EQ(groups, (std::vector<std::uint32_t>{0, 1, 2, 2, 0, 0, 0, 0}));
}

TEST(ReadObj, CountsWhatItIgnores) {
    const Level level = read(
        with_triangle("vt 0 0\nvn x y z\nvp 1\nmtllib a.mtl\ns off\nl 1 2\np 1\ncurv 1 2\n\n# no\nf 1 2 3\nV 1\n"));
    EXPECT_EQ(level.ignored_entries, 9u);
}

TEST(ReadObj, NotesWhatItDropsAndDivides) {
    const Level level = read(
        "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 0.00001 0 0\nv 4 4 1\nv 1 1 0\n"
        "f 1 2 5\nf 1 2 3 4\nf 1 1 2\nf 1 2 6 4\n\nf 1 3 2 4\nf 1 2 7 4\n");
    EXPECT_EQ(level.source_faces, 6u);
    expect_sound(level);
    ASSERT_EQ(level.notes.size(), 5u);
    const std::vector<LevelNote> expected{{FaceNote::kNoArea, 0, 8},
                                          {FaceNote::kNoArea, 2, 10},
                                          {FaceNote::kSplit, 3, 11},
                                          {FaceNote::kCrossing, 4, 13},
                                          {FaceNote::kSplit, 5, 14}};
    ASSERT_EQ(level.omissions.size(), 1u);
    EXPECT_EQ(level.omissions[0].what, "faces without area");
    EXPECT_EQ(level.omissions[0].count, 2u);
    EXPECT_TRUE(level.omissions[0].first.ends_with(":8"));
    for (std::size_t k = 0; k < 5; ++k) {
        EXPECT_EQ(level.notes[k].what, expected[k].what) << k;
        EXPECT_EQ(level.notes[k].source, expected[k].source) << k;
        EXPECT_EQ(level.notes[k].line, expected[k].line) << k;
    }
    EXPECT_EQ(level.faces.front().source, 1u);
    EXPECT_TRUE(read(with_triangle("f 1 1 1\n")).faces.empty());
}

TEST(ReadObj, RefusesWhatIsNoObj) {
    for (const std::string& text : {std::string(), std::string("\n\n"), std::string(kTriangle),
                                    std::string("{\"json\": [1, 2]}"), std::string("# f 1 2 3")}) {
        const Error error = refusal(text);
        EXPECT_EQ(error.code, ErrorCode::kMalformed);
        EXPECT_EQ(error.text(), "t.obj: no face (f) in the file");
    }
    EXPECT_EQ(refusal(with_triangle(std::string("f 1 2 3\n\0\n", 10))).text(),
              "t.obj:5: byte '\\x00': this is not a text file");
    EXPECT_EQ(refusal("\xFF\xFEv\n").code, ErrorCode::kMalformed);
    EXPECT_EQ(refusal("v 0 0 0\n\x89PNG 1\n").place, "t.obj:2");
    EXPECT_EQ(refusal(std::string("v\0 \0"
                                  "1\0",
                                  6))
                  .place,
              "t.obj:1");
    EXPECT_EQ(refusal("\x7F"
                      "ELF")
                  .code,
              ErrorCode::kMalformed);
}

TEST(ReadObj, QuotesLittle) {
    const Error error = refusal("v " + std::string(1'000'000, '7') + "x 0 0\n");
    EXPECT_LT(error.reason.size(), 120u);
    EXPECT_NE(error.reason.find(std::string(40, '7') + "...'"), std::string::npos);
    EXPECT_NE(refusal("v \xC3\xA4\"'\\ 0 0\n").reason.find("'\\xc3\\xa4\"'\\'"), std::string::npos);
}

TEST(ReadObj, DoesNotFollowTheLocale) {
    const std::string before = std::setlocale(LC_ALL, nullptr);
    for (const char* locale : {"de_DE.UTF-8", "fr_FR.UTF-8", "C"}) std::setlocale(LC_ALL, locale);
    EXPECT_EQ(read("v 1.5 0 0\nv 0 1.25 0\nv 0 0 1\nf 1 2 3\n").vertices[0], metres(1.5, 0, 0));
    std::setlocale(LC_ALL, before.c_str());
}

/// Bits of a sound file changed, lines cut and doubled: an error or a sound level, never anything else.
TEST(ReadObj, SurvivesDamage) {
    scenes::Rng rng(3);
    const std::string sound =
        with_triangle("v 1 1 0.5\nusemtl a\ng b\nf 1 2 3\nf 1/1 2/2 4/4 3/3\nf -1//1 -2//2 \\\n-3//3\n# end\n");
    int read_well = 0;
    for (int round = 0; round < 20'000; ++round) {
        std::string text = sound;
        for (std::uint32_t k = 0; k <= rng.below(3); ++k) {
            const std::size_t at = rng.below(std::uint32_t(text.size()));
            const auto kind = rng.below(4);
            if (kind == 0) text[at] = char(rng.below(256));
            if (kind == 1) text.erase(at, 1 + rng.below(8));
            if (kind == 2) text.insert(at, text.substr(rng.below(std::uint32_t(text.size())), 1 + rng.below(8)));
            if (kind == 3) text[at] = "0123456789-/. \\#\n\r"[rng.below(18)];
            if (text.empty()) break;
        }
        const Result<Level> level = read_obj(text, "t.obj");
        if (!level) continue;
        expect_sound(level.value());
        ++read_well;
    }
    EXPECT_GT(read_well, 1000);
}

TEST(ReadLevel, ReadsByEnding) {
    const auto folder = std::filesystem::temp_directory_path() / "firma_test_read_level";
    std::filesystem::create_directories(folder / "folder.obj");
    const auto write = [&](const char* name) {
        std::ofstream(folder / name, std::ios::binary) << with_triangle("f 1 2 3\n");
        return (folder / name).string();
    };
    for (const char* name : {"a.obj", "b.OBJ", "c.d.Obj", "with blank.obj"}) {
        const Result<Level> level = read_level(write(name));
        ASSERT_TRUE(level.ok()) << level.error().text();
        EXPECT_EQ(level.value().faces.size(), 1u);
    }
    for (const char* name : {"a.txt", "obj", "a.obj.gz", "a.obj~"})
        EXPECT_EQ(read_level(write(name)).error().code, ErrorCode::kUnsupported) << name;
    EXPECT_EQ(read_level("a.stl").error().text(), "a.stl: the name ends in none of " + level_endings());
    std::istringstream endings(level_endings());
    int count = 0;
    for (std::string ending; std::getline(endings >> std::ws, ending, ','); ++count)
        EXPECT_TRUE(level_format("a" + ending)) << ending;
    EXPECT_GE(count, 2);
    for (const char* name : {"missing.obj", "folder.obj", "no/such/folder/a.obj"}) {
        const Result<Level> level = read_level((folder / name).string());
        ASSERT_FALSE(level.ok());
        EXPECT_EQ(level.error().code, ErrorCode::kCannotRead);
        EXPECT_EQ(level.error().place, (folder / name).string());
    }
    std::filesystem::remove_all(folder);
}

std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> files;
    std::error_code missing;
    for (const auto& entry : std::filesystem::directory_iterator(folder, missing))
        if (entry.path().extension() == ".obj") files.push_back(entry.path());
    return files;
}

TEST(ReadLevel, ReadsOurOwnLevels) {
    const auto files = files_in(std::filesystem::path(FIRMA_ROOT) / "levels");
    EXPECT_FALSE(files.empty());
    for (const auto& file : files) {
        const Result<Level> level = read_level(file.string());
        ASSERT_TRUE(level.ok()) << level.error().text();
        expect_sound(level.value());
        EXPECT_TRUE(level.value().notes.empty()) << file;
    }
}

TEST(ReadLevel, ReadsTheSharedCases) {
    const auto files = files_in(std::filesystem::path(FIRMA_ROOT) / "../shared/casts/cases");
    if (files.empty()) GTEST_SKIP() << "../shared/casts/cases is not here";
    for (const auto& file : files) {
        const Result<Level> level = read_level(file.string());
        ASSERT_TRUE(level.ok()) << level.error().text();
        expect_sound(level.value());
        EXPECT_TRUE(level.value().notes.empty()) << file;
        EXPECT_EQ(level.value().faces.size(), level.value().source_faces) << file;
    }
}

}  // namespace
}  // namespace firma
