// SPDX-License-Identifier: MIT
// Splits a .glb. Not by tinygltf, which reads eight bytes too far where the last chunk is cut short.
// Source: Khronos Group, glTF 2.0 Specification, 2021, section 4.4.
#include "gltf/glb_chunks.h"

#include <cstdint>

namespace firma::gltf {
namespace {

constexpr std::uint32_t kMagic = 0x46546C67, kJson = 0x4E4F534A, kBin = 0x004E4942;

std::uint32_t number_at(std::span<const std::byte> bytes, std::size_t at) {
    std::uint32_t number = 0;
    for (std::size_t k = 4; k-- > 0;) number = number << 8 | std::to_integer<std::uint32_t>(bytes[at + k]);
    return number;
}

std::string_view text_of(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

Result<GlbChunks> split_glb(std::span<const std::byte> bytes, const std::string& name) {
    GlbChunks chunks;
    if (bytes.size() < 4 || number_at(bytes, 0) != kMagic) {
        chunks.json = text_of(bytes);
        return chunks;
    }
    const auto malformed = [&](std::string reason) { return Error{ErrorCode::kMalformed, name, std::move(reason)}; };
    if (bytes.size() < 20) return malformed("ends within its head");
    if (const std::uint32_t version = number_at(bytes, 4); version != 2)
        return Error{ErrorCode::kUnsupported, name, "is a .glb of version " + std::to_string(version) + "; 2 is read"};
    if (number_at(bytes, 8) != bytes.size())
        return malformed("says that it has " + std::to_string(number_at(bytes, 8)) + " bytes, and has " +
                         std::to_string(bytes.size()));
    for (std::size_t at = 12, chunk = 0; at < bytes.size(); ++chunk) {
        const std::string place = "chunk " + std::to_string(chunk);
        if (bytes.size() - at < 8) return malformed(place + " ends within its head");
        const std::size_t length = number_at(bytes, at);
        const std::uint32_t type = number_at(bytes, at + 4);
        at += 8;
        if (length > bytes.size() - at) return malformed(place + " reaches beyond the file");
        const std::span<const std::byte> content = bytes.subspan(at, length);
        if (chunk == 0) {
            if (type != kJson) return malformed("its first chunk is not JSON");
            chunks.json = text_of(content);
        } else if (chunk == 1 && type == kBin) {
            chunks.bin = content;
            chunks.has_bin = true;
        }
        at += length;
    }
    return chunks;
}

}  // namespace firma::gltf
