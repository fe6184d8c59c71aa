// SPDX-License-Identifier: MIT
// The words of a .map and of a .bsp's entities: blanks, comments, quotes, braces; lines counted.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace firma {

struct MapToken {
    enum class Kind : std::uint8_t {
        kEnd,     ///< of the text
        kOpen,    ///< {
        kClose,   ///< }
        kMark,    ///< one of ( ) [ ]
        kWord,    ///< anything else up to a blank, a mark, a brace or a quote
        kString,  ///< in quotes; `text` is what stands between them, escapes as they are
        kBroken,  ///< a quote without an end
    };
    Kind kind = Kind::kEnd;
    std::string_view text;
    std::uint32_t line = 0;  ///< where it begins, from 1

    bool is(char mark) const { return kind == Kind::kMark && text[0] == mark; }
};

/// Walks over a text once, without copies. Any byte up to 32 is a blank, as id's games have it. A line ends with LF or
/// CR LF; in a text without any LF, with CR. Comments run from // at the beginning of a token to the end of the line.
class MapTokens {
public:
    explicit MapTokens(std::string_view text);

    MapToken next();

    /// What next() will return.
    MapToken peek() const;

    /// A texture's name: in quotes, or all up to the next blank, be it braces or marks. Names such as {fence, +0lamp,
    /// *water or (sign) are in use.
    MapToken next_name();

    /// Everything up to the next blank: for skipping what is not understood.
    MapToken next_run();

private:
    void skip_blanks();
    MapToken quoted();
    MapToken run(bool ends_at_marks);

    const char* at_ = nullptr;
    const char* end_ = nullptr;
    char newline_ = '\n';
    std::uint32_t line_ = 1;
};

/// The text of a kString without its escapes: \" is a quote and \\ a backslash; any other backslash stands for itself,
/// as in "C:\quake\id1" or "first line\nsecond".
std::string unescape(std::string_view text);

}  // namespace firma
