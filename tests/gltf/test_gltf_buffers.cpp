// SPDX-License-Identifier: MIT
// Where buffers come from: data URIs, files beside, and from nowhere else.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "gltf/buffer_bytes.h"
#include "tests/gltf/read_text.h"
#include "tests/gltf/small_gltf.h"

namespace firma::gltf {
namespace {

TEST(GltfBuffers, Base64) {
    for (const std::string bytes : {"", "a", "ab", "abc", "abcd", "\xff\xfe\xfd\xfc\xfb"})
        EXPECT_EQ(decode_base64(base64(bytes)), bytes);
    EXPECT_EQ(decode_base64("YQ"), "a");
    EXPECT_EQ(decode_base64("+/+/"), "\xfb\xff\xbf");
    for (const char* bad : {"Y", "YQ=Q", "Y Q=", "YQ\n", "====", "Y===", "YWJj*"})
        EXPECT_FALSE(decode_base64(bad)) << bad;
}

TEST(GltfBuffers, PathsStayBelow) {
    EXPECT_EQ(path_below("a.bin"), "a.bin");
    EXPECT_EQ(path_below("parts/a%20b.bin"), "parts/a b.bin");
    EXPECT_EQ(path_below("./a..b"), "./a..b");
    for (const char* bad : {"", "/etc/passwd", "../a", "a/../../b", "a/..", "%2e%2e/a", "%2Fetc", "a%00b", "a%", "a%zz",
                            "file:a", "http://x/a", "C:a", "a\\b", "a//b", "a\nb"})
        EXPECT_FALSE(path_below(bad)) << bad;
}

class Folder {
public:
    Folder() {
        path = std::filesystem::temp_directory_path() / ("firma_gltf_" + std::to_string(getpid()));
        std::filesystem::create_directories(path / "parts");
    }
    ~Folder() { std::filesystem::remove_all(path); }
    void write(const std::string& name, const std::string& bytes) const {
        std::ofstream(path / name, std::ios::binary) << bytes;
    }

    std::filesystem::path path;
};

TEST(GltfBuffers, FilesBeside) {
    const Folder folder;
    const SmallGltf file = box_file();
    folder.write("a b.bin", file.buffer());
    folder.write("parts/long.bin", file.buffer() + "more");
    folder.write("short.bin", file.buffer().substr(1));
    const auto error = [&](const std::string& uri) {
        folder.write("box.gltf", file.json(R"(,"uri":")" + uri + '"'));
        const Result<GltfLevel> level = read_gltf((folder.path / "box.gltf").string());
        EXPECT_EQ(level ? volume_of(level.value()) : 6, 6);
        return level ? "none" : level.error().text().substr(folder.path.string().size());
    };
    EXPECT_EQ(error("a%20b.bin"), "none");
    EXPECT_EQ(error("a b.bin"), "none");
    EXPECT_EQ(error("parts/long.bin"), "none");
    EXPECT_EQ(error("short.bin"), "/box.gltf: buffer 0: has 167 of its 168 bytes");
    EXPECT_EQ(error("none.bin"), "/box.gltf: buffer 0: 'none.bin' cannot be read: No such file or directory");
    EXPECT_EQ(error("parts"), "/box.gltf: buffer 0: 'parts' cannot be read: Is a directory");
    EXPECT_EQ(error("../a.bin"), "/box.gltf: buffer 0: names '../a.bin', which is no file beside this one");
    EXPECT_EQ(error("data:text/plain,abc"), "/box.gltf: buffer 0: its data: URI is not base64");
    EXPECT_EQ(error("data:;base64,!"), "/box.gltf: buffer 0: its data: URI is not base64");
    EXPECT_EQ(error("data:;base64"), "/box.gltf: buffer 0: its data: URI is not base64");
    const std::string named = file.json(R"(,"uri":"a b.bin")");
    EXPECT_EQ(error_of(named), "a.glb: buffer 0: lies in another file, 'a b.bin'");
    EXPECT_TRUE(read_gltf(std::as_bytes(std::span(named)), "a.gltf", {}, folder.path.string()));

    namespace fs = std::filesystem;
    folder.write("parts/box.bin", file.buffer());
    // Finding 12 (F12).
    fs::create_symlink("parts/box.bin", folder.path / "inside.bin");
    fs::create_symlink("box.bin", folder.path / "parts/near.bin");
    EXPECT_EQ(error("inside.bin"), "none");
    EXPECT_EQ(error("parts/near.bin"), "none");
    const fs::path outside = folder.path.string() + "_outside";
    fs::create_directories(outside);
    fs::rename(folder.path / "parts/box.bin", outside / "box.bin");
    fs::create_symlink(outside / "box.bin", folder.path / "outside.bin");
    fs::create_symlink("../" + outside.filename().string(), folder.path / "folder");
    for (const std::string uri : {"outside.bin", "folder/box.bin"})
        EXPECT_EQ(error(uri), "/box.gltf: buffer 0: names '" + uri + "', a link that leads out of the file's folder");
    const fs::path linked = folder.path.string() + "_linked";
    fs::create_directory_symlink(folder.path, linked);  // the folder itself may be one
    folder.write("box.gltf", file.json(R"(,"uri":"a b.bin")"));
    EXPECT_TRUE(read_gltf((linked / "box.gltf").string()));
    fs::remove(linked);
    fs::remove_all(outside);
    const Result<GltfLevel> missing = read_gltf("/nowhere/at/all.glb");
    ASSERT_FALSE(missing);
    EXPECT_EQ(missing.error().code, ErrorCode::kCannotRead);
}

TEST(GltfBuffers, OnlyTheFirstIsTheChunk) {
    const SmallGltf file = box_file();
    std::string json = replaced(file.json(""), R"(}],"bufferViews")", R"(},{"byteLength":4}],"bufferViews")");
    json.resize((json.size() + 3) / 4 * 4, ' ');
    const std::string chunks = u32_bytes(std::uint32_t(json.size())) + "JSON" + json +
                               u32_bytes(std::uint32_t(file.buffer().size())) + std::string("BIN\0", 4) + file.buffer();
    EXPECT_EQ(error_of("glTF" + u32_bytes(2) + u32_bytes(std::uint32_t(chunks.size()) + 12) + chunks),
              "a.glb: buffer 1: says nowhere where its bytes are");
    EXPECT_EQ(error_of(file.json("")), "a.glb: buffer 0: says nowhere where its bytes are");
}

}  // namespace
}  // namespace firma::gltf
