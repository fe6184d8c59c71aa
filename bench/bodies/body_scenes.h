// SPDX-License-Identifier: MIT
// Scenes of bodies: rubble where blasts leave it, bodies thrown through levels, stacks.
#pragma once

#include <string>
#include <vector>

#include "bodies/body_peer.h"

namespace firma::bench {

/// @param repository  where levels/ and build/openarena/ lie; of maps those that are there
/// @param quick       few bodies, a second
std::vector<BodyScene> body_scenes(const std::string& repository, bool quick);

}  // namespace firma::bench
