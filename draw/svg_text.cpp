// SPDX-License-Identifier: MIT
// to_chars everywhere: the locale must not put commas into numbers.
#include "draw/svg_text.h"

#include <charconv>
#include <cmath>

#include "draw/utf8.h"
#include "firma/vec.h"

namespace firma::draw {

SvgText& SvgText::raw(std::string_view svg) {
    text_ += svg;
    return *this;
}

SvgText& SvgText::words(std::string_view text) {
    while (!text.empty()) {
        const std::size_t length = utf8_length(text);
        const char c = text[0];
        if (length == 0 || static_cast<unsigned char>(c) < 0x20 || c == 0x7F) {
            text_ += '?';
        } else if (c == '&') {
            text_ += "&amp;";
        } else if (c == '<') {
            text_ += "&lt;";
        } else if (c == '>') {
            text_ += "&gt;";
        } else {
            text_ += text.substr(0, length);
        }
        text.remove_prefix(length == 0 ? 1 : length);
    }
    return *this;
}

SvgText& SvgText::number(double value) {
    const double tenths = is_finite(value) ? std::floor(value * 10 + 0.5) : 0;
    if (std::fabs(tenths) > 1e15) return raw("0");
    const long long whole = static_cast<long long>(tenths);
    const unsigned long long size =
        whole < 0 ? 0ull - static_cast<unsigned long long>(whole) : static_cast<unsigned long long>(whole);
    if (whole < 0) text_ += '-';
    text_ += std::to_string(size / 10);
    if (size % 10 != 0) {
        text_ += '.';
        text_ += char('0' + size % 10);
    }
    return *this;
}

SvgText& SvgText::point(const PagePoint& p) {
    number(p.x);
    text_ += ',';
    return number(p.y);
}

void SvgText::label(const PagePoint& at, std::string_view text, std::string_view style) {
    raw("<text x=\"").number(at.x).raw("\" y=\"").number(at.y).raw("\" ").raw(style).raw(">");
    words(text).raw("</text>\n");
}

void SvgText::line(const PagePoint& from, const PagePoint& to, std::string_view style) {
    raw("<line x1=\"")
        .number(from.x)
        .raw("\" y1=\"")
        .number(from.y)
        .raw("\" x2=\"")
        .number(to.x)
        .raw("\" y2=\"")
        .number(to.y);
    raw("\" ").raw(style).raw("/>\n");
}

std::string short_number(double value, int decimals) {
    char digits[64];
    if (!is_finite(value) || std::fabs(value) > 1e15) return "?";
    const auto end = std::to_chars(digits, digits + sizeof digits, value, std::chars_format::fixed, decimals);
    std::string text(digits, end.ptr);
    if (text.find('.') != std::string::npos) {
        while (text.back() == '0') text.pop_back();
        if (text.back() == '.') text.pop_back();
    }
    return text == "-0" ? "0" : text;
}

std::string grouped_number(std::size_t value) {
    std::string text = std::to_string(value);
    for (std::size_t k = text.size(); k > 3;) text.insert(k -= 3, 1, ',');
    return text;
}

}  // namespace firma::draw
