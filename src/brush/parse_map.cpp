// SPDX-License-Identifier: MIT
// Parses .map files: Standard and Valve 220 brushes, brushDef, brushDef3, patchDef2, patchDef3; walks by loops alone,
// whatever the nesting.
//
//   map    = [ "Version" number ] { entity }
//   entity = "{" { key value | brush } "}"
//   brush  = "{" { side } "}" | "{" ( "patchDef2" | "patchDef3" ) patch "}"
//          | "{" ( "brushDef" | "brushDef3" ) "{" { key value | primitive } "}" "}" | "{" unknown-word ... "}"
//   side   = 3 * ( "(" x y z ")" ) texture alignment { further }
//   alignment = xoff yoff rotation xscale yscale                                             (Standard)
//             | "[" ux uy uz offset "]" "[" vx vy vz offset "]" rotation xscale yscale       (Valve 220)
//   primitive = plane "(" 2 * ( "(" 3 numbers ")" ) ")" texture { further }
//   plane  = 3 * ( "(" x y z ")" )                                                             (brushDef)
//          | "(" a b c d ")", outside where a x + b y + c z + d > 0                            (brushDef3)
//   further = contents flags value, or what other games put there
//   patch  = "{" texture "(" width height [ divisions divisions ] contents flags value ")" "(" width * column ")" "}"
//   column = "(" height * ( "(" x y z s t ")" ) ")"
#include "brush/parse_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "brush/map_tokens.h"
#include "level/message.h"
#include "level/parse_number.h"

namespace firma {
namespace {

using Kind = MapToken::Kind;
using Fault = std::optional<Error>;

constexpr double kMostPatchSize = 1023;  // control points in a row or a column; engines hold 31 and 63

// A whole number as the flags it stands for, negative ones in two's complement; 0 for what is none.
std::uint32_t flags_of(double value) {
    constexpr double kMost = 4294967296;
    if (!(value > -kMost && value < kMost) || std::floor(value) != value) return 0;
    return std::uint32_t(std::int64_t(value));
}

class MapParser {
public:
    MapParser(std::string_view text, std::string_view place, NoteList& notes)
        : tokens_(text), place_(place), notes_(notes) {}

    Fault parse() {
        for (;;) {
            const MapToken token = tokens_.next();
            if (token.kind == Kind::kEnd) return std::nullopt;
            if (token.kind == Kind::kOpen) {
                if (Fault fault = entity(token.line)) return fault;
            } else if (token.kind == Kind::kWord && token.text == "Version") {
                if (Fault fault = version()) return fault;
            } else {
                return expected("{ of an entity", token);
            }
        }
    }

    MapFile file;

private:
    std::string at(std::uint32_t line) const { return place_ + std::to_string(line); }

    Error malformed(std::uint32_t line, std::string reason) const {
        return {ErrorCode::kMalformed, at(line), std::move(reason)};
    }

    Error expected(std::string_view what, const MapToken& found) const {
        if (found.kind == Kind::kBroken) return malformed(found.line, "quote without an end: " + quote(found.text));
        const std::string instead = found.kind == Kind::kEnd ? "the file ends" : "found " + quote(found.text);
        return malformed(found.line, "expected " + std::string(what) + context() + ", " + instead);
    }

    // Where we are, for messages: " in brush 3 of entity 0".
    std::string context() const {
        if (file.entities.empty()) return {};
        const std::string entity =
            (in_entity_ ? " of entity " : " after entity ") + std::to_string(file.entities.size() - 1);
        return in_brush_ ? " in brush " + std::to_string(number_) + entity : entity;
    }

    Fault version() {
        file.has_version = true;
        double ignored = 0;
        return number(ignored, "the version");
    }

    Fault entity(std::uint32_t line) {
        file.entities.emplace_back().line = line;
        number_ = 0;
        in_entity_ = true;
        for (;;) {
            const MapToken token = tokens_.next();
            switch (token.kind) {
                case Kind::kClose:
                    in_entity_ = false;
                    return std::nullopt;
                case Kind::kOpen:
                    in_brush_ = true;
                    if (Fault fault = brush(token.line)) return fault;
                    in_brush_ = false;
                    ++number_;
                    break;
                case Kind::kString:
                case Kind::kWord:
                    if (Fault fault = key(token)) return fault;
                    break;
                default:
                    return expected("a key, a brush or }", token);
            }
        }
    }

