// SPDX-License-Identifier: MIT
// Numbers of a file exactly as written: what two positions being the same is judged by.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace firma {

/// mantissa * base ^ exponent, the base being 10 or 2 for a whole mesh. Every number has one form only (no base divides
/// the mantissa, zero has no exponent), so numbers are equal when their fields are.
struct ExactNumber {
    static constexpr std::uint32_t kShort = ~0u;

    std::int64_t mantissa = 0;  ///< only 1 or -1, the sign, when the digits are long
    std::int32_t exponent = 0;
    std::uint32_t long_digits = kShort;  ///< index of the mantissa's digits where they do not fit

    friend bool operator==(const ExactNumber&, const ExactNumber&) = default;
    friend auto operator<=>(const ExactNumber&, const ExactNumber&) = default;
};

/// A finite double, in base 2.
ExactNumber exact_binary(double value);

/// Decimal numbers of one file. Mantissas of more than eighteen digits are kept beside, each once.
class ExactDecimals {
public:
    /// Beyond this a number is no measurement, and arithmetic with it costs more than it is worth.
    static constexpr int kMostDigits = 400;  ///< of the mantissa, and largest exponent either way once it is whole

    /// @param word  a number as parse_number() takes it
    /// @return nothing when it exceeds kMostDigits
    std::optional<ExactNumber> add(std::string_view word);

    /// Hands over the long mantissas' digits.
    std::vector<std::string> take_long_digits();

private:
    std::uint32_t index_of(std::string digits);

    std::vector<std::string> long_digits_;
    std::unordered_map<std::string, std::uint32_t> index_;
};

}  // namespace firma
