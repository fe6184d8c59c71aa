// SPDX-License-Identifier: MIT
// Tables of matters: the built-in one, what a table must hold, and which texture is of which matter.
#include <algorithm>
#include <cmath>

#include "firma/matter.h"
#include "firma/vec.h"

namespace firma {
namespace {

constexpr std::string_view kStyles[] = {"chunks", "splinters", "bends", "pane"};

struct BuiltIn {
    const char* name;
    double density, strength;
    FractureStyle fracture;
    std::initializer_list<const char*> patterns;
};

MatterTable make_default() {
    // Densities and tensile strengths are rounded from usual tables of building materials. A name that two fit is of
    // the first.
    const BuiltIn kBuiltIn[] = {
        {"brick", 1900, 2, FractureStyle::kChunks, {"*brick*"}},
        {"concrete", 2400, 3, FractureStyle::kChunks, {"*concrete*", "*cement*", "*plaster*"}},
        {"wood", 600, 40, FractureStyle::kSplinters, {"*wood*", "*timber*", "*plank*", "*crate*"}},
        {"steel", 7850, 400, FractureStyle::kBends, {"*steel*", "*metal*", "*iron*", "*girder*"}},
        {"glass", 2500, 40, FractureStyle::kPane, {"*glass*", "*window*"}},
        {"rock", 2600, 8, FractureStyle::kChunks, {"*rock*", "*stone*", "*granite*", "*cliff*"}},
    };
    MatterTable table;
    // Before all others: what lies in this folder is glass to the readers of brushes, whatever its name says.
    const std::uint32_t kGlass = 5;
    table.patterns = {{"glass/*", kGlass}, {"*/glass/*", kGlass}};
    for (const BuiltIn& it : kBuiltIn) {
        Matter matter;
        matter.name = it.name;
        matter.inside = std::string("matter/") + it.name;
        matter.density = it.density;
        matter.strength = it.strength;
        matter.fracture = it.fracture;
        for (const char* pattern : it.patterns)
            table.patterns.push_back({pattern, std::uint32_t(table.matters.size())});
        table.matters.push_back(std::move(matter));
    }
    return table;
}

char small(char letter) {
    return letter >= 'A' && letter <= 'Z' ? char(letter - 'A' + 'a') : letter == '\\' ? '/' : letter;
}

/// Goes back to the last star only, so it takes at most the product of the lengths.
bool fits(std::string_view pattern, std::string_view name) {
    std::size_t p = 0, n = 0, star = std::string_view::npos, from = 0;
    while (n < name.size()) {
        if (p < pattern.size() && pattern[p] == '*') {
            star = p++;
            from = n;
        } else if (p < pattern.size() && small(pattern[p]) == small(name[n])) {
            ++p;
            ++n;
        } else if (star != std::string_view::npos) {
            p = star + 1;
            n = ++from;
        } else {
            return false;
        }
    }
    while (p < pattern.size() && pattern[p] == '*') ++p;
    return p == pattern.size();
}

std::optional<std::string> fault_of(const Matter& matter) {
    if (matter.name.size() > kMaxMatterText || matter.inside.size() > kMaxMatterText)
        return "has a text of more than " + std::to_string(kMaxMatterText) + " bytes";
    if (!(matter.density > 0) || !is_finite(matter.density)) return "its density is no finite number above zero";
    if (!(matter.strength >= 0) || !is_finite(matter.strength))
        return "its strength is no finite number, or below zero";
    if (!(matter.hardness >= 0 && matter.hardness <= 1)) return "its hardness is not within 0 and 1";
    if (fracture_style_name(matter.fracture).empty()) return "its fracture style is none";
    return std::nullopt;
}

}  // namespace

std::optional<FractureStyle> fracture_style(std::string_view name) {
    for (std::size_t k = 0; k < std::size(kStyles); ++k)
        if (kStyles[k] == name) return FractureStyle(k);
    return std::nullopt;
}

std::string_view fracture_style_name(FractureStyle style) {
    return std::size_t(style) < std::size(kStyles) ? kStyles[std::size_t(style)] : "";
}

const MatterTable& default_matters() {
    static const MatterTable table = make_default();
    return table;
}

std::optional<Error> check_matters(const MatterTable& table, const std::string& name) {
    const auto fault = [&](const std::string& place, std::string reason) {
        return Error{ErrorCode::kInvalid, name.empty() ? place : name + ": " + place, std::move(reason)};
    };
    if (table.matters.empty()) return fault("matters", "there is none");
    if (table.matters.size() > kMaxMatters || table.patterns.size() > kMaxMatters)
        return fault("matters", "there are more than " + std::to_string(kMaxMatters) + " of them, or of patterns");
    for (std::size_t k = 0; k < table.matters.size(); ++k) {
        const Matter& matter = table.matters[k];
        const std::string place = "matter " + std::to_string(k) + (matter.name.empty() ? "" : " '" + matter.name + "'");
        if (const auto reason = fault_of(matter)) return fault(place, *reason);
        if (*matter_named(table, matter.name) != k) return fault(place, "another one has the same name");
    }
    for (std::size_t k = 0; k < table.patterns.size(); ++k) {
        const MatterPattern& it = table.patterns[k];
        if (it.matter >= table.matters.size())
            return fault("pattern " + std::to_string(k), "it is of a matter that is not there");
        if (it.pattern.empty() || it.pattern.size() > kMaxMatterText)
            return fault("pattern " + std::to_string(k),
                         "it is empty, or of more than " + std::to_string(kMaxMatterText) + " bytes");
    }
    return std::nullopt;
}

std::optional<std::uint32_t> matter_named(const MatterTable& table, std::string_view name) {
    for (std::uint32_t k = 0; k < table.matters.size(); ++k)
        if (table.matters[k].name == name) return k;
    return std::nullopt;
}

std::uint32_t matter_of_texture(const MatterTable& table, std::string_view texture) {
    const std::string_view last = texture.substr(texture.find_last_of("/\\") + 1);  // npos + 1 is 0
    for (const MatterPattern& it : table.patterns)
        if (fits(it.pattern, it.pattern.find('/') == std::string::npos ? last : texture)) return it.matter;
    return 0;
}

}  // namespace firma
