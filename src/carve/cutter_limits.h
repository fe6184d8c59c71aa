// SPDX-License-Identifier: MIT
// What a cutter may take: by zones, faces and pieces of matter that are harder than others or may not be carved.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "carve/cut_terms.h"
#include "carve/cutter_solid.h"
#include "carve/new_loops.h"
#include "carve/trim_cutter.h"
#include "firma/solid.h"
#include "solid/solid_patch.h"

namespace firma {

/// A placed cutter, before it cuts a solid.
struct CutterLimits {
    const Solid& solid;
    const CutterSolid& cutter;
    const CutTerms& terms;
    const CarveRules& rules;
    bool fills;

    /// Of what the cutter's middle lies in, or nearest to: below 1, by how much it is shrunk; else 0.
    double hardness_at_middle() const;

    /// What may not be carved and may reach into the cutter. What is filled in changes no piece.
    std::vector<CutShield> shields() const;

    /// Of what is taken, what may not be carved and no piece stands for: then nothing could be cut short.
    std::optional<std::string> taken_and_hard(const SolidPatch& patch, const NewLoops& loops) const;

private:
    double hardness_of_zones(const Vec3& middle) const;
    double hardness_of_matter(const Vec3& middle) const;
    std::string material_name(std::uint32_t material) const;
};

}  // namespace firma
