// SPDX-License-Identifier: MIT
// A world that bytes made, judged as a whole.
#pragma once

#include "firma/solid.h"
#include "firma/world.h"
#include "save/entries.h"

namespace firma {

/// What no part can see by itself.
inline void check_whole(const World& world, bool exact, Damage& damage) {
    const auto face_place = [](FaceId face) {
        return face.valid() ? ": face " + std::to_string(face.value) : std::string();
    };
    if (const std::optional<WorldFault> fault = check_world(world)) {
        damage.report(ErrorCode::kMalformed, face_place(fault->face), "the world is broken: " + fault->what);
    } else if (exact) {
        if (const std::optional<SolidFault> solid = check_solid(world))
            damage.report(ErrorCode::kMalformed, face_place(solid->face), "the solid is broken: " + solid->what);
    }
}

}  // namespace firma
