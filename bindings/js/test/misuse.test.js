// SPDX-License-Identifier: MIT
// Every function with arguments of every kind: it answers, or throws a FirmaError, and the module never stops.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { FirmaError, HitBatch } from '../src/index.js';
import { boxMesh, firma, levelBytes } from './helpers.js';
import { random } from './scenario.js';

const next = random(77);
const below = (count) => Math.floor(next() * count);
const pick = (list) => list[below(list.length)];

const numbers = [
    0,
    -0,
    1,
    -1,
    0.5,
    2,
    3,
    4,
    7,
    8,
    100,
    1e-300,
    1e9,
    1e300,
    2 ** 31,
    2 ** 32 - 1,
    2 ** 32,
    2 ** 53,
    NaN,
];
const oddNumbers = [...numbers, Infinity, -Infinity];
const vectorOf = (length) => Array.from({ length }, () => (next() < 0.8 ? next() * 8 : pick(oddNumbers)));
const packed = (() => {
    const world = firma.worldFromMesh(boxMesh());
    const bytes = world.pack();
    world.release();
    return bytes;
})();

/** Half of what makes sense, half of what does not. */
const makers = [
    () => undefined,
    () => null,
    () => pick([true, false, '', 'rocky', 'box', 'a\0b', 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3', Symbol('s')]),
    () => pick(oddNumbers),
    () => pick([0n, 1n, -1n, 2n ** 63n, 2n ** 64n]),
    () => vectorOf(pick([0, 1, 2, 3, 3, 3, 4, 7, 9, 14, 21])),
    () => Float64Array.from(vectorOf(pick([0, 3, 7, 12, 24, 700]))),
    () => Float32Array.from(vectorOf(3)),
    () => Uint32Array.from(vectorOf(pick([3, 6, 12, 24]))),
    () => new DataView(new ArrayBuffer(56)),
    () => packed.map((byte, k) => (k === below(packed.length) ? below(256) : byte)),
    () => packed.subarray(0, below(packed.length)),
    () => levelBytes.subarray(0, below(4000)).buffer,
    () => ({ centre: vectorOf(3), radius: pick(oddNumbers), path: vectorOf(3) }),
    () => ({ position: vectorOf(3), rotation: vectorOf(pick([3, 4, 4])), scale: pick(oddNumbers) }),
    () => ({ position: vectorOf(3), scale: next() * 2 }),
    () => ({ fill: pick([true, false, 1]), material: pick(['', 'x', 5]), exact: pick([true, false, 0]) }),
    () => ({
        mask: pick(oddNumbers),
        bothSides: pick([true, false, 2]),
        skin: pick(oddNumbers),
        room: pick([undefined, 'any', 'locate', 0, 5, ...oddNumbers]),
        counts: pick([{}, 5, undefined]),
    }),
    () => ({
        zones: [{ low: vectorOf(3), high: vectorOf(3), hardness: next() }],
        hardness: vectorOf(2),
        mostFaces: pick(numbers),
    }),
    () => ({
        ...boxMesh(vectorOf(3), vectorOf(3)),
        materials: pick([undefined, [0, 0, 0, 0, 0, 9]]),
        masks: pick([undefined, [1]]),
    }),
    () => ({ positions: vectorOf(12), corners: Array.from({ length: 6 }, () => below(5)) }),
    () => ({ maxDepth: pick(numbers), facesPerBin: pick(numbers), skin: pick(oddNumbers), scale: pick(oddNumbers) }),
    () => new HitBatch(),
    () => [{}, null],
    () => () => 1,
];

test('arguments of every kind', () => {
    const world = firma.worldFromMesh(boxMesh());
    const cutter = firma.crater('rocky', 1);
    const job = world.startCarve(cutter, { position: [8, 4, 4] });
    const edit = world.edit();
    const store = firma.openStore(world, 1e5);
    const level = firma.levelFromMap('{ "classname" "worldspawn" }');
    const gone = firma.crater('box', 1);
    gone.release();
    const handles = [world, cutter, job, edit, store, level, gone];
    const answers = { returned: 0 };
    const objects = [firma, world, cutter, job, edit, store, level];
    for (let round = 0; round < 300; ++round) {
        for (const object of objects) {
            for (const name of Object.getOwnPropertyNames(Object.getPrototypeOf(object))) {
                if (['constructor', 'version', 'metresPerUnit'].includes(name)) continue;
                const given = Array.from({ length: below(4) }, () => (next() < 0.3 ? pick(handles) : pick(makers)()));
                // Once in three times what such a call begins with.
                if (/arve/.test(name) && next() < 0.5) given.splice(0, 2, cutter, { position: vectorOf(3) });
                if (/^(diff|openStore)$/.test(name) && next() < 0.5) given[0] = world;
                if (name === 'publish' && next() < 0.5) given.splice(0, 2, world, world);
                try {
                    const answer = object[name](...given);
                    ++answers.returned;
                    for (const one of [answer, answer?.world]) if (typeof one?.release === 'function') one.release();
                } catch (error) {
                    if (!(error instanceof FirmaError) || error.code === 'INTERNAL') {
                        error.message += ` (${name}, round ${round}, ${given.map((one) => typeof one)})`;
                        throw error;
                    }
                    assert.notEqual(error.message, '');
                    answers[error.code] = (answers[error.code] ?? 0) + 1;
                }
            }
        }
    }
    world.check();
    for (const object of [world, cutter, job, edit, store, level]) object.release();
    const seen = JSON.stringify(answers);
    for (const code of ['returned', 'BAD_CALL', 'BAD_HANDLE', 'INVALID', 'MALFORMED', 'OUT_OF_RANGE'])
        assert.ok(answers[code] > 3, seen);
});
