// SPDX-License-Identifier: MIT
// Numbers in an entity's keys.
#pragma once

#include <algorithm>
#include <optional>
#include <string_view>

#include "firma/brush_level.h"
#include "level/parse_number.h"

namespace firma {

/// The numbers of a value with blanks between them, as many as there are up to three.
struct KeyNumbers {
    double number[3] = {0, 0, 0};
    int count = 0;  ///< 0 also where something is no finite number
};

inline KeyNumbers key_numbers(const Entity& entity, std::string_view key) {
    std::string_view text = entity.value(key);
    KeyNumbers found;
    while (found.count < 3) {
        text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
        if (text.empty()) break;
        const std::string_view word = text.substr(0, text.find(' '));
        const std::optional<double> number = parse_number(word);
        if (!number || !is_finite(*number)) return {};
        found.number[found.count++] = *number;
        text.remove_prefix(word.size());
    }
    return found;
}

inline double key_number(const Entity& entity, std::string_view key, double otherwise) {
    const KeyNumbers found = key_numbers(entity, key);
    return found.count > 0 ? found.number[0] : otherwise;
}

/// Bits of `spawnflags`.
inline std::uint32_t key_flags(const Entity& entity) {
    const double number = key_number(entity, "spawnflags", 0);
    return number >= 0 && number < 4294967296.0 ? std::uint32_t(number) : 0;
}

}  // namespace firma
