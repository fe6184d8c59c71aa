// SPDX-License-Identifier: MIT
// Edits as bytes: commands, logs and their replays, patches between peers.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { readFileSync } from 'node:fs';
import { boxMesh, firma, readers, releasing, throwsCode, withLevel } from './helpers.js';

/** work(world, release later) in a box of air. */
const playing = (work) =>
    releasing([firma.worldFromMesh(boxMesh())], (world) => {
        const kept = [];
        releasing(kept, () => work(world, (object) => (kept.push(object), object)));
    });

/** A crater in the floor as a quantised command. */
function shot(number, x, keep, options = { material: 'dirt' }) {
    const crater = keep(firma.crater('rocky', number));
    const pose = { position: [x, 4.1, 0.2], rotation: firma.randomTurn(number), scale: 0.8 };
    return keep(keep(firma.editCommand(number, crater, pose, options)).quantised());
}

test('commands say what they do, and come back from their bytes', () => {
    playing((world, keep) => {
        const command = shot(3, 4, keep, { material: 'größe', from: [4, 4, 2] });
        const bytes = command.pack();
        assert.ok(bytes.length < 64, `${bytes.length} bytes`);
        const facts = keep(firma.unpackCommand(bytes, 'sent')).facts();
        assert.deepEqual(facts, command.facts());
        const { pose, options, ...others } = facts;
        assert.deepEqual(others, {
            kind: 'carve',
            number: 3,
            lastNumber: 3,
            partCount: 0,
            portal: null,
            open: null,
            shape: 'rocky',
            seed: 3n,
        });
        assert.deepEqual(options, { fill: false, material: 'größe', edit: 3, from: [4, 4, 2] });
        const { rotation, ...exact } = firma.quantisePose(pose); // turns of the seed stay in a command
        assert.deepEqual(exact, { position: pose.position, scale: pose.scale });
        assert.ok(rotation.every((part, k) => Math.abs(part - pose.rotation[k]) < 1 / 16384));
        assert.equal(pose.position[1] * 4096, Math.round(4.1 * 4096));

        const applied = world.apply(command);
        assert.equal(applied.report.status, 'done');
        const carved = world.carve(keep(firma.crater(facts.shape, facts.seed)), pose, options);
        assert.equal(keep(carved.world).hash(), keep(applied.world).hash());
        const job = keep(world.startApply(command));
        while (!job.run(0));
        assert.equal(keep(job.result().world).hash(), applied.world.hash());
        const again = applied.world.apply(command);
        assert.equal(keep(again.world).hash(), applied.world.hash());
        assert.equal(again.report.status, 'refused');
        assert.match(again.report.reason, /\d/);

        throwsCode('MALFORMED', () => firma.unpackCommand(bytes.subarray(0, 2), 'sent'), /sent/);
        throwsCode('BAD_CALL', () => firma.unpackCommand('text'), /data/);
        throwsCode('BAD_CALL', () => firma.editCommand(-1, command, pose), /number/);
        throwsCode('BAD_HANDLE', () => firma.editCommand(1, command, pose), /./);
        throwsCode('INVALID', () => keep(firma.editCommand(0, keep(firma.crater('box', 1)), pose)).pack());
    });
});

test('options of a command, and one that is cut off between two of them', () => {
    playing((world, keep) => {
        const options = { material: 'dirt', from: [4, 4, 2], chunks: { minVolume: 2, density: 5 } };
        const bytes = shot(3, 4, keep, options).pack();
        const read = (length) => keep(firma.unpackCommand(bytes.subarray(0, length))).facts().options;
        assert.deepEqual(read(bytes.length), { fill: false, edit: 3, ...options });
        const valid = [];
        for (let length = 0; length < bytes.length; ++length) {
            try {
                valid.push(read(length));
            } catch (error) {
                assert.equal(error.code, 'MALFORMED', `${length} bytes`);
            }
        }
        const { material, from } = options;
        assert.deepEqual(valid, [
            { fill: false, edit: 3, material: '' },
            { fill: false, edit: 3, material },
            { fill: false, edit: 3, material, from },
        ]);
        const usual = keep(firma.unpackCommand(shot(4, 4, keep, { chunks: true }).pack())).facts().options;
        assert.deepEqual(usual.chunks, { minVolume: 0.001, density: 0 }); // by what they are made of
    });
});

