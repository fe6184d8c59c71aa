// SPDX-License-Identifier: MIT
#include "bindings/c/level_world.h"

#include <vector>

namespace firma::c {

Error nothing_left(const std::string& name, std::span<const Omission> left_out) {
    std::string reason = "no face is left that a cast could meet";
    for (std::size_t k = 0; k < left_out.size(); ++k)
        reason += (k == 0 ? "; left out: " : "; ") + left_out[k].what + ": " + std::to_string(left_out[k].count);
    return {ErrorCode::kMalformed, name, reason};
}

Error nothing_left(const BrushLevel& level) {
    std::vector<Omission> all = level.omissions;
    all.insert(all.end(), level.surfaces.omissions.begin(), level.surfaces.omissions.end());
    return nothing_left(level.name, all);
}

}  // namespace firma::c
