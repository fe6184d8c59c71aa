// SPDX-License-Identifier: MIT
// A shape that moves, as a caller has it.
#pragma once

#include <string>

#include "bindings/c/convert.h"
#include "bindings/c/objects.h"
#include "firma/capsule.h"
#include "firma/hull.h"

namespace firma::c {

/// A mover as a caller has it, and its hull.
struct MoverThere {
    firma_mover mover{};
    const Hull* hull = nullptr;

    firma_code read(const firma_mover* given, const char* function) {
        if (!sized(given)) return bad_call(function, kWrongSize);
        take_sized(given, mover);
        if (mover.kind > FIRMA_MOVER_HULL)
            return fail(FIRMA_ERROR_INVALID, function, "there is no mover of kind " + std::to_string(mover.kind));
        if (mover.kind != FIRMA_MOVER_HULL) return FIRMA_OK;
        const HullObject* object = find<HullObject>(mover.hull.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        hull = &object->hull;
        return FIRMA_OK;
    }

    /// What `ask` answers for the shape: called with a sphere, with a capsule, or with a hull and where it is put.
    template <class Ask>
    auto with(const Ask& ask) const {
        const Vec3 at = vec(mover.at);
        if (hull) return ask(*hull, at);
        if (mover.kind == FIRMA_MOVER_CAPSULE) return ask(Capsule(at, vec(mover.to), mover.radius));
        return ask(Sphere{at, mover.radius});
    }
};

}  // namespace firma::c
