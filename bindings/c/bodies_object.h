// SPDX-License-Identifier: MIT
// Bodies behind a handle.
#pragma once

#include <utility>

#include "bindings/c/calls.h"
#include "bindings/c/handles.h"
#include "firma/bodies.h"

namespace firma::c {

struct BodiesObject final : Object {
    static constexpr Kind kKind = Kind::kBodies;
    static constexpr const char* kNoun = "list of bodies";
    BodiesObject() = default;
    explicit BodiesObject(Bodies of) : bodies(std::move(of)) {}
    Bodies bodies;
    bool broken = false;  ///< memory ran out within a step
};

/// Those of a handle; null with the code of why not.
inline BodiesObject* find_bodies(firma_bodies bodies, firma_code& code, const char* function) {
    BodiesObject* const object = find<BodiesObject>(bodies.id, function);
    code = FIRMA_ERROR_BAD_HANDLE;
    if (!object || !object->broken) return object;
    code = fail(FIRMA_ERROR_NO_MEMORY, function, "memory ran out in an earlier step of these bodies: they are lost");
    return nullptr;
}

struct BodyShapeObject final : Object {
    static constexpr Kind kKind = Kind::kBodyShape;
    static constexpr const char* kNoun = "body shape";
    explicit BodyShapeObject(BodyShape of) : shape(std::move(of)) {}
    const BodyShape shape;
};

inline BodyId id_of(firma_body_id id) {
    return {id.slot, id.use};
}

/// All of it; `size` as the struct is now.
firma_body body_told(const Body& from);
/// What may be taken of a caller's body, and taking it: all but its shape.
bool is_good(const firma_body& body);
void take_body(const firma_body& from, Body& body);
firma_code read_step(const firma_step_options* given, StepOptions& step, const char* function);
firma_step_options step_told(const StepOptions& from);
firma_step_report step_report_told(const StepReport& from);

inline constexpr const char* kNoSuchBody = "there is no such body any more";

/// How spheres are fitted, as a caller has it; null gives the defaults.
firma_code read_fit(const firma_fit_options* given, FitOptions& fit, const char* function);

}  // namespace firma::c
