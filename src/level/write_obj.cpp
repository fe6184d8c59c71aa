// SPDX-License-Identifier: MIT
// Two passes over the faces: vertices numbered in order of place, then corners by those numbers.
#include "firma/save.h"

#include <algorithm>
#include <span>
#include <system_error>
#include <vector>

#include "base/decimal.h"
#include "base/file_aside.h"
#include "solid/block.h"
#include "world/world_data.h"

namespace firma {
namespace {

constexpr std::size_t kPieceBytes = std::size_t(1) << 16;

struct PlacedFace {
    FaceId id;
    const Block* block;
    const FaceRecord* record;
};

std::vector<PlacedFace> faces_by_id(const WorldData& data, ObjFaces which) {
    std::vector<PlacedFace> faces;
    faces.reserve(data.face_count());
    for_each_block_of(data, [&](const Block& block) {
        for (const FaceRecord& record : block.faces)
            if (record.solid || which == ObjFaces::kAll) faces.push_back({record.id, &block, &record});
    });
    std::sort(faces.begin(), faces.end(), [](const PlacedFace& a, const PlacedFace& b) { return a.id < b.id; });
    return faces;
}

std::vector<GridPoint> different_corners(const std::vector<PlacedFace>& faces) {
    std::vector<GridPoint> points;
    for (const PlacedFace& face : faces)
        face.block->for_each_corner(*face.record, [&](const GridPoint& corner) { points.push_back(corner); });
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
}

/// A name as the rest of a line that reads back as itself: no control characters, nothing that begins a comment or
/// joins lines.
std::string line_safe(std::string name) {
    const auto is_blank = [](char c) { return c == ' ' || c == '\t'; };
    for (std::size_t k = 0; k < name.size(); ++k) {
        const auto byte = static_cast<unsigned char>(name[k]);
        const bool control = (byte < 0x20 && byte != '\t') || byte == 0x7f;
        const bool comment =
            byte == '#' && (k == 0 || is_blank(name[k - 1])) && (k + 1 == name.size() || is_blank(name[k + 1]));
        const bool at_end = k == 0 || k + 1 == name.size();
        if (control || comment || (at_end && (is_blank(name[k]) || byte == '\\'))) name[k] = '_';
    }
    return name;
}

/// Collects text and hands it on in pieces.
class TextPieces {
public:
    explicit TextPieces(const TextSink& put) : put_(put) {}

    std::string& text() { return text_; }
    /// Hands on what has become enough of a piece; false when that is not possible.
    bool flush(std::size_t least = kPieceBytes) {
        if (text_.empty() || text_.size() < least) return true;
        bytes_ += text_.size();
        const bool taken = put_(text_);
        text_.clear();
        return taken;
    }
    std::uint64_t bytes() const { return bytes_; }

private:
    const TextSink& put_;
    std::string text_;
    std::uint64_t bytes_ = 0;
};

bool write_vertices(const std::vector<GridPoint>& points, TextPieces& out) {
    for (const GridPoint& p : points) {
        std::string& text = out.text();
        text += 'v';
        for (int axis = 0; axis < 3; ++axis) {
            text += ' ';
            text += exact_decimal(p[axis]);
        }
        text += '\n';
        if (!out.flush()) return false;
    }
    return true;
}

bool write_faces(const World& world, const std::vector<PlacedFace>& faces, const std::vector<GridPoint>& points,
                 TextPieces& out) {
    const std::string* material = nullptr;
    for (const PlacedFace& face : faces) {
        std::string& text = out.text();
        const std::string& name = world.material_name(face.record->material);
        if (material ? *material != name : !name.empty()) text += "usemtl " + line_safe(name) + '\n';
        material = &name;
        text += 'f';
        face.block->for_each_corner(*face.record, [&](const GridPoint& corner) {
            const auto found = std::lower_bound(points.begin(), points.end(), corner);
            text += ' ';
            text += std::to_string(found - points.begin() + 1);
        });
        text += '\n';
        if (!out.flush()) return false;
    }
    return true;
}

Error cannot_write(const std::string& path, int reason) {
    return {ErrorCode::kCannotWrite, path, "cannot be written: " + std::generic_category().message(reason)};
}

}  // namespace

Result<ObjWritten> write_obj(const World& world, const TextSink& put, ObjFaces which) {
    const std::vector<PlacedFace> faces = faces_by_id(world.data(), which);
    const std::vector<GridPoint> points = different_corners(faces);
    TextPieces out(put);
    out.text() = "# Written by Firma. Metres; all digits are exact, multiples of 1/262144.\n";
    if (!write_vertices(points, out) || !write_faces(world, faces, points, out) || !out.flush(0))
        return Error{ErrorCode::kCannotWrite, "", "the sink took no more"};
    return ObjWritten{faces.size(), points.size(), out.bytes()};
}

Result<ObjWritten> write_obj(const World& world, const std::string& path, ObjFaces which) {
    ObjWritten written;
    const int failed = write_whole_file(path, [&](FileAside& file) {
        int reason = 0;
        const auto put = [&](std::string_view text) {
            reason = file.write(std::as_bytes(std::span(text)));
            return reason == 0;
        };
        if (const Result<ObjWritten> done = write_obj(world, put, which)) written = done.value();
        return reason;
    });
    if (failed) return cannot_write(path, failed);
    return written;
}

}  // namespace firma
