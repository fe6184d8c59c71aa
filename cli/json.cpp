// SPDX-License-Identifier: MIT
// nlohmann writes all doubles with a point or an exponent: whole ones are made integers first.
#include "cli/json.h"

#include <cmath>
#include <cstdint>

namespace firma::cli {

namespace {

constexpr double kLargestPlain = 1e17;  // what is larger has an exponent

bool is_whole(double value) {
    return std::fabs(value) < kLargestPlain && value == std::floor(value) && !(value == 0 && std::signbit(value));
}

void drop_points(Json& json) {
    if (json.is_structured()) {
        for (Json& part : json) drop_points(part);
    } else if (json.is_number_float() && is_whole(json.get<double>())) {
        json = json.get<std::int64_t>();
    }
}

}  // namespace

std::string json_text(Json json) {
    drop_points(json);
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace firma::cli
