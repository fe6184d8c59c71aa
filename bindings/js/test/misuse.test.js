// SPDX-License-Identifier: MIT
// Every function with arguments of every kind: it answers, or throws a FirmaError, and the module never stops.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { FirmaError, HitBatch } from '../src/index.js';
import { boxMesh, firma, levelBytes, readers } from './helpers.js';
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

const packedCommand = (() => {
    const cutter = firma.crater('box', 1);
    const command = firma.editCommand(1, cutter, { position: [8, 4, 4] });
    const bytes = command.pack();
    for (const one of [cutter, command]) one.release();
    return bytes;
})();

/** Half of what makes sense, half of what does not. */
const makers = [
    () => undefined,
    () => null,
    () => pick([true, false, '', 'rocky', 'box', 'a\0b', 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3', Symbol('s')]),
    () => pick(oddNumbers),
    () => ({ fill: pick([true, false]), chunks: pick([true, { minVolume: pick(oddNumbers) }, 3]) }),
    () => packedCommand.map((byte, k) => (k === below(packedCommand.length) ? below(256) : byte)),
    () => [{ region: [0, 0, 0], faces: 1n, points: pick([2n, 3, 'x']) }],
    () => [vectorOf(3).map(Math.floor)],
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
        contactOffset: pick(oddNumbers),
        room: pick([undefined, 'any', 'locate', 0, 5, ...oddNumbers]),
        counts: pick([{}, 5, undefined]),
    }),
    () => ({
        zones: [{ low: vectorOf(3), high: vectorOf(3), hardness: next() }],
        hardness: vectorOf(2),
        maxFaces: pick(numbers),
    }),
    () => ({
        ...boxMesh(vectorOf(3), vectorOf(3)),
        materials: pick([undefined, [0, 0, 0, 0, 0, 9]]),
        masks: pick([undefined, [1]]),
    }),
    () => ({ positions: vectorOf(12), corners: Array.from({ length: 6 }, () => below(5)) }),
    () => ({ maxDepth: pick(numbers), facesPerLeaf: pick(numbers), contactOffset: pick(oddNumbers), scale: pick(oddNumbers) }),
    () => new HitBatch(),
    () => [{}, null],
    () => () => 1,
];

