// SPDX-License-Identifier: MIT
// Objects that were released, belong to another module, or were forgotten.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { loadFirma } from '../src/index.js';
import { loadReaders } from '../src/readers.js';
import { boxMesh, brush, firma, readers, releasing, throwsCode } from './helpers.js';

const pose = { position: [8, 4, 4] };
const cast = { centre: [4, 4, 4], radius: 1, path: [6, 0, 0] };

/** One of each kind, and every call that takes it; `module` made them, with its readers. */
function everything(module, reading = readers) {
    const world = module.worldFromMesh(boxMesh());
    const cutter = module.crater('rocky', 1);
    const command = module.editCommand(1, cutter, pose);
    const log = module.beginLog(world);
    return {
        world,
        cutter,
        job: world.startCarve(cutter, pose),
        edit: world.edit(),
        store: module.openStore(world, 1e6),
        level: reading.levelFromMap(`{ "classname" "worldspawn" ${brush([0, 0, 0], [64, 64, 64], 'rock')} }`),
        chunks: world.pieces(),
        command,
        log,
        replay: log.replay(world),
    };
}

const callsOf = ({ world, cutter, job, edit, store, level, chunks, command, log, replay }) => ({
    copy: () => world.copy(),
    facts: () => world.facts(),
    hash: () => world.hash(),
    sameSolid: () => world.sameSolid(world),
    check: () => world.check(),
    measure: () => world.measure(),
    memory: () => world.memory(),
    faces: () => world.faces(),
    findFace: () => world.findFace(0),
    matters: () => world.matters(),
    matterAt: () => world.matterAt([4, 4, 4]),
    matterOf: () => world.matterOf({ id: 0, corner: [0, 0, 0] }),
    countMatters: () => world.countMatters(),
    cast: () => world.cast(cast),
    castAny: () => world.castAny(cast),
    castAll: () => world.castAll(cast),
    castBatch: () => world.castBatch([4, 4, 4, 1, 6, 0, 0]),
    castNone: () => world.castBatch([]),
    overlap: () => world.overlap([4, 4, 4], 9),
    closest: () => world.closest([4, 4, 4]),
    carve: () => world.carve(cutter, pose),
    startCarve: () => world.startCarve(cutter, pose),
    edit: () => world.edit(),
    diff: () => world.diff(world),
    withRules: () => world.withRules({}),
    pack: () => world.pack(),
    run: () => job.run(0),
    result: () => job.result(),
    editCarve: () => edit.carve(cutter, pose),
    finish: () => edit.finish(),
    current: () => store.current(),
    publish: () => store.publish(world, world),
    undo: () => store.undo(),
    redo: () => store.redo(),
    at: () => store.at(0),
    storeFacts: () => store.facts(),
    collect: () => store.collect(),
    texture: () => world.texture(0),
    eachFace: () => world.eachFace({}, () => true),
    triangles: () => world.triangles(),
    entities: () => level.entities(),
    notes: () => level.notes(),
    worldOfLevel: () => level.world(),
    apply: () => world.apply(command),
    startApply: () => world.startApply(command),
    withAnchors: () => world.withAnchors(),
    mass: () => world.mass(1),
    pieces: () => world.pieces(),
    listFaces: () => world.listFaces([]),
    makePatch: () => world.makePatch(new Uint8Array(4)),
    patchFrom: () => world.patchFrom(world),
    applyPatch: () => world.applyPatch(new Uint8Array(4)),
    listChunks: () => chunks.list(),
    worldOfChunk: () => chunks.world(0),
    commandFacts: () => command.facts(),
    quantised: () => command.quantised(),
    packCommand: () => command.pack(),
    part: () => command.part(0),
    append: () => log.append(command),
    checkpoint: () => log.checkpoint(world),
    logFacts: () => log.facts(),
    commandOfLog: () => log.command(0),
    packLog: () => log.pack(),
    compact: () => log.compact(world, 0),
    startReplay: () => log.replay(world),
    replayRun: () => replay.run(0),
    replayFacts: () => replay.facts(),
    replayResult: () => replay.result(),
});

