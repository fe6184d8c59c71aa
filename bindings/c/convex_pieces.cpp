// SPDX-License-Identifier: MIT
// Convex pieces of worlds and chunks: made once, then looked at.
#include "firma/convex_pieces.h"

#include <memory>
#include <utility>
#include <vector>

#include "bindings/c/convert.h"
#include "bindings/c/objects.h"

namespace firma::c {
namespace {

struct ConvexPiecesObject final : Object {
    static constexpr Kind kKind = Kind::kConvexPieces;
    static constexpr const char* kNoun = "list of convex pieces";

    explicit ConvexPiecesObject(ConvexPieces made) : pieces(std::move(made.pieces)) {
        for (const ConvexBody& piece : pieces) {
            std::vector<double>& own = corners.emplace_back();
            for (const Vec3& corner : piece.corners) own.insert(own.end(), {corner.x, corner.y, corner.z});
            std::vector<firma_convex_face>& own_faces = faces.emplace_back();
            for (const ConvexFace& face : piece.faces) {
                firma_convex_face out{{}, face.offset, face.first, face.count};
                put(face.normal, out.normal);
                own_faces.push_back(out);
            }
        }
    }

    std::vector<ConvexBody> pieces;
    std::vector<std::vector<double>> corners;  ///< of each
    std::vector<std::vector<firma_convex_face>> faces;
};

firma_code read_convex_options(const firma_convex_options* given, ConvexOptions& options, const char* function) {
    if (!given) return FIRMA_OK;
    if (!sized(given)) return bad_call(function, kWrongSize);
    firma_convex_options whole{};
    take_sized(given, whole);
    if (whole.max_pieces) options.max_pieces = whole.max_pieces;
    options.max_concavity = whole.max_concavity;
    if (whole.density != 0) options.density = whole.density;
    return FIRMA_OK;
}

firma_code give_convex_pieces(const Solid& solid, const firma_convex_options* options, firma_convex_pieces* out,
                              const char* function) {
    ConvexOptions read;
    if (const firma_code code = read_convex_options(options, read, function)) return code;
    Result<ConvexPieces> made = convex_pieces(solid, read);
    if (!made) return fail(made.error());
    return give(std::make_unique<ConvexPiecesObject>(std::move(made).value()), out, function);
}

}  // namespace
}  // namespace firma::c

using namespace firma;
using namespace firma::c;

firma_code firma_world_convex_pieces(firma_world world, const firma_convex_options* options,
                                     firma_convex_pieces* pieces) {
    return guarded(__func__, [&, function = __func__] {
        if (!pieces) return bad_call(function, kNull);
        const WorldObject* object = find<WorldObject>(world.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        return give_convex_pieces(object->world.solid(), options, pieces, function);
    });
}

firma_code firma_chunks_convex_pieces(firma_chunks chunks, size_t chunk, const firma_convex_options* options,
                                      firma_convex_pieces* pieces) {
    return guarded(__func__, [&, function = __func__] {
        if (!pieces) return bad_call(function, kNull);
        const ChunksObject* object = find<ChunksObject>(chunks.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        if (chunk >= object->chunks.size()) return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "there is no such chunk");
        return give_convex_pieces(object->chunks[chunk].solid, options, pieces, function);
    });
}

firma_code firma_convex_pieces_get_count(firma_convex_pieces pieces, size_t* count) {
    return guarded(__func__, [&, function = __func__] {
        if (!count) return bad_call(function, kNull);
        const ConvexPiecesObject* object = find<ConvexPiecesObject>(pieces.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        *count = object->pieces.size();
        return FIRMA_OK;
    });
}

firma_code firma_convex_pieces_get(firma_convex_pieces pieces, size_t piece, firma_convex_piece* out) {
    return guarded(__func__, [&, function = __func__] {
        if (!out) return bad_call(function, kNull);
        if (!sized(out)) return bad_call(function, kWrongSize);
        const ConvexPiecesObject* object = find<ConvexPiecesObject>(pieces.id, function);
        if (!object) return FIRMA_ERROR_BAD_HANDLE;
        if (piece >= object->pieces.size())
            return fail(FIRMA_ERROR_OUT_OF_RANGE, function, "there is no such convex piece");
        const ConvexBody& found = object->pieces[piece];
        firma_convex_piece made{};
        made.exact = found.exact;
        put(found.mass, made.mass);
        made.hull_volume = found.hull_volume;
        made.overhang = found.overhang;
        made.corners = object->corners[piece].data();
        made.corner_count = found.corners.size();
        made.faces = object->faces[piece].data();
        made.face_count = found.faces.size();
        made.loops = found.loops.data();
        made.loop_count = found.loops.size();
        put_sized(made, out);
        return FIRMA_OK;
    });
}

firma_code firma_convex_pieces_release(firma_convex_pieces pieces) {
    return release<ConvexPiecesObject>(pieces.id, __func__);
}
