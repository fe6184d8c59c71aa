// SPDX-License-Identifier: MIT
// The questions that the article leaves, each answered by measuring: a file for each.
#pragma once

#include "support/settings.h"

namespace firma::bench {

/// @return 0, or 1 where Firma was wrong or a table could not be written
int measure_formulas(const Settings& settings);
int measure_inside(const Settings& settings);
int measure_boxes(const Settings& settings);
int measure_edges(const Settings& settings);
int measure_tree(const Settings& settings);
int measure_subdivision(const Settings& settings);
int measure_stop_distance(const Settings& settings);

}  // namespace firma::bench
