// SPDX-License-Identifier: MIT
// The demo's fire fight: runs it, judges each frame, tells figures and draws.
#pragma once

#include <string>

#include "cli/load_level.h"

namespace firma::cli {

/// As typed.
struct FightArguments {
    LevelArguments level;
    std::string frames;  ///< a folder for pictures; empty: none
    std::string seconds, seed;
    bool json = false;
};

/// @return the exit code: 0, or 1 where something did not hold
/// @throws Failure for bad input
int run_fight(const FightArguments& arguments);

}  // namespace firma::cli
