// SPDX-License-Identifier: MIT
// What tests share: the modules, the first level, random numbers that are the same everywhere.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { after } from 'node:test';
import { FirmaError, loadFirma } from '../src/index.js';
import { loadReaders } from '../src/readers.js';

export const wasmUrl = new URL('../src/firma.wasm', import.meta.url);
export const readersUrl = new URL('../src/firma_readers.wasm', import.meta.url);
export const levelUrl = new URL('../../../levels/first.obj', import.meta.url);
export const levelBytes = readFileSync(levelUrl);

/** One instance for a test file; at its end nothing may be left in it. */
export const firma = await loadFirma();
export const readers = await loadReaders(firma);
after(() => assert.equal(firma.liveHandles(), 0, 'handles were left'));

/** Runs work(object...), then releases the objects. */
export function releasing(objects, work) {
    try {
        return work(...objects);
    } finally {
        for (const object of objects) if (!object.released) object.release();
    }
}

export const withLevel = (work) => releasing([readers.worldFromObj(levelBytes, { name: 'first.obj' })], work);

/** A room of air in rock, from `low` to `high`: its walls face inward. */
export function boxMesh(low = [0, 0, 0], high = [8, 8, 8]) {
    const positions = [];
    for (let k = 0; k < 8; ++k)
        for (let axis = 0; axis < 3; ++axis) positions.push((k >> axis) & 1 ? high[axis] : low[axis]);
    const quads = [0, 4, 6, 2, 1, 3, 7, 5, 0, 1, 5, 4, 2, 6, 7, 3, 0, 2, 3, 1, 4, 5, 7, 6];
    return { positions, corners: quads.reverse(), cornerCounts: [4, 4, 4, 4, 4, 4] };
}

/** A brush in units of the file: six sides, clockwise seen from outside; the one at low x with its own texture. */
export function brush(low, high, texture, lowX = texture) {
    const at = (...bits) => `( ${bits.map((bit, axis) => (bit ? high : low)[axis]).join(' ')} )`;
    const sides = [
        [at(0, 0, 0), at(0, 1, 0), at(0, 0, 1), lowX],
        [at(1, 0, 0), at(1, 0, 1), at(1, 1, 0), texture],
        [at(0, 0, 0), at(0, 0, 1), at(1, 0, 0), texture],
        [at(0, 1, 0), at(1, 1, 0), at(0, 1, 1), texture],
        [at(0, 0, 0), at(1, 0, 0), at(0, 1, 0), texture],
        [at(0, 0, 1), at(0, 1, 1), at(1, 0, 1), texture],
    ];
    return `{\n${sides.map((side) => `${side.join(' ')} 0 0 0 1 1\n`).join('')}}\n`;
}

/** Two rooms of 4 m along x within walls of half a metre, a portal between them at x = 4. */
export const twoRooms =
    `{\n"classname" "worldspawn"\n${brush([-16, -16, -16], [0, 144, 144], 'wall')}${brush([256, -16, -16], [272, 144, 144], 'wall')}` +
    `${brush([0, -16, -16], [256, 0, 144], 'wall')}${brush([0, 128, -16], [256, 144, 144], 'wall')}` +
    `${brush([0, 0, -16], [256, 128, 0], 'floor')}${brush([0, 0, 128], [256, 128, 144], 'roof')}}\n` +
    `{\n"classname" "func_areaportal"\n"targetname" "gate"\n${brush([128, -8, -8], [130, 136, 136], 'skip', 'portal')}}\n` +
    '{\n"classname" "firma_room"\n"name" "größe"\n"origin" "32 64 64"\n}\n';

/** Asserts that it throws a FirmaError of a code, and that its message is of the pattern. */
export function throwsCode(code, work, message = /./) {
    assert.throws(work, (error) => {
        assert.ok(error instanceof FirmaError, `not a FirmaError: ${error.stack}`);
        assert.equal(error.code, code, error.message);
        assert.match(error.message, message);
        return true;
    });
}
