// SPDX-License-Identifier: MIT
// What holds for any text taken as an .obj: an error with a place, or a sound level; and what the check says of the
// text holds for the level.
#pragma once

#include <string_view>

#include "firma/mesh.h"
#include "tests/fuzz/expect_sound_level.h"

namespace firma::fuzz {

inline void expect_sound_obj(std::string_view text) {
    for (const double scale : {0.0, 0.001}) {
        ReadOptions options;
        options.scale = scale;
        const Result<Level> level = read_obj(text, "f.obj", options);
        const Result<MeshCheck> check = check_obj(text, "f.obj", options);
        if (!level) {
            expect(!check, "what cannot be read cannot be checked");
            expect(level.error().place.starts_with("f.obj"), "errors have a place");
            expect(level.error().reason.size() < 300, "errors are short");
            continue;
        }
        expect_sound(level.value());
        if (!check) {
            expect(check.error().code == ErrorCode::kOutOfRange, "only long numbers are too much for a check");
            continue;
        }
        expect(check.value().faces == level.value().source_faces, "both count the same faces");
        if (check.value().closed())
            expect(area_vector(level.value()) == std::array<Wide, 3>{}, "a closed mesh stays closed");
        // Faces dropped: as the notes of the check have it.
        std::size_t none = 0, dropped = level.value().count(FaceNote::kNoArea);
        for (const MeshNotePlace& note : check.value().notes)
            none += note.what == MeshNote::kNoArea || note.what == MeshNote::kDropped;
        expect(none >= dropped, "every face that is dropped has a note");
    }
}

}  // namespace firma::fuzz
