// SPDX-License-Identifier: MIT
// A solid as convex pieces: counts, numbers, errors. The chunk is that of the C tests.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { throwsCode } from './helpers.js';
import { boxCutter, holding, makeLowRoom, recordings } from './recording_helpers.js';

const here = { position: [0, 0, 0] };

/** The piece of a bridge between two cuts, with a notch of a metre in its middle: a U of 6 x 2 x 0.5 m, 5.5 m3. */
function makeChunk(hold) {
    const bar = hold(boxCutter([-0.5, 3, 2], [8.5, 5, 2.5]));
    let world = hold(hold(makeLowRoom()).carve(bar, here, { fill: true }).world);
    let report;
    for (const [low, high] of [
        [[3.5, 2, 1], [4.5, 4, 3]],
        [[0.5, 2, 1], [1, 6, 3]],
        [[7, 2, 1], [7.5, 6, 3]],
    ]) {
        ({ world, report } = world.carve(hold(boxCutter(low, high)), here, { chunks: { density: 1000 } }));
        hold(world);
    }
    assert.equal(report.chunks, 1);
    return hold(report.loose);
}

test('a bridge with a notch is three boxes', () => {
    holding((hold) => {
        const chunks = makeChunk(hold);
        const world = hold(chunks.world(0));
        const pieces = recordings.convexPiecesOfChunk(chunks, 0, { density: 1000 });
        assert.equal(pieces.length, 3);
        assert.equal(pieces.reduce((sum, { volume }) => sum + volume, 0), 5.5);
        assert.equal(pieces.reduce((sum, { mass }) => sum + mass, 0), 5500);
        for (const piece of pieces) {
            assert.deepEqual([piece.exact, piece.overhang, piece.corners.length, piece.faces.length], [true, 0, 24, 6]);
            assert.ok(Math.abs(piece.hullVolume - piece.volume) < 1e-4);
            for (const { normal, offset, corners } of piece.faces) {
                assert.equal(corners.length, 4);
                const along = (k) => normal.reduce((sum, x, axis) => sum + x * piece.corners[3 * k + axis], 0);
                for (const k of corners) assert.ok(Math.abs(along(k) - offset) < 4e-6);
                // All others lie behind it: it is convex, and the normal looks outward.
                for (let k = 0; k < 8; ++k) assert.ok(along(k) - offset < 4e-6);
            }
        }
        assert.deepEqual(recordings.convexPieces(world, { density: 1000 }), pieces);
        // Nearly convex: one hull.
        const [hull, ...others] = recordings.convexPieces(world, { density: 1000, maxConcavity: 3 });
        assert.deepEqual(others, []);
        assert.deepEqual([hull.exact, hull.volume, hull.mass, hull.hullVolume], [false, 5.5, 5500, 6]);
        assert.ok(hull.overhang > 0.5 && hull.overhang <= 3);
    });
});

test('what cannot be divided says so', () => {
    holding((hold) => {
        const chunks = makeChunk(hold);
        const world = hold(chunks.world(0));
        const divide = (options) => recordings.convexPieces(world, options);
        throwsCode('TOO_LARGE', () => divide({ maxPieces: 2 }), /max_pieces \(2\)/);
        throwsCode('INVALID', () => divide({ maxPieces: 16385 }), /max_pieces/);
        throwsCode('INVALID', () => divide({ density: NaN }), /density/);
        throwsCode('BAD_CALL', () => divide({ concavity: 1 }), /convexPieces: the options: there is no concavity/);
        throwsCode('BAD_CALL', () => divide({ maxPieces: 1.5 }), /maxPieces/);
        throwsCode('INVALID', () => recordings.convexPieces(hold(makeLowRoom())), /infinity/);
        throwsCode('BAD_HANDLE', () => recordings.convexPieces(chunks));
        throwsCode('OUT_OF_RANGE', () => recordings.convexPiecesOfChunk(chunks, 1), /chunk/);
        throwsCode('BAD_CALL', () => recordings.convexPiecesOfChunk(chunks), /convexPiecesOfChunk: the chunk/);
    });
});
