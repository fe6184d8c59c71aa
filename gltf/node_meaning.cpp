// SPDX-License-Identifier: MIT
// What a node's name and extras say about its faces.
#include "gltf/node_meaning.h"

#include <utility>

#include "firma/level.h"
#include "level/message.h"

namespace firma::gltf {
namespace {

constexpr std::pair<std::string_view, std::uint32_t> kWords[] = {{"walk", kStopsWalk}, {"shoot", kStopsShots},
                                                                 {"see", kStopsSight}, {"liquid", kStopsLiquid},
                                                                 {"sky", kIsSky},      {"none", 0}};

constexpr std::size_t kMostNotes = 64;  // a file may say as many wrong things as it likes

bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

std::string small_letters(std::string_view text) {
    std::string small(text);
    for (char& c : small)
        if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
    return small;
}

/// As editors write a tick: true, 1, 1.0, "true".
std::optional<bool> truth_of(std::string_view text) {
    const std::string word = small_letters(text);
    if (word == "true" || word == "1" || word == "1.0") return true;
    if (word == "false" || word == "0" || word == "0.0") return false;
    return std::nullopt;
}

/// Words between whatever is no letter, so that texts as well as JSON lists of texts will do.
std::optional<std::uint32_t> mask_of(std::string_view text) {
    std::uint32_t mask = 0;
    bool any = false;
    for (std::size_t first = 0; first < text.size();) {
        if (!is_letter(text[first])) {
            ++first;
            continue;
        }
        std::size_t end = first;
        while (end < text.size() && is_letter(text[end])) ++end;
        const std::string word = small_letters(text.substr(first, end - first));
        bool known = false;
        for (const auto& [name, bits] : kWords) {
            if (word != name) continue;
            mask |= bits;
            known = true;
        }
        if (!known) return std::nullopt;
        any = true;
        first = end;
    }
    return any ? std::optional(mask) : std::nullopt;
}

}  // namespace

NodeMeaning meaning_of(std::string_view name, const Extras& extras, std::set<std::string>& notes) {
    NodeMeaning meaning;
    if (small_letters(name.substr(0, 6)) == "portal") meaning.portal = true;
    for (const std::string_view wanted :
         {"portal", "firma_portal", "part", "firma_part", "mask", "firma_mask"}) {  // ours last: it decides
        for (const auto& [key, text] : extras) {
            if (key != wanted) continue;
            const bool mask = wanted.ends_with("mask");
            const std::optional<std::uint32_t> bits = mask ? mask_of(text) : std::nullopt;
            const std::optional<bool> truth = mask ? std::nullopt : truth_of(text);
            if (bits) meaning.mask = bits;
            if (truth) (wanted.ends_with("part") ? meaning.part : meaning.portal) = truth;
            if (!bits && !truth && notes.size() < kMostNotes)
                notes.insert("extras." + std::string(wanted) + " of " + quote(text) + " is not understood" +
                             (mask ? ": words walk, shoot, see, liquid, sky, or none" : ": true or false"));
        }
    }
    return meaning;
}

}  // namespace firma::gltf
