// SPDX-License-Identifier: MIT
// A sphere that bounces about a closed room, as rows of places.
#pragma once

#include "cli/verb.h"

namespace firma::cli {

Verb add_walk(CLI::App& app);

}  // namespace firma::cli
