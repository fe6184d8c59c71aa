// SPDX-License-Identifier: MIT
// Any bytes as a .bsp: an error with a place, or a sound level; and what the check says of it holds for the level.
#include "firma/mesh.h"
#include "tests/fuzz/expect_sound_level.h"

using namespace firma;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto bytes = std::as_bytes(std::span(data, size));
    for (const ReadOptions& options : {ReadOptions{}, ReadOptions{.scale = 0.3, .patch_tolerance = 0.5}}) {
        const Result<Level> level = read_bsp(bytes, "f.bsp", options);
        const Result<MeshCheck> check = check_bsp(bytes, "f.bsp", options);
        fuzz::expect(level.ok() == check.ok(), "what can be read can be checked");
        if (!level) {
            fuzz::expect(level.error().text() == check.error().text(), "both say the same");
            fuzz::expect(level.error().place.starts_with("f.bsp"), "errors have a place");
            fuzz::expect(level.error().reason.size() < 300, "errors are short");
            continue;
        }
        fuzz::expect_sound(level.value());
        fuzz::expect(check.value().faces == level.value().source_faces, "both count the same faces");
        if (check.value().closed())
            fuzz::expect(fuzz::area_vector(level.value()) == std::array<fuzz::Wide, 3>{}, "a closed mesh stays closed");
    }
    return 0;
}
