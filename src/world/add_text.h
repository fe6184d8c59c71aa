// SPDX-License-Identifier: MIT
// Text in a hash.
#pragma once

#include <string>

#include "base/hasher.h"

namespace firma {

/// Its length, and eight letters a word.
inline void add_text(Hasher& hasher, const std::string& text) {
    hasher.add(text.size());
    std::uint64_t word = 0;
    for (std::size_t k = 0; k < text.size(); ++k) {
        word = word << 8 | static_cast<unsigned char>(text[k]);
        if (k % 8 == 7 || k + 1 == text.size()) {
            hasher.add(word);
            word = 0;
        }
    }
}

}  // namespace firma
