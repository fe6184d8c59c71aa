// SPDX-License-Identifier: MIT
// Casts a file of queries through a level.
#pragma once

#include "cli/verb.h"

namespace firma::cli {

Verb add_cast(CLI::App& app);

}  // namespace firma::cli
