// SPDX-License-Identifier: MIT
// Words for errors about files: quoted pieces of them, numbers, and places.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "firma/result.h"

namespace firma {

/// A piece of a file in quotes, for a message: at most 40 characters, those that are not printable ASCII as \xNN.
std::string quote(std::string_view text);

/// A double in the shortest form that reads back as itself.
std::string number_text(double value);

/// An error at a line of a file: "name:line".
Error error_at_line(ErrorCode code, std::string_view name, std::uint32_t line, std::string reason);

}  // namespace firma
