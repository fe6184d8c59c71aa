// SPDX-License-Identifier: MIT
// The outer form of a .firma file: a head, a table of sections, the sections, each with a checksum. Knows nothing of
// what is in them. docs/formats.md says what stands where.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "firma/result.h"
#include "firma/save.h"
#include "save/little_endian.h"

namespace firma {

/// Four letters, the first in the lowest byte.
using SectionType = std::uint32_t;
constexpr SectionType section_type(const char (&letters)[5]) {
    SectionType type = 0;
    for (int k = 0; k < 4; ++k) type |= SectionType(static_cast<unsigned char>(letters[k])) << 8 * k;
    return type;
}
/// "BINS", or in hexadecimal where they are no letters.
std::string section_name(SectionType type);

inline constexpr std::size_t kHeadBytes = 32;
inline constexpr std::size_t kTableEntryBytes = 32;
inline constexpr std::uint32_t kRequiredSection =
    1;  ///< a flag in the table: who does not know it cannot read the file

struct NewSection {
    SectionType type = 0;
    std::uint32_t flags = kRequiredSection;
    ByteWriter content;
};

/// The bytes of a file of these sections, in this order.
std::vector<std::byte> write_container(std::span<const NewSection> sections, std::uint32_t version = kFirmaFileVersion);

struct Section {
    SectionType type = 0;
    std::uint32_t flags = 0;
    std::span<const std::byte> bytes;

    bool required() const { return flags & kRequiredSection; }
};

/// All sections, in the file's order; each type at most once; views into the bytes given.
/// @return the first thing that is wrong, with its place: magic, version, sizes, places that overlap or leave gaps,
///         checksums
Result<std::vector<Section>> read_container(std::span<const std::byte> bytes, const std::string& name);

/// Of bytes that read_container() took: 1 to kFirmaFileVersion.
std::uint32_t version_of_container(std::span<const std::byte> bytes);

}  // namespace firma
