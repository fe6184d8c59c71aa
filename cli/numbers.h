// SPDX-License-Identifier: MIT
// Numbers as people and files write them, in and out, whatever the locale.
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "firma/vec.h"

namespace firma::cli {

/// A decimal number and nothing else: "1", "-.5", "+2e-3". Not: "", "nan", "inf", "0x10", "1 2", "1e999".
/// @return the nearest double, or nothing
std::optional<double> read_number(std::string_view text);

/// Values of options. What they throw (a Failure) names the option and what was given.
double number_option(const std::string& option, const std::string& text);
double number_option(const std::string& option, const std::string& text, double low, double high);
std::uint64_t count_option(const std::string& option, const std::string& text, std::uint64_t low, std::uint64_t high);
/// "x,y,z"
Vec3 point_option(const std::string& option, const std::string& text);
/// "x", "y" or "z" -> 0, 1, 2; "" is z.
int axis_option(const std::string& option, const std::string& text);

/// Appends a double with 17 significant digits, as printf's %.17g does.
void append_17(std::string& out, double value);

/// 1234567 -> "1,234,567"
std::string grouped(std::uint64_t value);
/// 1, "face" -> "1 face"; 2000, "face" -> "2,000 faces"; 2, "brush", "brushes" -> "2 brushes"
std::string counted(std::uint64_t count, std::string_view one, std::string_view many = {});
/// 1536000 -> "1.5 MB"
std::string bytes_text(std::uint64_t bytes);
/// (1, 2.5, -3) -> "(1, 2.5, -3)"
std::string point_text(const Vec3& p);
/// 0.00123 -> "1.23 ms"
std::string seconds_text(double seconds);
double seconds_since(std::chrono::steady_clock::time_point start);

}  // namespace firma::cli
