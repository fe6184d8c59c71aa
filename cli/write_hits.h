// SPDX-License-Identifier: MIT
// Hits of `firma cast`, a row each.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "firma/world.h"

namespace firma::cli {

inline constexpr std::string_view kHitsHeader =
    "query,status,fraction,safe_fraction,cx,cy,cz,px,py,pz,nx,ny,nz,fnx,fny,fnz,face,feature,room\n";

std::string_view status_name(Status status);
std::string_view feature_name(Feature feature);

/// Appends the row of a query (counted from 0), with what the world that was asked knows of the face: numbers with 17
/// significant digits, nothing behind the status of a miss.
void append_hit(std::string& out, std::size_t query, const World& world, const Hit& hit);

}  // namespace firma::cli