test('a call on a released object throws BAD_HANDLE, whatever came to live after it', () => {
    const all = everything(firma);
    assert.equal(firma.liveHandles(), 10);
    for (const object of Object.values(all)) {
        assert.equal(object.released, false);
        object.release();
        assert.equal(object.released, true);
    }
    assert.equal(firma.liveHandles(), 0);
    const others = everything(firma);
    const calls = callsOf(all);
    for (const name in calls) throwsCode('BAD_HANDLE', calls[name], /released already/);
    throwsCode('BAD_HANDLE', () => firma.memory([others.world, all.world]), /world/);
    throwsCode('BAD_HANDLE', () => firma.openStore(all.world, 1), /world/);
    throwsCode('BAD_HANDLE', () => others.world.diff(all.world), /world/);
    throwsCode('BAD_HANDLE', () => others.world.carve(all.cutter, pose), /cutter/);
    throwsCode('BAD_HANDLE', () => others.store.publish(others.world, all.world), /world/);
    throwsCode('BAD_HANDLE', () => others.world.apply(all.command), /command/);
    throwsCode('BAD_HANDLE', () => others.world.patchFrom(all.world), /world/);
    throwsCode('BAD_HANDLE', () => others.log.append(all.command), /command/);
    throwsCode('BAD_HANDLE', () => others.log.replay(all.world), /world/);
    throwsCode('BAD_HANDLE', () => firma.groupCommand([others.command, all.command]), /command/);
    for (const object of Object.values(others)) object.release();
});

test('a second release throws, a second dispose does not', () => {
    for (const object of Object.values(everything(firma))) {
        object.release();
        throwsCode('BAD_HANDLE', () => object.release(), /released already/);
        assert.equal(object.released, true);
        if (Symbol.dispose) object[Symbol.dispose]();
    }
    if (!Symbol.dispose) return;
    const world = firma.worldFromMesh(boxMesh());
    world[Symbol.dispose]();
    assert.equal(world.released, true);
    world[Symbol.dispose]();
});

test('objects of another module are told from ours', async () => {
    const other = await loadFirma();
    const theirs = everything(other, await loadReaders(other));
    const ours = everything(firma);
    throwsCode('BAD_HANDLE', () => ours.world.carve(theirs.cutter, pose), /another module/);
    throwsCode('BAD_HANDLE', () => ours.world.startCarve(theirs.cutter, pose), /another module/);
    throwsCode('BAD_HANDLE', () => ours.edit.carve(theirs.cutter, pose), /another module/);
    throwsCode('BAD_HANDLE', () => ours.world.diff(theirs.world), /another module/);
    throwsCode('BAD_HANDLE', () => ours.store.publish(ours.world, theirs.world), /another module/);
    throwsCode('BAD_HANDLE', () => firma.openStore(theirs.world, 1), /another module/);
    throwsCode('BAD_HANDLE', () => firma.memory([theirs.world]), /another module/);
    throwsCode('BAD_HANDLE', () => ours.world.apply(theirs.command), /another module/);
    throwsCode('BAD_HANDLE', () => ours.log.checkpoint(theirs.world), /another module/);
    throwsCode('BAD_HANDLE', () => firma.cutterAtRest(theirs.world, pose), /another module/);
    throwsCode('BAD_HANDLE', () => firma.beginLog(theirs.world), /another module/);
    assert.equal(ours.world.hash(), theirs.world.hash());
    for (const object of [...Object.values(ours), ...Object.values(theirs)]) object.release();
    assert.equal(other.liveHandles(), 0);
});

test('every call of a live object works', () => {
    const all = everything(firma);
    all.job.run(Infinity);
    const made = [];
    const calls = callsOf(all);
    for (const name in calls) {
        if (['undo', 'redo', 'makePatch', 'applyPatch', 'part', 'matterOf'].includes(name)) continue;
        const answer = calls[name]();
        for (const one of [answer, answer?.world]) if (one?.release) made.push(one);
    }
    releasing([...made, ...Object.values(all)], () => assert.equal(made.length, 20));
});

test('errors release what was made on the way', () => {
    releasing(Object.values(everything(firma)), (world, cutter) => {
        const held = firma.liveHandles();
        throwsCode('BAD_CALL', () => world.carve(cutter, { position: [1] }));
        throwsCode('INVALID', () => world.diff(world, 0.001));
        throwsCode('BAD_CALL', () => world.castBatch(['x', 1, 1, 1, 1, 1, 1]));
        assert.throws(() => readers.worldFromObj('nonsense 1 2 3\nf'));
        assert.equal(firma.liveHandles(), held);
    });
});

test('what was forgotten is released by and by', () => {
    const program = `
        import { loadFirma } from ${JSON.stringify(new URL('../src/index.js', import.meta.url).href)};
        const firma = await loadFirma();
        for (let k = 0; k < 100; ++k) firma.crater('rocky', k);
        const kept = firma.crater('box', 1);
        for (let k = 0; k < 50 && firma.liveHandles() > 1; ++k) {
            gc();
            await new Promise((resolve) => setTimeout(resolve, 10));
        }
        console.log(firma.liveHandles(), kept.released);`;
    const result = spawnSync(process.execPath, ['--expose-gc', '--input-type=module', '-e', program], {
        encoding: 'utf8',
        cwd: fileURLToPath(new URL('.', import.meta.url)),
    });
    assert.equal(result.stdout, '1 false\n', result.stderr);
});
