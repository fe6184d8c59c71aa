// SPDX-License-Identifier: MIT
// The sections of lists of faces and of patches, beside those of .firma files. docs/edit_log.md says what is in them.
#pragma once

#include <span>
#include <vector>

#include "save/sections.h"
#include "solid/block.h"
#include "world/world_data.h"

namespace firma {

/// Hashes of the world and of its cells.
inline constexpr SectionType kListSection = section_type("LIST");
inline constexpr SectionType kListRegionsSection = section_type("LREG");
inline constexpr SectionType kListFacesSection = section_type("LFAC");
/// Version of the format, flags, hashes of the world before and after.
inline constexpr SectionType kPatchSection = section_type("PTCH");
inline constexpr SectionType kPatchRegionsSection = section_type("PREG");
inline constexpr SectionType kPatchRemovedSection = section_type("PREM");
inline constexpr SectionType kPatchImportsSection = section_type("PIMP");

inline constexpr SectionType kSectionsOfLists[] = {kListSection, kListRegionsSection, kListFacesSection};
inline constexpr SectionType kSectionsOfPatches[] = {kPatchSection, kPatchRegionsSection, kPatchRemovedSection,
                                                     kPatchImportsSection};

inline constexpr std::size_t kListBytes = 16;
inline constexpr std::size_t kListFaceBytes = 12;
inline constexpr std::size_t kPatchBytes = 24;
inline constexpr std::size_t kImportBytes = 24;
inline constexpr std::uint32_t kPatchVersion = 1;
inline constexpr std::uint32_t kPatchHasCells = 1;
inline constexpr std::uint32_t kPatchNoAnchors = 2;  ///< of the world that it makes; else they stay, or are a section

/// What differs only where rooms and portals do.
std::uint64_t hash_cells(const Cells& cells);

/// The facets of some regions, of the solid and castable only, by id.
std::vector<FacetPlace> facets_in(const WorldData& data, std::span<const Region> regions);

/// Of a facet and its room: what lists compare.
std::uint64_t hash_listed(const WorldData& data, const FacetPlace& facet);

/// A face whose objects those of a patch share: a facet of it, where that begins, the hash of its exact form.
struct PatchImport {
    FaceId id;
    GridPoint corner;
    std::uint64_t hash = 0;
};

void put_regions(ByteWriter& out, std::span<const Region> regions);
Region region_at(const std::byte* at);

}  // namespace firma
