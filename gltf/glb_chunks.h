// SPDX-License-Identifier: MIT
// The two forms of a glTF file: text alone, or a .glb that holds the text and a buffer.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "firma/result.h"

namespace firma::gltf {

struct GlbChunks {
    std::string_view json;
    std::span<const std::byte> bin;  ///< empty where there is none
    bool has_bin = false;
};

/// Told apart by the first four bytes, whatever the name. Chunks of other types are passed over, as the format says.
/// @return kMalformed for lengths that do not fit, kUnsupported for another version of the container
Result<GlbChunks> split_glb(std::span<const std::byte> bytes, const std::string& name);

}  // namespace firma::gltf
