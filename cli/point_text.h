// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <string>

#include "firma/vec.h"

namespace firma::cli {

/// "(1, 2.5, -3)"
inline std::string point_text(const Vec3& p) {
    return fmt::format("({}, {}, {})", p.x, p.y, p.z);
}

}  // namespace firma::cli