test('groups are one version; doors', () => {
    playing((world, keep) => {
        const parts = [shot(1, 2, keep), shot(2, 6, keep)];
        const group = keep(firma.groupCommand(parts));
        const { kind, number, lastNumber, partCount, pose, options } = group.facts();
        assert.deepEqual([kind, number, lastNumber, partCount, pose, options], ['group', 0, 2, 2, null, null]);
        assert.deepEqual(keep(group.part(1)).facts(), parts[1].facts());
        const { world: after, report } = world.apply(keep(firma.unpackCommand(group.pack())));
        assert.deepEqual([keep(after).facts().version, after.facts().edits, report.status], [1, 2, 'done']);
        const volumes = parts.map((part) => {
            const result = world.apply(part);
            keep(result.world);
            return result.report.volume;
        });
        assert.ok(Math.abs(report.volume - volumes[0] - volumes[1]) < 1e-9);
        throwsCode('INVALID', () => firma.groupCommand([]), /at least one/);
        throwsCode('INVALID', () => firma.groupCommand([group]), /is a group/);
        throwsCode('INVALID', () => firma.groupCommand([parts[1], parts[0]]), /part 1/);
        throwsCode('BAD_CALL', () => firma.groupCommand(group), /array/);
        throwsCode('BAD_HANDLE', () => firma.groupCommand([world, {}]), /command/);
        throwsCode('OUT_OF_RANGE', () => group.part(2), /no such part/);
        const door = keep(firma.unpackCommand(keep(firma.doorCommand(9, 7, false)).pack()));
        assert.deepEqual([door.facts().kind, door.facts().portal, door.facts().open], ['door', 7, false]);
        const shut = world.apply(door);
        keep(shut.world);
        assert.equal(shut.report.status, 'refused'); // no such portal
        throwsCode('BAD_CALL', () => firma.doorCommand(9, 7, 1), /open/);
    });
});

/** Four craters and their log, with a checkpoint after the second and the last. */
function play(world, keep) {
    const log = keep(firma.beginLog(world));
    let now = world;
    for (let k = 1; k <= 4; ++k) {
        const command = shot(10 * k, 1.5 * k, keep);
        log.append(command);
        throwsCode('INVALID', () => log.append(command));
        now = keep(now.apply(command).world);
        if (k % 2 === 0) log.checkpoint(now);
    }
    return { log, now };
}

test('a log gives the same world in any slices', () => {
    playing((world, keep) => {
        const { log, now } = play(world, keep);
        const bytes = log.pack();
        const read = keep(firma.unpackLog(bytes, 'game'));
        const facts = read.facts();
        assert.deepEqual(facts, log.facts());
        assert.equal(facts.levelHash, world.hash());
        assert.deepEqual([facts.commandCount, facts.checkpointCount, facts.lastNumber, facts.levelEdits], [4, 2, 40, 0]);
        assert.equal(keep(read.command(2)).facts().number, 30);
        throwsCode('OUT_OF_RANGE', () => read.command(4), /no such command/);
        const replay = keep(read.replay(world));
        let behind = 0;
        while (!replay.run(0)) {
            const { commandsBehind, commandsInAll, finished } = replay.facts();
            assert.ok(commandsBehind >= behind && commandsInAll === 4 && !finished);
            behind = commandsBehind;
        }
        assert.equal(keep(replay.result()).hash(), now.hash());
        const { commandsBehind, commandsInAll, ...counts } = replay.facts();
        assert.deepEqual([commandsBehind, commandsInAll], [4, 4]);
        assert.deepEqual(counts, { finished: true, applied: 4, done: 4, nothing: 0, refused: 0, checkpoints: 2, error: null });
        const half = keep(read.replay(world, 25));
        half.run(Infinity);
        assert.deepEqual([half.facts().applied, half.facts().checkpoints], [2, 1]);
        const other = keep(read.replay(now));
        assert.ok(other.run(Infinity));
        const { finished, applied, error } = other.facts();
        assert.deepEqual([finished, applied], [true, 0]);
        assert.match(error, /another world/);
        throwsCode('INVALID', () => other.result(), /another world/);
        const held = keep(world.withAnchors({ materials: ['plaster'] }));
        assert.match(keep(read.replay(held)).facts().error, /other anchors/);
        throwsCode('INVALID', () => replay.run(-1), /time/);
        const damaged = bytes.slice();
        damaged[damaged.length >> 1] ^= 1;
        throwsCode('MALFORMED', () => firma.unpackLog(damaged, 'game'), /game/);
    });
});

