// SPDX-License-Identifier: MIT
// The bytes of a file, and what its name says about them.
#pragma once

#include <cstdint>
#include <string>

#include "firma/result.h"

namespace firma {

/// The whole of a file.
/// @return kCannotRead with the system's reason: missing, a folder, not allowed, broken off; kTooLarge beyond 4 GiB
Result<std::string> read_file(const std::string& path);

enum class LevelFormat : std::uint8_t { kObj, kBsp, kMap };

/// By what stands behind the last point of the name, capitals or not.
/// @return kUnsupported for other endings, naming those that there are
Result<LevelFormat> level_format(const std::string& path);
/// The endings that there are, for messages: ".obj, .bsp".
std::string level_endings();

}  // namespace firma
