// SPDX-License-Identifier: MIT
// Numbers of the surface grid as exact decimals.
#pragma once

#include <cstdint>
#include <string>

namespace firma {

/// Metres of a count of surface steps (1/262144 m), with all its digits and none to spare: at most 18 behind the point.
std::string exact_decimal(std::int32_t steps);

}  // namespace firma
