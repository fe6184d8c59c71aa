// SPDX-License-Identifier: MIT
// Memory: that it grows under our views, that it runs out, and what a trap does.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { loadFirma } from '../src/index.js';
import { loadReaders } from '../src/readers.js';
import { boxMesh, levelBytes, readers, releasing, throwsCode, wasmUrl } from './helpers.js';
import { randomCasts } from './scenario.js';

const bytes = readFileSync(wasmUrl);
const cast = { centre: [4, 4, 4], radius: 1, path: [6, 0, 0] };

/** The library, and its instance's memory and functions. */
async function loadOpen() {
    const { instantiate } = WebAssembly;
    let exports;
    WebAssembly.instantiate = async (...args) => {
        const instance = await instantiate(...args);
        exports = { ...instance.exports };
        return { exports };
    };
    try {
        return { firma: await loadFirma(bytes), exports };
    } finally {
        WebAssembly.instantiate = instantiate;
    }
}

/** After this no more memory can be had than the module's allocator has. */
function growToTheEnd(memory) {
    for (let pages = 65536; pages >= 1; pages >>= 1) {
        try {
            for (;;) memory.grow(pages);
        } catch {
            // Fewer, then.
        }
    }
}

test('memory that grows within any call', async () => {
    const { firma, exports } = await loadOpen();
    const world = firma.worldFromMesh(boxMesh());
    const expected = world.cast(cast);
    const hash = world.hash();
    const [low, high] = [
        [0, 0, 0],
        [8, 8, 8],
    ];
    const inputs = randomCasts(100, { low, high }, 1);
    const batch = world.castBatch(inputs);
    // As if each of these calls took memory: what they answer must be read from where it is afterwards.
    const own = new Map();
    const growing =
        (name) =>
        (...args) => {
            const answer = own.get(name)(...args);
            exports.memory.grow(1);
            return answer;
        };
    const core = coreOf(world);
    const all = Object.keys(core.exports).filter((name) => typeof core.exports[name] === 'function');
    for (const name of all) {
        own.set(name, core.exports[name]);
        core.exports[name] = growing(name);
    }
    assert.deepEqual(world.cast(cast), expected);
    assert.equal(world.castAny(cast), true);
    assert.equal(world.hash(), hash);
    assert.deepEqual(world.castAll(cast)[0], expected);
    const again = world.castBatch(inputs);
    for (let k = 0; k < 100; ++k) assert.deepEqual(again.hit(k), batch.hit(k));
    assert.equal(world.facts().faceCount, 6);
    assert.equal(world.measure().volume, -512);
    assert.equal(world.faces().ids.length, 6);
    assert.deepEqual(world.closest([4, 4, 1]).point, [4, 4, 0]);
    assert.equal(world.overlap([4, 4, 4], 5).length, 6);
    assert.equal(world.locate([4, 4, 4]).where, 'air');
    const cutter = firma.crater('rocky', 1);
    const { world: after, report } = world.carve(cutter, { position: [8, 4, 4] }, { material: 'x' });
    assert.equal(report.status, 'done');
    assert.equal(world.diff(after, 1).removed.length, report.facesRemoved);
    assert.ok(after.facts().materials.includes('x'));
    const copy = firma.unpackWorld(after.pack());
    assert.equal(copy.hash(), after.hash());
    throwsCode('MALFORMED', () => readers.worldFromObj('v 0 0 zero', { name: 'röhre' }), /röhre/);
    const store = firma.openStore(world, 1e6);
    store.publish(world, after);
    assert.equal(store.facts().current, 1);
    const ruled = world.withRules({ zones: [{ name: 'z', low: [4, 0, 0], high: [12, 9, 9], hardness: 1 }] });
    const refused = ruled.carve(cutter, { position: [8, 4, 4] });
    assert.match(refused.report.reason, /z/);
    for (const one of [world, cutter, after, copy, store, ruled, refused.world]) one.release();
    assert.equal(firma.liveHandles(), 0);
});

/** The symbol-named property that ties an object to its instance. */
function coreOf(object) {
    return object[Object.getOwnPropertySymbols(object).find((symbol) => symbol.description === 'core')];
}

