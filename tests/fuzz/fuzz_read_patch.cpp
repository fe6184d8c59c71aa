// SPDX-License-Identifier: MIT
// Any bytes as patches and lists of faces: with checksums put right, or sound ones with some of their bytes changed. An
// error, or a world that bears checks and edits, and is the one that the patch says.
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "base/assert.h"
#include "firma/edit_log.h"
#include "firma/world_patch.h"
#include "save/patch_sections.h"
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

/// A patch may hold a solid that crosses itself: no check looks for that, and cuts of it may contradict each other.
void on_assertion(const char* condition, const char* advice, const char* file, int line) {
    if (std::strstr(advice, "contradict")) return;
    std::fprintf(stderr, "%s:%d: %s: %s\n", file, line, condition, advice);
    std::abort();
}

EditCommand crater(std::uint32_t number, CutterShape shape, double x, double z) {
    return crater_command(number, {shape, number}, {x, 0.05, z}, 0.6, {"crater"});
}

/// A world that lacks an edit, and one that does not.
struct Peers {
    World broken = two_rooms(), sound = broken;
    File patch, list;
    Peers() {
        for (std::uint32_t k = 1; k <= 3; ++k) {
            const EditCommand command = crater(k, k == 2 ? CutterShape::kWedge : CutterShape::kBox, 1.7 + 0.5 * k, 2);
            sound = apply(sound, command).world;
            if (k != 2) broken = apply(broken, command).world;
        }
        list = list_faces(broken, differing_regions(hash_regions(broken), hash_regions(sound)));
        patch = make_patch(sound, list, "list").value();
    }
};

const Peers& peers() {
    static const Peers both;
    return both;
}

/// Bytes within sections replaced; checksums put right. Now and then the hashes of the worlds too.
File changed(File file, Bytes& bytes) {
    const std::vector<SectionPlace> places = section_places(file);
    for (int k = bytes.next() % 8; k >= 0; --k) {
        const SectionPlace& place = places[std::size_t(bytes.next()) % places.size()];
        if (place.length == 0) continue;
        const std::size_t at = std::size_t(bytes.next() << 8 | bytes.next()) % place.length;
        const int how = bytes.next();
        std::byte& byte = file[place.first + at];
        byte = how % 2 ? std::byte(bytes.next()) : byte ^ std::byte(1 << how / 2 % 8);
    }
    fix_checksums(file);
    return file;
}

/// Whether a patch is applied or refused, the world it is for stays.
void apply_any(const World& world, const File& patch) {
    const std::uint64_t before = hash_world(world);
    const Result<World> made = apply_patch(world, patch, "fuzz");
    expect(hash_world(world) == before, "a patch changed the world that it was applied to");
    if (!made) return;
    expect(!check_world(made.value()), "a patch made a world that is not sound");
    expect(!check_solid(made.value()), "a patch made a solid that is not sound");
    const World after = apply(made.value(), crater(9, CutterShape::kRocky, 2.2, 2)).world;
    expect(!check_world(after), "a cut after a patch made a world that is not sound");
}

/// What PatchReader compares last is made to fit, so that what comes before it is tried.
void say_hash_of(File& patch, std::uint64_t hash) {
    for (const SectionPlace& place : section_places(patch))
        if (place.type == kPatchSection && place.length == kPatchBytes) {
            put_u32(patch, place.first + 16, std::uint32_t(hash));
            put_u32(patch, place.first + 20, std::uint32_t(hash >> 32));
        }
    fix_checksums(patch);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    set_assert_handler(on_assertion);
    Bytes bytes(data, size);
    const int mode = bytes.next();
    if (mode % 4 == 0) {
        File file;
        for (std::size_t k = 1; k < size; ++k) file.push_back(std::byte(data[k]));
        apply_any(peers().broken, file);
        (void)make_patch(peers().sound, file, "fuzz");
        return 0;
    }
    if (mode % 4 == 1) {  // a list that lies
        const Result<File> patch = make_patch(peers().sound, changed(peers().list, bytes), "fuzz");
        if (patch) apply_any(peers().broken, patch.value());
        return 0;
    }
    File patch = changed(peers().patch, bytes);
    if (mode % 4 == 3) say_hash_of(patch, hash_world(peers().sound));
    apply_any(peers().broken, patch);
    return 0;
}
