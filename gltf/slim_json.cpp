// SPDX-License-Identifier: MIT
// Judges and cuts a glTF file's JSON.
// Source: Khronos Group, glTF 2.0 Specification, 2021, chapter 5.
#include "gltf/slim_json.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <span>

#include "level/message.h"

namespace firma::gltf {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kLongestText = std::size_t(1) << 28;
constexpr int kDeepest = 64;
constexpr std::size_t kMostEntries = std::size_t(1) << 22;  // of a list; tinygltf takes some 600 bytes for a node

enum class Kind { kIndex, kSize, kText, kFlag, kIndices, kNumbers3, kNumbers4, kNumbers16 };

struct Member {
    const char* name;
    Kind kind;
    bool required = false;
};

constexpr Member kAccessor[] = {{"bufferView", Kind::kIndex}, {"byteOffset", Kind::kSize},
                                {"normalized", Kind::kFlag},  {"componentType", Kind::kIndex, true},
                                {"count", Kind::kSize, true}, {"type", Kind::kText, true}};
constexpr Member kSparse[] = {{"count", Kind::kIndex, true}};
constexpr Member kSparseIndices[] = {
    {"bufferView", Kind::kIndex, true}, {"byteOffset", Kind::kIndex}, {"componentType", Kind::kIndex, true}};
constexpr Member kSparseValues[] = {{"bufferView", Kind::kIndex, true}, {"byteOffset", Kind::kIndex}};
constexpr Member kView[] = {{"buffer", Kind::kIndex, true},
                            {"byteOffset", Kind::kSize},
                            {"byteLength", Kind::kSize, true},
                            {"byteStride", Kind::kSize}};
constexpr Member kBuffer[] = {{"uri", Kind::kText}, {"byteLength", Kind::kSize, true}};
constexpr Member kMesh[] = {{"name", Kind::kText}};
constexpr Member kPrimitive[] = {{"indices", Kind::kIndex}, {"material", Kind::kIndex}, {"mode", Kind::kIndex}};
constexpr Member kAttributes[] = {{"POSITION", Kind::kIndex}, {"NORMAL", Kind::kIndex}, {"TEXCOORD_0", Kind::kIndex}};
constexpr Member kNode[] = {{"name", Kind::kText},           {"mesh", Kind::kIndex},
                            {"children", Kind::kIndices},    {"matrix", Kind::kNumbers16},
                            {"rotation", Kind::kNumbers4},   {"scale", Kind::kNumbers3},
                            {"translation", Kind::kNumbers3}};
constexpr Member kScene[] = {{"nodes", Kind::kIndices}};
constexpr Member kMaterial[] = {{"name", Kind::kText}, {"doubleSided", Kind::kFlag}};

/// Pictures, light and motion: what is read is the same without them.
constexpr std::string_view kHarmless[] = {"KHR_materials_", "KHR_texture_",          "EXT_texture_",
                                          "MSFT_texture_",  "KHR_lights_",           "EXT_lights_",
                                          "KHR_xmp",        "KHR_mesh_quantization", "KHR_animation_"};

/// Of brackets outside of texts.
int depth_of(std::string_view text) {
    int depth = 0, deepest = 0;
    bool quoted = false;
    for (std::size_t k = 0; k < text.size(); ++k) {
        const char c = text[k];
        if (quoted) {
            if (c == '\\') ++k;
            quoted = c != '"';
        } else if (c == '"') {
            quoted = true;
        } else if (c == '[' || c == '{') {
            deepest = std::max(deepest, ++depth);
        } else if (c == ']' || c == '}') {
            --depth;
        }
    }
    return deepest;
}

/// A whole number from 0, also where it is written with a fraction or an exponent.
std::optional<std::uint64_t> whole(const Json& value) {
    if (value.is_number_unsigned()) return value.get<std::uint64_t>();
    if (!value.is_number_float()) return std::nullopt;
    const double number = value.get<double>();
    if (!(number >= 0 && number <= 0x1p53) || number != std::floor(number)) return std::nullopt;
    return std::uint64_t(number);
}

bool is_index(const Json& value) {
    const std::optional<std::uint64_t> number = whole(value);
    return number && *number < (std::uint64_t(1) << 31);
}

bool all_numbers(const Json& value, std::size_t count) {
    return value.is_array() && value.size() == count &&
           std::all_of(value.begin(), value.end(), [](const Json& number) { return number.is_number(); });
}

/// What a member should have been, or null.
const char* fault_of(const Json& value, Kind kind) {
    switch (kind) {
        case Kind::kIndex:
            return is_index(value) ? nullptr : "a whole number from 0 to 2^31 - 1";
        case Kind::kSize:
            return whole(value).value_or(~0ull) <= (1ull << 53) ? nullptr : "a whole number from 0 to 2^53";
        case Kind::kText:
            return value.is_string() ? nullptr : "a text";
        case Kind::kFlag:
            return value.is_boolean() ? nullptr : "true or false";
        case Kind::kIndices:
            return value.is_array() && std::all_of(value.begin(), value.end(), is_index)
                       ? nullptr
                       : "a list of whole numbers from 0 to 2^31 - 1";
        case Kind::kNumbers3:
            return all_numbers(value, 3) ? nullptr : "a list of 3 numbers";
        case Kind::kNumbers4:
            return all_numbers(value, 4) ? nullptr : "a list of 4 numbers";
        case Kind::kNumbers16:
            return all_numbers(value, 16) ? nullptr : "a list of 16 numbers";
    }
    return nullptr;
}

Json in_one_form(Json&& value, Kind kind) {
    if (kind == Kind::kIndex || kind == Kind::kSize) return *whole(value);
    if (kind == Kind::kIndices)
        for (Json& number : value) number = *whole(number);
    return std::move(value);
}

class Cutter {
public:
    Cutter(Json& from, const std::string& name) : from_(from), name_(name) {}

