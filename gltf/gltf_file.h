// SPDX-License-Identifier: MIT
// A glTF file taken apart: what tinygltf makes of its JSON, and the bytes of its buffers.
#pragma once

#include <tiny_gltf.h>

#include <cstddef>
#include <span>
#include <string>

#include "firma/result.h"
#include "gltf/buffer_bytes.h"
#include "gltf/slim_json.h"

namespace firma::gltf {

struct GltfFile {
    std::string name;
    tinygltf::Model model;  ///< without buffers and images; nothing says yet that its indices name anything
    SlimJson rest;
    Buffers buffers;
};

/// @param bytes  must outlive what comes back
Result<GltfFile> open_gltf(std::span<const std::byte> bytes, const std::string& name, const std::string& folder);

}  // namespace firma::gltf
