// SPDX-License-Identifier: MIT
// What `firma info` and `firma check` tell of a .firma file, which holds a world and not a level.
#pragma once

#include "cli/load_level.h"

namespace firma::cli {

/// @return the exit code; so with the other
int tell_saved_world(const LoadedLevel& loaded, bool json);

int check_saved_world(const LoadedLevel& loaded, bool json);

}  // namespace firma::cli
