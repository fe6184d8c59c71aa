// SPDX-License-Identifier: MIT
// Debris behind a handle, with the bodies that the last call named.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "bindings/c/bodies_object.h"
#include "bindings/c/convert.h"
#include "bindings/c/objects.h"
#include "firma/debris.h"

namespace firma::c {

inline constexpr std::size_t kDebrisLists = FIRMA_DEBRIS_TO_GROUND + 1;

/// One of the edits of a firma_debris_tend().
struct DebrisFill {
    Cutter cutter;
    Pose pose;
    /// Of the world after; kept with it.
    const char* material = "";
};

struct DebrisObject final : Object {
    static constexpr Kind kKind = Kind::kDebris;
    static constexpr const char* kNoun = "debris";
    DebrisObject() = default;
    explicit DebrisObject(Debris of) : debris(std::move(of)) {}
    Debris debris;
    std::array<std::vector<BodyId>, kDebrisLists> named;  ///< by firma_debris_list
    std::vector<DebrisFill> fills;
    World filled;         ///< keeps their materials' names
    bool broken = false;  ///< memory ran out within a call that changed it

    void forget() {
        for (std::vector<BodyId>& list : named) list.clear();
        fills.clear();
        filled = {};
    }
};

/// Those of a handle; null with the code of why not.
DebrisObject* find_debris(firma_debris debris, firma_code& code, const char* function);

/// Debris with its bodies, both as they are found.
struct DebrisThere {
    DebrisObject* debris = nullptr;
    BodiesObject* bodies = nullptr;

    firma_code find_both(firma_debris of, firma_bodies with, const char* function);
    firma_code find_piece(firma_debris of, firma_bodies with, firma_body_id id, const char* function);

    /// Does what changes them: where memory runs out within it, both are lost.
    template <class Work>
    auto change(const Work& work) {
        debris->broken = bodies->broken = true;
        auto made = work(bodies->bodies, debris->debris);
        debris->broken = bodies->broken = false;
        return made;
    }
};

/// Rules, and the spheres that they point to.
struct DebrisRulesThere {
    DebrisRules rules;
    std::vector<Sphere> clear;

    /// Null gives the defaults.
    firma_code read(const firma_debris_rules* given, const char* function);
};
firma_debris_rules debris_rules_told(const DebrisRules& from);

/// @param carve  of the crater, as it is to be told
firma_explosion explosion_told(const BlastResult& from, const firma_carve_report& carve);

/// A pattern as a caller has it.
firma_code read_pattern(const firma_fracture_pattern* given, FracturePattern& pattern, const char* function);
/// Null gives the defaults.
firma_code read_fracture(const firma_fracture_options* given, FractureOptions& options, const char* function);

firma_code read_blast(const firma_blast* given, Blast& blast, const char* function);
/// Null gives the defaults.
firma_code read_push(const firma_push_options* given, PushOptions& push, const char* function);
/// Options of a cut within another call, which may not be a fill.
firma_code read_cut(const firma_carve_options* given, CarveOptions& carve, const char* function);

}  // namespace firma::c
