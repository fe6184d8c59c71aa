// SPDX-License-Identifier: MIT
// Reads with fast_float, writes with to_chars: neither knows a locale.
#include "cli/numbers.h"

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "cli/failure.h"

namespace firma::cli {

std::optional<double> read_number(std::string_view text) {
    if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
    double value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = fast_float::from_chars(text.data(), end, value);
    if (error != std::errc() || stop != end || !std::isfinite(value)) return std::nullopt;
    return value;
}

double number_option(const std::string& option, const std::string& text) {
    const std::optional<double> value = read_number(text);
    if (!value) throw Failure(option, fmt::format("'{}' is not a finite decimal number", text));
    return *value;
}

double number_option(const std::string& option, const std::string& text, double low, double high) {
    const double value = number_option(option, text);
    if (value < low || value > high)
        throw Failure(option, std::isfinite(high) ? fmt::format("{} is not within {} .. {}", text, low, high)
                                                  : fmt::format("{} is less than {}", text, low));
    return value;
}

std::uint64_t count_option(const std::string& option, const std::string& text, std::uint64_t low, std::uint64_t high) {
    std::uint64_t value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error != std::errc() || stop != end || value < low || value > high)
        throw Failure(option, fmt::format("'{}' is not a whole number within {} .. {}", text, low, high));
    return value;
}

Vec3 point_option(const std::string& option, const std::string& text) {
    Vec3 point;
    std::string_view rest = text;
    for (int axis = 0; axis < 3; ++axis) {
        const std::size_t comma = rest.find(',');
        if ((comma == std::string_view::npos) != (axis == 2))
            throw Failure(option, fmt::format("'{}' is not three numbers with commas between them (x,y,z)", text));
        point[axis] = number_option(option, std::string(rest.substr(0, comma)));
        rest.remove_prefix(axis == 2 ? rest.size() : comma + 1);
    }
    return point;
}

int axis_option(const std::string& option, const std::string& text) {
    if (text.empty() || text == "z") return 2;
    if (text == "x") return 0;
    if (text == "y") return 1;
    throw Failure(option, "'" + text + "' is neither x, y nor z");
}

void append_17(std::string& out, double value) {
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, value, std::chars_format::general, 17);
    out.append(digits, end.ptr);
}

std::string grouped(std::uint64_t value) {
    std::string text = std::to_string(value);
    for (std::size_t k = text.size(); k > 3;) text.insert(k -= 3, 1, ',');
    return text;
}

std::string counted(std::uint64_t count, std::string_view one, std::string_view many) {
    if (count == 1) return fmt::format("1 {}", one);
    return many.empty() ? fmt::format("{} {}s", grouped(count), one) : fmt::format("{} {}", grouped(count), many);
}

std::string bytes_text(std::uint64_t bytes) {
    if (bytes < 1000) return fmt::format("{} bytes", bytes);
    if (bytes < 1000000) return fmt::format("{:.1f} kB", double(bytes) / 1e3);
    return fmt::format("{:.1f} MB", double(bytes) / 1e6);
}

std::string point_text(const Vec3& p) {
    return fmt::format("({}, {}, {})", p.x, p.y, p.z);
}

std::string seconds_text(double seconds) {
    return seconds < 1 ? fmt::format("{:.2f} ms", 1e3 * seconds) : fmt::format("{:.2f} s", seconds);
}

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace firma::cli
