// SPDX-License-Identifier: MIT
// Judges options and points.
#include "level/judge_input.h"

#include <cmath>

#include "firma/grid.h"
#include "level/message.h"

namespace firma {

std::optional<Error> judge_options(const ReadOptions& options, const std::string& name) {
    if (!is_finite(options.scale) || options.scale < 0) {
        return Error{ErrorCode::kInvalid, name, "scale " + number_text(options.scale) + " is not a positive number"};
    }
    if (!(options.patch_tolerance > 0)) {
        return Error{ErrorCode::kInvalid, name,
                     "patch tolerance " + number_text(options.patch_tolerance) + " is not a positive number"};
    }
    return std::nullopt;
}

std::string point_fault(const Vec3& position, double scale) {
    int axis = 0;
    for (int k = 2; k >= 0; --k) {
        Vec3 alone;
        alone[k] = position[k] * scale;
        if (!snap(alone)) axis = k;
    }
    const std::string name(1, "xyz"[axis]);
    if (!is_finite(position[axis])) return name + " is " + number_text(position[axis]);
    return "lies outside the world: " + name + " = " + number_text(position[axis] * scale) + " m";
}

}  // namespace firma
