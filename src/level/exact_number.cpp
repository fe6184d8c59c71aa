// SPDX-License-Identifier: MIT
// Numbers of a file exactly as written.
#include "level/exact_number.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace firma {
namespace {

constexpr std::size_t kShortDigits = 18;  // 10^18 < 2^63

/// A decimal number taken apart: sign, digits from the first to the last that is not zero, exponent of the last.
struct Parts {
    bool negative = false;
    std::string_view before, after;  // the digits before and behind the point
    std::int64_t exponent = 0;
};

Parts take_apart(std::string_view word) {
    Parts parts;
    if (word.starts_with('+') || word.starts_with('-')) {
        parts.negative = word[0] == '-';
        word.remove_prefix(1);
    }
    if (const std::size_t e = word.find_first_of("eE"); e != std::string_view::npos) {
        const bool minus = word[e + 1] == '-';
        for (const char c : word.substr(e + 1))
            if (c >= '0' && c <= '9')
                parts.exponent = std::min<std::int64_t>(parts.exponent * 10 + (c - '0'), 1'000'000'000);
        if (minus) parts.exponent = -parts.exponent;
        word = word.substr(0, e);
    }
    const std::size_t point = word.find('.');
    parts.before = word.substr(0, point);
    if (point != std::string_view::npos) parts.after = word.substr(point + 1);
    return parts;
}

}  // namespace

ExactNumber exact_binary(double value) {
    ExactNumber number;
    if (value == 0) return number;
    number.mantissa = std::int64_t(std::frexp(value, &number.exponent) * 0x1p53);
    number.exponent -= 53;
    while (number.mantissa % 2 == 0) {
        number.mantissa /= 2;
        ++number.exponent;
    }
    return number;
}

std::optional<ExactNumber> ExactDecimals::add(std::string_view word) {
    const Parts parts = take_apart(word);
    std::int64_t exponent = parts.exponent - std::int64_t(parts.after.size());
    std::string digits;  // most fit into its own bytes
    std::size_t zeros = 0;
    for (const std::string_view part : {parts.before, parts.after})
        for (const char c : part) {
            if (c == '0') {
                zeros += !digits.empty();
                continue;
            }
            if (digits.size() + zeros >= std::size_t(kMostDigits)) return std::nullopt;
            digits.append(std::exchange(zeros, 0), '0');
            digits += c;
        }
    exponent += std::int64_t(zeros);

    ExactNumber number;
    if (digits.empty()) return number;
    if (std::abs(exponent) > kMostDigits) return std::nullopt;
    number.exponent = std::int32_t(exponent);
    if (digits.size() > kShortDigits) {
        number.mantissa = 1;
        number.long_digits = index_of(std::move(digits));
    } else {
        for (const char c : digits) number.mantissa = number.mantissa * 10 + (c - '0');
    }
    if (parts.negative) number.mantissa = -number.mantissa;
    return number;
}

std::uint32_t ExactDecimals::index_of(std::string digits) {
    const auto [entry, is_new] = index_.try_emplace(std::move(digits), std::uint32_t(long_digits_.size()));
    if (is_new) long_digits_.push_back(entry->first);
    return entry->second;
}

std::vector<std::string> ExactDecimals::take_long_digits() {
    index_.clear();
    return std::exchange(long_digits_, {});
}

}  // namespace firma
