// SPDX-License-Identifier: MIT
// Parts that move: what is cast and overlapped among them; what is refused.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { games, inRoom, makeSlab } from './game_helpers.js';
import { releasing, throwsCode } from './helpers.js';

const down = [0, 0, -1];
const ball = { centre: [4, 4, 2], radius: 0.5 };
const withLift = (work) =>
    inRoom((room) => releasing([games.parts(), makeSlab(1, 1, 0.25)], (parts, slab) => work(room, parts, slab)));

test('a ball meets a lift half way', () => {
    withLift((room, parts, slab) => {
        const scene = { world: room, parts };
        const standing = { position: [4, 4, 0.25] };
        assert.equal(parts.add({ world: slab, motion: standing }), 0);
        assert.equal(parts.add({ world: slab, motion: { position: [1.5, 4, 0.25], rotation: [0, 0, 1, 1] } }), 1);
        assert.equal(parts.count(), 2);
        parts.setMotions([{ ...standing, path: [0, 0, 1] }, { position: [1.5, 4, 0.25] }]);
        const hit = games.castScene(scene, { ...ball, path: down });
        assert.deepEqual([hit.part, hit.status, hit.fraction, hit.centre[2]], [0, 'hit', 0.5, 1.5]);
        assert.deepEqual([hit.surfaceVelocity, hit.normal], [[0, 0, 1], [0, 0, 1]]);
        assert.equal(slab.face(hit).normal[2], 1);
        // Over half of the motion it comes just so far.
        const half = { ...scene, to: 0.5 };
        assert.equal(games.castScene(half, { ...ball, path: [0, 0, 0] }).hit, false);
        assert.equal(games.castSceneAny(half, { ...ball, path: [0, 0, 0] }), false);
        assert.equal(games.castSceneAny(half, { ...ball, path: down }), true);
        const box = games.hullBox([0.5, 0.5, 0.5]);
        const shapes = [{ hull: box, at: [4, 4, 2] }, { from: [4, 4, 2], to: [4, 4, 3], radius: 0.5 }];
        for (const shape of shapes) assert.equal(games.castScene(scene, { ...shape, path: down }).fraction, 0.5);
        box.release();
        // The level is still there, and alone it is a scene.
        const wall = games.castScene(scene, { ...ball, path: [4, 0, 0] });
        assert.deepEqual([wall.part, wall.fraction, wall.surfaceVelocity], [null, 0.875, [0, 0, 0]]);
        const { part, surfaceVelocity, ...alone } = games.castScene(room, { ...ball, path: [4, 0, 0] });
        assert.deepEqual(alone, room.cast({ ...ball, path: [4, 0, 0] }));
        // A part that the cast does not share a bit with.
        parts.set(0, { world: slab, mask: 2, motion: { ...standing, path: [0, 0, 1] } });
        assert.equal(games.castScene(scene, { ...ball, path: down }, { mask: 1 }).hit, false);

        const found = games.overlapScene(scene, ball, { fraction: 1 });
        assert.deepEqual([found.length, found[0].part, found[0].direction], [1, 0, [0, 0, 1]]);
        assert.deepEqual(found[0].surfaceVelocity, [0, 0, 1]);
        assert.equal(games.overlapScene(scene, ball).length, 0);
        assert.equal(games.overlapScene(scene, ball, { fraction: 1, mask: 1 }).length, 0);
        const all = games.overlapScene(scene, { centre: [4, 4, 4], radius: 9 });
        assert.equal(all.length, 18);
        assert.deepEqual(all.slice(0, 6).map((one) => one.part), Array(6).fill(null));
    });
});

test('parts keep their worlds, and turn', () => {
    withLift((room, parts, slab) => {
        const bar = makeSlab(3, 0.1, 0.1);
        parts.add({ world: bar, motion: { position: [4, 4, 4], turn: [0, 0, 3] } });
        bar.release();
        const hit = games.castScene({ world: room, parts }, { centre: [4, 6, 4], radius: 0.25, path: [0, 0, 0] });
        assert.deepEqual([hit.part, hit.hit], [0, true]);
        // Half a turn less than three radians: the bar comes to it with its side.
        assert.ok(hit.fraction > 0.4 && hit.fraction < 0.55, `${hit.fraction}`);
        assert.ok(Math.abs(hit.surfaceVelocity[0]) > 4);
    });
});

test('what is no part or no scene says so', () => {
    withLift((room, parts, slab) => {
        const scene = { world: room, parts };
        const add = (part) => parts.add(part);
        throwsCode('BAD_CALL', () => add(undefined), /the part must be an object/);
        throwsCode('BAD_HANDLE', () => add({}), /not a world/);
        throwsCode('BAD_CALL', () => add({ world: slab, pose: {} }), /there is no pose/);
        throwsCode('BAD_CALL', () => add({ world: slab, motion: { at: [0, 0, 0] } }), /the motion: there is no at/);
        throwsCode('BAD_CALL', () => add({ world: slab, motion: { position: 5 } }), /position must be an array/);
        throwsCode('OUT_OF_RANGE', () => add({ world: slab, motion: { position: [0, NaN, 0] } }), /motion/);
        throwsCode('OUT_OF_RANGE', () => add({ world: slab, motion: { rotation: [0, 0, 0, 0] } }), /motion/);
        throwsCode('OUT_OF_RANGE', () => add({ world: slab, motion: { turn: [0, 0, 9] } }), /motion/);
        assert.equal(parts.count(), 0);
        add({ world: slab });
        throwsCode('OUT_OF_RANGE', () => parts.set(1, { world: slab }), /no part 1/);
        throwsCode('INVALID', () => parts.setMotions([{}, {}]));
        throwsCode('BAD_CALL', () => parts.setMotions({}), /array/);
        throwsCode('BAD_CALL', () => parts.setMotions([undefined]), /motion 0/);
        throwsCode('BAD_CALL', () => parts.setMotions([{ turns: 1 }]), /motion 0: there is no turns/);
        assert.equal(games.castScene({ ...scene, from: 2 }, { ...ball, path: down }).status, 'invalid');
        assert.equal(games.castScene(scene, { ...ball, path: [0, NaN, 0] }).status, 'invalid');
        throwsCode('OUT_OF_RANGE', () => games.castSceneAny({ ...scene, to: 2 }, { ...ball, path: down }), /stretch/);
        throwsCode('OUT_OF_RANGE', () => games.overlapScene(scene, ball, { fraction: 2 }), /0\.\.1/);
        throwsCode('BAD_CALL', () => games.overlapScene(scene, ball, { time: 1 }), /there is no time/);
        throwsCode('BAD_CALL', () => games.castScene(scene, ball), /path/);
        throwsCode('BAD_CALL', () => games.castScene(scene, { ...ball, path: down }, { passed: [] }), /there is no passed/);
        throwsCode('BAD_CALL', () => games.castScene(undefined, { ...ball, path: down }), /scene/);
        throwsCode('BAD_CALL', () => games.castScene({ ...scene, frm: 0 }, { ...ball, path: down }), /there is no frm/);
    });
});
