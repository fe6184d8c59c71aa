// SPDX-License-Identifier: MIT
// Worlds in files on Windows: whole or not at all, under names in UTF-8, and what cannot be says why.
#define WIN32_LEAN_AND_MEAN
#include <windows.h>

#include <gtest/gtest.h>
#include <process.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include "tests/save/saved_worlds.h"

namespace firma {
namespace {

namespace fs = std::filesystem;

/// A folder of its own; gone afterwards.
class SaveWorldWindows : public testing::Test {
protected:
    SaveWorldWindows() {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    ~SaveWorldWindows() override { fs::remove_all(folder_); }

    std::string path(const char* name) const { return folder_.string() + "\\" + name; }
    std::size_t files() const {
        return std::size_t(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
    }

    const fs::path folder_ = fs::temp_directory_path() / ("firma_test_save_" + std::to_string(_getpid()));
};

std::string text_of(const Result<FirmaWritten>& saved) {
    return saved ? "" : saved.error().text();
}

TEST_F(SaveWorldWindows, ThereAndBackOverWhatWasThere) {
    const World world = cut_room(10, 1), other = room_world();
    EXPECT_EQ(text_of(save_world(other, path("a.firma"))), "");
    EXPECT_EQ(text_of(save_world(world, path("a.firma"))), "");
    EXPECT_EQ(files(), 1u);
    const Result<World> read = load_world(path("a.firma"));
    ASSERT_TRUE(read.ok()) << read.error().text();
    EXPECT_EQ(hash_world(read.value()), hash_world(world));
}

TEST_F(SaveWorldWindows, NamesAreUtf8) {
    const World world = cut_room(2, 1);
    const std::string name = path("gr\xc3\xbc\xc3\x9f \xe2\x82\xac.firma");
    EXPECT_EQ(text_of(save_world(world, name)), "");
    EXPECT_TRUE(fs::exists(folder_ / L"gr\u00fc\u00df \u20ac.firma"));
    const Result<World> read = load_world(name);
    ASSERT_TRUE(read.ok()) << read.error().text();
    EXPECT_EQ(hash_world(read.value()), hash_world(world));
}

TEST_F(SaveWorldWindows, WhatCannotBeSays) {
    const World world = room_world();
    EXPECT_EQ(load_world(path("none.firma")).error().text(),
              path("none.firma") + ": cannot be read: No such file or directory");
    EXPECT_EQ(text_of(save_world(world, path("no\\a.firma"))),
              path("no\\a.firma") + ": cannot be written: No such file or directory");
    EXPECT_EQ(text_of(save_world(world, folder_.string())), folder_.string() + ": cannot be written: Is a directory");
    EXPECT_EQ(text_of(save_world(world, "")), "a file needs a name");
    std::ofstream(path("empty.firma"));
    EXPECT_EQ(load_world(path("empty.firma")).error().text(),
              path("empty.firma") + ": it does not begin as a .firma file does");
    EXPECT_EQ(files(), 1u);
}

/// A file that nobody else may open or take the name of.
class OpenAlone {
public:
    explicit OpenAlone(const std::string& path)
        : handle_(CreateFileA(path.c_str(), GENERIC_READ, 0, nullptr, OPEN_EXISTING, FILE_ATTRIBUTE_NORMAL, nullptr)) {
        EXPECT_NE(handle_, INVALID_HANDLE_VALUE);
    }
    ~OpenAlone() { CloseHandle(handle_); }
    OpenAlone(const OpenAlone&) = delete;
    OpenAlone& operator=(const OpenAlone&) = delete;

private:
    const HANDLE handle_;
};

TEST_F(SaveWorldWindows, WaitsForWhoHasTheFileOpen) {
    const World before = room_world(), after = cut_room(2, 1);
    ASSERT_EQ(text_of(save_world(before, path("a.firma"))), "");
    std::thread saves;
    {
        const OpenAlone reader(path("a.firma"));
        saves = std::thread([&] { EXPECT_EQ(text_of(save_world(after, path("a.firma"))), ""); });
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
    }
    saves.join();
    EXPECT_EQ(hash_world(load_world(path("a.firma")).value()), hash_world(after));
    EXPECT_EQ(files(), 1u);
}

TEST_F(SaveWorldWindows, SaysSoWhenTheFileStaysOpen) {
    const World before = room_world(), after = cut_room(2, 1);
    ASSERT_EQ(text_of(save_world(before, path("a.firma"))), "");
    {
        const OpenAlone reader(path("a.firma"));
        EXPECT_EQ(text_of(save_world(after, path("a.firma"))),
                  path("a.firma") + ": cannot be written: Permission denied");
    }
    EXPECT_EQ(hash_world(load_world(path("a.firma")).value()), hash_world(before));
    EXPECT_EQ(files(), 1u);
}

TEST_F(SaveWorldWindows, SeveralAtOnceWaitForEachOther) {
    const World worlds[] = {room_world(), cut_room(4, 3)};
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t)
        threads.emplace_back([&, t] {
            for (int k = 0; k < 10; ++k) EXPECT_EQ(text_of(save_world(worlds[t % 2], path("a.firma"))), "");
        });
    for (std::thread& thread : threads) thread.join();
    const std::uint64_t hash = hash_world(load_world(path("a.firma")).value());
    EXPECT_TRUE(hash == hash_world(worlds[0]) || hash == hash_world(worlds[1]));
    EXPECT_EQ(files(), 1u);
}

}  // namespace
}  // namespace firma
