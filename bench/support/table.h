// SPDX-License-Identifier: MIT
// A table of results: Markdown for people, CSV for bench/results.
#pragma once

#include <string>
#include <vector>

namespace firma::bench {

class Table {
public:
    /// @param name  also the name of the CSV file
    Table(std::string name, std::vector<std::string> columns);

    void add(std::vector<std::string> cells);

    /// Prints the table; writes FOLDER/NAME.csv as well, unless `folder` is empty.
    /// @return false when the file cannot be written
    bool finish(const std::string& folder) const;

private:
    std::string name_;
    std::vector<std::string> columns_;
    std::vector<std::vector<std::string>> rows_;
};

/// Three significant digits, thousands in groups: for people.
std::string number(double value);
std::string count(std::size_t value);
/// "12.3%"
std::string percent(double share);
/// "1.23 x"
std::string times(double ratio);

}  // namespace firma::bench
