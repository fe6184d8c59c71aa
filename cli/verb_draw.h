// SPDX-License-Identifier: MIT
// A plan and a section of a level, with casts, as SVG.
#pragma once

#include "cli/verb.h"

namespace firma::cli {

Verb add_draw(CLI::App& app);

}  // namespace firma::cli
