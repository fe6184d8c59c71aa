// SPDX-License-Identifier: MIT
// The lines of an .obj as words.
#include "level/obj_lines.h"

#include <algorithm>
#include <cstring>

namespace firma {
namespace {

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

/// What ends a line of this text.
char newline_of(std::string_view text) {
    const bool old_mac = text.find('\n') == std::string_view::npos && text.find('\r') != std::string_view::npos;
    return old_mac ? '\r' : '\n';
}

bool is_control(char c) {
    const auto byte = static_cast<unsigned char>(c);
    return (byte < 0x20 && !(byte >= '\t' && byte <= '\r')) || byte == 0x7f;
}

}  // namespace

ObjLines::ObjLines(std::string_view text)
    : at_(text.data()), end_(text.data() + text.size()), newline_(newline_of(text)) {}

bool ObjLines::next() {
    if (begun_) skip_line();
    begun_ = true;
    for (;;) {
        skip_blanks();
        if (at_ == end_) return false;
        if (*at_ != newline_ && *at_ != '#') return true;
        skip_line();
    }
}

std::string_view ObjLines::word() {
    skip_blanks();
    if (at_line_end() || *at_ == '#') return {};
    const char* const begin = at_;
    while (!at_line_end() && !is_blank(*at_) && !continuation()) ++at_;
    return {begin, std::size_t(at_ - begin)};
}

std::string ObjLines::rest() {
    std::string text;
    skip_blanks();
    while (!at_line_end()) {
        if (skip_continuation()) {
            text += ' ';
            continue;
        }
        const bool ends_word = at_ + 1 == end_ || at_[1] == newline_ || is_blank(at_[1]);
        if (*at_ == '#' && ends_word && (text.empty() || is_blank(text.back()))) break;
        text += *at_++;
    }
    while (!text.empty() && is_blank(text.back())) text.pop_back();
    return text;
}

/// How many bytes a backslash at the very end of a line and the line's end take here; 0 without one.
std::size_t ObjLines::continuation() const {
    if (at_ == end_ || *at_ != '\\') return 0;
    const char* after = at_ + 1;
    if (newline_ == '\n' && after != end_ && *after == '\r') ++after;
    if (after != end_ && *after != newline_) return 0;
    return std::size_t(after - at_) + (after != end_);
}

bool ObjLines::skip_continuation() {
    const std::size_t length = continuation();
    if (length == 0) return false;
    at_ += length;
    line_ += at_[-1] == newline_;
    return true;
}

void ObjLines::skip_blanks() {
    for (;;) {
        while (at_ != end_ && *at_ != newline_ && is_blank(*at_)) ++at_;
        if (!skip_continuation()) return;
    }
}

/// To the beginning of the next line, continued ones included, unless a comment comes first.
void ObjLines::skip_line() {
    while (!word().empty()) {
    }
    if (at_ == end_) return;
    const void* const found = std::memchr(at_, newline_, std::size_t(end_ - at_));
    at_ = found ? static_cast<const char*>(found) + 1 : end_;
    line_ += found != nullptr;
}

std::size_t find_control_byte(std::string_view text) {
    constexpr std::size_t kBlock = 4096;
    for (std::size_t begin = 0; begin < text.size(); begin += kBlock) {
        const std::string_view block = text.substr(begin, kBlock);
        unsigned found = 0;
        for (const char c : block) found |= unsigned(is_control(c));  // no branch inside: many bytes at a time
        if (found) return begin + std::size_t(std::find_if(block.begin(), block.end(), is_control) - block.begin());
    }
    return text.size();
}

std::uint32_t line_of(std::string_view text, std::size_t offset) {
    const char newline = newline_of(text);
    return 1 + std::uint32_t(std::count(text.begin(), text.begin() + std::ptrdiff_t(offset), newline));
}

}  // namespace firma
