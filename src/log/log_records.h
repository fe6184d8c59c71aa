// SPDX-License-Identifier: MIT
// The outer form of a log: a head, records, an end with a checksum. docs/edit_log.md says what stands where.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace firma {

/// What text mode does to a file shows in its line end and its end mark.
inline constexpr std::array<unsigned char, 8> kLogMagic{'F', 'I', 'R', 'M', 'L', '\r', '\n', 0x1A};
/// Magic, version, hashes of the level and its rules, its edits.
inline constexpr std::size_t kLogHeadBytes = 8 + 4 + 8 + 8 + 4;

/// Each but the end has its length behind it.
enum class LogRecord : std::uint8_t {
    kEnd = 0,         ///< a checksum of all bytes before the checksum, and nothing after it
    kCutter = 1,      ///< one that commands after it name by its number, in order
    kCommand = 2,     ///< as put_command()
    kCheckpoint = 3,  ///< hash_world() of the world after the commands before it
    kPatch = 4,       ///< first of all: the number of the last edit it stands for, and the patch
};
/// Records with this bit may be passed over by who does not know them.
inline constexpr std::uint8_t kOptionalRecord = 128;

}  // namespace firma
