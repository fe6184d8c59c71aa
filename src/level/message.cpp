// SPDX-License-Identifier: MIT
// Words for errors about files.
#include "level/message.h"

#include <charconv>
#include <cstdio>
#include <utility>

#include "level/parse_number.h"

namespace firma {

std::string quote(std::string_view text) {
    constexpr std::size_t kLongest = 40;
    constexpr char kDigits[] = "0123456789abcdef";
    std::string quoted = "'";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        const bool printable = byte >= 0x20 && byte < 0x7f;
        if (quoted.size() - 1 + (printable ? 1 : 4) > kLongest) return quoted + "...'";
        if (printable) {
            quoted += c;
        } else {
            quoted += "\\x";
            quoted += kDigits[byte >> 4];
            quoted += kDigits[byte & 15];
        }
    }
    return quoted + "'";
}

std::string number_text(double value) {
    char text[32];
#if defined(__wasm__)  // where the tables of to_chars would be a third of the module
    for (int digits = 15; digits <= 17; ++digits) {
        std::snprintf(text, sizeof text, "%.*g", digits, value);
        if (parse_number(text) == value) break;
    }
    return text;
#else
    const auto end = std::to_chars(text, text + sizeof text, value).ptr;
    return {text, end};
#endif
}

Error error_at_line(ErrorCode code, std::string_view name, std::uint32_t line, std::string reason) {
    return {code, std::string(name) + ":" + std::to_string(line), std::move(reason)};
}

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
