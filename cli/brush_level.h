// SPDX-License-Identifier: MIT
// What `firma info` and `firma check` tell of a level of brushes.
#pragma once

#include <string>

#include "cli/load_level.h"

namespace firma::cli {

/// @param loaded  with brushes
/// @return the exit code: 0
int tell_brushes(const LoadedLevel& loaded, bool json);

struct CheckBrushes {
    bool json = false;
    bool all = false;  ///< every note, not only the first 20
    std::string pts;   ///< where a leak is written to; empty: nowhere
};

/// @return 0 when sound, 1 when not
int check_brushes(const LoadedLevel& loaded, const CheckBrushes& how);

}  // namespace firma::cli