test('arguments and answers leave no memory behind', async () => {
    const { firma, exports } = await loadOpen();
    const level = await firma.worldFromObj(levelBytes);
    const cutter = firma.crater('rocky', 1);
    const packed = level.pack();
    const round = () => {
        firma.unpackWorld(packed, 'x'.repeat(100_000)).release();
        throwsCode('MALFORMED', () => firma.unpackWorld(packed.subarray(1)));
        throwsCode('BAD_CALL', () => level.withRules({ hardness: new Float64Array(50_000), zones: [{}] }));
        level.carve(cutter, { position: [40, 20, 2.5] }, { material: 'x'.repeat(100_000) }).world.release();
        level.faces();
        level.overlap([40, 20, 4], 300);
        level.castBatch(new Float64Array(7 * 3000));
    };
    for (let k = 0; k < 5; ++k) round();
    const before = exports.memory.buffer.byteLength;
    for (let k = 0; k < 30; ++k) round();
    assert.equal(exports.memory.buffer.byteLength, before);
    level.release();
    cutter.release();
    assert.equal(firma.liveHandles(), 0);
});

test('memory beyond two and beyond three gigabytes', async () => {
    const level = releasing([readers.worldFromObj(levelBytes)], (world) => world.pack());
    for (const pages of [33000, 50000]) {
        const { firma, exports } = await loadOpen();
        exports.memory.grow(pages);
        const plain = await loadFirma(bytes);
        const [here, there] = [firma, plain].map((one) => {
            const world = one.unpackWorld(level, 'größe');
            const cutter = one.crater('spiky', 3);
            const position = world.cast({ centre: [40, 20, 4], radius: 0, path: [30, 1, 0] }).point;
            const { world: after } = world.carve(cutter, { position }, { material: 'größe' });
            const batch = after.castBatch(randomCasts(1500, after.facts(), 4));
            const facts = after.facts();
            const answers = {
                facts,
                hash: after.hash(),
                faces: after.faces(),
                diff: world.diff(after, 1),
                near: after.overlap([40, 20, 4], 300),
                hits: Array.from({ length: batch.count }, (_, k) => batch.hit(k)),
                packed: after.pack(),
                solid: after.locate([40, 20, 4]),
            };
            answers.again = one.unpackWorld(answers.packed).hash();
            for (const object of [world, cutter, after]) object.release();
            return answers;
        });
        const lent = coreOf(firma.crater('box', 1)).take(1 << 20);
        assert.ok(lent > pages * 65536, `${lent}`);
        assert.deepEqual(here, there);
    }
});

test('no memory for arguments: nothing happens, and the module goes on', async () => {
    const { firma, exports } = await loadOpen();
    const world = firma.worldFromMesh(boxMesh());
    const before = world.cast(cast);
    growToTheEnd(exports.memory);
    throwsCode('NO_MEMORY', () => firma.unpackWorld(new Uint8Array(64 << 20)));
    assert.deepEqual(world.cast(cast), before);
    world.release();
    assert.equal(firma.liveHandles(), 0);
});

test('a trap stops the module for good', async () => {
    const { firma, exports } = await loadOpen();
    const other = await loadFirma(bytes);
    const reading = await loadReaders(firma);
    const world = reading.worldFromObj(levelBytes);
    const packed = world.pack();
    const batch = world.castBatch([40, 20, 4, 0.5, 9, 0, 0]);
    const kept = batch.hit(0);
    growToTheEnd(exports.memory);
    // Worlds until there is no room for another.
    throwsCode(
        'INTERNAL',
        () => {
            for (;;) firma.unpackWorld(packed);
        },
        /stopped .*loadFirma\(\)/,
    );
    const stopped = /^the module stopped .* load it anew with loadFirma\(\)$/;
    for (const call of [
        () => firma.liveHandles(),
        () => firma.version,
        () => firma.crater('rocky', 1),
        () => reading.worldFromObj(levelBytes),
        () => firma.worldFromMesh(boxMesh()),
        () => firma.unpackWorld(packed),
        () => firma.memory([world]),
        () => firma.randomTurn(1),
        () => firma.openStore(world, 1),
        () => world.cast(cast),
        () => world.castAny(cast),
        () => world.castAll(cast),
        () => world.castBatch([]),
        () => world.facts(),
        () => world.faces(),
        () => world.diff(world),
        () => world.pack(),
    ])
        throwsCode('INTERNAL', call, stopped);
    assert.throws(
        () => world.hash(),
        (error) => error.cause instanceof WebAssembly.RuntimeError,
    );
    // What was copied out is still there, and letting go is quiet.
    assert.deepEqual(batch.hit(0), kept);
    assert.equal(world.released, false);
    world.release();
    world.release();
    assert.equal(world.released, true);
    if (Symbol.dispose) world[Symbol.dispose]();
    // Another instance does not notice.
    (await other.worldFromObj(levelBytes)).release();
    assert.equal(other.liveHandles(), 0);
});
