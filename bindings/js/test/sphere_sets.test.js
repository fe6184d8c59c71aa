// SPDX-License-Identifier: MIT
// Sets of spheres: against a world, against each other, fitted into a solid; the nearest point of a scene.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { throwsCode } from './helpers.js';
import { boxWorld, holding, makeLowRoom, recordings } from './recording_helpers.js';

const near = (actual, expected, error = 1e-9) =>
    assert.ok(Math.abs(actual - expected) <= error, `${actual} is not ${expected} to ${error}`);
/** Two spheres, 2 m apart along x. */
const bar = [-1, 0, 0, 0.25, 1, 0, 0, 0.25];

test('a set against a room', () => {
    holding((hold) => {
        const room = hold(makeLowRoom());
        const hit = recordings.castSet(room, bar, { position: [4, 4, 2], path: [6, 0, 0] });
        // To the bit as the cast of the sphere in front.
        const { sphere, ...rest } = hit;
        assert.equal(sphere, 1);
        assert.deepEqual(rest, room.cast({ centre: [5, 4, 2], radius: 0.25, path: [6, 0, 0] }));
        const parts = hold(recordings.parts());
        parts.add({ world: hold(boxWorld([-0.5, -2, -2], [0.5, 2, 2], true)), motion: { position: [9, 4, 2], path: [-6, 0, 0] } });
        const met = recordings.castSetScene({ world: room, parts }, bar, { position: [4, 4, 2], path: [0, 0, 0] });
        assert.deepEqual([met.hit, met.part], [true, 0]);
        assert.ok(Math.abs(met.surfaceVelocity[0] + 6) < 1e-9 && met.sphere !== null);
        const alone = recordings.castSetScene(room, bar, { position: [4, 4, 2], path: [6, 0, 0] });
        assert.deepEqual([alone.fraction, alone.sphere, alone.part], [hit.fraction, hit.sphere, null]);
        // One that turns comes to the wall where sin(a) = 0.75.
        const turned = recordings.castSet(room, [0, 1, 0, 0.25], { position: [7, 4, 2], turn: [0, 0, -1.5] });
        assert.deepEqual([turned.hit, turned.sphere, turned.point[0]], [true, 0, 8]);
        near(Math.sin(1.5 * turned.fraction), 0.75, 2e-4);
        const missed = recordings.castSet(room, bar, { position: [4, 4, 2], path: [0.5, 0, 0] });
        assert.deepEqual([missed.status, missed.fraction, missed.sphere], ['miss', 1, null]);
        assert.equal(recordings.castSet(room, bar, { position: [4, 4, 2], path: [6, 0, 0] }, { mask: 0 }).hit, false);
        assert.equal(recordings.castSet(room, bar, { position: [4, 4, 2] }, { room: 7 }).status, 'invalid');
        assert.equal(recordings.castSet(room, [0, 0, 0, -1], { position: [4, 4, 2] }).status, 'invalid');
        throwsCode('BAD_CALL', () => recordings.castSet(room, bar), /the motion must be an object/);
        throwsCode('BAD_CALL', () => recordings.castSet(room, [1], {}), /4 numbers for each/);
        throwsCode('BAD_CALL', () => recordings.castSet(room, bar, { at: [0, 0, 0] }), /there is no at/);
        throwsCode('BAD_HANDLE', () => recordings.castSet({}, bar, {}), /not a world/);
    });
});

test('two sets against each other', () => {
    const hit = recordings.castSetPair(bar, { path: [3, 0, 0] }, [0, 0, 0, 0.5], { position: [5, 0, 0], path: [-3, 0, 0] });
    assert.deepEqual([hit.status, hit.hit, hit.sphereA, hit.sphereB], ['hit', true, 1, 0]);
    near(hit.fraction, 3.25 / 6);
    near(hit.normal[0], -1);
    near(hit.point[0], 1.25 + 3 * hit.fraction);
    const away = recordings.castSetPair(bar, { path: [-3, 0, 0] }, [0, 0, 0, 0.5], { position: [5, 0, 0] });
    assert.deepEqual([away.status, away.fraction, away.sphereA, away.sphereB], ['miss', 1, null, null]);
    assert.equal(recordings.castSetPair(bar, { turn: [Infinity, 0, 0] }, bar, {}).status, 'invalid');
    throwsCode('BAD_CALL', () => recordings.castSetPair(bar, {}, bar), /the motion must be an object/);
});

