// SPDX-License-Identifier: MIT
// Any bytes as .firma files: as they are; with places, sizes and checksums put right; or a sound file changed by rules,
// checksums put right; or solids that cross. An error, or a world that bears checks, casts, an edit and being saved
// again.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "base/assert.h"
#include "firma/queries.h"
#include "firma/rooms.h"
#include "firma/solid.h"
#include "firma/triangles.h"
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

/// A file may hold a solid that crosses itself: no check looks for that, and cuts of it may contradict each other. Then
/// they are refused. Nothing else may be asserted in vain.
void on_assertion(const char* condition, const char* advice, const char* file, int line) {
    if (std::strstr(advice, "contradict")) return;
    std::fprintf(stderr, "%s:%d: %s: %s\n", file, line, condition, advice);
    std::abort();
}

void put_u64(File& file, std::size_t at, std::uint64_t value) {
    put_u32(file, at, std::uint32_t(value));
    put_u32(file, at + 4, std::uint32_t(value >> 32));
}

/// Puts right what a container checks: magic, version, places, lengths that reach too far, zeros between, checksums.
void mend(File& file) {
    static const File sound = pack_world(World());
    if (file.size() < kHeadBytes) file.resize(kHeadBytes);
    file.resize(file.size() / 8 * 8);
    std::copy_n(sound.begin(), 12, file.begin());
    const std::size_t most = (file.size() - kHeadBytes) / kTableEntryBytes;
    const std::uint32_t count = std::min(read_u32(file.data() + 12), std::uint32_t(most));
    put_u32(file, 12, count);
    put_u32(file, 24, 0);
    std::size_t place = kHeadBytes + count * kTableEntryBytes;
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t entry = kHeadBytes + k * kTableEntryBytes;
        const std::uint64_t length = std::min<std::uint64_t>(read_u64(file.data() + entry + 16), file.size() - place);
        put_u64(file, entry + 8, place);
        put_u64(file, entry + 16, length);
        put_u32(file, entry + 28, 0);
        place += std::size_t(length);
        for (; place % 8 != 0; ++place) file[place] = std::byte(0);
    }
    file.resize(place);
    put_u64(file, 16, place);
    fix_checksums(file);
}

const File& sound_file(int which) {
    static const std::vector<File> files = [] {
        const World small = cut_room(1, 3), facets = cut_room(2, 4);
        return std::vector<File>{pack_world(tiny_world()),   pack_world(room_world()),
                                 pack_world(small),          pack_world(facets, {.exact = false}),
                                 pack_world(World()),        pack_world(two_rooms()),
                                 pack_world(papered_world())};
    }();
    return files[std::size_t(which) % files.size()];
}

std::size_t entry_size(SectionType type) {
    switch (type) {
        case kFacesSection:
            return kFaceBytes;
        case kRoomRecordsSection:
        case kAnchorsSection:
        case kPortalCornersSection:
        case kVerticesSection:
        case kGridPointsSection:
        case kMeetPointsSection:
            return kPointBytes;
        case kPlanesSection:
            return kPlaneBytes;
        case kEdgesSection:
            return kEdgeBytes;
        case kExactFacesSection:
            return kExactFaceBytes;
        case kTextureMapsSection:
            return kTextureMapBytes;
        case kTexturedFacesSection:
        case kTextureOutlinesSection:
            return kTexturedFaceBytes;
        case kWorldSection:
            return kWorldBytes;
        default:
            return 4;
    }
}

std::size_t number_below(std::size_t end, Bytes& bytes) {
    const int high = bytes.next();
    return std::size_t(high << 8 | bytes.next()) % end;
}

/// A number that code may stumble over, or one near another.
std::uint32_t odd_number(std::uint32_t was, Bytes& bytes) {
    constexpr std::uint32_t kOdd[] = {0,          1,          2,          0x7FFFFFFF, 0x80000000, 0xFFFFFFFF,
                                      0xFFFFFFFE, 0x7FC00000, 0x7F800000, 0xFF800000, 0x02000000, 0xFE000000};
    const int kind = bytes.next();
    if (kind < 64) return was + 1;
    if (kind < 128) return was - 1;
    if (kind < 160) return was ^ 1u << (kind & 31);
    return kOdd[std::size_t(kind) % std::size(kOdd)];
}

/// One change within a section.
void change(File& file, const SectionPlace& place, Bytes& bytes) {
    const std::size_t size = entry_size(place.type), entries = place.length / size;
    if (entries == 0) return;
    const std::size_t at = place.first + number_below(entries, bytes) * size;
    const std::size_t other = place.first + number_below(entries, bytes) * size;
    const std::size_t field = size < 4 ? 0 : number_below(size / 4, bytes) * 4;
    switch (bytes.next() % 6) {
        case 0: {  // any byte
            const std::size_t byte = number_below(size, bytes);
            file[at + byte] = std::byte(bytes.next());
            break;
        }
        case 1:  // an odd number
            if (size >= 4) put_u32(file, at + field, odd_number(read_u32(file.data() + at + field), bytes));
            break;
        case 2:  // an entry over another
            std::copy_n(file.begin() + std::ptrdiff_t(other), size, file.begin() + std::ptrdiff_t(at));
            break;
        case 3:  // two entries change places
            std::swap_ranges(file.begin() + std::ptrdiff_t(at), file.begin() + std::ptrdiff_t(at + size),
                             file.begin() + std::ptrdiff_t(other));
            break;
        case 4:  // a field of another
            if (size >= 4) put_u32(file, at + field, read_u32(file.data() + other + field));
            break;
        default:  // any number
            if (size >= 4) put_u32(file, at + field, std::uint32_t(bytes.next()));
    }
}

