// SPDX-License-Identifier: MIT
// A level of nothing would make a world that answers every cast with a miss, and says nothing.
#pragma once

#include <span>
#include <string>

#include "firma/level.h"
#include "firma/result.h"

namespace firma {

/// kMalformed: "no face is left that a cast could meet; DETAIL; left out: WHAT: COUNT; ..."
///
/// @param detail  of the level's kind; may be empty
Error nothing_left(const std::string& name, const std::string& detail, std::span<const Omission> left_out);

}  // namespace firma
