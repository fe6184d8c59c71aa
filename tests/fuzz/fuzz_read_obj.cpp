// SPDX-License-Identifier: MIT
// Any bytes as an .obj.
#include <cstdint>

#include "tests/fuzz/expect_sound_obj.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    firma::fuzz::expect_sound_obj({reinterpret_cast<const char*>(data), size});
    return 0;
}