test('arguments of every kind', async () => {
    const world = firma.worldFromMesh(boxMesh());
    const cutter = firma.crater('rocky', 1);
    const job = world.startCarve(cutter, { position: [8, 4, 4] });
    const edit = world.edit();
    const store = firma.openStore(world, 1e5);
    const level = readers.levelFromMap('{ "classname" "worldspawn" }');
    const chunks = world.pieces();
    const command = firma.editCommand(1, cutter, { position: [8, 4, 4] });
    const log = firma.beginLog(world);
    log.append(command);
    const replay = log.replay(world);
    const gone = firma.crater('box', 1);
    gone.release();
    const handles = [world, cutter, job, edit, store, level, chunks, command, log, replay, gone];
    const answers = { returned: 0 };
    const objects = [firma, readers, world, cutter, job, edit, store, level, chunks, command, log, replay];
    for (let round = 0; round < 900; ++round) {
        for (const object of objects) {
            for (const name of Object.getOwnPropertyNames(Object.getPrototypeOf(object))) {
                if (['constructor', 'version', 'metresPerUnit'].includes(name)) continue;
                const given = Array.from({ length: below(4) }, () => (next() < 0.3 ? pick(handles) : pick(makers)()));
                // Once in three times what such a call begins with.
                if (/arve/.test(name) && next() < 0.5) given.splice(0, 2, cutter, { position: vectorOf(3) });
                if (/^(diff|openStore)$/.test(name) && next() < 0.5) given[0] = world;
                if (/^(apply|startApply|append)$/.test(name) && next() < 0.5) given[0] = command;
                if (/^(compact|replay|checkpoint|patchFrom)$/.test(name) && next() < 0.5) given[0] = world;
                if (name === 'publish' && next() < 0.5) given.splice(0, 2, world, world);
                try {
                    const answer = await object[name](...given); // some of Firma's are promises
                    ++answers.returned;
                    const made = [answer, answer?.world, answer?.cutter, answer?.loose, answer?.report?.loose];
                    for (const one of made) if (typeof one?.release === 'function') one.release();
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
    for (const object of objects.slice(2)) object.release();
    const seen = JSON.stringify(answers);
    for (const code of ['returned', 'BAD_CALL', 'BAD_HANDLE', 'INVALID', 'MALFORMED', 'OUT_OF_RANGE'])
        assert.ok(answers[code] > 3, seen);
});

const refused = (call, message) =>
    assert.throws(call, (error) => {
        assert.ok(error instanceof FirmaError && error.code === 'BAD_CALL', `${error.stack}`);
        assert.match(error.message, message);
        return true;
    });

test('a member that options do not have is refused by name', () => {
    const mesh = boxMesh();
    const world = firma.worldFromMesh(mesh);
    const cutter = firma.crater('box', 1);
    const ball = { centre: [4, 4, 4], radius: 0.5, path: [1, 0, 0] };
    const at = { position: [8, 4, 4] };
    const zone = { low: [0, 0, 0], high: [1, 1, 1], hardness: 1 };
    const edit = world.edit();
    refused(() => readers.worldFromObj(levelBytes, { sclae: 2 }), /^worldFromObj: the options: there is no sclae, only name/);
    refused(() => firma.worldFromMesh(mesh, { Skin: 1 }), /there is no Skin/);
    refused(() => firma.worldFromMesh({ ...mesh, mask: [1] }), /the mesh: there is no mask, only .*masks/);
    for (const cast of ['cast', 'castAny', 'castAll']) refused(() => world[cast](ball, { both: true }), /there is no both/);
    refused(() => world.castBatch(new Float64Array(7), { masks: 1 }), /there is no masks/);
    refused(() => world.castAny(ball, { counts: {} }), /there is no counts/);
    refused(() => world.cast(ball, { counts: { bin: 0 } }), /counts: there is no bin,/);
    for (const call of [world.carve, world.startCarve].map((one) => one.bind(world)).concat(edit.carve.bind(edit))) {
        refused(() => call(cutter, { ...at, size: 2 }), /the pose: there is no size, only position, rotation, scale/);
        refused(() => call(cutter, at, { filled: true }), /there is no filled/);
    }
    refused(() => world.carve(cutter, at, { chunks: { volume: 1 } }), /chunks: there is no volume, only minVolume, density/);
    refused(() => world.withAnchors({ material: 'x' }), /the anchors: there is no material,/);
    refused(() => world.withRules({ zone: [zone] }), /the rules: there is no zone,/);
    refused(() => world.withRules({ zones: [{ ...zone, hard: 1 }] }), /zone 0: the zone: there is no hard,/);
    refused(() => world.pack({ exakt: true }), /there is no exakt/);
    refused(() => world.path(0, 0, { open: true }), /there is no open/);
    for (const one of [edit, cutter, world]) one.release();
});

test('a value of a wrong type is refused', () => {
    const mesh = boxMesh();
    const world = firma.worldFromMesh(mesh);
    const cutter = firma.crater('box', 1);
    const ball = { centre: [4, 4, 4], radius: 0.5, path: [1, 0, 0] };
    const at = { position: [8, 4, 4] };
    for (const options of [null, [], 'fast', 7]) {
        refused(() => world.cast(ball, options), /must be an object/);
        refused(() => world.carve(cutter, at, options), /must be an object/);
        refused(() => firma.worldFromMesh(mesh, options), /must be an object/);
    }
    refused(() => firma.worldFromMesh(mesh, { name: null }), /name must be a string/);
    refused(() => firma.worldFromMesh({ ...mesh, twoSided: 'yes' }), /twoSided must be an array/);
    refused(() => firma.worldFromMesh({ ...mesh, twoSided: mesh.cornerCounts.map(() => 2) }), /must be true, false, 1 or 0/);
    refused(() => firma.worldFromMesh({ ...mesh, materialNames: null }), /materialNames must be an array/);
    refused(() => world.cast(ball, { room: null }), /room/);
    refused(() => world.cast(ball, { counts: { nodes: '0' } }), /nodes must be a number/);
    refused(() => world.carve(cutter, { ...at, scale: null }), /scale must be a number/);
    refused(() => world.carve(cutter, { ...at, rotation: null }), /rotation must be an array/);
    refused(() => world.carve(cutter, at, { material: 5 }), /material must be a string/);
    refused(() => world.withRules({ zones: null }), /zones must be an array/);
    refused(() => world.withRules({ maxFaces: null }), /maxFaces must be an integer/);
    refused(() => world.withRules({ hardness: null }), /hardness must be an array/);
    refused(() => world.pack({ exact: 1 }), /exact must be true or false/);
    for (const one of [cutter, world]) one.release();
});
