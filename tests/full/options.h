// SPDX-License-Identifier: MIT
// What the programs of the large numbers are told on their command lines: words, each followed by its value.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

namespace firma::full {

/// What every program takes.
struct Options {
    std::uint64_t count = 0, seed = 1;
    int threads = 1;
    std::size_t show = 3;  ///< failures printed
};

/// One more number, or one more text.
struct ExtraOption {
    std::string word;
    std::uint64_t* number = nullptr;
    std::string* text = nullptr;
};

/// @return false when a word is not known or has no value
inline bool read_options(int count, char** words, Options& options, const std::vector<ExtraOption>& extra) {
    for (int k = 1; k < count; k += 2) {
        if (k + 1 >= count) return false;
        const std::string word = words[k];
        const std::uint64_t number = std::strtoull(words[k + 1], nullptr, 10);
        const auto more = std::find_if(extra.begin(), extra.end(), [&](const auto& it) { return it.word == word; });
        if (more != extra.end()) {
            if (more->number) *more->number = number;
            if (more->text) *more->text = words[k + 1];
        } else if (word == "--count") {
            options.count = number;
        } else if (word == "--seed") {
            options.seed = number;
        } else if (word == "--threads") {
            options.threads = int(std::clamp<std::uint64_t>(number, 1, 64));
        } else if (word == "--show") {
            options.show = std::size_t(number);
        } else {
            return false;
        }
    }
    return true;
}

}  // namespace firma::full
