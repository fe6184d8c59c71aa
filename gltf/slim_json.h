// SPDX-License-Identifier: MIT
// The JSON of a glTF file, judged and cut down to what is read, before tinygltf sees it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "firma/result.h"

namespace firma::gltf {

using Extras = std::vector<std::pair<std::string, std::string>>;

struct SlimJson {
    struct Buffer {
        std::optional<std::string> uri;
        std::uint64_t length = 0;
    };

    /// For tinygltf: accessors, buffer views, meshes, nodes, scenes, materials; of those only what is read, every
    /// member of the type that the format says. tinygltf itself ignores what it does not understand, wraps large
    /// integers, and follows images wherever they point.
    std::string json;
    std::vector<Buffer> buffers;
    std::vector<Extras> node_extras;   ///< of each node
    std::vector<bool> cut_materials;   ///< of each material: `extras.cut`, which write_glb() leaves
    std::vector<std::string> matters;  ///< of each material: `extras.matter`, or `extras.material`; "" without
    std::size_t skins = 0, animations = 0, cameras = 0;
    std::size_t morphs = 0;  ///< primitives with morph targets
    bool gpu_instances = false;
};

/// @return kMalformed with the line where the JSON breaks, or with the entry and member of another type than the format
///         says; kUnsupported for another version than 2.0 and for extensions that must be understood; kTooLarge
Result<SlimJson> slim_json(std::string_view text, const std::string& name);

}  // namespace firma::gltf
