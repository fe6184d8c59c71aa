// SPDX-License-Identifier: MIT
#include "world/judge_options.h"

#include "carve/judge_rules.h"
#include "firma/vec.h"

namespace firma {

std::optional<Error> judge_options(const WorldOptions& options, const std::string& name) {
    const double offset = options.tolerance.contact_offset;
    if (!(offset >= 0) || !is_finite(offset))
        return Error{ErrorCode::kInvalid, name, "the contact offset must be a finite number, not below zero"};
    if (options.matters)
        if (auto error = check_matters(*options.matters, name)) return error;
    return judge_rules(options.rules, name);
}

}  // namespace firma
