// SPDX-License-Identifier: MIT
// A world that bytes made, judged as a whole.
#pragma once

#include "firma/solid.h"
#include "firma/world.h"
#include "save/entries.h"

namespace firma {

inline std::string fault_place(FaceId face) {
    return face.valid() ? ": face " + std::to_string(face.value) : std::string();
}
inline void report(Damage& damage, const WorldFault& fault) {
    damage.report(ErrorCode::kMalformed, fault_place(fault.face), "the world is broken: " + fault.what);
}
inline void report(Damage& damage, const SolidFault& fault) {
    damage.report(ErrorCode::kMalformed, fault_place(fault.face), std::string("the solid is broken: ") + fault.what);
}

/// What no part can see by itself.
inline void check_whole(const World& world, bool exact, Damage& damage) {
    if (const std::optional<WorldFault> fault = check_world(world)) {
        report(damage, *fault);
    } else if (exact) {
        if (const std::optional<SolidFault> solid = check_solid(world)) report(damage, *solid);
    }
}

}  // namespace firma
