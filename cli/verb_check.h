// SPDX-License-Identifier: MIT
// What is wrong with a level, and where.
#pragma once

#include "cli/verb.h"

namespace firma::cli {

Verb add_check(CLI::App& app);

}  // namespace firma::cli
