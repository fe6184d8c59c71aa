// SPDX-License-Identifier: MIT
// Reads a Wavefront .obj into a Level.
#include <string>

#include "level/level_builder.h"
#include "level/message.h"
#include "level/parse_obj.h"

namespace firma {
namespace {

class ObjLevelMaker final : public ObjVisitor {
public:
    explicit ObjLevelMaker(std::string_view name) : name_(name), builder_(std::string(name)) {
        builder_.mend_what_is_dropped();
    }

    bool vertex(const ObjVertex& vertex) override { return builder_.add_vertex(vertex.metres).has_value(); }

    std::optional<Error> face(const ObjFace& face) override {
        info_.source = face.source;
        info_.line = face.line;
        builder_.add_face(face.corners, info_, face.uvs);
        if (builder_.corner_count() <= LevelBuilder::kMaxCount) return std::nullopt;
        return error_at_line(ErrorCode::kTooLarge, name_, face.line, "more than 2^31 corners of faces");
    }

    void material(std::string_view name) override { info_.material = builder_.material(name); }
    void group(std::string_view name) override { info_.group = builder_.group(name); }

    Level finish(const ObjCounts& counts) {
        return builder_.finish(counts.faces, counts.ignored_entries, counts.omissions);
    }

private:
    std::string name_;
    LevelBuilder builder_;
    LevelBuilder::FaceInfo info_;
};

}  // namespace

Result<Level> read_obj(std::string_view text, std::string name, const ReadOptions& options) {
    ObjLevelMaker maker(name);
    const Result<ObjCounts> counts = parse_obj(text, name, options, maker);
    if (!counts) return counts.error();
    return maker.finish(counts.value());
}

}  // namespace firma