    Result<SlimJson> cut() {
        if (std::optional<Error> error = judge_head()) return *std::move(error);
        to_["asset"]["version"] = "2.0";
        const auto none = [](Json&, Json&, const std::string&) -> std::optional<Error> { return std::nullopt; };
        if (std::optional<Error> error = list("bufferViews", "buffer view", kView, none)) return *error;
        if (std::optional<Error> error = list("scenes", "scene", kScene, none)) return *error;
        if (std::optional<Error> error =
                list("accessors", "accessor", kAccessor,
                     [&](Json& from, Json& to, const std::string& place) { return add_sparse(from, to, place); }))
            return *error;
        if (std::optional<Error> error =
                list("meshes", "mesh", kMesh,
                     [&](Json& from, Json& to, const std::string& place) { return add_primitives(from, to, place); }))
            return *error;
        if (std::optional<Error> error = add_the_rest()) return *error;
        slim_.json = to_.dump();
        return std::move(slim_);
    }

private:
    Error fail(const std::string& place, std::string reason) const {
        return {ErrorCode::kMalformed, place.empty() ? name_ : name_ + ": " + place, std::move(reason)};
    }
    Error unsupported(std::string reason) const { return {ErrorCode::kUnsupported, name_, std::move(reason)}; }

    std::optional<Error> judge_head() {
        const auto asset = from_.find("asset");
        if (asset == from_.end() || !asset->is_object() || !asset->contains("version") ||
            !(*asset)["version"].is_string())
            return fail("", "has no asset.version, so it is no glTF");
        for (const char* member : {"version", "minVersion"}) {
            const auto version = asset->find(member);
            if (version != asset->end() && *version != "2.0")
                return unsupported("is of " + std::string(member) + " " + quote(version->dump()) + "; 2.0 is read");
        }
        const auto required = from_.find("extensionsRequired");
        if (required != from_.end() && required->is_array())
            for (const Json& extension : *required) {
                const std::string text = extension.is_string() ? extension.get<std::string>() : extension.dump();
                const bool harmless = std::any_of(std::begin(kHarmless), std::end(kHarmless),
                                                  [&](std::string_view known) { return text.starts_with(known); });
                if (!harmless) return unsupported("needs the extension " + quote(text) + ", which is not read");
            }
        const auto used = from_.find("extensionsUsed");
        if (used != from_.end() && used->is_array())
            slim_.gpu_instances = std::find(used->begin(), used->end(), "EXT_mesh_gpu_instancing") != used->end();
        if (const auto scene = from_.find("scene"); scene != from_.end()) {
            if (!is_index(*scene)) return fail("scene", "is not a whole number from 0 to 2^31 - 1");
            to_["scene"] = *whole(*scene);
        }
        return std::nullopt;
    }

