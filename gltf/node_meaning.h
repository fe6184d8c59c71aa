// SPDX-License-Identifier: MIT
// What a node's name and extras say about its faces.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "gltf/slim_json.h"

namespace firma::gltf {

/// Nothing where the node does not say: then its parent's holds.
struct NodeMeaning {
    std::optional<bool> portal;
    std::optional<std::uint32_t> mask;
    std::optional<bool> part;
};

/// A portal by a name that begins with "portal", capitals or not, or by `firma_portal` or `portal` among the extras,
/// which may also deny it; a part that moves by `firma_part` or `part` likewise; a mask by `firma_mask` or `mask`:
/// words walk, shoot, see, liquid, sky, or none.
///
/// @param notes  gets a sentence for what is not understood; that is then as if it were not there
NodeMeaning meaning_of(std::string_view name, const Extras& extras, std::set<std::string>& notes);

}  // namespace firma::gltf
