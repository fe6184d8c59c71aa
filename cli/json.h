// SPDX-License-Identifier: MIT
// A small writer of JSON: for --json, one object on standard output.
#pragma once

#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>

#include "firma/vec.h"

namespace firma::cli {

/// Builds one value from the outside in. Inside an object every value has a key, inside an array none:
///
///     JsonWriter json;
///     json.open_object();
///     json.add("faces", 12);
///     json.open_array("notes");
///     json.close();
///     json.close();
///     print(json.text());
class JsonWriter {
public:
    void open_object(std::string_view key = {});
    void open_array(std::string_view key = {});
    void close();

    void add(std::string_view key, std::string_view value);
    void add(std::string_view key, const char* value) { add(key, std::string_view(value)); }
    void add(std::string_view key, bool value);
    void add(std::string_view key, double value);  ///< 17 digits; null when not finite
    void add(std::string_view key, const Vec3& value);
    template <std::integral T>
    void add(std::string_view key, T value) {
        begin(key);
        text_ += std::to_string(value);
    }
    void add_null(std::string_view key);

    /// The value, with a line feed at its end.
    const std::string& text() const { return text_; }

private:
    void begin(std::string_view key);
    void quote(std::string_view text);
    void number(double value);

    std::string text_;
    std::string closers_;  ///< of what is open, innermost last
    bool first_ = true;    ///< nothing stands in the innermost yet
};

}  // namespace firma::cli
