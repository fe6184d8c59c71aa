// SPDX-License-Identifier: MIT
// Numbers in text files: the same in every locale, and nothing taken for a number that is not one.
#pragma once

#include <optional>
#include <string_view>

namespace firma {

/// Reads a whole word as a decimal number: digits with at most one point, a sign (+ too), an exponent; such as 1, -2.5,
/// .5, 5. or +1e-3.
///
/// @return the nearest double, infinite when beyond the doubles; nothing when the word is not such a number:
/// hexadecimal,
///         "nan", "inf", or with anything before or after it
std::optional<double> parse_number(std::string_view word);

}  // namespace firma