test('a log that the command line wrote of the depot, whose brushes of firma_anchor hold', () => {
    const read = (name) => readFileSync(new URL(`../../../${name}`, import.meta.url));
    const kept = [readers.levelFromMap(read('levels/depot.map'), { name: 'depot.map' })];
    const keep = (object) => (kept.push(object), object);
    releasing(kept, (level) => {
        const volumes = level.anchorVolumes();
        assert.equal(volumes.length, 4);
        assert.ok(volumes.every(({ low, high }) => low.every((x, axis) => x < high[axis])));
        const world = keep(level.world());
        // What `firma carve levels/depot.map --chunks --log` writes: see tests/cli/test_log.py.
        const log = keep(firma.unpackLog(read('tests/data/depot_bridge.firmalog'), 'depot_bridge'));
        const replay = keep(log.replay(keep(world.withAnchors({ volumes }))));
        replay.run(Infinity);
        const { done, checkpoints, error } = replay.facts();
        assert.deepEqual([done, checkpoints, error], [3, 1, null]);
        assert.equal(keep(replay.result()).hash(), 0xe1f4b967d5727f35n);
        for (const anchors of [undefined, { volumes: volumes.slice(1) }]) {
            const other = keep(log.replay(keep(world.withAnchors(anchors))));
            assert.ok(other.run(Infinity));
            assert.match(other.facts().error, /other anchors/);
            throwsCode('INVALID', () => other.result(), /other anchors/);
        }
    });
});

test('a log is compacted for who joins late', () => {
    playing((world, keep) => {
        const { log, now } = play(world, keep);
        const shorter = keep(firma.unpackLog(keep(log.compact(world, 30)).pack()));
        const { commandCount, patchedNumber, patchBytes } = shorter.facts();
        assert.deepEqual([commandCount, patchedNumber, patchBytes > 0], [1, 30, true]);
        const replay = keep(shorter.replay(world));
        replay.run(Infinity);
        assert.equal(keep(replay.result()).hash(), now.hash());
        throwsCode('INVALID', () => log.compact(now, 30));
        throwsCode('INVALID', () => shorter.compact(world, 20));
    });
});

test('peers that differ find where, and one mends the other', () => {
    withLevel((world) => {
        const kept = [];
        const keep = (object) => (kept.push(object), object);
        releasing(kept, () => {
            const cutter = keep(firma.crater('rocky', 4));
            const { low, high } = world.facts();
            const place = (share) => low.map((at, axis) => at + share * (high[axis] - at));
            const behind = keep(world.carve(cutter, { position: [place(0.3)[0], place(0.5)[1], 0], scale: 1.5 }).world);
            const ahead = keep(behind.carve(cutter, { position: [place(0.6)[0], place(0.5)[1], 0], scale: 1.5 }).world);
            assert.notEqual(ahead.hash(), behind.hash());
            const regions = firma.differingRegions(behind.hashRegions(), ahead.hashRegions());
            assert.ok(regions.length > 0);
            assert.deepEqual(firma.differingRegions(ahead.hashRegions(), ahead.hashRegions()), []);
            const list = behind.listFaces(regions);
            const patch = ahead.makePatch(list, 'list');
            for (const one of [patch, ahead.patchFrom(behind)]) {
                const mended = keep(behind.applyPatch(one, 'peer'));
                assert.equal(mended.hash(), ahead.hash());
                mended.check();
            }
            throwsCode('INVALID', () => world.applyPatch(patch, 'peer'));
            throwsCode('MALFORMED', () => ahead.makePatch(list.subarray(1), 'list'), /list/);
            const damaged = patch.slice();
            damaged[damaged.length >> 1] ^= 1;
            assert.throws(() => behind.applyPatch(damaged, 'peer'));
            throwsCode('BAD_CALL', () => firma.differingRegions(5, []), /array/);
            throwsCode('BAD_CALL', () => firma.differingRegions([{}], []), /region/);
            throwsCode('BAD_CALL', () => behind.listFaces([[1, 2]]), /region/);
            throwsCode('BAD_HANDLE', () => ahead.patchFrom(cutter), /./);
        });
    });
});
