// SPDX-License-Identifier: MIT
// Casts at bodies: rays, spheres and sets at balls that stand or go on; an index outlives its bodies; what is refused.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { throwsCode } from './helpers.js';
import { holding, recordings } from './recording_helpers.js';

const near = (actual, expected, error = 1e-9) =>
    assert.ok(Math.abs(actual - expected) <= error, `${actual} is not ${expected} to ${error}`);
const ray = { centre: [0, 0, 0], radius: 0, path: [7, 0, 0] };

/** A ball at x = 4 that rises at 3 m/s and spins at 2 rad/s, one behind it, as in the C tests. */
function makeBalls(hold) {
    const bodies = hold(recordings.bodies());
    const shape = hold(recordings.bodyShape([0, 0, 0, 0.5], recordings.massOfBall(0.5, 1000)));
    const [first, second] = [4, 6].map((x) => bodies.add(shape, { position: [x, 0, 0] }));
    bodies.set(first, { velocity: [0, 0, 3], spin: [0, 0, 2] });
    return { bodies, first, second };
}

test('rays, spheres and sets at bodies that stand', () => {
    holding((hold) => {
        const { bodies, first, second } = makeBalls(hold);
        const index = hold(recordings.bodyIndex(bodies));
        const hit = index.cast(ray);
        assert.deepEqual([hit.status, hit.hit, hit.body, hit.bodySphere, hit.sphere], ['hit', true, first, 0, 0]);
        near(hit.fraction, 0.5);
        near(hit.safeFraction, 0.5 - 0.001 / 7);
        near(index.cast(ray, { contactOffset: 0.7 }).safeFraction, 0.4);
        near(hit.point[0], 3.5);
        near(hit.normal[0], -1);
        near(hit.surfaceVelocity[1], -1);
        near(hit.surfaceVelocity[2], 3);
        const thick = index.cast({ centre: [0, 0, 0], radius: 0.25, path: [6.5, 0, 0] });
        near(thick.fraction, 0.5);
        near(thick.centre[0], 3.25);
        assert.equal(index.cast(ray, { except: first }).body, second);
        const missed = index.cast(ray, { mask: 0 });
        assert.deepEqual([missed.status, missed.hit, missed.fraction, missed.body], ['miss', false, 1, null]);
        assert.deepEqual([missed.sphere, missed.bodySphere], [null, null]);
        const set = index.castSet([0, 2, 0, 0.25, 0, 0.75, 0, 0.25], { path: [8, 0, 0] }, { except: null });
        assert.deepEqual([set.hit, set.sphere, set.body], [true, 1, first]);
        near(set.fraction, 0.5);
        near(set.normal[1], 1);
        assert.equal(index.castSet([], { path: [8, 0, 0] }).status, 'miss');
    });
});

test('bodies go on as they move, and may be gone', () => {
    holding((hold) => {
        const { bodies } = makeBalls(hold);
        const index = hold(recordings.bodyIndex(bodies, 1));
        const waits = { centre: [4, 0, 2], radius: 0, path: [0, 0, 0] };
        const hit = index.cast(waits);
        near(hit.fraction, 0.5, 1e-4);
        near(hit.normal[2], 1, 1e-4);
        bodies.release();
        assert.deepEqual(index.cast(waits), hit);
        throwsCode('BAD_HANDLE', () => recordings.bodyIndex(bodies), /bodies/);
    });
});

test('casts that are none say so', () => {
    holding((hold) => {
        const { bodies } = makeBalls(hold);
        throwsCode('OUT_OF_RANGE', () => recordings.bodyIndex(bodies, -1), /seconds/);
        throwsCode('BAD_CALL', () => recordings.bodyIndex(bodies, '1'), /seconds must be a number/);
        throwsCode('BAD_HANDLE', () => recordings.bodyIndex({}), /not a list of bodies/);
        const index = hold(recordings.bodyIndex(bodies));
        assert.equal(index.cast({ ...ray, radius: -1 }).status, 'invalid');
        assert.equal(index.cast({ ...ray, path: [NaN, 0, 0] }).status, 'invalid');
        assert.equal(index.castSet([0, 0, 0, 1], { rotation: [0, 0, 0, 0] }).status, 'invalid');
        throwsCode('BAD_CALL', () => index.cast({ centre: [0, 0, 0], radius: 0 }), /path/);
        throwsCode('BAD_CALL', () => index.cast(ray, { except: 3 }), /BigInt/);
        throwsCode('BAD_CALL', () => index.cast(ray, { room: 1 }), /there is no room/);
        throwsCode('BAD_CALL', () => index.castSet([0, 0, 0], {}), /4 numbers for each/);
        throwsCode('BAD_CALL', () => index.castSet([0, 0, 0, 1]), /the motion must be an object/);
        throwsCode('TOO_LARGE', () => index.castSet(new Float64Array(4 * 4097), {}), /4096/);
        index.release();
        throwsCode('BAD_HANDLE', () => index.cast(ray), /body index/);
    });
});
