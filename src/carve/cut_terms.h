// SPDX-License-Identifier: MIT
// What a cut goes by, beside the solid and the cutter.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "carve/clip_sheets.h"
#include "carve/find_loose.h"
#include "carve/split_matter.h"
#include "firma/solid.h"
#include "geometry/grid_box.h"

namespace firma {

struct CutTerms {
    const CarveRules* rules = nullptr;                    ///< null: none
    const std::vector<std::string>* materials = nullptr;  ///< for reasons; null: by number
    std::uint32_t material = 0;                           ///< of the faces that the cutter leaves
    std::size_t other_faces = 0;                          ///< that count for CarveRules::max_faces beside the solid's
    /// What the solid is made of. With materials of insides these count in place of `material`, but for fills.
    CutMatters matters;
    /// A piece as a solid, for what may not be carved. None where there is nothing such.
    std::function<std::optional<Solid>(const MatterPiece&)> solid_of;
    std::uint32_t edit = 0;            ///< the number it is given; 0: the one after the last
    const Anchors* anchors = nullptr;  ///< what holds pieces; null: do not look for loose ones
    /// Which air faces of a part look into: where a carving opens several, or may, CutOpening says how. Empty: it is
    /// not asked.
    std::function<std::uint32_t(std::uint32_t part)> air_of;
    /// Adds the polygons that stand in the air and meet a box: a fill takes of them what lies in the cutter.
    std::function<void(const GridBox& box, std::vector<CutSheet>& sheets)> sheets_at;
};

}  // namespace firma
