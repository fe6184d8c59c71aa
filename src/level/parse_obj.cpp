// SPDX-License-Identifier: MIT
// Reads the entries of an .obj and hands them on.
// Source: Wavefront, Advanced Visualizer manual, appendix B1 (object files).
#include "level/parse_obj.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "level/divide_polygon.h"
#include "level/message.h"
#include "level/obj_lines.h"
#include "level/parse_number.h"

namespace firma {
namespace {

constexpr char kAxisNames[] = "xyz";

std::string world_range(char axis) {
    return std::string("-8192 m <= ") + axis + " < 8192 m";
}

/// A vertex index as written, or nothing when the word is not a whole number.
std::optional<std::int64_t> parse_index(std::string_view word) {
    const bool negative = !word.empty() && word[0] == '-';
    if (negative) word.remove_prefix(1);
    if (word.empty()) return std::nullopt;
    std::int64_t value = 0;
    for (const char c : word) {
        if (c < '0' || c > '9') return std::nullopt;
        value = std::min<std::int64_t>(value * 10 + (c - '0'), std::numeric_limits<std::int64_t>::max() / 20);
    }
    return negative ? -value : value;
}

/// What an entry that is not read would add to the level, in the plural; null where it is nothing.
const char* shape_of(std::string_view keyword) {
    constexpr std::pair<std::string_view, const char*> kShapes[] = {
        {"p", "points (p)"},           {"l", "lines (l)"},          {"curv", "curves (curv)"},
        {"curv2", "curves (curv2)"},   {"surf", "surfaces (surf)"}, {"bzp", "patches (bzp)"},
        {"bsp", "patches (bsp)"},      {"cdc", "curves (cdc)"},     {"cdp", "patches (cdp)"},
        {"call", "other files (call)"}};
    for (const auto& [of, what] : kShapes)
        if (keyword == of) return what;
    return nullptr;
}

class ObjParser {
public:
    ObjParser(std::string_view text, std::string_view name, double scale, ObjVisitor& visitor)
        : lines_(text), name_(name), scale_(scale), visitor_(visitor) {}

    /// Reads one line's entry.
    std::optional<Error> entry() {
        const std::string_view keyword = lines_.word();
        if (keyword == "v") return vertex();
        if (keyword == "vt") return texture_vertex();
        if (keyword == "f") return face();
        if (keyword == "usemtl") {
            visitor_.material(lines_.rest());
        } else if (keyword == "g" || keyword == "o") {
            visitor_.group(lines_.rest());
        } else {
            return other(keyword);
        }
        return std::nullopt;
    }

    bool next() { return lines_.next(); }
    const ObjCounts& counts() const { return counts_; }

private:
    Error malformed(std::string reason) const {
        return error_at_line(ErrorCode::kMalformed, name_, lines_.line(), std::move(reason));
    }
    Error out_of_range(std::string reason) const {
        return error_at_line(ErrorCode::kOutOfRange, name_, lines_.line(), std::move(reason));
    }

    std::optional<Error> vertex();
    std::optional<Error> texture_vertex();
    std::optional<Error> number(std::string_view word, std::size_t place, double& value) const;
    Error outside_world(const ObjVertex& vertex) const;
    std::optional<Error> face();
    std::optional<Error> corner(std::string_view word);
    std::optional<Error> other(std::string_view keyword);
    std::string vertex_name() const { return "vertex " + std::to_string(vertices_ + 1); }

