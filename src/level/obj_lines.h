// SPDX-License-Identifier: MIT
// The lines of an .obj as words: line ends of every kind, continued lines, comments.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace firma {

/// Walks over a text once, without copies. Words are parts of it.
///
/// A line ends with LF or CR LF; in a text without any LF, with CR. A backslash at its very end continues it, as if it
/// were a blank; not in a comment. A comment begins with a word that begins with #.
class ObjLines {
public:
    explicit ObjLines(std::string_view text);

    /// Goes to the next line that has a word. False at the end of the text.
    bool next();

    /// The next word of the line; empty at its end.
    std::string_view word();

    /// What is left of the line, trimmed, blanks inside as they are: for names. A lone # ends it; a # within a word
    /// does not, as in "Material #25".
    std::string rest();

    /// Number of the line, from 1, that the word read last lies on.
    std::uint32_t line() const { return line_; }

private:
    bool at_line_end() const { return at_ == end_ || *at_ == newline_; }
    std::size_t continuation() const;
    bool skip_continuation();
    void skip_blanks();
    void skip_line();

    const char* at_ = nullptr;
    const char* end_ = nullptr;
    char newline_ = '\n';
    std::uint32_t line_ = 1;
    bool begun_ = false;
};

/// Offset of the first byte that no text holds: NUL and other control characters but tabs and line ends. size() when
/// there is none.
std::size_t find_control_byte(std::string_view text);

/// Number of the line that a byte lies on, from 1.
std::uint32_t line_of(std::string_view text, std::size_t offset);

}  // namespace firma