    /// Members of `from` that are read, moved to `to`.
    std::optional<Error> move_members(Json& from, Json& to, std::span<const Member> members,
                                      const std::string& place) const {
        if (!from.is_object()) return fail(place, "is not an object");
        to = Json::object();
        for (const Member& member : members) {
            const auto value = from.find(member.name);
            if (value == from.end()) {
                if (member.required) return fail(place, "has no " + std::string(member.name));
                continue;
            }
            if (const char* should = fault_of(*value, member.kind))
                return fail(place, std::string(member.name) + " is not " + should);
            to[member.name] = in_one_form(std::move(*value), member.kind);
        }
        return std::nullopt;
    }

    /// A list of the file, each entry cut down and then handed to `more` with what it was.
    template <class More>
    std::optional<Error> each(const char* member, const char* word, std::span<const Member> members, More more) {
        const auto entries = from_.find(member);
        if (entries == from_.end()) return std::nullopt;
        if (!entries->is_array()) return fail(member, "is not a list");
        if (entries->size() > kMostEntries)
            return Error{ErrorCode::kTooLarge, name_ + ": " + member, "has more than 2^22 entries"};
        for (std::size_t k = 0; k < entries->size(); ++k) {
            const std::string place = word + (" " + std::to_string(k));
            Json to;
            if (std::optional<Error> error = move_members((*entries)[k], to, members, place)) return error;
            if (std::optional<Error> error = more((*entries)[k], std::move(to), place)) return error;
        }
        return std::nullopt;
    }

    template <class More>
    std::optional<Error> list(const char* member, const char* word, std::span<const Member> members, More more) {
        return each(member, word, members, [&](Json& from, Json&& to, const std::string& place) {
            std::optional<Error> error = more(from, to, place);
            to_[member].push_back(std::move(to));
            return error;
        });
    }

    std::optional<Error> add_sparse(Json& from, Json& to, const std::string& place) const {
        const auto sparse = from.find("sparse");
        if (sparse == from.end()) return std::nullopt;
        const std::string at = place + " sparse";
        if (std::optional<Error> error = move_members(*sparse, to["sparse"], kSparse, at)) return error;
        for (const auto& [member, members] :
             {std::pair{"indices", std::span<const Member>(kSparseIndices)}, {"values", kSparseValues}}) {
            const auto part = sparse->find(member);
            if (part == sparse->end()) return fail(at, "has no " + std::string(member));
            if (std::optional<Error> error = move_members(*part, to["sparse"][member], members, at + " " + member))
                return error;
        }
        return std::nullopt;
    }

    std::optional<Error> add_primitives(Json& from, Json& to, const std::string& place) {
        to["primitives"] = Json::array();
        const auto primitives = from.find("primitives");
        if (primitives == from.end() || !primitives->is_array()) return fail(place, "has no list of primitives");
        for (std::size_t k = 0; k < primitives->size(); ++k) {
            if (++primitives_ > kMostEntries)
                return Error{ErrorCode::kTooLarge, name_ + ": meshes", "have more than 2^22 primitives"};
            const std::string at = place + ", primitive " + std::to_string(k);
            Json &primitive = (*primitives)[k], slim;
            if (std::optional<Error> error = move_members(primitive, slim, kPrimitive, at)) return error;
            const auto attributes = primitive.find("attributes");
            if (attributes == primitive.end()) return fail(at, "has no attributes");
            if (std::optional<Error> error = move_members(*attributes, slim["attributes"], kAttributes, at))
                return error;
            slim_.morphs += primitive.contains("targets");
            to["primitives"].push_back(std::move(slim));
        }
        return std::nullopt;
    }

