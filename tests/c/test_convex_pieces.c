/* SPDX-License-Identifier: MIT */
/* A solid as convex pieces: counts, numbers, errors. */
#include <math.h>
#include <stddef.h>

#include "tests/c/check.h"

static const firma_pose kHere = {{0, 0, 0}, {0, 0, 0, 1}, 1};

/* The piece of a bridge between two cuts, with a notch of a metre in its middle: a U of 6 x 2 x 0.5 m, 5.5 m3. */
static firma_chunks make_chunk(void) {
    static const double boxes[][6] = {{3.5, 2, 1, 4.5, 4, 3}, {0.5, 2, 1, 1, 6, 3}, {7, 2, 1, 7.5, 6, 3}};
    const firma_world room = make_room();
    const firma_cutter bar = make_box(-0.5, 3, 2, 8.5, 5, 2.5);
    const firma_carve_options fill = {.size = sizeof fill, .fill = 1};
    const firma_carve_options options = {.size = sizeof options, .chunks = 1, .density = 1000};
    firma_world world = {0};
    CHECK_OK(firma_carve(room, bar, &kHere, &fill, &world, NULL));
    CHECK_OK(firma_cutter_release(bar));
    CHECK_OK(firma_world_release(room));
    firma_carve_report report = {.size = sizeof report};
    for (int k = 0; k < 3; ++k) {
        const firma_cutter blade =
            make_box(boxes[k][0], boxes[k][1], boxes[k][2], boxes[k][3], boxes[k][4], boxes[k][5]);
        firma_world after = {0};
        CHECK_OK(firma_carve(world, blade, &kHere, &options, &after, &report));
        CHECK_OK(firma_cutter_release(blade));
        CHECK_OK(firma_world_release(world));
        world = after;
    }
    CHECK_OK(firma_world_release(world));
    CHECK(report.chunks == 1);
    return report.loose;
}

static void check_pieces(firma_convex_pieces pieces, size_t expected) {
    size_t count = 0;
    double volume = 0, mass = 0;
    CHECK_OK(firma_convex_pieces_get_count(pieces, &count));
    CHECK(count == expected);
    for (size_t k = 0; k < count; ++k) {
        firma_convex_piece piece = {.size = sizeof piece};
        CHECK_OK(firma_convex_pieces_get(pieces, k, &piece));
        CHECK(piece.exact == 1 && piece.overhang == 0 && fabs(piece.hull_volume - piece.mass.volume) < 1e-4);
        CHECK(piece.corner_count == 8 && piece.face_count == 6 && piece.loop_count == 24);
        volume += piece.mass.volume;
        mass += piece.mass.mass;
        for (size_t f = 0; f < piece.face_count; ++f) {
            const firma_convex_face* const face = &piece.faces[f];
            CHECK(face->count == 4 && face->first + face->count <= piece.loop_count);
            for (uint32_t c = 0; c < face->count; ++c) {
                const double* const corner = &piece.corners[3 * piece.loops[face->first + c]];
                const double along =
                    face->normal[0] * corner[0] + face->normal[1] * corner[1] + face->normal[2] * corner[2];
                CHECK(fabs(along - face->offset) < 4e-6);
            }
        }
    }
    CHECK(volume == 5.5 && mass == 5500);
}

void test_convex_pieces(void) {
    const firma_chunks chunks = make_chunk();
    firma_convex_options options = {.size = sizeof options, .density = 1000};
    firma_convex_pieces pieces = {0};
    CHECK_OK(firma_chunks_convex_pieces(chunks, 0, &options, &pieces));
    check_pieces(pieces, 3);
    firma_convex_piece piece = {.size = sizeof piece};
    CHECK_FAILS(firma_convex_pieces_get(pieces, 3, &piece), FIRMA_ERROR_OUT_OF_RANGE, "piece");
    CHECK_FAILS(firma_convex_pieces_get(pieces, 0, NULL), FIRMA_ERROR_BAD_CALL, "null");
    piece.size = 0;
    CHECK_FAILS(firma_convex_pieces_get(pieces, 0, &piece), FIRMA_ERROR_BAD_CALL, "size");
    CHECK_OK(firma_convex_pieces_release(pieces));
    CHECK_FAILS(firma_convex_pieces_release(pieces), FIRMA_ERROR_BAD_HANDLE, "convex pieces");

    firma_world world = {0};
    CHECK_OK(firma_chunks_world(chunks, 0, &world));
    CHECK_OK(firma_world_convex_pieces(world, &options, &pieces));
    check_pieces(pieces, 3);
    CHECK_OK(firma_convex_pieces_release(pieces));

    options.max_concavity = 3;
    CHECK_OK(firma_world_convex_pieces(world, &options, &pieces));
    size_t count = 0;
    CHECK_OK(firma_convex_pieces_get_count(pieces, &count));
    CHECK(count == 1);
    piece.size = sizeof piece;
    CHECK_OK(firma_convex_pieces_get(pieces, 0, &piece));
    CHECK(piece.exact == 0 && piece.overhang > 0.5 && piece.overhang <= 3);
    CHECK(piece.mass.volume == 5.5 && piece.mass.mass == 5500 && piece.hull_volume == 6);
    CHECK_OK(firma_convex_pieces_release(pieces));

    options.max_concavity = 0;
    options.max_pieces = 2;
    CHECK_FAILS(firma_world_convex_pieces(world, &options, &pieces), FIRMA_ERROR_TOO_LARGE, "max_pieces (2)");
    options.max_pieces = 16385;
    CHECK_FAILS(firma_world_convex_pieces(world, &options, &pieces), FIRMA_ERROR_INVALID, "max_pieces");
    options.max_pieces = 0;
    options.density = NAN;
    CHECK_FAILS(firma_world_convex_pieces(world, &options, &pieces), FIRMA_ERROR_INVALID, "density");
    CHECK_FAILS(firma_world_convex_pieces(world, NULL, NULL), FIRMA_ERROR_BAD_CALL, "null");
    CHECK_FAILS(firma_chunks_convex_pieces(chunks, 1, NULL, &pieces), FIRMA_ERROR_OUT_OF_RANGE, "chunk");
    const firma_world room = make_room();
    CHECK_FAILS(firma_world_convex_pieces(room, NULL, &pieces), FIRMA_ERROR_INVALID, "infinity");
    CHECK_OK(firma_world_release(room));
    CHECK_OK(firma_world_release(world));
    CHECK_OK(firma_chunks_release(chunks));
}