test('spheres of a closed mesh make a body of it', () => {
    holding((hold) => {
        const room = hold(makeLowRoom());
        const block = hold(boxWorld([-1, -0.5, -0.5], [1, 0.5, 0.5], true));
        const { spheres, error } = recordings.fitSpheres(block, { maxSpheres: 12, maxError: 0.01 });
        assert.equal(spheres.length, 48);
        assert.ok(error > 0.01 && error < 0.4);
        near(spheres[3], 0.5, 1e-3);
        for (let k = 0; k < 48; k += 4) {
            const [x, y, z, radius] = spheres.subarray(k, k + 4);
            assert.ok(Math.abs(x) + radius <= 1 + 1e-9 && Math.max(Math.abs(y), Math.abs(z)) + radius <= 0.5 + 1e-9);
        }
        const few = recordings.fitSpheres(block, { maxSpheres: 1 });
        assert.equal(few.spheres.length, 4);
        assert.ok(recordings.fitSpheres(block).error < few.error);
        const bodies = hold(recordings.bodies());
        const id = bodies.add(hold(recordings.bodyShape(spheres, block.mass(500))), { position: [4, 4, 1] });
        near(bodies.get(id).mass, 1000);
        for (let tick = 0; tick < 128; ++tick) bodies.step(room, 1 / 64);
        near(bodies.get(id).position[2], 0.5, 0.01);
        throwsCode('INVALID', () => recordings.fitSpheres(room));
        throwsCode('INVALID', () => recordings.fitSpheres(block, { maxSpheres: 5000 }));
        throwsCode('BAD_CALL', () => recordings.fitSpheres(block, { spheres: 3 }), /there is no spheres/);
        throwsCode('BAD_HANDLE', () => recordings.fitSpheres({}), /not a world/);
    });
});

test('the nearest point of a level with a lift', () => {
    holding((hold) => {
        const world = hold(makeLowRoom());
        const parts = hold(recordings.parts());
        parts.add({ world: hold(boxWorld([-1, -0.5, -0.5], [1, 0.5, 0.5], true)), motion: { position: [4, 4, 1], path: [0, 0, 2] } });
        const scene = { world, parts };
        const point = [4, 4, 1.75];
        const found = recordings.closestInScene(scene, point);
        assert.deepEqual([found.part, found.point[2], found.surfaceVelocity], [0, 1.5, [0, 0, 2]]);
        near(found.distance, 0.25);
        near(recordings.closestInScene(scene, point, { fraction: 1 }).distance, 0.75);
        assert.equal(recordings.closestInScene(scene, point, { reach: 0.125 }), null);
        const { part, surfaceVelocity, ...alone } = recordings.closestInScene(scene, [7.75, 4, 1.75]);
        assert.deepEqual([part, surfaceVelocity], [null, [0, 0, 0]]);
        assert.deepEqual(alone, world.closest([7.75, 4, 1.75]));
        throwsCode('OUT_OF_RANGE', () => recordings.closestInScene(scene, point, { fraction: 2 }), /fraction/);
        throwsCode('OUT_OF_RANGE', () => recordings.closestInScene(scene, point, { reach: -1 }), /reach/);
        throwsCode('INVALID', () => recordings.closestInScene(scene, point, { room: 7 }), /room 7/);
        throwsCode('BAD_CALL', () => recordings.closestInScene(scene, [1, 2]), /point must have 3 numbers/);
        throwsCode('BAD_CALL', () => recordings.closestInScene(scene, point, { far: 1 }), /there is no far/);
    });
});
