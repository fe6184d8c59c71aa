// SPDX-License-Identifier: MIT
// JSON by nlohmann, as --json prints it: one object, its keys in the order in which they were given.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "firma/vec.h"

namespace firma {

/// [x, y, z]. In the namespace of Vec3, where nlohmann looks for it.
inline void to_json(nlohmann::ordered_json& json, const Vec3& point) {
    json = {point.x, point.y, point.z};
}

namespace cli {

using Json = nlohmann::ordered_json;

/// One value over several lines, with a line feed at its end. Numbers have the fewest digits that are read as the same
/// double; whole ones have no point; what is not finite becomes null. Bytes that are not UTF-8 (names of files may hold
/// any) become U+FFFD.
std::string json_text(Json json);

}  // namespace cli
}  // namespace firma
