// SPDX-License-Identifier: MIT
// JSON objects that people write, read key by key: what is missing, of another kind, out of range or unknown is told
// with its place.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/json.h"
#include "firma/vec.h"

namespace firma::cli {

/// @throws Failure naming file, line and column for what is no JSON, and for a key that an object has twice
Json parse_json(const std::string& text, const std::string& name);

/// One object. Its functions throw a Failure that names its place and the key.
class JsonFields {
public:
    /// @param place  for messages: "script.json: event 3: blast"; throws where it is no object
    JsonFields(const Json& json, std::string place);

    bool has(std::string_view key) const;
    /// Null where it is not there.
    const Json* find(std::string_view key);
    const Json& at(std::string_view key);

    double number(std::string_view key, std::optional<double> otherwise, double low, double high);
    std::uint64_t count(std::string_view key, std::optional<std::uint64_t> otherwise, std::uint64_t low,
                        std::uint64_t high);
    /// [x, y, z]
    Vec3 vec(std::string_view key, std::optional<Vec3> otherwise);
    std::string text(std::string_view key, std::optional<std::string> otherwise);
    bool flag(std::string_view key, bool otherwise);
    /// An array; none where it is not there.
    const Json& list(std::string_view key);

    const std::string& place() const { return place_; }
    std::string place_of(std::string_view key) const;
    [[noreturn]] void fail(std::string_view key, const std::string& reason) const;
    /// Refuses keys that nobody asked for.
    void finish() const;

private:
    const Json& json_;
    const std::string place_;
    std::vector<std::string> asked_;
};

/// Three numbers; throws a Failure with the place.
Vec3 vec_of(const Json& json, const std::string& place);

}  // namespace firma::cli
