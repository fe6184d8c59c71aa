// SPDX-License-Identifier: MIT
// firma carve: craters from a csv file, the level after them as an .obj.
#pragma once

#include "cli/verb.h"

namespace firma::cli {

Verb add_carve(CLI::App& app);

}  // namespace firma::cli