    ObjLines lines_;
    std::string_view name_;
    double scale_;
    ObjVisitor& visitor_;
    ObjCounts counts_;
    std::uint32_t vertices_ = 0;
    std::vector<std::uint32_t> corners_;
    std::vector<TexturePoint> texture_vertices_, uvs_;  ///< all so far; of the face at hand
};

/// v x y z [w | r g b]: weights and colours are checked to be numbers, and left.
std::optional<Error> ObjParser::vertex() {
    ObjVertex vertex;
    vertex.line = lines_.line();
    std::size_t count = 0;
    for (std::string_view word = lines_.word(); !word.empty(); word = lines_.word(), ++count) {
        double value = 0;
        if (auto error = number(word, count, value)) return error;
        if (count >= 3) continue;
        if (auto error = visitor_.number(word, count, lines_.line())) return error;
        vertex.text[count] = word;
        vertex.position[int(count)] = value;
    }
    if (count != 3 && count != 4 && count != 6)
        return malformed(vertex_name() + " has " + std::to_string(count) +
                         " numbers; it takes 3, 4 (with a weight) or 6 " + "(with a colour)");
    vertex.metres = vertex.position * scale_;
    if (!visitor_.vertex(vertex)) return outside_world(vertex);
    ++vertices_;
    return std::nullopt;
}

/// vt u [v [w]], v pointing up. Where a texture lies never keeps a level from being read: what is no number is not
/// there. It counts with the entries that are no geometry.
std::optional<Error> ObjParser::texture_vertex() {
    ++counts_.ignored_entries;
    constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();
    const auto read = [&](double missing) {
        const std::string_view word = lines_.word();
        return word.empty() ? missing : parse_number(word).value_or(kNoNumber);
    };
    const double u = read(kNoNumber), v = read(0);
    texture_vertices_.push_back({u, 1 - v});
    return std::nullopt;
}

std::optional<Error> ObjParser::number(std::string_view word, std::size_t place, double& value) const {
    const auto what = [&] {
        return quote(word) + " as " + (place < 3 ? std::string(1, kAxisNames[place]) : "further number") + " of " +
               vertex_name();
    };
    const std::optional<double> parsed = parse_number(word);
    if (!parsed) return malformed(what() + " is not a number");
    if (!is_finite(*parsed)) return out_of_range(what() + " is too large for a number");
    value = *parsed;
    return std::nullopt;
}

Error ObjParser::outside_world(const ObjVertex& vertex) const {
    for (int axis = 0; axis < 3; ++axis) {
        const double metres = vertex.metres[axis];
        if (snap({metres, 0, 0})) continue;
        const char axis_name = kAxisNames[axis];
        std::string reason =
            vertex_name() + " lies outside the world: " + axis_name + " = " + number_text(metres) + " m";
        if (scale_ != 1) reason += " (" + quote(vertex.text[std::size_t(axis)]) + " times " + number_text(scale_) + ")";
        if (metres >= -kWorldRim && metres < kWorldRim) reason += ", rounded to 1/4096 m,";
        return error_at_line(ErrorCode::kOutOfRange, name_, vertex.line,
                             reason + " is not within " + world_range(axis_name));
    }
    return error_at_line(ErrorCode::kOutOfRange, name_, vertex.line, vertex_name() + " lies outside the world");
}

/// f corner corner corner ...
std::optional<Error> ObjParser::face() {
    ObjFace face;
    face.line = lines_.line();
    face.source = counts_.faces;
    corners_.clear();
    uvs_.clear();
    for (std::string_view word = lines_.word(); !word.empty(); word = lines_.word()) {
        if (corners_.size() == kMaxOutlineCorners)
            return error_at_line(ErrorCode::kTooLarge, name_, face.line,
                                 "face of more than " + std::to_string(kMaxOutlineCorners) + " corners");
        if (auto error = corner(word)) return error;
    }
    if (corners_.size() < 3)
        return malformed("face of " + std::to_string(corners_.size()) + " corners; it takes at least 3");
    face.corners = corners_;
    if (uvs_.size() == corners_.size()) face.uvs = uvs_;
    ++counts_.faces;
    return visitor_.face(face);
}

/// i, i/t, i//n or i/t/n. Firma has no use for normals: they must be numbers, no more. A texture vertex that is not
/// there is none.
std::optional<Error> ObjParser::corner(std::string_view word) {
    constexpr auto kNowhere = std::string_view::npos;
    const std::size_t first = word.find('/');
    const std::size_t second = first == kNowhere ? kNowhere : word.find('/', first + 1);
    const auto index = parse_index(word.substr(0, first));
    bool sound = index.has_value();
    if (first != kNowhere) {
        const std::string_view texture = word.substr(first + 1, second == kNowhere ? kNowhere : second - first - 1);
        const std::optional<std::int64_t> named = parse_index(texture);
        sound = sound && (named || (texture.empty() && second != kNowhere));
        const auto count = std::int64_t(texture_vertices_.size());
        const std::int64_t at = !named ? -1 : *named > 0 ? *named - 1 : count + *named;
        if (named && *named != 0 && at >= 0 && at < count) {
            const TexturePoint& uv = texture_vertices_[std::size_t(at)];
            if (is_finite(uv[0]) && is_finite(uv[1])) uvs_.push_back(uv);
        }
    }
    if (second != kNowhere) sound = sound && parse_index(word.substr(second + 1));
    if (!sound) return malformed("corner " + quote(word) + " is not of the form v, v/t, v//n or v/t/n");
    if (*index == 0) return out_of_range("corner " + quote(word) + " names vertex 0; they count from 1");
    const std::int64_t vertex = *index > 0 ? *index - 1 : std::int64_t(vertices_) + *index;
    if (vertex < 0 || vertex >= std::int64_t(vertices_))
        return out_of_range("corner " + quote(word) + " names no vertex; " + std::to_string(vertices_) +
                            " come before it");
    corners_.push_back(std::uint32_t(vertex));
    return std::nullopt;
}

/// What is not geometry for casts is counted. A keyword that no text would hold means that this is not an .obj at all.
std::optional<Error> ObjParser::other(std::string_view keyword) {
    const bool is_word = std::all_of(keyword.begin(), keyword.end(), [](char c) { return c > 0x20 && c < 0x7f; });
    if (!is_word) return malformed(quote(keyword) + " begins no entry of an .obj");
    ++counts_.ignored_entries;
    if (const char* const what = shape_of(keyword)) {
        const auto known = std::find_if(counts_.omissions.begin(), counts_.omissions.end(),
                                        [&](const Omission& omission) { return omission.what == what; });
        if (known != counts_.omissions.end())
            ++known->count;
        else
            counts_.omissions.push_back({what, 1, std::string(name_) + ":" + std::to_string(lines_.line())});
    }
    return std::nullopt;
}

}  // namespace

Result<ObjCounts> parse_obj(std::string_view text, std::string_view name, const ReadOptions& options,
                            ObjVisitor& visitor) {
    if (!is_finite(options.scale) || options.scale < 0)
        return Error{ErrorCode::kInvalid, std::string(name),
                     "scale " + number_text(options.scale) + " is not a positive number"};
    if (text.size() > std::numeric_limits<std::uint32_t>::max())
        return Error{ErrorCode::kTooLarge, std::string(name), "more than 4 GiB of text"};
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    if (const std::size_t at = find_control_byte(text); at != text.size())
        return error_at_line(ErrorCode::kMalformed, name, line_of(text, at),
                             "byte " + quote(text.substr(at, 1)) + ": this is not a text file");

    ObjParser parser(text, name, options.scale == 0 ? 1 : options.scale, visitor);
    while (parser.next())
        if (auto error = parser.entry()) return *std::move(error);
    if (parser.counts().faces == 0) return Error{ErrorCode::kMalformed, std::string(name), "no face (f) in the file"};
    return parser.counts();
}

}  // namespace firma
