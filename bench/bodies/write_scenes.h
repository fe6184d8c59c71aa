// SPDX-License-Identifier: MIT
// Scenes of bodies for bench/node, which gives them to the libraries there.
#pragma once

#include <span>
#include <string>

#include "bodies/body_peer.h"

namespace firma::bench {

/// For the k-th scene FOLDER/k.firma, its world, and FOLDER/k.json: `name`, `what`, `seconds`, and `bodies`, each with
/// `spheres` (four numbers each, about the centre of mass, in the principal axes), `mass` (kg), `inertia` (three, kg
/// m2), `friction`, `restitution`, `position` (of the centre of mass, m), `rotation` (of the principal axes),
/// `velocity`, `spin` and, for a box, `half` (m). Files of scenes that were there before go.
/// @return "", or what could not be written
std::string write_scenes(std::span<const BodyScene> scenes, const std::string& folder);

}  // namespace firma::bench