    Fault key(const MapToken& name) {
        const MapToken value = tokens_.next();
        if (value.kind != Kind::kString && value.kind != Kind::kWord) {
            return expected("a value for the key " + quote(name.text), value);
        }
        file.entities.back().keys.emplace_back(unescape(name.text), unescape(value.text));
        return std::nullopt;
    }

    Fault brush(std::uint32_t line) {
        const MapToken first = tokens_.peek();
        if (first.kind == Kind::kWord) {
            tokens_.next();
            if (first.text == "patchDef2") return patch(line, 0);
            if (first.text == "patchDef3") return patch(line, 2);
            if (first.text == "brushDef") return primitive(line, Form::kPrimitive);
            if (first.text == "brushDef3") return primitive(line, Form::kPlane);
            notes_.leave_out("primitive " + quote(first.text) + " is not understood", "primitives " + quote(first.text),
                             at(first.line) + context());
            return skip_to_close(first);
        }
        return sides(line, Form::kSide);
    }

    // How a side is written.
    enum class Form : std::uint8_t { kSide, kPrimitive, kPlane };

    Fault primitive(std::uint32_t line, Form form) {
        file.has_primitives = true;
        const MapToken open = tokens_.next();
        if (open.kind != Kind::kOpen) return expected("{ of a brush's sides", open);
        if (Fault fault = sides(line, form)) return fault;
        const MapToken close = tokens_.next();
        if (close.kind != Kind::kClose) return expected("} of the brush", close);
        return std::nullopt;
    }

    // To the brace that closes them.
    Fault sides(std::uint32_t line, Form form) {
        MapBrush found;
        found.first_side = std::uint32_t(file.sides.size());
        found.entity = std::uint32_t(file.entities.size() - 1);
        found.number = number_;
        found.line = line;
        for (;;) {
            const MapToken token = tokens_.peek();
            if (form != Form::kSide && token.kind == Kind::kString) {  // keys of a brush, for editors
                tokens_.next();
                const MapToken value = tokens_.next();
                if (value.kind != Kind::kString) return expected("a value for the key " + quote(token.text), value);
                continue;
            }
            if (!token.is('(')) break;
            if (found.side_count == kMostBrushSides) {
                return Error{ErrorCode::kTooLarge, at(token.line),
                             "more than " + std::to_string(kMostBrushSides) + " sides" + context()};
            }
            if (Fault fault = side(form)) return fault;
            ++found.side_count;
        }
        const MapToken close = tokens_.next();
        if (close.kind != Kind::kClose) return expected("( of a side or }", close);
        file.brushes.push_back(found);
        return std::nullopt;
    }

    // To the brace that closes the brush. Names may begin with braces, so only those that stand alone count.
    Fault skip_to_close(const MapToken& what) {
        for (std::uint64_t depth = 1;;) {
            const MapToken token = tokens_.next_run();
            if (token.kind == Kind::kEnd) {
                return malformed(what.line, quote(what.text) + context() + " has no end: braces do not match");
            }
            if (token.text.find_first_not_of("{}") != std::string_view::npos) continue;
            for (const char& brace : token.text) {
                depth += brace == '{' ? 1 : std::uint64_t(-1);
                if (depth > 0) continue;
                const char* from = what.text.data();
                file.entities.back().unknown.push_back({std::string(from, std::size_t(&brace - from)), what.line});
                return std::nullopt;
            }
        }
    }

    Fault expect(char mark, std::string_view of) {
        const MapToken token = tokens_.next();
        if (token.is(mark)) return std::nullopt;
        return expected(std::string(1, mark) + " of " + std::string(of), token);
    }

    Fault number(double& value, std::string_view of) {
        const MapToken token = tokens_.next();
        const std::optional<double> parsed =
            token.kind == Kind::kWord ? parse_number(token.text) : std::optional<double>();
        if (!parsed) return expected("a number of " + std::string(of), token);
        if (!is_finite(*parsed)) {
            return Error{ErrorCode::kOutOfRange, at(token.line),
                         quote(token.text) + context() + " is too large for a number"};
        }
        value = *parsed;
        return std::nullopt;
    }

