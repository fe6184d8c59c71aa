// SPDX-License-Identifier: MIT
// Any bytes as a mesh, written as an .obj: more of them reach the geometry than of those that must spell it.
#include <cstdint>
#include <string>

#include "tests/fuzz/bytes.h"
#include "tests/fuzz/expect_sound_obj.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    // Units from far below the grid's step to the size of the world.
    constexpr const char* kUnits[] = {"e-30", "e-5", "e-4", "e-3", "e-2", "", "e1", ".000000000000000000001e0"};
    firma::fuzz::Bytes bytes(data, size);
    std::string text;
    const int vertices = 1 + bytes.next() % 40;
    for (int k = 0; k < vertices; ++k) {
        text += "v";
        const char* const unit = kUnits[bytes.next() % 8];
        for (int axis = 0; axis < 3; ++axis) text += " " + std::to_string(bytes.next() % 64 - 20) + unit;
        text += "\n";
    }
    while (!bytes.empty()) {
        std::string forth, back;
        for (int left = 3 + bytes.next() % 12; left > 0; --left) {
            const std::string corner = " " + std::to_string(1 + bytes.next() % vertices);
            forth += corner;
            back.insert(0, corner);
        }
        text += "f" + forth + "\n";
        if (size % 2 == 0) text += "f" + back + "\n";  // so that the mesh is closed
    }
    firma::fuzz::expect_sound_obj(text);
    return 0;
}
