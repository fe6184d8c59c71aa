// SPDX-License-Identifier: MIT
// A table of matters as text: a key and its value a line. docs/formats.md has the form.
#include <algorithm>
#include <string_view>
#include <utility>

#include "firma/matter.h"
#include "level/message.h"
#include "level/parse_number.h"
#include "level/read_file.h"

namespace firma {
namespace {

bool is_blank_letter(char letter) {
    return letter == ' ' || letter == '\t' || letter == '\r';
}

std::string_view without_blanks(std::string_view text) {
    while (!text.empty() && is_blank_letter(text.front())) text.remove_prefix(1);
    while (!text.empty() && is_blank_letter(text.back())) text.remove_suffix(1);
    return text;
}

class MatterReader {
public:
    explicit MatterReader(const std::string& name) : name_(name) {}

    std::optional<Error> line(std::string_view text) {
        ++line_;
        if (text.find('\0') != std::string_view::npos) return fault("holds a zero byte");
        text = without_blanks(text);
        if (text.empty() || text.front() == '#') return std::nullopt;
        const std::size_t end = std::min(text.find_first_of(" \t"), text.size());
        const std::string_view key = text.substr(0, end), value = without_blanks(text.substr(end));
        if (value.empty()) return fault(quote(key) + " has no value");
        if (value.size() > kMaxMatterText)
            return fault("a value of more than " + std::to_string(kMaxMatterText) + " bytes");
        if (key == "matter") return begin(value);
        if (key == "default") return set_default(value);
        if (key != "inside" && key != "texture" && key != "density" && key != "strength" && key != "hardness" &&
            key != "fracture")
            return fault(quote(key) +
                         " is none of: matter, inside, texture, density, strength, hardness, fracture, "
                         "default");
        if (table_.matters.size() == 1) return fault(quote(key) + " stands before the first 'matter'");
        return set(key, value, table_.matters.back());
    }

    Result<MatterTable> finish() {
        if (table_.matters.size() == 1) return Error{ErrorCode::kMalformed, name_, "there is no 'matter' in it"};
        if (default_.empty()) return std::move(table_);
        const std::optional<std::uint32_t> found = matter_named(table_, default_);
        line_ = default_line_;
        if (!found) return fault("no matter " + quote(default_) + " is in the table");
        // In place of the one without a name, which the table then does without.
        std::swap(table_.matters[0], table_.matters[*found]);
        table_.matters.erase(table_.matters.begin() + std::ptrdiff_t(*found));
        for (MatterPattern& it : table_.patterns)
            it.matter = it.matter == *found ? 0 : it.matter - (it.matter > *found);
        return std::move(table_);
    }

private:
    Error fault(std::string reason) const {
        return error_at_line(ErrorCode::kMalformed, name_, line_, std::move(reason));
    }

    std::optional<Error> begin(std::string_view value) {
        if (matter_named(table_, value)) return fault("there is a matter " + quote(value) + " already");
        if (table_.matters.size() == kMaxMatters)
            return fault("more than " + std::to_string(kMaxMatters - 1) + " matters");
        Matter& matter = table_.matters.emplace_back();
        matter.name = value;
        return std::nullopt;
    }

    std::optional<Error> set_default(std::string_view value) {
        if (!default_.empty()) return fault("a second 'default'");
        default_ = value;
        default_line_ = line_;
        return std::nullopt;
    }

    std::optional<Error> set(std::string_view key, std::string_view value, Matter& matter) {
        if (key == "inside") {
            matter.inside = value;
            return std::nullopt;
        }
        if (key == "texture") {
            if (table_.patterns.size() == kMaxMatters)
                return fault("more than " + std::to_string(kMaxMatters) + " textures");
            table_.patterns.push_back({std::string(value), std::uint32_t(table_.matters.size()) - 1});
            return std::nullopt;
        }
        if (key == "fracture") {
            const std::optional<FractureStyle> style = fracture_style(value);
            if (!style) return fault(quote(value) + " is none of: chunks, splinters, bends, pane");
            matter.fracture = *style;
            return std::nullopt;
        }
        const std::optional<double> parsed = parse_number(value);
        if (!parsed || !is_finite(*parsed)) return fault(quote(value) + " is no finite number");
        const double number = *parsed;
        if (key == "density") {
            if (!(number > 0)) return fault("a density must be above zero");
            matter.density = number;
        } else if (key == "strength") {
            if (!(number >= 0)) return fault("a strength must not be below zero");
            matter.strength = number;
        } else {
            if (!(number >= 0 && number <= 1)) return fault("a hardness must be within 0 and 1");
            matter.hardness = number;
        }
        return std::nullopt;
    }

    const std::string& name_;
    std::uint32_t line_ = 0, default_line_ = 0;
    MatterTable table_;  ///< the first is that without a name
    std::string default_;
};

}  // namespace

Result<MatterTable> read_matters(std::string_view text, const std::string& name) {
    MatterReader reader(name);
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        if (auto error = reader.line(text.substr(0, end))) return *std::move(error);
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return reader.finish();
}

Result<MatterTable> read_matter_file(const std::string& path) {
    const Result<std::string> bytes = read_file(path);
    if (!bytes) return bytes.error();
    return read_matters(bytes.value(), path);
}

}  // namespace firma