File changed_file(Bytes& bytes) {
    File file = sound_file(bytes.next());
    const std::vector<SectionPlace> places = section_places(file);
    while (!bytes.empty()) change(file, places[std::size_t(bytes.next()) % places.size()], bytes);
    fix_checksums(file);
    return file;
}

/// Boxes anywhere, all of their faces marked as bounding solids, however they cross: what readers of levels never make,
/// but a file may say.
File crossing_file(Bytes& bytes) {
    std::string text;
    for (int boxes = 2 + bytes.next() % 3; boxes > 0; --boxes) {
        Vec3 low, high;
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = double(bytes.next() - 128) / 16;
            high[axis] = low[axis] + double(1 + bytes.next() % 128) / 16;
        }
        add_box(text, low, high, bytes.next() % 2);
    }
    File file = pack_world(world_of(text));
    for (const SectionPlace& place : section_places(file)) {
        if (place.type == kWorldSection) file[place.first + 24] = std::byte(kExactPart | kHasRules | bytes.next() % 2);
        if (place.type != kFacesSection) continue;
        for (std::size_t k = 0; k < place.length / kFaceBytes; ++k)
            file[place.first + k * kFaceBytes + 25] |= std::byte(kSolidFace);
    }
    fix_checksums(file);
    return file;
}

/// Cuts one after another where rays from the middle meet faces, and anywhere.
World cut_on(World world, Bytes& bytes) {
    for (int cuts = 0; cuts < 6 && !bytes.empty(); ++cuts) {
        const int how = bytes.next();
        Pose pose;
        for (int axis = 0; axis < 3; ++axis) pose.position[axis] = double(bytes.next() - 128) / 12;
        pose.scale = 0.25 + double(bytes.next()) / 32;
        const Cutter cutter = make_crater(CutterShape(how % 5), std::uint64_t(bytes.next()));
        world = (how & 64 ? fill(world, cutter, pose, {"new"}) : carve(world, cutter, pose, {"new"})).world;
    }
    return world;
}

void use_rooms(const World& world, const Vec3& middle, int how) {
    const Location where = locate(world, middle);
    expect(where.where != Where::kAir || where.room.value < world.room_count(), "a point in a room too many");
    for (std::uint32_t room = 0; room < world.room_count() && room < 8; ++room) {
        const std::optional<RoomInfo> info = room_info(world, {room});
        expect(info && info->portals.size() <= portal_count(world), "a room lists portals that are not there");
        expect(neighbours(world, {room}).size() <= world.room_count(), "a room has neighbours that are not there");
        static_cast<void>(find_path(world, {room}, {0}, Doors::kAllOpen));
        static_cast<void>(cast(world, {middle, 0.2}, {50, 3, how * 0.1}, {.room = {room}}));
    }
    for (std::uint32_t portal = 0; portal < portal_count(world) && portal < 8; ++portal)
        expect(!check_world(*set_portal_open(world, {portal}, !portal_info(world, {portal})->open)),
               "a door made a world that is not sound");
}

void use(const World& world, int how) {
    expect(!check_world(world), "a world was read that is not sound");
    expect(!check_solid(world), "a solid was read that is not sound");
    const World again = unpack_world(pack_world(world), "again").value();
    expect(hash_world(again) == hash_world(world), "saved again, it is another world");
    const Box bounds = world.bounds();
    const Vec3 middle = bounds.empty() ? Vec3{} : (bounds.low + bounds.high) * 0.5;
    Pose pose;
    pose.position = middle;
    for (int k = 0; k < 6; ++k) {
        Vec3 path{0.3, 0.2, 0.1};
        path[k / 2] = k % 2 ? 20000 : -20000;
        const Hit hit = cast(world, {middle, k % 2 ? 0.1 : 0}, path);
        expect(!hit.face.valid() || world.face(hit.face).has_value(), "a face that was met is not found");
        static_cast<void>(room_of(world, hit));
        if (const std::optional<TextureProjection> lies = texture_of(world, hit.face))
            expect(is_usable(*lies), "a face has a projection that is none");
        if (hit.touched() && k <= how % 6) pose.position = hit.point;
    }
    for (const auto& [u, v] : triangles_of(world, {.uvs = true}).uvs)
        expect(is_finite(double(u)) && is_finite(double(v)), "a texture coordinate is no number");
    std::vector<Overlap> near;
    overlap(world, {pose.position, 1}, near);
    static_cast<void>(locate(world.solid(), middle));
    use_rooms(world, middle, how);
    pose.scale = 0.4 + how % 8;
    const Cutter cutter = make_crater(CutterShape(how % 5), std::uint64_t(how));
    const CarveResult result = how & 64 ? fill(world, cutter, pose, {"new"}) : carve(world, cutter, pose, {"new"});
    expect(!check_world(result.world), "an edit of a world that was read made one that is not sound");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    set_assert_handler(on_assertion);
    Bytes bytes(data, size);
    const int mode = bytes.next(), how = bytes.next();
    File file;
    if (mode % 4 == 2) {
        file = changed_file(bytes);
    } else if (mode % 4 == 3) {
        file = crossing_file(bytes);
    } else {
        for (std::size_t k = 2; k < size; ++k) file.push_back(std::byte(data[k]));
        if (mode % 4 == 1) mend(file);
    }
    const Result<World> read = unpack_world(file, "fuzz");
    if (!read) return 0;
    use(read.value(), how);
    if (mode % 4 == 3) expect(!check_world(cut_on(read.value(), bytes)), "cuts made a world that is not sound");
    return 0;
}
