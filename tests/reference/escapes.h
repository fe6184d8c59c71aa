// SPDX-License-Identifier: MIT
// Tries to get out of closed meshes.
#pragma once

#include <cstdint>
#include <string>

#include "scenes/closed_meshes.h"

namespace firma::reference {

struct EscapeTally {
    scenes::MeshKind kind = scenes::MeshKind::kBox;
    std::uint64_t casts = 0;
    std::uint64_t lost = 0;    ///< met nothing on the way from inside to far outside
    std::uint64_t judged = 0;  ///< of the casts, looked at by the oracle as well
    std::uint64_t wrong = 0;   ///< of those, in error
    std::string first_failure;

    void add(const EscapeTally& other);
};

inline constexpr std::uint64_t kEscapesAChunk = 2000;

/// One mesh and 2000 casts, three particles to a ball; one in 64 is also judged by the oracle.
EscapeTally try_escapes(std::uint64_t seed, std::uint64_t chunk);

}  // namespace firma::reference
