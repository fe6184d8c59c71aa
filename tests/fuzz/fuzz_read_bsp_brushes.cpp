// SPDX-License-Identifier: MIT
// Any bytes as the brushes of a .bsp: an error with a place, or a sound level of brushes.
#include <cstdint>
#include <span>

#include "tests/fuzz/expect_sound_brushes.h"

using namespace firma;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto bytes = std::as_bytes(std::span(data, size));
    for (const ReadOptions& options : {ReadOptions{}, ReadOptions{.scale = 0.3, .patch_tolerance = 0.5}}) {
        const Result<BrushLevel> level = read_bsp_brushes(bytes, "f.bsp", options);
        level ? fuzz::expect_sound(level.value()) : fuzz::expect_sound_error(level.error(), "f.bsp");
    }
    return 0;
}
