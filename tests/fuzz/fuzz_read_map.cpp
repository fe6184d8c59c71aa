// SPDX-License-Identifier: MIT
// Any bytes as a .map: an error with a place, or a sound level of brushes.
#include <cstdint>
#include <string_view>

#include "tests/fuzz/expect_sound_brushes.h"

using namespace firma;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    for (const ReadOptions& options : {ReadOptions{}, ReadOptions{.scale = 0.3, .patch_tolerance = 0.5}}) {
        const Result<BrushLevel> level = read_map(text, "f.map", options);
        level ? fuzz::expect_sound(level.value()) : fuzz::expect_sound_error(level.error(), "f.map");
    }
    return 0;
}