    Fault numbers(std::span<double> values, std::string_view of) {
        for (double& value : values)
            if (Fault fault = number(value, of)) return fault;
        return std::nullopt;
    }

    // Numbers between marks.
    Fault numbers(char open, std::span<double> values, char close, std::string_view of) {
        if (Fault fault = expect(open, of)) return fault;
        if (Fault fault = numbers(values, of)) return fault;
        return expect(close, of);
    }

    Fault name(std::string& into) {
        const MapToken token = tokens_.next_name();
        if (token.kind == Kind::kString) {
            into = unescape(token.text);
        } else if (token.kind == Kind::kWord) {
            into = std::string(token.text);
        } else {
            return expected("a texture", token);
        }
        return std::nullopt;
    }

    Fault side(Form form) {
        MapSide found;
        found.line = tokens_.peek().line;
        if (Fault fault = form == Form::kPlane ? plane(found) : points(found)) return fault;
        if (form != Form::kSide)
            if (Fault fault = texture_matrix(found.alignment)) return fault;
        if (Fault fault = name(found.texture)) return fault;
        if (form == Form::kSide)
            if (Fault fault = alignment(found.alignment)) return fault;
        further(found);
        file.sides.push_back(std::move(found));
        return std::nullopt;
    }

    Fault points(MapSide& into) {
        for (Vec3& point : into.points) {
            double xyz[3] = {};
            if (Fault fault = numbers('(', xyz, ')', "a point")) return fault;
            point = {xyz[0], xyz[1], xyz[2]};
        }
        return std::nullopt;
    }

    Fault plane(MapSide& into) {
        double abcd[4] = {};
        if (Fault fault = numbers('(', abcd, ')', "a plane")) return fault;
        const Vec3 normal = {abcd[0], abcd[1], abcd[2]};
        const double size = length(normal);
        const double distance = -abcd[3] / size;
        if (!(size > 0) || !is_finite(size) || !is_finite(distance))
            return malformed(into.line, "a plane" + context() + " has no normal");
        into.plane = FloatPlane{normal * (1 / size), distance};
        for (int axis = 0; axis < 3; ++axis)  // 0.3 * (1 / 0.3) may not be 1
            if (std::fabs(normal[axis]) == size) into.plane->normal[axis] = normal[axis] > 0 ? 1 : -1;
        return std::nullopt;
    }

    Fault texture_matrix(MapAlignment& into) {
        constexpr std::string_view kOf = "the texture's matrix";
        into.form = MapAlignment::Form::kMatrix;
        if (Fault fault = expect('(', kOf)) return fault;
        for (double* row : {into.u, into.v})
            if (Fault fault = numbers('(', std::span(row, 3), ')', kOf)) return fault;
        return expect(')', kOf);
    }

    Fault alignment(MapAlignment& into) {
        constexpr std::string_view kOf = "the texture's alignment";
        if (tokens_.peek().is('[')) {
            into.form = MapAlignment::Form::kAxes;
            for (double* axis : {into.u, into.v})
                if (Fault fault = numbers('[', std::span(axis, 4), ']', kOf)) return fault;
        } else {
            for (double* offset : {&into.u[3], &into.v[3]})
                if (Fault fault = number(*offset, kOf)) return fault;
        }
        if (Fault fault = number(into.rotation, kOf)) return fault;
        return numbers(into.scale, kOf);
    }

    // Contents, flags and value; other games have further words there.
    void further(MapSide& into) {
        for (std::uint32_t k = 0; tokens_.peek().kind == Kind::kWord; ++k) {
            const MapToken token = tokens_.next();
            const std::optional<double> value = parse_number(token.text);
            if (k < 2 && value) (k == 0 ? into.contents : into.flags) = flags_of(*value);
            if (k >= 3 || !value) notes_.add("further words of a side are left", at(token.line) + context());
        }
    }

