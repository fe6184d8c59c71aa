// SPDX-License-Identifier: MIT
// How the bins over a room's faces are made, and what they came to.
#pragma once

#include <cstddef>
#include <cstdint>

#include "firma/vec.h"

namespace firma {

enum class Split : std::uint8_t {
    kLongestAxis,  ///< the article's: the bin's box in half across its longest axis, faces by their centre
    kSurfaceArea,  ///< where the expected cost, by surface area, is least
};

/// The article's three stop rules, all at once; a bin that meets any of them is not divided further.
struct TreeOptions {
    Split split = Split::kLongestAxis;
    int max_depth = 48;         ///< bins above a bin, 0..64; out of range counts as the nearest end
    int faces_per_bin = 4;      ///< a bin of at most this many is done, >= 1
    double min_bin_volume = 0;  ///< cubic metres; a bin whose box holds less is done
};

/// What a tree came to.
struct TreeStatistics {
    std::size_t faces = 0;
    std::size_t blocks = 0;  ///< immutable pieces of up to 64 items
    std::size_t bins = 0;    ///< inner ones and leaves
    std::size_t leaf_bins = 0;
    int depth = 0;                ///< bins above the deepest leaf
    std::size_t largest_bin = 0;  ///< faces in the fullest leaf
    double overlap = 0;           ///< mean over inner bins: area shared by both children / area of the bin, 0..1
    std::size_t bytes = 0;        ///< tree and faces, resident
    FIRMA_INLINE double bytes_per_face() const { return faces ? double(bytes) / double(faces) : 0; }
};

}  // namespace firma
