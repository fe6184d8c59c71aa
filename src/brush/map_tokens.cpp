// SPDX-License-Identifier: MIT
// The words of a .map.
#include "brush/map_tokens.h"

#include <cstring>

namespace firma {
namespace {

using Kind = MapToken::Kind;

bool is_blank(char c) {
    return static_cast<unsigned char>(c) <= 0x20;
}

bool is_mark(char c) {
    return c == '(' || c == ')' || c == '[' || c == ']';
}

char newline_of(std::string_view text) {
    const bool old_mac = text.find('\n') == std::string_view::npos && text.find('\r') != std::string_view::npos;
    return old_mac ? '\r' : '\n';
}

}  // namespace

MapTokens::MapTokens(std::string_view text)
    : at_(text.data()), end_(text.data() + text.size()), newline_(newline_of(text)) {}

void MapTokens::skip_blanks() {
    for (;;) {
        for (; at_ != end_ && is_blank(*at_); ++at_) line_ += *at_ == newline_;
        if (end_ - at_ < 2 || at_[0] != '/' || at_[1] != '/') return;
        const void* const found = std::memchr(at_, newline_, std::size_t(end_ - at_));
        at_ = found ? static_cast<const char*>(found) : end_;
    }
}

// A value that ends in a backslash looks as if its last quote were escaped ("C:\maps\"). As in TrenchBroom, an escaped
// quote ends the string after all when nothing but the line's end or a brace follows it.
MapToken MapTokens::quoted() {
    MapToken token{Kind::kString, {}, line_};
    const char* const begin = ++at_;
    for (; at_ != end_ && *at_ != '"'; ++at_) {
        line_ += *at_ == newline_;
        if (*at_ != '\\' || at_ + 1 == end_) continue;
        const bool ends = at_[1] == '"' && (at_ + 2 == end_ || at_[2] == '\n' || at_[2] == '\r' || at_[2] == '}');
        if (!ends && (at_[1] == '"' || at_[1] == '\\')) ++at_;
    }
    token.text = {begin, std::size_t(at_ - begin)};
    if (at_ == end_) {
        token.kind = Kind::kBroken;
    } else {
        ++at_;
    }
    return token;
}

MapToken MapTokens::run(bool ends_at_marks) {
    const char* const begin = at_;
    while (at_ != end_ && !is_blank(*at_) &&
           !(ends_at_marks && (is_mark(*at_) || *at_ == '{' || *at_ == '}' || *at_ == '"'))) {
        ++at_;
    }
    return {Kind::kWord, {begin, std::size_t(at_ - begin)}, line_};
}

MapToken MapTokens::next() {
    skip_blanks();
    if (at_ == end_) return {Kind::kEnd, {}, line_};
    if (*at_ == '"') return quoted();
    const bool brace = *at_ == '{' || *at_ == '}';
    if (!brace && !is_mark(*at_)) return run(true);
    const std::string_view text(at_, 1);
    ++at_;
    return {!brace ? Kind::kMark : text[0] == '{' ? Kind::kOpen : Kind::kClose, text, line_};
}

MapToken MapTokens::peek() const {
    MapTokens ahead = *this;
    return ahead.next();
}

MapToken MapTokens::next_name() {
    skip_blanks();
    if (at_ == end_) return {Kind::kEnd, {}, line_};
    return *at_ == '"' ? quoted() : run(false);
}

MapToken MapTokens::next_run() {
    skip_blanks();
    if (at_ == end_) return {Kind::kEnd, {}, line_};
    return run(false);
}

std::string unescape(std::string_view text) {
    std::string plain;
    plain.reserve(text.size());
    for (std::size_t k = 0; k < text.size(); ++k) {
        const bool escape = text[k] == '\\' && k + 1 < text.size() && (text[k + 1] == '"' || text[k + 1] == '\\');
        plain += text[escape ? ++k : k];
    }
    return plain;
}

}  // namespace firma
