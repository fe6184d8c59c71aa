// SPDX-License-Identifier: MIT
// A table of results.
#include "support/table.h"

#include <cmath>
#include <cstdio>
#include <fstream>

namespace firma::bench {
namespace {

std::string formatted(const char* format, double value) {
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

/// Cells hold no quotes; a comma asks for them.
std::string csv_cell(const std::string& cell) {
    if (cell.find(',') == std::string::npos) return cell;
    std::string quoted(1, '"');
    quoted.append(cell).push_back('"');
    return quoted;
}

template <class Cell>
std::string line(const std::vector<std::string>& cells, const char* between, const Cell& cell) {
    std::string text;
    for (std::size_t k = 0; k < cells.size(); ++k) text.append(k ? between : "").append(cell(cells[k]));
    return text;
}

}  // namespace

Table::Table(std::string name, std::vector<std::string> columns)
    : name_(std::move(name)), columns_(std::move(columns)) {}

void Table::add(std::vector<std::string> cells) {
    cells.resize(columns_.size());
    rows_.push_back(std::move(cells));
}

bool Table::finish(const std::string& folder) const {
    const auto plain = [](const std::string& cell) { return cell; };
    std::printf("\n%s\n\n| %s |\n|", name_.c_str(), line(columns_, " | ", plain).c_str());
    for (std::size_t k = 0; k < columns_.size(); ++k) std::printf(k == 0 ? "---|" : "---:|");
    std::printf("\n");
    for (const auto& row : rows_) std::printf("| %s |\n", line(row, " | ", plain).c_str());
    std::fflush(stdout);
    if (folder.empty()) return true;

    std::ofstream file(folder + "/" + name_ + ".csv");
    file << line(columns_, ",", csv_cell) << '\n';
    for (const auto& row : rows_) file << line(row, ",", csv_cell) << '\n';
    file.close();
    if (file) return true;
    std::fprintf(stderr, "%s/%s.csv: cannot be written\n", folder.c_str(), name_.c_str());
    return false;
}

std::string count(std::size_t value) {
    std::string digits = std::to_string(value);
    for (std::ptrdiff_t at = std::ptrdiff_t(digits.size()) - 3; at > 0; at -= 3) digits.insert(std::size_t(at), 1, ' ');
    return digits;
}

std::string number(double value) {
    const double size = std::fabs(value);
    if (size == 0) return "0";
    if (size < 1e-3) return formatted("%.2g", value);
    if (size < 9.995) return formatted("%.2f", value);
    if (size < 99.95) return formatted("%.1f", value);
    if (size < 1e15 && value > 0) return count(std::size_t(std::llround(size)));
    return formatted("%.3g", value);
}

std::string percent(double share) {
    const double value = 100 * share;
    return formatted(value != 0 && value < 0.1 ? "%.2g%%" : value < 9.95 ? "%.2f%%" : "%.1f%%", value);
}

std::string times(double ratio) {
    return formatted(ratio < 9.995 ? "%.2f x" : ratio < 99.95 ? "%.1f x" : "%.0f x", ratio);
}

}  // namespace firma::bench
