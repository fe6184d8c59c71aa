// SPDX-License-Identifier: MIT
// Shows that it works: casts in our level, checked and drawn.
#pragma once

#include "cli/verb.h"

namespace firma::cli {

Verb add_demo(CLI::App& app);

}  // namespace firma::cli
