// SPDX-License-Identifier: MIT
// What readers of Quake's formats judge alike: options and points.
#pragma once

#include <optional>
#include <string>

#include "firma/level.h"
#include "firma/vec.h"

namespace firma {

inline constexpr double kQuakeUnit = 1.0 / 32;  ///< metres, unless the options say otherwise

/// kInvalid for options that make no sense.
std::optional<Error> judge_options(const ReadOptions& options, const std::string& name);

/// Why the snap refused a point (in the file's units): "y is nan", or "lies outside the world: x = 8192 m".
std::string point_fault(const Vec3& position, double scale);

}  // namespace firma
