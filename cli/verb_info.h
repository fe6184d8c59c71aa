// SPDX-License-Identifier: MIT
// What a level is: faces, bounds, tree, bytes, times.
#pragma once

#include "cli/verb.h"

namespace firma::cli {

Verb add_info(CLI::App& app);

}  // namespace firma::cli
