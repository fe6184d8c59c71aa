// SPDX-License-Identifier: MIT
#include "carve/judge_rules.h"

#include <cmath>

namespace firma {
namespace {

bool is_hardness(double h) {
    return h >= 0 && h <= 1;
}

}  // namespace

bool holds_points(const Box& box) {
    return box.low.x <= box.high.x && box.low.y <= box.high.y && box.low.z <= box.high.z;
}

bool is_merge_share(double share) {
    return share >= 0 && share < INFINITY;
}

std::optional<Error> judge_rules(const CarveRules& rules, const std::string& name) {
    const auto fault = [&](const std::string& place, std::string reason) {
        return Error{ErrorCode::kInvalid, name.empty() ? place : name + ": " + place, std::move(reason)};
    };
    for (std::size_t k = 0; k < rules.zones.size(); ++k) {
        const CarveZone& zone = rules.zones[k];
        const std::string place =
            "rules, zone " + std::to_string(k) + (zone.name.empty() ? "" : " '" + zone.name + "'");
        if (!is_hardness(zone.hardness)) return fault(place, "its hardness is not within 0 and 1");
        if (!holds_points(zone.box)) return fault(place, "its box is empty, or not of numbers");
    }
    for (std::size_t k = 0; k < rules.hardness.size(); ++k)
        if (!is_hardness(rules.hardness[k]))
            return fault("rules, material " + std::to_string(k), "its hardness is not within 0 and 1");
    if (!is_merge_share(rules.merge_share)) return fault("rules", "merge_share is no share: a number from 0 on");
    if (!(rules.max_cutter_size > 0)) return fault("rules", "max_cutter_size is not a length above zero");
    return std::nullopt;
}

}  // namespace firma
