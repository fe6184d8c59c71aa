// SPDX-License-Identifier: MIT
// Reads csv with a header: columns by name in any order, and errors that name file and line.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace firma::cli {

/// A whole file: "-" is standard input.
/// @throws Failure when it is missing, a folder, or cannot be read
std::string read_file(const std::string& path);

/// For a message: a piece of a file, with what is not printable as '?', and not too much of it.
std::string shown(std::string_view text);

/// Plain csv: fields between commas, no quotes; blanks around a field do not count; lines end in LF or CRLF. The header
/// must hold each column asked for exactly once, optional ones all or none, and no other.
class CsvReader {
public:
    /// @param text     the file; must outlive the reader
    /// @param name     for messages
    /// @param columns  their names; at() counts in this order
    /// @param optional at() counts them behind `columns`
    CsvReader(std::string_view text, std::string name, std::span<const std::string_view> columns,
              std::span<const std::string_view> optional = {});

    bool has_optional() const { return columns_.size() > required_; }

    /// Goes on to the next row; false at the end. An empty line is an error, as is a row with too few or too many
    /// fields.
    bool next();
    /// A field of this row.
    std::string_view at(std::size_t column) const { return fields_[place_[column]]; }
    /// The same as a finite decimal number.
    double number(std::size_t column) const;
    /// Rows that the file can have at most.
    std::size_t most_rows() const;

    [[noreturn]] void fail(const std::string& reason) const;

private:
    bool next_line();
    void split();

    std::string_view rest_, row_;
    std::string name_;
    std::vector<std::string_view> columns_;  ///< that the file has
    std::size_t required_;
    std::vector<std::size_t> place_;        ///< of a column within a row
    std::vector<std::string_view> fields_;  ///< of this row
    std::size_t line_ = 0;                  ///< from 1, the header included
};

}  // namespace firma::cli
