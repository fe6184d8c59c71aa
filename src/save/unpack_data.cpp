// SPDX-License-Identifier: MIT
// What a saved world has besides faces. Options are taken as they are: whoever uses them can do with any numbers. Rules
// are those that with_rules() takes; what the first version took beyond that is what it meant there.
#include "save/unpack_data.h"

#include <algorithm>
#include <limits>

#include "carve/judge_rules.h"
#include "save/sections.h"
#include "solid/face_ids.h"

namespace firma {
namespace {

/// One less than what says "no face": as edits have it.
constexpr std::uint32_t kMostFaceIds = ~0u - 1;
/// Numbers of edits and versions that years of edits do not use up: those of a world read can go on growing, and
/// versions are exact in JavaScript.
constexpr std::uint32_t kMostEdits = 1u << 31;
constexpr std::uint64_t kMostVersion = std::uint64_t(1) << 52;

std::size_t limit_of(std::uint64_t value) {
    constexpr std::uint64_t kMost = std::numeric_limits<std::size_t>::max();
    return std::size_t(value < kMost ? value : kMost);
}

bool unpack_counters(const Entries& section, UnpackedData& unpacked, Damage& damage) {
    if (section.count() != 1) return damage.report(section.type(), "is not 64 bytes long");
    const std::byte* at = section.at(0);
    StoredWorld& data = unpacked.world;
    data.version = read_u64(at);
    const std::uint64_t faces = read_u64(at + 8);
    data.next_face = read_u32(at + 16);
    data.edits = read_u32(at + 20);
    const std::uint32_t flags = read_u32(at + 24), split = read_u32(at + 40);
    unpacked.rooms = read_u32(at + 28);
    data.tolerance.contact_offset = read_f64(at + 32);
    data.tree_options.split = split == std::uint32_t(Split::kSurfaceArea) ? Split::kSurfaceArea : Split::kLongestAxis;
    data.tree_options.max_depth = read_i32(at + 44);
    data.tree_options.faces_per_leaf = read_i32(at + 48);
    data.tree_options.min_node_volume = read_f64(at + 56);
    data.rock_outside = flags & kRockOutside;
    unpacked.exact = flags & kExactPart;
    unpacked.has_records = flags & kHasRoomRecords;
    unpacked.has_portals = flags & kHasPortals;
    data.known = unpacked.has_records;
    if (flags & kHasRules) data.rules = std::make_shared<const CarveRules>();

    const std::uint64_t numbered = std::uint64_t(std::min(data.edits, kLastEditNumber)) * kIdsAnEdit;
    if (faces > data.next_face + numbered) return damage.report(section.type(), "has more faces than there were ids");
    unpacked.faces = std::size_t(faces);
    if (data.next_face > kMostFaceIds) return damage.report(section.type(), "has no ids left for new faces");
    if (data.version > kMostVersion || data.edits > kMostEdits)
        return damage.report(section.type(), 0, "has no numbers left for new edits");
    // Of a contact offset below zero, casts would say that it is safe to go through what they meet.
    if (!(data.tolerance.contact_offset >= 0) || !is_finite(data.tolerance.contact_offset))
        return damage.report(section.type(), 0, "its contact offset is no length");
    if (flags & ~(kRockOutside | kExactPart | kHasRules | kHasRoomRecords | kHasPortals) || read_u32(at + 52) != 0)
        return damage.report(section.type(), "has flags that mean nothing");
    if (split > std::uint32_t(Split::kSurfaceArea))
        return damage.report(section.type(), "has no such way to divide nodes");
    if (data.rock_outside && !unpacked.exact) return damage.report(section.type(), "has rock without its faces");
    if (unpacked.rooms == 0) return damage.report(section.type(), "has no room");
    if (!unpacked.has_records && (unpacked.rooms > 1 || unpacked.has_portals))
        return damage.report(section.type(), "has several rooms or portals, and no records of rooms");
    return true;
}

bool unpack_materials(const Entries& section, UnpackedData& unpacked, Damage& damage) {
    if (section.count() < 4) return damage.report(section.type(), "ends before its count");
    const std::uint64_t count = read_u32(section.at(0));
    if (count > (section.count() - 4) / 4) return damage.report(section.type(), "ends before its lengths");
    Texts texts({section.at(std::size_t(4 + 4 * count)), section.count() - std::size_t(4 + 4 * count)});
    auto names = std::make_shared<std::vector<std::string>>(std::size_t(count));
    for (std::size_t k = 0; k < count; ++k)
        if (!texts.take(read_u32(section.at(4 + 4 * k)), (*names)[k]))
            return damage.report(section.type(), k, "ends before its text");
    if (!texts.all_taken()) return damage.report(section.type(), "has bytes behind its last text");
    unpacked.world.materials = std::move(names);
    return true;
}

/// As the first version took them: what is beyond 1 refuses, what is no number above 0 does nothing.
double hardness_of(double given) {
    return given > 0 ? std::min(given, 1.0) : 0;
}

CarveZone zone_at(const std::byte* at) {
    CarveZone zone;
    for (int axis = 0; axis < 3; ++axis) {
        zone.box.low[axis] = read_f64(at + 8 * axis);
        zone.box.high[axis] = read_f64(at + 24 + 8 * axis);
    }
    zone.hardness = hardness_of(read_f64(at + 48));
    return zone;
}

bool unpack_rules(const Entries& section, const Entries* merge, const Entries* open_faces, UnpackedData& unpacked,
                  Damage& damage) {
    if (section.count() < kRulesBytes) return damage.report(section.type(), "ends before its limits");
    const std::byte* at = section.at(0);
    const std::uint64_t zones = read_u32(at), hardness = read_u32(at + 4);
    CarveRules rules;
    std::size_t* const limits[] = {&rules.max_faces,     &rules.max_candidate_faces,
                                   &rules.max_new_faces, &rules.max_cutter_triangles,
                                   &rules.max_pairs,     &rules.max_corners};
    for (std::size_t k = 0; k < std::size(limits); ++k) *limits[k] = limit_of(read_u64(at + 8 + 8 * k));
    rules.max_cutter_size = read_f64(at + 56);
    if (!(rules.max_cutter_size > 0)) return damage.report(section.type(), "its largest cutter has no length");

    std::uint64_t left = section.count() - kRulesBytes;
    if (hardness > left / 8) return damage.report(section.type(), "ends before the hardness of its materials");
    left -= 8 * hardness;
    if (zones > left / kZoneBytes) return damage.report(section.type(), "ends before its zones");
    left -= kZoneBytes * zones;
    const std::byte* const of_materials = at + kRulesBytes;
    const std::byte* const of_zones = of_materials + 8 * hardness;
    Texts names({of_zones + kZoneBytes * zones, std::size_t(left)});
    for (std::size_t k = 0; k < hardness; ++k) rules.hardness.push_back(hardness_of(read_f64(of_materials + 8 * k)));
    for (std::size_t k = 0; k < zones; ++k) {
        rules.zones.push_back(zone_at(of_zones + kZoneBytes * k));
        if (!names.take(read_u64(of_zones + kZoneBytes * k + 56), rules.zones.back().name))
            return damage.report(section.type(), k, "ends before its name");
    }
    if (!names.all_taken()) return damage.report(section.type(), "has bytes behind its last name");
    std::erase_if(rules.zones, [](const CarveZone& zone) { return !holds_points(zone.box); });
    if (merge && merge->count() > 0) {
        rules.merge_share = read_f64(merge->at(0));
        if (merge->count() != 1 || !is_merge_share(rules.merge_share))
            return damage.report(merge->type(), "is no share of walls");
    }
    if (open_faces && open_faces->count() > 0) {
        rules.open_faces = false;
        if (open_faces->count() != 1 || read_u32(open_faces->at(0)) != 0)
            return damage.report(open_faces->type(), "does not say that faces which bound nothing stay");
    }
    unpacked.world.rules = std::make_shared<const CarveRules>(std::move(rules));
    return true;
}

/// Facets of walls whose exact form was left away are not cut: nothing would be behind a hole in them.
void keep_open_faces(UnpackedData& unpacked) {
    CarveRules rules = unpacked.world.rules ? *unpacked.world.rules : CarveRules{};
    rules.open_faces = false;
    unpacked.world.rules = std::make_shared<const CarveRules>(std::move(rules));
}

}  // namespace

UnpackedData unpack_data(Sections& sections, Damage& damage) {
    UnpackedData unpacked;
    const Entries world = sections.entries(kWorldSection, kWorldBytes);
    const Entries materials = sections.entries(kMaterialsSection, 1);
    if (damage.error() || !unpack_counters(world, unpacked, damage) || !unpack_materials(materials, unpacked, damage))
        return unpacked;
    if (!unpacked.world.rules) {
        if (!unpacked.exact) keep_open_faces(unpacked);
        return unpacked;
    }
    const Entries rules = sections.entries(kRulesSection, 1);
    std::optional<Entries> merge;
    if (sections.has(kMergeSection)) merge = sections.entries(kMergeSection, 8);
    std::optional<Entries> open_faces;
    if (sections.has(kOpenFacesSection)) open_faces = sections.entries(kOpenFacesSection, 4);
    if (!damage.error())
        unpack_rules(rules, merge ? &*merge : nullptr, open_faces ? &*open_faces : nullptr, unpacked, damage);
    if (!unpacked.exact && !damage.error()) keep_open_faces(unpacked);
    return unpacked;
}

}  // namespace firma
