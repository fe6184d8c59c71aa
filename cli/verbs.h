// SPDX-License-Identifier: MIT
// The verbs of the command line, one file each: verb_info.cpp and its like.
#pragma once

#include "cli/verb.h"

namespace firma::cli {

/// What a level is: faces, bounds, tree, bytes, times.
Verb add_info(CLI::App& app);
/// What is wrong with a level, and where.
Verb add_check(CLI::App& app);
/// Casts a file of queries through a level.
Verb add_cast(CLI::App& app);
/// Craters from a csv file, and the level after them.
Verb add_carve(CLI::App& app);
/// What an edit log says; whether it holds; the level after it.
Verb add_log(CLI::App& app);
/// A sphere that bounces about a closed room, as rows of places.
Verb add_walk(CLI::App& app);
/// A plan and a section of a level, with casts, as SVG; or a view of it, as PNG.
Verb add_draw(CLI::App& app);
/// Steps a game by a script and records it.
Verb add_simulate(CLI::App& app);
/// Steps a recorded game again and compares it.
Verb add_replay(CLI::App& app);
/// A folder over HTTP on this machine, for the playground.
Verb add_serve(CLI::App& app);
/// Shows that it works: casts in our level, checked and drawn.
Verb add_demo(CLI::App& app);

}  // namespace firma::cli
