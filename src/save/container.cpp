// SPDX-License-Identifier: MIT
// The outer form of a .firma file.
//
// Head: magic (8 bytes), version, number of sections (u32 each), bytes of the file (u64), 0 (u32), checksum of all that
// and of the table (u32). Table entry: type, flags (u32), place, length (u64), checksum, 0 (u32). Sections follow
// without gaps, but that each is filled up with zeros to a multiple of 8.
#include "save/container.h"

#include <algorithm>
#include <array>

#include "firma/save.h"
#include "save/crc32c.h"

namespace firma {
namespace {

/// What text mode does to a file shows in its line end and its end mark.
constexpr std::array<unsigned char, 8> kMagic{'F', 'I', 'R', 'M', 'A', '\r', '\n', 0x1A};
constexpr std::size_t kChecksumAt = 28;  // in the head

std::uint64_t filled_up(std::uint64_t length) {
    return (length + 7) & ~std::uint64_t(7);
}

/// Of the head up to its own place, and the table.
std::uint32_t checksum_of_table(std::span<const std::byte> bytes, std::size_t sections) {
    return crc32c(bytes.subspan(kHeadBytes, sections * kTableEntryBytes), crc32c(bytes.first(kChecksumAt)));
}

void append(std::vector<std::byte>& bytes, const std::vector<std::byte>& more) {
    bytes.insert(bytes.end(), more.begin(), more.end());
    bytes.resize(filled_up(bytes.size()));
}

class ContainerReader {
public:
    ContainerReader(std::span<const std::byte> bytes, const std::string& name) : bytes_(bytes), name_(name) {}

    Result<std::vector<Section>> read() {
        if (std::optional<Error> error = check_head()) return *error;
        std::vector<Section> sections;
        std::uint64_t place = kHeadBytes + count_ * kTableEntryBytes;
        for (std::size_t k = 0; k < count_; ++k) {
            const std::byte* entry = bytes_.data() + kHeadBytes + k * kTableEntryBytes;
            Section section{read_u32(entry), read_u32(entry + 4), {}};
            if (read_u64(entry + 8) != place) return fault(section, "does not begin where the one before ends");
            const std::uint64_t length = read_u64(entry + 16);
            if (length > bytes_.size() - place || filled_up(length) > bytes_.size() - place)
                return fault(section, "reaches beyond the end of the file");
            section.bytes = bytes_.subspan(std::size_t(place), std::size_t(length));
            if (crc32c(section.bytes) != read_u32(entry + 24)) return fault(section, "is damaged: wrong checksum");
            if (read_u32(entry + 28) != 0) return fault(section, "has an entry in the table that means nothing");
            place += length;
            for (; place % 8 != 0; ++place)
                if (bytes_[std::size_t(place)] != std::byte(0)) return fault(section, "is followed by no zero");
            const auto same = [&](const Section& other) { return other.type == section.type; };
            if (std::any_of(sections.begin(), sections.end(), same)) return fault(section, "is there twice");
            sections.push_back(section);
        }
        if (place != bytes_.size()) return fault("bytes behind the last section");
        return sections;
    }

private:
    Error fault(const char* reason) const { return {ErrorCode::kMalformed, name_, reason}; }
    Error fault(const Section& section, const char* reason) const {
        return {ErrorCode::kMalformed, name_ + ": section " + section_name(section.type), reason};
    }

    std::optional<Error> check_head() {
        if (!is_firma_file(bytes_)) return fault("it does not begin as a .firma file does");
        if (bytes_.size() < kHeadBytes) return fault("it ends within its head");
        const std::uint32_t version = read_u32(bytes_.data() + 8);
        if (version < 1 || version > kFirmaFileVersion)
            return Error{
                ErrorCode::kUnsupported, name_,
                "it is of version " + std::to_string(version) + " of the format; this Firma reads versions 1 to 3"};
        count_ = read_u32(bytes_.data() + 12);
        if (count_ > (bytes_.size() - kHeadBytes) / kTableEntryBytes)
            return fault("it ends within its table of sections");
        if (checksum_of_table(bytes_, count_) != read_u32(bytes_.data() + kChecksumAt))
            return fault("its head or its table of sections is damaged: wrong checksum");
        if (read_u32(bytes_.data() + 24) != 0) return fault("its head is not as a .firma file's");
        if (read_u64(bytes_.data() + 16) != bytes_.size())
            return fault("it is not as long as its head says: cut short, or something was added");
        return {};
    }

    const std::span<const std::byte> bytes_;
    const std::string& name_;
    std::size_t count_ = 0;
};

}  // namespace

std::string section_name(SectionType type) {
    constexpr char kDigits[] = "0123456789abcdef";
    std::string letters, digits = "0x";
    for (int k = 0; k < 4; ++k) letters += char(type >> 8 * k & 255);
    for (int k = 7; k >= 0; --k) digits += kDigits[type >> 4 * k & 15];
    const bool plain = std::all_of(letters.begin(), letters.end(), [](char c) { return c > ' ' && c < 127; });
    return plain ? letters : digits;
}

std::vector<std::byte> write_container(std::span<const NewSection> sections) {
    std::uint64_t place = kHeadBytes + sections.size() * kTableEntryBytes;
    ByteWriter table;
    for (const NewSection& section : sections) {
        table.u32(section.type);
        table.u32(section.flags);
        table.u64(place);
        table.u64(section.content.size());
        table.u32(crc32c(section.content.bytes()));
        table.u32(0);
        place += filled_up(section.content.size());
    }
    ByteWriter head;
    for (const unsigned char letter : kMagic) head.u8(letter);
    head.u32(kFirmaFileVersion);
    head.u32(std::uint32_t(sections.size()));
    head.u64(place);
    head.u32(0);
    head.u32(crc32c(table.bytes(), crc32c(head.bytes())));

    std::vector<std::byte> bytes;
    bytes.reserve(std::size_t(place));
    append(bytes, head.bytes());
    append(bytes, table.bytes());
    for (const NewSection& section : sections) append(bytes, section.content.bytes());
    return bytes;
}

Result<std::vector<Section>> read_container(std::span<const std::byte> bytes, const std::string& name) {
    return ContainerReader(bytes, name).read();
}

std::uint32_t version_of_container(std::span<const std::byte> bytes) {
    return read_u32(bytes.data() + 8);
}

bool is_firma_file(std::span<const std::byte> bytes) {
    return bytes.size() >= kMagic.size() &&
           std::equal(kMagic.begin(), kMagic.end(), bytes.begin(),
                      [](unsigned char letter, std::byte byte) { return std::byte(letter) == byte; });
}

}  // namespace firma