    /// What does not go to tinygltf, or not whole.
    std::optional<Error> add_the_rest() {
        if (std::optional<Error> error =
                each("buffers", "buffer", kBuffer, [&](Json&, Json&& to, const std::string&) -> std::optional<Error> {
                    SlimJson::Buffer& buffer = slim_.buffers.emplace_back();
                    buffer.length = to["byteLength"].get<std::uint64_t>();
                    if (to.contains("uri")) buffer.uri = std::move(to["uri"].get_ref<std::string&>());
                    return std::nullopt;
                }))
            return error;
        if (std::optional<Error> error = list(
                "materials", "material", kMaterial, [&](Json& from, Json&, const std::string&) -> std::optional<Error> {
                    const auto extras = from.find("extras");
                    slim_.matters.emplace_back();
                    for (const char* key : {"material", "matter"})
                        if (extras != from.end() && extras->is_object() && extras->contains(key) &&
                            (*extras)[key].is_string())
                            slim_.matters.back() = (*extras)[key].get<std::string>();
                    slim_.cut_materials.push_back(extras != from.end() && extras->is_object() &&
                                                  extras->contains("cut") && (*extras)["cut"] == true);
                    return std::nullopt;
                }))
            return error;
        if (std::optional<Error> error =
                list("nodes", "node", kNode, [&](Json& from, Json& to, const std::string& place) {
                    slim_.node_extras.push_back(texts_of(from));
                    const bool both = to.contains("matrix") &&
                                      (to.contains("rotation") || to.contains("scale") || to.contains("translation"));
                    return both ? std::optional(fail(place, "has a matrix and its parts")) : std::nullopt;
                }))
            return error;
        const auto count = [&](const char* member) {
            const auto entries = from_.find(member);
            return entries != from_.end() && entries->is_array() ? entries->size() : 0;
        };
        slim_.skins = count("skins");
        slim_.animations = count("animations");
        slim_.cameras = count("cameras");
        return std::nullopt;
    }

    static Extras texts_of(const Json& node) {
        Extras texts;
        const auto extras = node.find("extras");
        if (extras == node.end() || !extras->is_object()) return texts;
        for (const auto& [key, value] : extras->items())
            texts.emplace_back(key, value.is_string() ? value.get<std::string>() : value.dump());
        return texts;
    }

    Json& from_;
    const std::string& name_;
    Json to_;
    SlimJson slim_;
    std::size_t primitives_ = 0;
};

/// "name:line" of a byte counted from 1, as the parser does.
Error broken_json(std::string_view text, std::size_t byte, const std::string& name) {
    const std::string_view before = text.substr(0, std::min(byte > 0 ? byte - 1 : 0, text.size()));
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t column = before.size() - (before.rfind('\n') + 1) + 1;  // npos + 1 is 0
    return error_at_line(ErrorCode::kMalformed, name, std::uint32_t(line),
                         "its JSON breaks off at column " + std::to_string(column));
}

}  // namespace

Result<SlimJson> slim_json(std::string_view text, const std::string& name) {
    if (text.size() > kLongestText) return Error{ErrorCode::kTooLarge, name, "has more than 256 MiB of JSON"};
    if (depth_of(text) > kDeepest) return Error{ErrorCode::kMalformed, name, "its JSON is nested too deeply"};
    Json json;
    try {
        json = Json::parse(text.begin(), text.end());
    } catch (const Json::parse_error& error) {
        return broken_json(text, error.byte, name);
    } catch (const Json::exception&) {
        return Error{ErrorCode::kOutOfRange, name, "its JSON has a number that is too large"};
    }
    if (!json.is_object()) return Error{ErrorCode::kMalformed, name, "its JSON is not an object"};
    return Cutter(json, name).cut();
}

}  // namespace firma::gltf
