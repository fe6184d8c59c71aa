// SPDX-License-Identifier: MIT
// JSON objects that people write, read key by key.
#include "cli/json_fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "cli/failure.h"

namespace firma::cli {

namespace {

/// nlohmann's "[json.exception.parse_error.101] parse error at line 3, column 5: syntax error while ..."
std::string reason_of_parser(const std::string& what) {
    constexpr std::string_view kBegin = "parse error ";
    const std::size_t at = what.find(kBegin);
    return at == std::string::npos ? what : what.substr(at + kBegin.size());
}

/// Finds a key that an object has twice, of which the parser keeps one.
class KeyWatch {
public:
    bool operator()(int, Json::parse_event_t event, Json& parsed) {
        if (event == Json::parse_event_t::object_start) keys_.emplace_back();
        if (event == Json::parse_event_t::object_end) keys_.pop_back();
        if (event != Json::parse_event_t::key) return true;
        const std::string key = parsed.get<std::string>();
        std::vector<std::string>& seen = keys_.back();
        if (twice_.empty() && std::find(seen.begin(), seen.end(), key) != seen.end()) twice_ = key;
        seen.push_back(key);
        return true;
    }
    const std::string& twice() const { return twice_; }

private:
    std::vector<std::vector<std::string>> keys_;
    std::string twice_;
};

}  // namespace

Json parse_json(const std::string& text, const std::string& name) {
    KeyWatch watch;
    Json json;
    try {
        json = Json::parse(
            text, [&](int depth, Json::parse_event_t event, Json& parsed) { return watch(depth, event, parsed); });
    } catch (const Json::exception& error) {
        throw Failure(name, reason_of_parser(error.what()));
    }
    if (!watch.twice().empty()) throw Failure(name, "an object has the key '" + watch.twice() + "' twice");
    return json;
}

Vec3 vec_of(const Json& json, const std::string& place) {
    const auto is_number = [](const Json& part) { return part.is_number() && std::isfinite(part.get<double>()); };
    if (!json.is_array() || json.size() != 3 || !std::all_of(json.begin(), json.end(), is_number))
        throw Failure(place, "is not three numbers, [x, y, z]");
    return {json[0].get<double>(), json[1].get<double>(), json[2].get<double>()};
}

JsonFields::JsonFields(const Json& json, std::string place) : json_(json), place_(std::move(place)) {
    if (!json.is_object()) throw Failure(place_, "is not an object, {...}");
}

bool JsonFields::has(std::string_view key) const {
    return json_.contains(std::string(key));
}

const Json* JsonFields::find(std::string_view key) {
    asked_.emplace_back(key);
    const auto found = json_.find(std::string(key));
    return found == json_.end() ? nullptr : &*found;
}

const Json& JsonFields::at(std::string_view key) {
    const Json* found = find(key);
    if (!found) throw Failure(place_, fmt::format("'{}' is missing", key));
    return *found;
}

std::string JsonFields::place_of(std::string_view key) const {
    return fmt::format("{}: {}", place_, key);
}

void JsonFields::fail(std::string_view key, const std::string& reason) const {
    throw Failure(place_of(key), reason);
}

double JsonFields::number(std::string_view key, std::optional<double> otherwise, double low, double high) {
    const Json* found = otherwise ? find(key) : &at(key);
    if (!found) return *otherwise;
    if (!found->is_number()) fail(key, "is not a number");
    const double value = found->get<double>();
    if (!(value >= low && value <= high)) fail(key, fmt::format("is {}, which is not {} to {}", value, low, high));
    return value;
}

std::uint64_t JsonFields::count(std::string_view key, std::optional<std::uint64_t> otherwise, std::uint64_t low,
                                std::uint64_t high) {
    const Json* found = otherwise ? find(key) : &at(key);
    if (!found) return *otherwise;
    if (!found->is_number_unsigned()) fail(key, "is not a whole number, 0 or more");
    const std::uint64_t value = found->get<std::uint64_t>();
    if (value < low || value > high) fail(key, fmt::format("is {}, which is not {} to {}", value, low, high));
    return value;
}

Vec3 JsonFields::vec(std::string_view key, std::optional<Vec3> otherwise) {
    const Json* found = otherwise ? find(key) : &at(key);
    return found ? vec_of(*found, place_of(key)) : *otherwise;
}

std::string JsonFields::text(std::string_view key, std::optional<std::string> otherwise) {
    const Json* found = otherwise ? find(key) : &at(key);
    if (!found) return *otherwise;
    if (!found->is_string()) fail(key, "is not a text, \"...\"");
    return found->get<std::string>();
}

bool JsonFields::flag(std::string_view key, bool otherwise) {
    const Json* found = find(key);
    if (!found) return otherwise;
    if (!found->is_boolean()) fail(key, "is not true or false");
    return found->get<bool>();
}

const Json& JsonFields::list(std::string_view key) {
    static const Json kNoEntries = Json::array();
    const Json* found = find(key);
    if (!found) return kNoEntries;
    if (!found->is_array()) fail(key, "is not a list, [...]");
    return *found;
}

void JsonFields::finish() const {
    for (const auto& [key, value] : json_.items()) {
        if (std::find(asked_.begin(), asked_.end(), key) != asked_.end()) continue;
        std::string known;
        for (const std::string& name : asked_) known += (known.empty() ? "" : ", ") + name;
        throw Failure(place_, fmt::format("there is no key '{}' here; there are {}", key, known));
    }
}

}  // namespace firma::cli
