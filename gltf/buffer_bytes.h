// SPDX-License-Identifier: MIT
// Where a glTF buffer's bytes come from: the .glb's chunk, a data URI, a file beside it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "firma/result.h"
#include "gltf/glb_chunks.h"

namespace firma::gltf {

/// The buffers of one file, in order.
class Buffers {
public:
    /// @param folder  of files, with the slash behind it; empty: none may be named
    Buffers(const GlbChunks& chunks, std::string name, std::string folder)
        : chunks_(chunks), name_(std::move(name)), folder_(std::move(folder)) {}

    /// Adds the next buffer.
    /// @param uri     nothing: the .glb's chunk, which only the first buffer may be
    /// @param length  that the file says it has
    std::optional<Error> add(const std::optional<std::string_view>& uri, std::uint64_t length);

    const std::vector<std::span<const std::byte>>& list() const { return list_; }

private:
    Error fail(ErrorCode code, std::string reason) const;
    Result<std::span<const std::byte>> bytes_of(std::string_view uri);

    GlbChunks chunks_;
    std::string name_, folder_;
    std::vector<std::span<const std::byte>> list_;
    std::deque<std::string> held_;  ///< of those that are not in the file as they are; stays where it is
    std::uint64_t held_bytes_ = 0;
};

/// @return nothing where it is not base64: a letter that is none, a length that cannot be
std::optional<std::string> decode_base64(std::string_view text);

/// The path that a URI names below a folder, %-escapes resolved.
/// @return nothing where it names anything else: with a scheme, from the root, by "..", with control characters
std::optional<std::string> path_below(std::string_view uri);

}  // namespace firma::gltf
