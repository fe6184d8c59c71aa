// SPDX-License-Identifier: MIT
// Numbers in text files, by fast_float.
#include "level/parse_number.h"

#include <fast_float/fast_float.h>

namespace firma {

std::optional<double> parse_number(std::string_view word) {
    const char* begin = word.data();
    const char* const end = begin + word.size();
    if (begin != end && *begin == '+') {
        ++begin;
        if (begin != end && *begin == '-') return std::nullopt;
    }
    // fast_float knows names for what is not finite; a number begins otherwise.
    const char* first = begin != end && *begin == '-' ? begin + 1 : begin;
    if (first == end || !((*first >= '0' && *first <= '9') || *first == '.')) return std::nullopt;

    double value = 0;
    const auto answer = fast_float::from_chars(begin, end, value);
    if (answer.ptr != end) return std::nullopt;
    if (answer.ec == std::errc()) return value;
    // Releases differ in whether they call a number too large or too small for a double an error; they agree on the
    // value.
    if (answer.ec == std::errc::result_out_of_range) return value;
    return std::nullopt;
}

}  // namespace firma
