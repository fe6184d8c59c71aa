// SPDX-License-Identifier: MIT
// Tells text from other bytes: names of files may hold any.
#pragma once

#include <cstddef>
#include <string_view>

namespace firma::debug {

/// Bytes of the well-formed UTF-8 character that `text` begins with, or 0.
std::size_t utf8_length(std::string_view text);

}  // namespace firma::debug
