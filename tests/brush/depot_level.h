// SPDX-License-Identifier: MIT
#pragma once

#include <fstream>
#include <iterator>
#include <string>

#include "firma/brush_level.h"

namespace firma::test {

inline BrushLevel depot_level() {
    std::ifstream file(FIRMA_ROOT "/levels/depot.map", std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    return read_map(text, "depot.map").value();
}

}  // namespace firma::test
