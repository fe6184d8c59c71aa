// SPDX-License-Identifier: MIT
// Takes a glTF file apart.
#include "gltf/gltf_file.h"

#include <utility>

#include "gltf/glb_chunks.h"

namespace firma::gltf {
namespace {

/// Its first line, shortened.
std::string words_of(const std::string& text) {
    const std::string line = text.substr(0, text.find('\n'));
    return line.empty() ? "is not understood" : line.size() > 120 ? line.substr(0, 120) + "..." : line;
}

}  // namespace

Result<GltfFile> open_gltf(std::span<const std::byte> bytes, const std::string& name, const std::string& folder) {
    const Result<GlbChunks> chunks = split_glb(bytes, name);
    if (!chunks) return chunks.error();
    Result<SlimJson> slim = slim_json(chunks.value().json, name);
    if (!slim) return slim.error();

    GltfFile file{name, {}, std::move(slim).value(), Buffers(chunks.value(), name, folder)};
    for (const SlimJson::Buffer& buffer : file.rest.buffers)
        if (std::optional<Error> error = file.buffers.add(buffer.uri, buffer.length)) return *error;
    file.rest.buffers.clear();

    std::string errors, warnings;
    const std::string& json = file.rest.json;
    const bool parsed = tinygltf::TinyGLTF().LoadASCIIFromString(&file.model, &errors, &warnings, json.data(),
                                                                 unsigned(json.size()), "");
    if (!parsed || !errors.empty()) return Error{ErrorCode::kMalformed, name, words_of(errors)};
    file.rest.json.clear();
    return file;
}

}  // namespace firma::gltf
