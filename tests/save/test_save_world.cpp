// SPDX-License-Identifier: MIT
// Worlds in files: whole or not at all, whatever happens meanwhile.
#include <gtest/gtest.h>

#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include "tests/save/saved_worlds.h"

namespace firma {
namespace {

namespace fs = std::filesystem;

/// A folder of its own; gone afterwards.
class SaveWorld : public testing::Test {
protected:
    SaveWorld() {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
    }
    ~SaveWorld() override { fs::remove_all(folder_); }

    std::string path(const char* name) const { return (folder_ / name).string(); }
    std::size_t files() const {
        return std::size_t(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
    }

    const fs::path folder_ = fs::temp_directory_path() / ("firma_test_save_" + std::to_string(getpid()));
};

std::string text_of(const Result<FirmaWritten>& saved) {
    return saved ? "" : saved.error().text();
}

TEST_F(SaveWorld, ThereAndBack) {
    const World world = cut_room(10, 1), other = room_world();
    EXPECT_EQ(text_of(save_world(other, path("a.firma"))), "");
    EXPECT_EQ(text_of(save_world(world, path("a.firma"))), "");
    EXPECT_EQ(files(), 1u);
    const Result<World> read = load_world(path("a.firma"));
    ASSERT_TRUE(read.ok()) << read.error().text();
    EXPECT_EQ(hash_world(read.value()), hash_world(world));
    const Result<FirmaWritten> facets = save_world(world, path("b.firma"), {.exact = false});
    ASSERT_TRUE(facets.ok());
    EXPECT_EQ(facets.value().bytes, fs::file_size(path("b.firma")));
    EXPECT_LT(fs::file_size(path("b.firma")), fs::file_size(path("a.firma")));
}

TEST_F(SaveWorld, LinksAreFollowedAndModesKept) {
    const World world = room_world();
    EXPECT_TRUE(save_world(room_world(), path("a.firma")));
    fs::permissions(path("a.firma"), fs::perms::owner_read | fs::perms::owner_write);
    fs::create_symlink(path("a.firma"), path("link.firma"));
    EXPECT_TRUE(save_world(cut_room(2, 1), path("link.firma")));
    EXPECT_TRUE(fs::is_symlink(path("link.firma")));
    EXPECT_EQ(fs::status(path("a.firma")).permissions(), fs::perms::owner_read | fs::perms::owner_write);
    EXPECT_EQ(hash_world(load_world(path("a.firma")).value()), hash_world(cut_room(2, 1)));
    EXPECT_EQ(files(), 2u);
}

TEST_F(SaveWorld, WhatCannotBeSays) {
    const World world = room_world();
    EXPECT_EQ(load_world(path("none.firma")).error().text(),
              path("none.firma") + ": cannot be read: No such file or directory");
    EXPECT_EQ(load_world(folder_.string()).error().text(), folder_.string() + ": cannot be read: Is a directory");
    EXPECT_EQ(text_of(save_world(world, path("no/a.firma"))),
              path("no/a.firma") + ": cannot be written: No such file or directory");
    EXPECT_EQ(text_of(save_world(world, folder_.string())), folder_.string() + ": cannot be written: Is a directory");
    EXPECT_EQ(text_of(save_world(world, "")), "a file needs a name");
    std::ofstream(path("empty.firma"));
    EXPECT_EQ(load_world(path("empty.firma")).error().text(),
              path("empty.firma") + ": it does not begin as a .firma file does");
    EXPECT_EQ(text_of(save_world(world, "/dev/full")), "/dev/full: cannot be written: Invalid argument");
    EXPECT_EQ(files(), 1u);
}

TEST_F(SaveWorld, NothingIsPutInPlaceOfALinkOrWaitsForAPipe) {
    const World world = room_world();
    fs::create_symlink("not_yet.firma", path("link.firma"));
    EXPECT_EQ(text_of(save_world(world, path("link.firma"))),
              path("link.firma") + ": cannot be written: No such file or directory");
    EXPECT_TRUE(fs::is_symlink(path("link.firma")));
    fs::create_symlink("round.firma", path("round.firma"));
    EXPECT_EQ(text_of(save_world(world, path("round.firma"))),
              path("round.firma") + ": cannot be written: Too many levels of symbolic links");
    ASSERT_EQ(mkfifo(path("a.firma.part").c_str(), 0600), 0);
    EXPECT_EQ(text_of(save_world(world, path("a.firma"))),
              path("a.firma") + ": cannot be written: No such device or address");
    EXPECT_EQ(files(), 3u);
}

TEST_F(SaveWorld, PipesAreRead) {
    const World world = cut_room(5, 2);
    EXPECT_TRUE(save_world(world, path("a.firma")));
    ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
    std::thread writer([&] {
        std::ofstream pipe(path("pipe"), std::ios::binary);
        pipe << std::ifstream(path("a.firma"), std::ios::binary).rdbuf();
    });
    const Result<World> read = load_world(path("pipe"));
    writer.join();
    ASSERT_TRUE(read.ok()) << read.error().text();
    EXPECT_EQ(hash_world(read.value()), hash_world(world));
}

// Finding 10 (F10): files were mapped.
TEST_F(SaveWorld, AFileCutShortMeanwhileIsAnErrorAtMost) {
    const World world = cut_room(150, 3);
    ASSERT_TRUE(save_world(world, path("a.firma")));
    const std::vector<std::byte> bytes = pack_world(world);
    const pid_t reader = fork();  // a process of its own, as a fault in its memory would be a signal
    ASSERT_GE(reader, 0);
    if (reader == 0) {
        for (;;) {
            const Result<World> read = load_world(path("a.firma"));
            if (read ? hash_world(read.value()) != hash_world(world) : read.error().text().empty()) _exit(1);
        }
    }
    for (int k = 0; k < 500; ++k) {
        fs::resize_file(path("a.firma"), bytes.size() / 2);
        std::this_thread::sleep_for(std::chrono::microseconds(100));
        std::fstream(path("a.firma"), std::ios::binary | std::ios::in | std::ios::out)
            .seekp(std::streamoff(bytes.size() / 2))
            .write(reinterpret_cast<const char*>(bytes.data()) + bytes.size() / 2,
                   std::streamsize(bytes.size() - bytes.size() / 2));
        std::this_thread::sleep_for(std::chrono::milliseconds(k % 7));
    }
    int status = 0;
    EXPECT_EQ(waitpid(reader, &status, WNOHANG), 0) << "ended by itself with status " << status;
    kill(reader, SIGKILL);
    waitpid(reader, &status, 0);
}

TEST_F(SaveWorld, LongFilesAreReadWholeOrNotAtAll) {
    const World world = cut_room(250, 3);
    std::vector<std::byte> bytes = pack_world(world);
    const std::size_t whole = bytes.size();
    ASSERT_GT(whole, std::size_t(1) << 20) << "more than one piece";
    const auto write = [&](const char* name) {
        std::ofstream(path(name), std::ios::binary)
            .write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
        return load_world(path(name));
    };
    EXPECT_EQ(hash_world(write("a.firma").value()), hash_world(world));
    bytes.pop_back();
    const std::string length = ": it is not as long as its head says: cut short, or something was added";
    EXPECT_EQ(write("short.firma").error().text(), path("short.firma") + length);
    bytes.resize(whole + 8);
    EXPECT_EQ(write("long.firma").error().text(), path("long.firma") + length);
    fs::resize_file(path("long.firma"), std::uintmax_t(1) << 42);  // without blocks on the disk
    EXPECT_EQ(load_world(path("long.firma")).error().text(), path("long.firma") + length) << "at once";
}

TEST_F(SaveWorld, SeveralAtOnceWaitForEachOther) {
    const World worlds[] = {room_world(), cut_room(4, 3)};
    std::vector<std::thread> threads;
    for (int t = 0; t < 4; ++t)
        threads.emplace_back([&, t] {
            for (int k = 0; k < 10; ++k) EXPECT_TRUE(save_world(worlds[t % 2], path("a.firma")));
        });
    for (int k = 0; k < 20; ++k) {
        const Result<World> read = load_world(path("a.firma"));
        EXPECT_TRUE(read.ok() || read.error().code == ErrorCode::kCannotRead);
    }
    for (std::thread& thread : threads) thread.join();
    const std::uint64_t hash = hash_world(load_world(path("a.firma")).value());
    EXPECT_TRUE(hash == hash_world(worlds[0]) || hash == hash_world(worlds[1]));
    EXPECT_EQ(files(), 1u);
}

/// A process that saves two worlds by turns, killed at a random moment.
TEST_F(SaveWorld, AKillAtAHundredMomentsLosesNothing) {
    const World worlds[] = {cut_room(3, 4), cut_room(4, 4)};
    const std::uint64_t hashes[] = {hash_world(worlds[0]), hash_world(worlds[1])};
    ASSERT_NE(hashes[0], hashes[1]);
    const auto start = std::chrono::steady_clock::now();
    const pid_t timed = fork();  // starting a process takes long too where this one is large
    ASSERT_GE(timed, 0);
    if (timed == 0) {
        for (int k = 0; k < 3; ++k)
            if (!save_world(worlds[0], path("a.firma"))) _exit(1);
        _exit(0);
    }
    int ended = 0;
    ASSERT_EQ(waitpid(timed, &ended, 0), timed);
    ASSERT_EQ(ended, 0);
    const std::chrono::duration<double, std::micro> three = std::chrono::steady_clock::now() - start;
    scenes::Rng rng(5);
    int first = 0, second = 0, asides = 0;
    for (int kill_number = 0; kill_number < 100; ++kill_number) {
        const double microseconds = rng.uniform(0, 2 * three.count());
        const pid_t child = fork();
        ASSERT_GE(child, 0);
        if (child == 0) {
            for (int k = 1;; ++k)
                if (!save_world(worlds[k % 2], path("a.firma"))) _exit(1);
        }
        std::this_thread::sleep_for(std::chrono::duration<double, std::micro>(microseconds));
        kill(child, SIGKILL);
        int status = 0;
        ASSERT_EQ(waitpid(child, &status, 0), child);
        ASSERT_TRUE(WIFSIGNALED(status)) << "a save failed";
        const Result<World> read = load_world(path("a.firma"));
        ASSERT_TRUE(read.ok()) << read.error().text();
        const std::uint64_t hash = hash_world(read.value());
        ASSERT_TRUE(hash == hashes[0] || hash == hashes[1]);
        hash == hashes[0] ? ++first : ++second;
        ASSERT_LE(files(), 2u) << "more than the file and one aside";
        asides += files() == 2;
    }
    EXPECT_GT(first, 0);
    EXPECT_GT(second, 0);
    EXPECT_GT(asides, 0) << "kills came between saves, not within: nothing was tried";
    EXPECT_TRUE(save_world(worlds[1], path("a.firma")));  // takes over what is left
    EXPECT_EQ(files(), 1u);
    EXPECT_EQ(hash_world(load_world(path("a.firma")).value()), hashes[1]);
}

}  // namespace
}  // namespace firma
