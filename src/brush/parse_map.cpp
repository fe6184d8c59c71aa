// SPDX-License-Identifier: MIT
// Parses .map files: Standard and Valve 220 brushes, patchDef2; walks by loops alone, whatever the nesting.
//
//   map    = { entity }
//   entity = "{" { key value | brush } "}"
//   brush  = "{" { side } "}" | "{" "patchDef2" patch "}" | "{" unknown-word ... "}"
//   side   = 3 * ( "(" x y z ")" ) texture alignment { further }
//   alignment = xoff yoff rotation xscale yscale                                             (Standard)
//             | "[" ux uy uz offset "]" "[" vx vy vz offset "]" rotation xscale yscale       (Valve 220)
//   further = contents flags value, or what other games put there
//   patch  = "{" texture "(" width height contents flags value ")" "(" width * column ")" "}"
//   column = "(" height * ( "(" x y z s t ")" ) ")"
#include "brush/parse_map.h"

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
                notes_.add("'Version' is not understood", at(token.line));  // Doom 3 begins so
                tokens_.next();
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
            if (first.text == "patchDef2") return patch(line);
            notes_.add("primitive " + quote(first.text) + " is not understood", at(first.line) + context());
            return skip_to_close(first);
        }
        MapBrush found;
        found.first_side = std::uint32_t(file.sides.size());
        found.entity = std::uint32_t(file.entities.size() - 1);
        found.number = number_;
        found.line = line;
        while (tokens_.peek().is('(')) {
            if (found.side_count == kMostBrushSides) {
                return Error{ErrorCode::kTooLarge, at(tokens_.peek().line),
                             "more than " + std::to_string(kMostBrushSides) + " sides" + context()};
            }
            if (Fault fault = side()) return fault;
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
        if (!std::isfinite(*parsed)) {
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

    Fault side() {
        MapSide found;
        found.line = tokens_.peek().line;
        for (Vec3& point : found.points) {
            double xyz[3] = {};
            if (Fault fault = numbers('(', xyz, ')', "a point")) return fault;
            point = {xyz[0], xyz[1], xyz[2]};
        }
        if (Fault fault = name(found.texture)) return fault;
        if (Fault fault = alignment()) return fault;
        further(found);
        file.sides.push_back(std::move(found));
        return std::nullopt;
    }

    // How the texture lies: must be there and be numbers, and is left.
    Fault alignment() {
        constexpr std::string_view kOf = "the texture's alignment";
        double values[5] = {};
        if (!tokens_.peek().is('[')) return numbers(values, kOf);
        for (int axis = 0; axis < 2; ++axis)
            if (Fault fault = numbers('[', std::span(values).first(4), ']', kOf)) return fault;
        return numbers(std::span(values).first(3), kOf);
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

    Fault patch(std::uint32_t line) {
        const MapToken open = tokens_.next();
        if (open.kind != Kind::kOpen) return expected("{ of a patch", open);
        MapPatch found;
        found.entity = std::uint32_t(file.entities.size() - 1);
        found.number = number_;
        found.line = line;
        if (Fault fault = name(found.texture)) return fault;
        const std::uint32_t head = tokens_.peek().line;
        double sizes[5] = {};
        if (Fault fault = numbers('(', sizes, ')', "a patch's size")) return fault;
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
        found.contents = flags_of(sizes[2]);
        found.flags = flags_of(sizes[3]);
        if (Fault fault = control_points(found.patch)) return fault;
        for (const std::string_view of : {"the patch", "the patch's brush"}) {
            const MapToken close = tokens_.next();
            if (close.kind != Kind::kClose) return expected("} of " + std::string(of), close);
        }
        file.patches.push_back(std::move(found));
        return std::nullopt;
    }

    // Column by column in the file, row by row in a Patch. Taken as they come: a size alone takes no memory.
    Fault control_points(Patch& patch) {
        constexpr std::string_view kOf = "a patch's points";
        std::vector<Vec3> columns;
        if (Fault fault = expect('(', kOf)) return fault;
        for (std::uint32_t x = 0; x < patch.width; ++x) {
            if (Fault fault = expect('(', kOf)) return fault;
            for (std::uint32_t y = 0; y < patch.height; ++y) {
                double values[5] = {};
                if (Fault fault = numbers('(', values, ')', kOf)) return fault;
                columns.push_back({values[0], values[1], values[2]});
            }
            if (Fault fault = expect(')', kOf)) return fault;
        }
        if (Fault fault = expect(')', kOf)) return fault;
        for (std::uint32_t y = 0; y < patch.height; ++y)
            for (std::uint32_t x = 0; x < patch.width; ++x)
                patch.control.push_back(columns[std::size_t(x) * patch.height + y]);
        return std::nullopt;
    }

    MapTokens tokens_;
    std::string place_;
    NoteList& notes_;
    std::uint32_t number_ = 0;  // of the brush at hand
    bool in_entity_ = false, in_brush_ = false;
};

}  // namespace

Result<MapFile> parse_map(std::string_view text, std::string_view place, NoteList& notes) {
    if (text.size() > std::numeric_limits<std::uint32_t>::max()) {
        return Error{ErrorCode::kTooLarge, std::string(place) + "1", "more than 4 GiB of text"};
    }
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    MapParser parser(text, place, notes);
    if (Fault fault = parser.parse()) return *std::move(fault);
    return std::move(parser.file);
}

}  // namespace firma
