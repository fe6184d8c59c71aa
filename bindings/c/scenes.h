// SPDX-License-Identifier: MIT
// Levels with their parts, as a caller has them.
#pragma once

#include <span>
#include <vector>

#include "bindings/c/convert.h"
#include "bindings/c/objects.h"
#include "firma/moving_parts.h"

namespace firma::c {

struct PartsObject final : Object {
    static constexpr Kind kKind = Kind::kParts;
    static constexpr const char* kNoun = "list of parts";
    std::vector<MovingPart> parts;
};

/// What a firma_scene names. Views: good as long as its handles are held.
struct SceneThere {
    const World* world = nullptr;
    std::span<const MovingPart> parts{};
    double from = 0, to = 1;

    firma_code read(const firma_scene* given, const char* function);
    Scene scene() const { return {*world, parts, from, to}; }
    /// Whether its stretch is one.
    bool has_stretch() const { return from >= 0 && from <= to && to <= 1; }
};

}  // namespace firma::c
