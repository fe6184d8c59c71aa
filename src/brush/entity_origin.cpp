// SPDX-License-Identifier: MIT
// Reads an entity's place.
#include <algorithm>
#include <string_view>

#include "firma/brush_level.h"
#include "level/parse_number.h"

namespace firma {

std::optional<Vec3> entity_origin(const BrushLevel& level, const Entity& entity) {
    std::string_view text = entity.value("origin");
    Vec3 place;
    for (int axis = 0; axis < 3; ++axis) {
        text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
        const std::string_view word = text.substr(0, text.find(' '));
        const std::optional<double> number = parse_number(word);
        if (!number) return std::nullopt;
        place[axis] = *number;
        text.remove_prefix(word.size());
    }
    if (text.find_first_not_of(' ') != std::string_view::npos) return std::nullopt;
    return place * level.metres_a_unit;
}

}  // namespace firma
