// SPDX-License-Identifier: MIT
// Words for errors about files: quoted pieces of them, numbers, and places.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "firma/level.h"
#include "firma/result.h"

namespace firma {

/// A piece of a file in quotes, for a message: at most 40 characters, those that are not printable ASCII as \xNN.
std::string quote(std::string_view text);

/// A double in the shortest form that reads back as itself.
std::string number_text(double value);

/// An error at a line of a file: "name:line".
Error error_at_line(ErrorCode code, std::string_view name, std::uint32_t line, std::string reason);

/// A level of nothing would make a world that answers every cast with a miss, and says nothing.
/// kMalformed: "no face is left that a cast could meet; DETAIL; left out: WHAT: COUNT; ..."
///
/// @param detail  of the level's kind; may be empty
Error nothing_left(const std::string& name, const std::string& detail, std::span<const Omission> left_out);

}  // namespace firma