    // Doom 3's say in how many pieces a patch is to be divided each way; as with others, the tolerance does.
    Fault patch(std::uint32_t line, std::size_t divisions) {
        file.has_primitives = true;
        const MapToken open = tokens_.next();
        if (open.kind != Kind::kOpen) return expected("{ of a patch", open);
        MapPatch found;
        found.entity = std::uint32_t(file.entities.size() - 1);
        found.number = number_;
        found.line = line;
        if (Fault fault = name(found.texture)) return fault;
        const std::uint32_t head = tokens_.peek().line;
        double sizes[7] = {};
        if (Fault fault = numbers('(', std::span(sizes).first(5 + divisions), ')', "a patch's size")) return fault;
        for (int k = 0; k < 2; ++k) {
            const double size = sizes[k];
            if (!(size >= 3 && size <= kMostPatchSize) || std::floor((size - 1) / 2) * 2 + 1 != size) {
                return malformed(head, "patch of " + number_text(sizes[0]) + " x " + number_text(sizes[1]) +
                                           " control points" + context() + "; both must be odd, from 3 to " +
                                           number_text(kMostPatchSize));
            }
        }
        found.patch.width = std::uint32_t(sizes[0]);
        found.patch.height = std::uint32_t(sizes[1]);
        found.contents = flags_of(sizes[2 + divisions]);
        found.flags = flags_of(sizes[3 + divisions]);
        if (Fault fault = control_points(found.patch, found.uvs)) return fault;
        for (const std::string_view of : {"the patch", "the patch's brush"}) {
            const MapToken close = tokens_.next();
            if (close.kind != Kind::kClose) return expected("} of " + std::string(of), close);
        }
        file.patches.push_back(std::move(found));
        return std::nullopt;
    }

    // Column by column in the file, row by row in a Patch. Taken as they come: a size alone takes no memory.
    Fault control_points(Patch& patch, Patch& uvs) {
        constexpr std::string_view kOf = "a patch's points";
        std::vector<Vec3> columns, uv_columns;
        if (Fault fault = expect('(', kOf)) return fault;
        for (std::uint32_t x = 0; x < patch.width; ++x) {
            if (Fault fault = expect('(', kOf)) return fault;
            for (std::uint32_t y = 0; y < patch.height; ++y) {
                double values[5] = {};
                if (Fault fault = numbers('(', values, ')', kOf)) return fault;
                columns.push_back({values[0], values[1], values[2]});
                uv_columns.push_back({values[3], values[4], 0});
            }
            if (Fault fault = expect(')', kOf)) return fault;
        }
        if (Fault fault = expect(')', kOf)) return fault;
        uvs.width = patch.width;
        uvs.height = patch.height;
        for (std::uint32_t y = 0; y < patch.height; ++y)
            for (std::uint32_t x = 0; x < patch.width; ++x) {
                patch.control.push_back(columns[std::size_t(x) * patch.height + y]);
                uvs.control.push_back(uv_columns[std::size_t(x) * patch.height + y]);
            }
        return std::nullopt;
    }

    MapTokens tokens_;
    std::string place_;
    NoteList& notes_;
    std::uint32_t number_ = 0;  // of the brush at hand
    bool in_entity_ = false, in_brush_ = false;
};

// Of the comments at the top.
std::string format_of(std::string_view text) {
    constexpr std::string_view kKey = "// Format: ";
    while (!text.empty()) {
        const std::string_view line = text.substr(0, text.find_first_of("\r\n"));
        if (line.starts_with(kKey)) return std::string(line.substr(kKey.size()));
        if (!line.empty() && !line.starts_with("//")) break;
        text.remove_prefix(std::min(text.size(), line.size() + 1));
    }
    return {};
}

}  // namespace

Result<MapFile> parse_map(std::string_view text, std::string_view place, NoteList& notes) {
    if (text.size() > std::numeric_limits<std::uint32_t>::max()) {
        return Error{ErrorCode::kTooLarge, std::string(place) + "1", "more than 4 GiB of text"};
    }
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    MapParser parser(text, place, notes);
    parser.file.format = format_of(text);
    if (Fault fault = parser.parse()) return *std::move(fault);
    return std::move(parser.file);
}

}  // namespace firma
