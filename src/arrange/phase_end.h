// SPDX-License-Identifier: MIT
// How a step of an arrangement's phase ends.
#pragma once

#include <cstdint>

namespace firma {

enum class PhaseEnd : std::uint8_t {
    kGoesOn,     ///< call it again
    kDone,       ///< all of it is done
    kBroken,     ///< a solid crosses itself
    kUnlocated,  ///< a part that meets nothing lies where nobody could tell
};

}  // namespace firma
