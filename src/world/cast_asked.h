// SPDX-License-Identifier: MIT
// cast() and cast_any() of what a batch asks.
#pragma once

#include "firma/queries.h"
#include "world/movers.h"

namespace firma {

Hit cast_asked(const World& world, const Asked& asked, const CastOptions& options);
Status cast_any_asked(const World& world, const Asked& asked, const CastOptions& options);

}  // namespace firma
