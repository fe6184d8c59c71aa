// SPDX-License-Identifier: MIT
// Any bytes as edit logs and commands: as they are; with the head and the checksum put right; or a sound log with some
// of its bytes changed. An error with its byte, or a log that packs to what reads as the same, and whose replay leaves
// a sound world.
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "base/assert.h"
#include "firma/edit_log.h"
#include "log/log_records.h"
#include "tests/fuzz/bytes.h"
#include "tests/save/saved_worlds.h"

namespace {

using namespace firma;
using fuzz::Bytes;
using File = std::vector<std::byte>;

void expect(bool holds, const char* what) {
    if (holds) return;
    std::fprintf(stderr, "broken: %s\n", what);
    std::abort();
}

/// A mesh that crosses itself is judged where it is placed; what is left of it may contradict itself, and is refused.
void on_assertion(const char* condition, const char* advice, const char* file, int line) {
    if (std::strstr(advice, "contradict")) return;
    std::fprintf(stderr, "%s:%d: %s: %s\n", file, line, condition, advice);
    std::abort();
}

/// Two rooms of 4 m, with a door, under rules that keep each edit short.
const World& level() {
    static const World world = [] {
        CarveRules rules;
        rules.max_pairs = 20'000;
        rules.max_cutter_triangles = 2'000;
        return with_rules(two_rooms(), rules).value();
    }();
    return world;
}

const File& sound_log() {
    static const File file = [] {
        EditLog log(level());
        World world = level();
        const auto add = [&](const EditCommand& command) {
            expect(!log.append(command), "a sound command was refused");
            world = apply(world, command).world;
            log.add_checkpoint(world);
        };
        add(crater_command(1, {CutterShape::kRocky, 7}, {2, 0, 2}, 0.5, {"crater"}));
        EditCommand mesh;
        mesh.number = 3;
        const Cutter box = make_crater(CutterShape::kBox, 0);
        mesh.cutter = make_cutter(box.vertices(), box.triangles(), "box").value();
        mesh.pose.position = {5.03, 0.01, 2};
        mesh.pose.scale = 0.7;
        add(mesh);
        EditCommand door;
        door.number = 4;
        door.kind = EditKind::kDoor;
        door.portal = {0};
        add(door);
        EditCommand group;
        group.kind = EditKind::kGroup;
        group.parts = {crater_command(5, {CutterShape::kWedge, 9}, {6, 4, 1}, 0.6), door};
        group.parts[1].number = 8;
        group.parts[1].open = false;
        add(group);
        return pack_log(log);
    }();
    return file;
}

/// Magic, version, the level's hashes and the checksum put right.
void mend(File& file) {
    const File& sound = sound_log();
    if (file.size() < kLogHeadBytes + 5) file.resize(kLogHeadBytes + 5);
    std::copy_n(sound.begin(), kLogHeadBytes, file.begin());
    put_u32(file, file.size() - 4, crc32c(std::span<const std::byte>(file).first(file.size() - 4)));
}

/// A few bytes of a sound log replaced, put in or taken out.
File changed_log(Bytes& bytes) {
    File file = sound_log();
    for (int k = bytes.next() % 8; k >= 0; --k) {
        const std::size_t place = std::size_t(bytes.next() << 8 | bytes.next()) % (file.size() - 4);
        const int how = bytes.next();
        const auto value = std::byte(bytes.next());
        if (how % 4 == 0) file.insert(file.begin() + std::ptrdiff_t(place), value);
        if (how % 4 == 1 && file.size() > 5) file.erase(file.begin() + std::ptrdiff_t(place));
        if (how % 4 >= 2) file[place] = value;
    }
    mend(file);
    return file;
}

void use(const EditLog& log) {
    const File packed = pack_log(log);
    const Result<EditLog> again = unpack_log(packed, "again");
    expect(again.ok(), "a log that was packed is not read");
    expect(pack_log(again.value()) == packed, "a log that was packed is read as another");
    if (log.commands().size() > 50) return;
    const ReplayResult made = replay(level(), log);
    expect(!check_world(made.world), "a replay left a world that is not sound");
    expect(!check_solid(made.world), "a replay left a solid that is not sound");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    set_assert_handler(on_assertion);
    Bytes bytes(data, size);
    const int mode = bytes.next();
    File file;
    if (mode % 4 == 2) {
        file = changed_log(bytes);
    } else {
        for (std::size_t k = 1; k < size; ++k) file.push_back(std::byte(data[k]));
    }
    if (mode % 4 == 3) {
        const Result<EditCommand> command = unpack_command(file, "fuzz");
        if (!command) return 0;
        const Result<File> packed = pack_command(command.value());
        expect(packed.ok(), "a command that was read cannot be packed");
        const World made = apply(level(), command.value()).world;
        expect(!check_world(made), "a command left a world that is not sound");
        expect(!check_solid(made), "a command left a solid that is not sound");
        return 0;
    }
    if (mode % 4 == 1) mend(file);
    const Result<EditLog> log = unpack_log(file, "fuzz");
    if (log)
        use(log.value());
    else
        expect(log.error().place.rfind("fuzz: byte ", 0) == 0, "an error names no byte");
    return 0;
}
