// SPDX-License-Identifier: MIT
// Reads what `firma cast` wrote, for drawing.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "cli/read_queries.h"
#include "draw/draw_casts.h"
#include "firma/hit.h"

namespace firma::cli {

/// A cast as a picture wants it.
draw::DrawnCast drawn(const Query& query, const PolygonHit& hit);

/// The hits of these queries, row by row.
/// @throws Failure naming file and line where a row is malformed, or is not the next query's
std::vector<draw::DrawnCast> read_hits(const std::string& path, std::span<const Query> queries);

}  // namespace firma::cli
