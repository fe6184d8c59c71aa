// SPDX-License-Identifier: MIT
// Solids as convex pieces, for another engine.
import { object, word } from './arguments.js';
import { getMassAt } from './chunks.js';
import { idOf, makeHandle } from './handle.js';
import { CONVEX_FACE, CONVEX_OPTIONS, CONVEX_PIECE } from './layout.js';
import { putMembers, structTable } from './structs.js';

const { fresh, toFill } = structTable({ options: [CONVEX_OPTIONS], piece: [CONVEX_PIECE] });

const KINDS = { maxPieces: 'word', maxConcavity: 'number', density: 'number' };

/** @returns the address of the struct */
function putOptions(core, options, place) {
    const at = fresh(core, 'options');
    const given = object(options, place, 'the options', Object.keys(KINDS));
    putMembers(core, at, CONVEX_OPTIONS, KINDS, given, place);
    return at;
}

function getFace(core, at, loops) {
    const first = (loops >>> 2) + core.getU32(at + CONVEX_FACE.first);
    return {
        normal: core.getVector(at + CONVEX_FACE.normal),
        offset: core.getF64(at + CONVEX_FACE.offset),
        corners: Array.from(core.u32.subarray(first, first + core.getU32(at + CONVEX_FACE.count))),
    };
}

function getPiece(core, pieces, k) {
    const at = toFill(core, 'piece');
    core.run('firma_convex_pieces_get', pieces, k, at);
    const [corners, faces, loops] = ['corners', 'faces', 'loops'].map((name) => core.getU32(at + CONVEX_PIECE[name]));
    const first = corners >>> 3;
    return {
        ...getMassAt(core, at + CONVEX_PIECE.mass),
        exact: core.getU32(at + CONVEX_PIECE.exact) !== 0,
        hullVolume: core.getF64(at + CONVEX_PIECE.hullVolume),
        overhang: core.getF64(at + CONVEX_PIECE.overhang),
        corners: core.f64.slice(first, first + 3 * core.getU32(at + CONVEX_PIECE.cornerCount)),
        faces: Array.from({ length: core.getU32(at + CONVEX_PIECE.faceCount) }, (_, face) =>
            getFace(core, faces + face * CONVEX_FACE.sizeof, loops),
        ),
    };
}

/** All pieces of a list of the module's, copied; releases it. */
function takePieces(core, pieces) {
    try {
        core.run('firma_convex_pieces_get_count', pieces, core.at.out);
        return Array.from({ length: core.getU32(core.at.out) }, (_, k) => getPiece(core, pieces, k));
    } finally {
        if (!core.stopped) core.run('firma_convex_pieces_release', pieces);
    }
}

export function convexPieces(core, world, options) {
    const place = 'convexPieces';
    const id = idOf(world, core, place, 'world');
    return takePieces(core, makeHandle(core, 'firma_world_convex_pieces', id, putOptions(core, options, place)));
}

export function convexPiecesOfChunk(core, chunks, chunk, options) {
    const place = 'convexPiecesOfChunk';
    const id = idOf(chunks, core, place, 'list of chunks');
    word(chunk, place, 'the chunk');
    return takePieces(core, makeHandle(core, 'firma_chunks_convex_pieces', id, chunk, putOptions(core, options, place)));
}
