// SPDX-License-Identifier: MIT
// A folder over HTTP on this machine, for the playground.
#pragma once

#include "cli/verb.h"

namespace firma::cli {

Verb add_serve(CLI::App& app);

}  // namespace firma::cli
