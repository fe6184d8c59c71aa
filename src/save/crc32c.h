// SPDX-License-Identifier: MIT
// The checksum of .firma files: against accidents, not against malice.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace firma {

/// CRC-32C (Castagnoli: reflected, polynomial 0x1EDC6F41, from and to all ones), as in iSCSI, ext4 and others. Finds
/// every change of up to 32 bits in a row.
/// @param before  of the bytes before these, to go on with
std::uint32_t crc32c(std::span<const std::byte> bytes, std::uint32_t before = 0);

}  // namespace firma
