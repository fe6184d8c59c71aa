// SPDX-License-Identifier: MIT
// Escapes what JSON wants escaped; bytes that are not UTF-8 (file names may hold any) become U+FFFD.
#include "cli/json.h"

#include <charconv>
#include <cmath>

#include "debug/utf8.h"

namespace firma::cli {

void JsonWriter::begin(std::string_view key) {
    if (!closers_.empty()) {
        if (!first_) text_ += ',';
        text_ += '\n';
        text_.append(2 * closers_.size(), ' ');
        if (closers_.back() == '}') {
            quote(key);
            text_ += ": ";
        }
    }
    first_ = false;
}

void JsonWriter::open_object(std::string_view key) {
    begin(key);
    text_ += '{';
    closers_ += '}';
    first_ = true;
}

void JsonWriter::open_array(std::string_view key) {
    begin(key);
    text_ += '[';
    closers_ += ']';
    first_ = true;
}

void JsonWriter::close() {
    const char closer = closers_.back();
    closers_.pop_back();
    if (!first_) {
        text_ += '\n';
        text_.append(2 * closers_.size(), ' ');
    }
    text_ += closer;
    first_ = false;
    if (closers_.empty()) text_ += '\n';
}

void JsonWriter::add(std::string_view key, std::string_view value) {
    begin(key);
    quote(value);
}

void JsonWriter::add(std::string_view key, bool value) {
    begin(key);
    text_ += value ? "true" : "false";
}

void JsonWriter::add(std::string_view key, double value) {
    begin(key);
    number(value);
}

void JsonWriter::add(std::string_view key, const Vec3& value) {
    begin(key);
    text_ += '[';
    for (int axis = 0; axis < 3; ++axis) {
        if (axis > 0) text_ += ", ";
        number(value[axis]);
    }
    text_ += ']';
}

void JsonWriter::add_null(std::string_view key) {
    begin(key);
    text_ += "null";
}

void JsonWriter::number(double value) {
    if (!std::isfinite(value)) {
        text_ += "null";
        return;
    }
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, value, std::chars_format::general, 17);
    text_.append(digits, end.ptr);
}

void JsonWriter::quote(std::string_view text) {
    constexpr char kHex[] = "0123456789abcdef";
    text_ += '"';
    while (!text.empty()) {
        const std::size_t length = debug::utf8_length(text);
        const unsigned char c = static_cast<unsigned char>(text[0]);
        if (length == 0) {
            text_ += "\\ufffd";
        } else if (c == '"' || c == '\\') {
            text_ += '\\';
            text_ += char(c);
        } else if (c < 0x20 || c == 0x7F) {
            text_ += "\\u00";
            text_ += kHex[c >> 4];
            text_ += kHex[c & 15];
        } else {
            text_ += text.substr(0, length);
        }
        text.remove_prefix(length == 0 ? 1 : length);
    }
    text_ += '"';
}

}  // namespace firma::cli
