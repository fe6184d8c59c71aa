// SPDX-License-Identifier: MIT
#include "level/nothing_left.h"

namespace firma {

Error nothing_left(const std::string& name, const std::string& detail, std::span<const Omission> left_out) {
    std::string reason = "no face is left that a cast could meet";
    if (!detail.empty()) reason += "; " + detail;
    reason += "; left out: ";
    for (std::size_t k = 0; k < left_out.size(); ++k)
        reason += (k > 0 ? "; " : "") + left_out[k].what + ": " + std::to_string(left_out[k].count);
    if (left_out.empty()) reason += "nothing";
    return {ErrorCode::kMalformed, name, reason};
}

}  // namespace firma
