// SPDX-License-Identifier: MIT
// Memory that grows within any call: what the module of recordings answers is read from where it is afterwards.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { CORE } from '../src/handle.js';
import { loadRecordings, Projectiles } from '../src/recordings.js';
import { boxMesh } from './helpers.js';

/** Runs work, with memory that grows by a page within each call into the module. */
function growing(core, work) {
    const own = core.exports;
    const grow = (name) => (...args) => {
        const answer = own[name](...args);
        core.memory.grow(1);
        return answer;
    };
    const functions = Object.keys(own).filter((name) => typeof own[name] === 'function');
    core.exports = Object.fromEntries(functions.map((name) => [name, grow(name)]));
    try {
        return work();
    } finally {
        core.exports = own;
    }
}

test('debris, blasts, paths, convex pieces and supports', async () => {
    const recordings = await loadRecordings();
    const box = (low, high) => {
        const mesh = boxMesh(low, high);
        return recordings.worldFromMesh({ ...mesh, corners: mesh.corners.reverse() });
    };
    const room = recordings.worldFromMesh(boxMesh());
    const core = room[CORE];
    /** What all of it answers, without the handles. */
    const askAll = () => {
        const held = [];
        const hold = (object) => (held.push(object), object);
        try {
            const block = hold(box([3, 3, 4], [5, 5, 9]));
            const hung = hold(recordings.cutterFromWorld(block));
            const level = hold(hold(room.carve(hung, { position: [0, 0, 0] }, { fill: true }).world).withAnchors());
            const [bodies, debris] = [hold(recordings.bodies()), hold(recordings.debris())];
            const crater = hold(recordings.crater('rocky', 1));
            const at = [4, 4, 7];
            const shot = debris.explode(bodies, level, { at }, crater, { position: at, scale: 2 }, { carve: { material: 'soot' } });
            const after = hold(shot.world);
            delete shot.report.carve.times;
            const [first] = bodies.list();
            const pattern = recordings.fracturePattern(level, 0);
            const shattered = debris.shatter(bodies, first, { ...pattern, sizeOfPiece: [0.3, 0.3, 0.3] }, { world: after });
            const tended = debris.tend(bodies, after, 1, { maxBodies: 3, keepClear: [1, 1, 1, 0.5] });
            hold(tended.world);
            const parts = hold(recordings.parts());
            parts.add({ world: block, motion: { position: [-2, -2, -4], path: [0.1, 0, 0] } });
            const bears = recordings.breakable(parts, 0);
            const felt = recordings.blastFelt(parts, 0, after, { at: [6, 6, 2] });
            const shots = new Projectiles();
            shots.add({ position: [6, 2, 2], velocity: [-400, 10, 0] });
            const flown = recordings.flyScene(shots, { world: after, parts }, 1 / 60, { other: { resistance: 10 } });
            const broken = debris.breakPart(bodies, parts, 0, after, { breakable: { ...bears, health: 1 }, portals: [] });
            hold(broken.world);
            const things = hold(recordings.findSupports(after, [{ kind: 'stands', low: [1, 1, 1], high: [2, 2, 2], reach: 4 }]));
            const diff = things.diff(room, after);
            hold(diff.after);
            return {
                shot: shot.report,
                shattered,
                tended: tended.report,
                felt,
                flown,
                broken: [broken.breakable, broken.report],
                supports: [things.get(0), things.faces(0), diff.changes],
                pierced: recordings.pierce(after, { start: [1, 4, 7], path: [9, 0.1, 0] }),
                pieces: recordings.convexPieces(hold(debris.world(bodies, bodies.list()[0]))),
                seen: recordings.exposure(after, at, [4, 4, 1, 0.5, 7, 7, 7, 0.25]),
                hash: [bodies.hash(), debris.hash(), after.hash()],
            };
        } finally {
            for (const object of held) object.release();
        }
    };
    const expected = askAll();
    assert.ok(expected.shot.loose.length > 0 && expected.broken[1].pieces.length > 0 && expected.flown.events.length > 0);
    assert.ok(expected.pierced.spans.length > 0 && expected.pieces.length > 0 && expected.tended.removed.length > 0);
    assert.deepEqual(growing(core, askAll), expected);
    room.release();
    assert.equal(recordings.liveHandles(), 0);
});
