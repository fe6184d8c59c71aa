// SPDX-License-Identifier: MIT
// Patches changed on purpose, beyond what checksums and counts tell: entries of sections replaced, exchanged, taken
// out; sections of other patches; lists of faces that lie about some of them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <span>
#include <utility>
#include <vector>

#include "firma/world_patch.h"
#include "save/patch_sections.h"
#include "scenes/rng.h"
#include "tests/save/saved_worlds.h"

namespace firma {

struct ChangedSection {
    SectionType type = 0;
    std::vector<std::byte> bytes;
};

inline std::vector<ChangedSection> sections_of(std::span<const std::byte> bytes) {
    std::vector<ChangedSection> sections;
    for (const SectionPlace& place : section_places(bytes)) {
        const auto content = bytes.subspan(place.first, place.length);
        sections.push_back({place.type, {content.begin(), content.end()}});
    }
    return sections;
}

inline std::vector<std::byte> file_of(std::span<const ChangedSection> sections) {
    std::vector<NewSection> all;
    for (const ChangedSection& section : sections) {
        all.push_back({section.type, kRequiredSection, {}});
        for (const std::byte byte : section.bytes) all.back().content.u8(std::uint8_t(byte));
    }
    return write_container(all);
}

inline std::size_t entry_bytes(SectionType type) {
    const std::pair<SectionType, std::size_t> sizes[] = {
        {kPatchImportsSection, kImportBytes},  {kFacesSection, kFaceBytes},         {kVerticesSection, kPointBytes},
        {kPortalCornersSection, kPointBytes},  {kPatchRegionsSection, kPointBytes}, {kPlanesSection, kPlaneBytes},
        {kGridPointsSection, kPointBytes},     {kMeetPointsSection, kPointBytes},   {kEdgesSection, kEdgeBytes},
        {kExactFacesSection, kExactFaceBytes}, {kWorldSection, kWorldBytes},        {kPortalsSection, kPortalBytes}};
    for (const auto& [known, size] : sizes)
        if (known == type) return size;
    return 4;
}

/// One change to one section. What is wrong with it may be seen by the reader, by what judges worlds, or not at all.
inline void change_patch(std::vector<ChangedSection>& sections, scenes::Rng& rng) {
    const auto below = [&](std::size_t count) { return std::size_t(rng.next() % count); };
    ChangedSection& section = sections[below(sections.size())];
    if (section.type == kPatchSection || section.type == kMaterialsSection) return;
    const std::size_t size = entry_bytes(section.type), count = section.bytes.size() / size;
    if (count == 0) return;
    std::byte* const entry = section.bytes.data() + size * below(count);
    std::byte* const other = section.bytes.data() + size * below(count);
    const std::size_t at = 4 * below(size / 4);
    const auto value = [&](std::int64_t step) {
        const auto changed = std::uint32_t(read_u32(entry + at) + std::uint64_t(step));
        std::memcpy(entry + at, &changed, 4);
    };
    switch (below(8)) {
        case 0:  // a number as another entry has it
            std::memcpy(entry + at, other + at, 4);
            break;
        case 1:
            value(rng.next() % 2 ? 1 : -1);
            break;
        case 2:  // a step of the input grid, or several
            value((rng.next() % 2 ? 64 : -64) * std::int64_t(1 + below(64)));
            break;
        case 3:
            std::swap_ranges(entry, entry + size, other);
            break;
        case 4:
            std::copy_n(other, size, entry);
            break;
        case 5:
            section.bytes.erase(section.bytes.begin() + (entry - section.bytes.data()),
                                section.bytes.begin() + (entry - section.bytes.data()) + std::ptrdiff_t(size));
            break;
        case 6:  // two neighbours change places
            if (entry + 2 * size <= section.bytes.data() + section.bytes.size())
                std::swap_ranges(entry, entry + size, entry + size);
            break;
        default:
            value(std::int64_t(std::uint64_t(1) << below(32)));
    }
}

/// A list of what one world has, that says of some faces that they are as in the other, and leaves some out.
inline std::vector<std::byte> lying_list(const World& mine, const World& other, scenes::Rng& rng, std::size_t lies) {
    const std::vector<Region> regions = differing_regions(hash_regions(mine), hash_regions(other));
    std::vector<ChangedSection> sections = sections_of(list_faces(mine, regions));
    const std::vector<FacetPlace> theirs = facets_in(other.data(), regions);
    for (ChangedSection& section : sections) {
        if (section.type != kListFacesSection || section.bytes.empty() || theirs.empty()) continue;
        for (std::size_t k = 0; k < lies; ++k) {
            const FacetPlace& facet = theirs[std::size_t(rng.next() % theirs.size())];
            const std::uint32_t id = facet.record().id.value;
            std::vector<std::byte> entry(kListFaceBytes);
            const std::uint64_t hash = hash_listed(other.data(), facet);
            std::memcpy(entry.data(), &id, 4);
            std::memcpy(entry.data() + 4, &hash, 8);
            std::size_t at = 0;
            while (at < section.bytes.size() && read_u32(section.bytes.data() + at) < id) at += kListFaceBytes;
            const auto place = section.bytes.begin() + std::ptrdiff_t(at);
            const bool there = at < section.bytes.size() && read_u32(section.bytes.data() + at) == id;
            if (there && rng.next() % 2)
                section.bytes.erase(place, place + std::ptrdiff_t(kListFaceBytes));
            else if (there)
                std::copy(entry.begin(), entry.end(), place);
            else
                section.bytes.insert(place, entry.begin(), entry.end());
        }
    }
    return file_of(sections);
}

}  // namespace firma
