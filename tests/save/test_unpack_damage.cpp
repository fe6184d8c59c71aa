// SPDX-License-Identifier: MIT
// Damaged and hostile files: an error with its place or the same world, never anything else.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "firma/chunk.h"
#include "firma/queries.h"
#include "firma/solid.h"
#include "tests/save/saved_worlds.h"

namespace firma {
namespace {

/// Of a small world with an exact part, and without.
std::vector<std::vector<std::byte>> small_files() {
    return {pack_world(tiny_world()), pack_world(tiny_world(), {.exact = false}), pack_world(World()),
            pack_world(two_rooms()), pack_world(with_anchors(papered_world()), {.index = false})};
}

TEST(UnpackDamage, EveryByteFlipped) {
    for (std::vector<std::byte>& bytes : small_files()) {
        const std::uint64_t hash = hash_world(unpack_world(bytes, "test").value());
        std::size_t refused = 0;
        for (std::size_t k = 0; k < bytes.size(); ++k) {
            for (const unsigned flip : {1u, 0x80u, 0xFFu}) {
                bytes[k] ^= std::byte(flip);
                const Result<World> read = unpack_world(bytes, "test");
                bytes[k] ^= std::byte(flip);
                if (read) {
                    EXPECT_EQ(hash_world(read.value()), hash) << "byte " << k;
                } else {
                    ++refused;
                    EXPECT_EQ(read.error().place.rfind("test", 0), 0u) << read.error().text();
                }
            }
        }
        EXPECT_EQ(refused, 3 * bytes.size());  // what lies between sections is zero, and checked
    }
}

TEST(UnpackDamage, EveryTruncation) {
    for (const std::vector<std::byte>& bytes : small_files()) {
        for (std::size_t length = 0; length < bytes.size(); ++length)
            ASSERT_FALSE(unpack_world(std::span(bytes).first(length), "test")) << length;
        std::vector<std::byte> longer = bytes;
        longer.resize(bytes.size() + 8);
        EXPECT_FALSE(unpack_world(longer, "test"));
    }
}

/// Casts, an edit and the checks: whatever came out of a file must bear them.
void use(const World& world) {
    EXPECT_FALSE(check_world(world));
    EXPECT_FALSE(check_solid(world));
    EXPECT_NE(cast(world, {{0, 0, 1.5}, 0.1}, {1, 5, 0.3}).status, Status::kInvalid);
    Pose pose;
    pose.position = {0.1, 3.9, 0.2};
    pose.scale = 0.6;
    const CarveResult result = carve(world, make_crater(CutterShape::kRocky, 7), pose);
    if (result.done()) {
        EXPECT_FALSE(check_world(result.world));
    }
}

/// Right checksums over wrong content: each byte of each section in turn.
TEST(UnpackDamage, EveryByteFlippedUnderRightChecksums) {
    for (const std::vector<std::byte>& bytes : small_files()) {
        std::size_t read_anyway = 0, refused = 0;
        for (const SectionPlace& place : section_places(bytes)) {
            for (std::size_t k = place.first; k < place.first + place.length; ++k) {
                for (const unsigned flip : {1u, 0x80u}) {
                    std::vector<std::byte> damaged = bytes;
                    damaged[k] ^= std::byte(flip);
                    fix_checksums(damaged);
                    const Result<World> read = unpack_world(damaged, "test");
                    read ? ++read_anyway : ++refused;
                    if (read && k % 7 == 0) use(read.value());
                }
            }
        }
        EXPECT_GT(read_anyway, 20u);  // versions, ids, masks, names ...
        EXPECT_GT(refused, 20u);
    }
}

/// The place and reason of a file whose content was changed, checksums right.
template <class Change>
std::string text_of(SectionType type, const Change& change) {
    std::vector<std::byte> bytes = pack_world(tiny_world());
    for (const SectionPlace& place : section_places(bytes))
        if (place.type == type) change(bytes, place);
    fix_checksums(bytes);
    const Result<World> read = unpack_world(bytes, "a.firma");
    return read ? "read" : read.error().text();
}

TEST(UnpackDamage, ErrorsNameTheirPlace) {
    using Bytes = std::vector<std::byte>;
    EXPECT_EQ(text_of(kCornersSection, [](Bytes& b, const SectionPlace& p) { b[p.first + 4 * 5 + 1] = std::byte(9); }),
              "a.firma: section CORN, entry 5: names a vertex that is not there");
    EXPECT_EQ(text_of(kFacesSection,
                      [](Bytes& b, const SectionPlace& p) { b[p.first + 3 * kFaceBytes + 28] = std::byte(65); }),
              "a.firma: section FACE, entry 3: does not have 3 to 64 corners");
    EXPECT_EQ(
        text_of(kEdgesSection, [](Bytes& b, const SectionPlace& p) { put_u32(b, p.first + 2 * kEdgeBytes, 77777); }),
        "a.firma: section EDGE, entry 2: names a vertex that is not there");
    EXPECT_EQ(text_of(kPlanesSection, [](Bytes& b, const SectionPlace& p) { b[p.first + 7] = std::byte(0x40); }),
              "a.firma: section PLAN, entry 0: is no plane through points of the grid");
    EXPECT_EQ(text_of(kFacesSection, [](Bytes& b, const SectionPlace& p) { put_u32(b, p.first + kFaceBytes, 0); }),
              "a.firma: section FACE, entry 1: does not have a higher id than the last");
    EXPECT_EQ(text_of(kFacesSection, [](Bytes& b, const SectionPlace& p) { put_u32(b, p.first + 20, 1); }),
              "a.firma: section FACE, entry 0: lies in a room that is not there");
    EXPECT_EQ(text_of(kFacesSection, [](Bytes& b, const SectionPlace& p) { put_u32(b, p.first + 12, 99); }),
              "a.firma: section FACE, entry 0: has a material that is not there");
    EXPECT_EQ(text_of(kWorldSection, [](Bytes& b, const SectionPlace& p) { put_u32(b, p.first + 8, 1); }),
              "a.firma: section FACE: has not as many entries as faces");
}

TEST(UnpackDamage, ErrorsOfRoomsNameTheirPlace) {
    const auto with_u32 = [](SectionType type, std::size_t at, std::uint32_t value) {
        std::vector<std::byte> bytes = pack_world(two_rooms());
        for (const SectionPlace& place : section_places(bytes))
            if (place.type == type) put_u32(bytes, place.first + at, value);
        fix_checksums(bytes);
        const Result<World> read = unpack_world(bytes, "a.firma");
        return read ? "read" : read.error().text();
    };
    const std::size_t second_room = kRoomRecordBytes, first_portal = 4;
    EXPECT_EQ(with_u32(kRoomRecordsSection, second_room + 8, 2),
              "a.firma: section RECS, entry 1: is part of a room that is not there");
    EXPECT_EQ(with_u32(kRoomRecordsSection, 8, 1),
              "a.firma: the world is broken: portal 0 leads from a room to itself");
    EXPECT_EQ(with_u32(kRoomRecordsSection, second_room + 8, 0),
              "a.firma: the world is broken: portal 0 leads from a room to itself");
    EXPECT_EQ(with_u32(kRoomRecordsSection, 4, 2), "a.firma: section RECS, entry 0: has flags that mean nothing");
    EXPECT_EQ(with_u32(kRoomRecordsSection, 4, 1),
              "a.firma: the world is broken: more than one room, or rock as well, reaches to infinity");
    EXPECT_EQ(with_u32(kRoomRecordsSection, 0, 3), "a.firma: section RECS: has bytes behind its last name");
    EXPECT_EQ(with_u32(kRoomRecordsSection, 0, ~0u), "a.firma: section RECS, entry 0: ends before its name");
    EXPECT_EQ(with_u32(kPortalsSection, 0, ~0u), "a.firma: section PORT: ends before its portals");
    EXPECT_EQ(with_u32(kPortalsSection, first_portal, 2),
              "a.firma: section PORT, entry 0: leads to a room that is not there");
    EXPECT_EQ(with_u32(kPortalsSection, first_portal, 1),
              "a.firma: the world is broken: portal 0 leads from a room to itself");
    EXPECT_EQ(with_u32(kPortalsSection, first_portal + 16, 0), "read");  // the door is open
    EXPECT_EQ(with_u32(kPortalsSection, first_portal + 16, 5),
              "a.firma: section PORT, entry 0: has flags that mean nothing");
    EXPECT_EQ(with_u32(kPortalsSection, first_portal + 20, 0), "a.firma: section PPOL, entry 0: belongs to no portal");
    EXPECT_EQ(with_u32(kPortalsSection, first_portal + 20, ~0u),
              "a.firma: section PORT, entry 0: has more polygons than there are");
    EXPECT_EQ(with_u32(kPortalPolygonsSection, 0, 2), "a.firma: section PPOL, entry 0: does not have 3 to 64 corners");
    EXPECT_EQ(with_u32(kPortalPolygonsSection, 0, 64),
              "a.firma: section PPOL, entry 0: has more corners than there are");
    EXPECT_EQ(with_u32(kPortalPolygonsSection, 0, 3), "a.firma: section PCOR, entry 3: belongs to no portal");
    EXPECT_EQ(with_u32(kPortalCornersSection, 0, 77),
              "a.firma: the world is broken: portal 0 has a polygon that is not convex and planar, with area");
    EXPECT_EQ(with_u32(kWorldSection, 24, kRockOutside | kExactPart | kHasRules | kHasPortals),
              "a.firma: section WRLD: has several rooms or portals, and no records of rooms");
    EXPECT_EQ(with_u32(kWorldSection, 24, kRockOutside | kExactPart | kHasRules | kHasRoomRecords),
              "a.firma: section PORT: is there without a reason");
}

TEST(UnpackDamage, ErrorsOfTexturesNameTheirPlace) {
    std::vector<std::byte> bytes;
    const auto change = [&](SectionType type, std::size_t at, std::uint32_t value) {
        for (const SectionPlace& place : section_places(bytes))
            if (place.type == type) put_u32(bytes, place.first + at, value);
    };
    const auto answer = [&] {
        fix_checksums(bytes);
        const Result<World> read = unpack_world(bytes, "a.firma");
        return read ? "read" : read.error().text();
    };
    const auto with_u32 = [&](SectionType type, std::size_t at, std::uint32_t value) {
        bytes = pack_world(papered_world());
        change(type, at, value);
        return answer();
    };
    const std::size_t second_map = kTextureMapBytes, second = kTexturedFaceBytes, third = 2 * kTexturedFaceBytes;
    for (const std::uint32_t high : {0x7FF00000u, 0x7FF80001u, 0xFFF00000u, 0x44000000u})  // 0x1p65
        for (std::size_t number = 0; number < 8; ++number)
            EXPECT_EQ(with_u32(kTextureMapsSection, second_map + 8 * number + 4, high),
                      "a.firma: section TMAP, entry 1: its numbers are not finite, or too large");
    EXPECT_EQ(with_u32(kTextureMapsSection, 64, 3), "a.firma: section TMAP, entry 0: has flags that mean nothing");
    EXPECT_EQ(with_u32(kTextureMapsSection, 68, 1), "a.firma: section TMAP, entry 0: has flags that mean nothing");
    EXPECT_EQ(with_u32(kTextureMapsSection, 64, 0), "read");
    EXPECT_EQ(with_u32(kTexturedFacesSection, second + 4, 3), "a.firma: section TFAC, entry 1: names no projection");
    EXPECT_EQ(with_u32(kTexturedFacesSection, 0, 7), "a.firma: section TFAC, entry 1: is out of order");
    EXPECT_EQ(with_u32(kTexturedFacesSection, 0, 1),
              "a.firma: section TFAC, entry 1: is one of several of a face, and has no outline");
    EXPECT_EQ(with_u32(kTexturedFacesSection, third + 8, 2),
              "a.firma: section TFAC, entry 2: does not have 3 to 64 corners, or none");
    EXPECT_EQ(with_u32(kTexturedFacesSection, third + 8, 65),
              "a.firma: section TFAC, entry 2: does not have 3 to 64 corners, or none");
    EXPECT_EQ(with_u32(kTexturedFacesSection, third + 8, 4),
              "a.firma: section TFAC, entry 2: has more corners than there are");
    EXPECT_EQ(with_u32(kTexturedFacesSection, third, 77), "read") << "of a face that is gone";
    change(kTexturedFacesSection, third + 8, 0);
    EXPECT_EQ(answer(), "a.firma: section TCOR, entry 3: belongs to no face");
    EXPECT_EQ(with_u32(kTextureOutlinesSection, 0, 77), "read");
    const auto without = [](SectionType type) {
        std::vector<NewSection> sections;
        const std::vector<std::byte> whole = pack_world(papered_world());
        const std::vector<Section> known = read_container(whole, "test").value();
        for (const Section& section : known) {
            if (section.type == type) continue;
            NewSection copy{section.type, section.flags, {}};
            for (const std::byte byte : section.bytes) copy.content.u8(std::uint8_t(byte));
            sections.push_back(copy);
        }
        const Result<World> read = unpack_world(write_container(sections), "a.firma");
        return read ? "read" : read.error().text();
    };
    EXPECT_EQ(without(kTextureMapsSection), "a.firma: section TFAC: is there without a reason");
    EXPECT_EQ(without(kTexturedFacesSection), "a.firma: section TFAC: is missing");
    EXPECT_EQ(without(kTextureOutlinesSection), "a.firma: section TCOR: is missing");
}

TEST(UnpackDamage, ErrorsOfAnchorsNameTheirPlace) {
    const World world = with_anchors(
        tiny_world(), {.hanging = false, .materials = {""}, .sources = {3, 5}, .volumes = {{{1, 2, 3}, {4, 5, 6}}}});
    const auto with_u32 = [&](std::size_t at, std::uint32_t value) {
        std::vector<std::byte> bytes = pack_world(world);
        for (const SectionPlace& place : section_places(bytes))
            if (place.type == kAnchorsSection) put_u32(bytes, place.first + at, value);
        fix_checksums(bytes);
        const Result<World> read = unpack_world(bytes, "a.firma");
        return read ? "read" : read.error().text();
    };
    const std::size_t second = kAnchorBytes, third = 2 * kAnchorBytes;
    EXPECT_EQ(with_u32(8, 77), "read") << "a material that is not there holds nothing";
    EXPECT_EQ(with_u32(0, 5), "a.firma: section HOLD, entry 0: has flags that mean nothing");
    EXPECT_EQ(with_u32(second + 4, 1), "a.firma: section HOLD, entry 1: has flags that mean nothing");
    EXPECT_EQ(with_u32(second + 8, 5), "a.firma: section HOLD, entry 2: is out of order");
    EXPECT_EQ(with_u32(third, 0), "a.firma: section HOLD, entry 2: is out of order");
    EXPECT_EQ(with_u32(third, kHangingHolds), "read");
    const std::size_t volume = 3 * kAnchorBytes;
    EXPECT_EQ(with_u32(volume + 4, 1), "a.firma: section HOLD, entry 3: is out of order");
    EXPECT_EQ(with_u32(volume + 8, 0x7FFFFFFF), "a.firma: section HOLD: a volume that holds is no box");
    EXPECT_EQ(with_u32(volume, kHangingHolds), "a.firma: section HOLD, entry 4: is out of order");
}

TEST(UnpackDamage, ContactOffsetAndCountersAreOnesToGoOnWith) {
    const auto with_u64 = [](std::size_t at, std::uint64_t value) {
        return text_of(kWorldSection, [&](std::vector<std::byte>& b, const SectionPlace& p) {
            put_u32(b, p.first + at, std::uint32_t(value));
            put_u32(b, p.first + at + 4, std::uint32_t(value >> 32));
        });
    };
    for (const double contact_offset : {-1.0, -1e-300, double(NAN), double(INFINITY)})
        EXPECT_EQ(with_u64(32, std::bit_cast<std::uint64_t>(contact_offset)),
                  "a.firma: section WRLD, entry 0: its contact offset is no length")
            << contact_offset;
    for (const double contact_offset : {0.0, 0.5, 1e300})
        EXPECT_EQ(with_u64(32, std::bit_cast<std::uint64_t>(contact_offset)), "read");
    for (const std::uint64_t version : {~std::uint64_t(0), (std::uint64_t(1) << 52) + 1})
        EXPECT_EQ(with_u64(0, version), "a.firma: section WRLD, entry 0: has no numbers left for new edits");
    EXPECT_EQ(with_u64(0, std::uint64_t(1) << 52), "read");
    const auto with_edits = [](std::uint32_t edits) {
        return text_of(kWorldSection,
                       [&](std::vector<std::byte>& b, const SectionPlace& p) { put_u32(b, p.first + 20, edits); });
    };
    EXPECT_EQ(with_edits(~0u), "a.firma: section WRLD, entry 0: has no numbers left for new edits");
    EXPECT_EQ(with_edits(1u << 31), "read");
}

// Until 0.2 rules were taken as they were given: files may hold any.
TEST(UnpackDamage, RulesAreReadAsOnesThatCanBeGiven) {
    WorldOptions options;
    options.rules.zones = {{"empty", {{0, 0, 0}, {1, 1, 1}}, 0.5}, {"vault", {{-1, -2, -3}, {1, 2, 3}}, 0.25}};
    options.rules.hardness = {0.5, 0.5, 0.5, 0.5};
    std::vector<std::byte> bytes = pack_world(room_world(options));
    std::size_t at = 0;
    for (const SectionPlace& place : section_places(bytes))
        if (place.type == kRulesSection) at = place.first + kRulesBytes;
    ASSERT_NE(at, 0u);
    const auto put = [&](std::size_t offset, double value) {
        const auto bits = std::bit_cast<std::uint64_t>(value);
        put_u32(bytes, at + offset, std::uint32_t(bits));
        put_u32(bytes, at + offset + 4, std::uint32_t(bits >> 32));
    };
    const double given[] = {7, -3, NAN, 0.75}, meant[] = {1, 0, 0, 0.75};
    for (std::size_t k = 0; k < 4; ++k) put(8 * k, given[k]);
    const std::size_t zones = 8 * std::size(given);
    put(zones, 9);  // the low corner of the first beyond its high one
    put(zones + kZoneBytes + 48, INFINITY);
    fix_checksums(bytes);

    const Result<World> read = unpack_world(bytes, "old.firma");
    ASSERT_TRUE(read) << read.error().text();
    const CarveRules& rules = *read.value().data().rules;
    EXPECT_TRUE(std::equal(rules.hardness.begin(), rules.hardness.end(), meant, std::end(meant)));
    ASSERT_EQ(rules.zones.size(), 1u);
    EXPECT_EQ(rules.zones[0].name, "vault");
    EXPECT_EQ(rules.zones[0].hardness, 1);
    const Result<World> again = with_rules(read.value(), rules);
    EXPECT_TRUE(again) << again.error().text();
}

TEST(UnpackDamage, OtherVersionsSaySo) {
    std::vector<std::byte> bytes = pack_world(tiny_world());
    put_u32(bytes, 8, 4);
    fix_checksums(bytes);
    const Result<World> read = unpack_world(bytes, "a.firma");
    ASSERT_FALSE(read);
    EXPECT_EQ(read.error().code, ErrorCode::kUnsupported);
    EXPECT_EQ(read.error().text(), "a.firma: it is of version 4 of the format; this Firma reads versions 1 to 3");
    const std::string text = "o level\nv 0 0 0\n";
    EXPECT_EQ(unpack_world(std::as_bytes(std::span(text)), "a.obj").error().text(),
              "a.obj: it does not begin as a .firma file does");
}

TEST(UnpackDamage, UnknownSectionsArePassedOverUnlessRequired) {
    const World world = tiny_world();
    const std::vector<std::byte> bytes = pack_world(world);
    for (const bool required : {false, true}) {
        const std::vector<Section> known = read_container(bytes, "test").value();
        std::vector<NewSection> sections;
        for (const Section& section : known) {
            NewSection copy{section.type, section.flags, {}};
            for (const std::byte byte : section.bytes) copy.content.u8(std::uint8_t(byte));
            sections.push_back(copy);
        }
        NewSection fresh{section_type("NEWS"), required ? kRequiredSection : 0, {}};
        fresh.content.u8(1);
        sections.insert(sections.begin() + 2, fresh);
        const Result<World> read = unpack_world(write_container(sections), "a.firma");
        EXPECT_EQ(read.ok(), !required);
        if (read) {
            EXPECT_EQ(hash_world(read.value()), hash_world(world));
        } else {
            EXPECT_EQ(read.error().code, ErrorCode::kUnsupported);
            EXPECT_EQ(read.error().place, "a.firma: section NEWS");
        }
    }
}

TEST(UnpackDamage, Crc32cIsTheUsualOne) {
    const std::string digits = "123456789";
    EXPECT_EQ(crc32c(std::as_bytes(std::span(digits))), 0xE3069283u);
    const std::span<const std::byte> all = std::as_bytes(std::span(digits));
    EXPECT_EQ(crc32c(all.subspan(4), crc32c(all.first(4))), 0xE3069283u);
}

}  // namespace
}  // namespace firma
