// SPDX-License-Identifier: MIT
// Any bytes as an .obj: an error with a place, or a sound level; and what the check says of it holds for the level.
#include "firma/check_mesh.h"
#include "test/fuzz/expect_sound_level.h"

using namespace firma;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    for (const double scale : {0.0, 0.001}) {
        ReadOptions options;
        options.scale = scale;
        const Result<Level> level = read_obj(text, "f.obj", options);
        const Result<MeshCheck> check = check_obj(text, "f.obj", options);
        if (!level) {
            fuzz::expect(!check, "what cannot be read cannot be checked");
            fuzz::expect(level.error().place.starts_with("f.obj"), "errors have a place");
            fuzz::expect(level.error().reason.size() < 300, "errors are short");
            continue;
        }
        fuzz::expect_sound(level.value());
        if (!check) {
            fuzz::expect(check.error().code == ErrorCode::kOutOfRange, "only long numbers are too much for a check");
            continue;
        }
        fuzz::expect(check.value().faces == level.value().source_faces, "both count the same faces");
        if (check.value().closed())
            fuzz::expect(fuzz::area_vector(level.value()) == std::array<fuzz::Wide, 3>{}, "a closed mesh stays closed");
        // Faces dropped: as the notes of the check have it.
        std::size_t none = 0, dropped = level.value().count(FaceNote::kNoArea);
        for (const MeshNotePlace& note : check.value().notes)
            none += note.what == MeshNote::kNoArea || note.what == MeshNote::kDropped;
        fuzz::expect(none >= dropped, "every face that is dropped has a note");
    }
    return 0;
}
