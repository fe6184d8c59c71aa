// SPDX-License-Identifier: MIT
// Projectiles: free flight, ricochets, through a slab, at a body; the array itself; what is refused.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Projectiles } from '../src/games.js';
import { games, inRoom, makeBall, near } from './game_helpers.js';
import { releasing, throwsCode } from './helpers.js';

const made = (...all) => {
    const shots = new Projectiles();
    for (const [position, velocity] of all) shots.add({ position, velocity });
    return shots;
};

test('they fly on the parabola, and stop at what they meet', () => {
    inRoom((room) => {
        const shots = made([[1, 4, 3], [8, 0, 0]], [[4, 4, 2], [0, 0, -100]], [[1, 1, 1.5], [50, 0, -2]]);
        shots.set(2, { user: 42 });
        const same = shots.copy();
        const begun = games.hashProjectiles(shots);
        assert.equal(games.hashProjectiles(same), begun);
        const report = games.fly(shots, room, 0.125);
        const [free, stopped] = [shots.get(0), shots.get(1)];
        near(free.position[0], 2, 1e-9);
        near(free.position[2], 3 - 9.81 / 128, 1e-9);
        assert.deepEqual([free.age, free.worldHash, free.state], [0.125, room.hash(), 'flying']);
        assert.deepEqual([stopped.state, stopped.velocity, shots.get(2).user], ['stopped', [0, 0, 0], 42]);
        assert.deepEqual([report.flying, report.impacts], [2, 1]);
        assert.equal(report.events.length, 1);
        const [event] = report.events;
        assert.deepEqual([event.kind, event.projectile, event.normal], ['stopped', 1, [0, 0, 1]]);
        assert.deepEqual([event.body, event.portal, event.lengths], [null, null, []]);
        assert.equal(room.face(event).normal[2], 1);
        near(event.time, 0.02, 1e-3);
        near(event.energy, 50, 0.5);
        near(event.impulse[2], -1, 0.01);
        // A copy goes the same way, to the bit, events told or not.
        assert.notEqual(games.hashProjectiles(shots), begun);
        assert.deepEqual(games.fly(same, room, 0.125, { events: false }).events, []);
        assert.equal(games.hashProjectiles(same), games.hashProjectiles(shots));
        assert.deepEqual(same.positions(), shots.positions());
    });
});

test('ricochets, ways through walls, bodies', () => {
    inRoom((room) => {
        const flat = made([[1, 1, 0.1], [50, 0, -2]]);
        const { events } = games.fly(flat, room, 0.125);
        assert.deepEqual(events.map((one) => one.kind), ['ricochet']);
        near(events[0].velocity[2], 0.4 * (2 * 2 + 2 * 9.81 * 0.1) ** 0.5, 0.01);

        const box = games.crater('box', 1);
        const { world } = room.carve(box, { position: [4, 4, 4] }, { fill: true });
        releasing([box, world, games.bodies(), makeBall()], (_, filled, bodies, ball) => {
            const shots = made([[1, 4, 4], [500, 0, 0]]);
            const through = games.fly(shots, filled, 1 / 128, { other: { resistance: 100 }, gravity: [0, 0, 0] });
            assert.deepEqual(through.events.map((one) => one.kind), ['entered', 'left']);
            const [, left] = through.events;
            near(left.thickness, 2, 1e-9);
            near(left.energy, 200, 1e-6);
            near(left.velocity[0], Math.sqrt(500 * 500 - (2 * 200) / 0.01), 1e-6);
            assert.equal(left.lengths.length, 1);
            assert.deepEqual([left.lengths[0].from, left.lengths[0].to], [0, 1]);
            // A matter of its own terms; what it leaves out is as `other` says.
            const terms = filled.matters().matters.map(() => ({ resistance: 1e4 }));
            const held = games.fly(made([[1, 4, 4], [500, 0, 0]]), filled, 1 / 128, { matters: terms });
            assert.deepEqual(held.events.map((one) => one.kind), ['entered', 'stopped']);
            near(held.events[1].thickness, 0.125, 1e-6);

            const id = bodies.add(ball, { position: [4, 1, 2] });
            const at = made([[1, 1, 2], [100, 0, 0]]);
            const met = games.fly(at, filled, 1 / 16, { bodies, ofBodies: { ricochetBelow: 0 } });
            assert.deepEqual([met.events[0].kind, met.events[0].body], ['stopped', id]);
            near(bodies.get(id).velocity[0], (0.01 * 100) / bodies.get(id).mass, 1e-6);
            assert.equal(games.fly(made([[1, 1, 2], [100, 0, 0]]), filled, 1 / 64).impacts, 0);
        });
    });
});

test('projectiles in a row', () => {
    const shots = new Projectiles();
    assert.equal(shots.count, 0);
    for (let k = 0; k < 40; ++k) assert.equal(shots.add({ position: [k, 2 * k, 0], user: k }), k);
    const plain = { position: [0, 0, 0], velocity: [0, 0, 0], mass: 0.01, age: 0, mask: 0xffffffff, user: 0, worldHash: 0n, state: 'flying' };
    assert.deepEqual(shots.get(0), plain);
    shots.set(7, { ...plain, mass: 2, age: 3, mask: 5, worldHash: 2n ** 63n, state: 'stopped' });
    assert.deepEqual(shots.get(7), { ...plain, mass: 2, age: 3, mask: 5, worldHash: 2n ** 63n, state: 'stopped' });
    const copy = new Projectiles(shots);
    shots.set(9, { state: 'expired' });
    assert.equal(shots.removeEnded(), 2);
    assert.deepEqual([shots.count, shots.get(7).user, shots.get(8).user, shots.get(37).user], [38, 8, 10, 39]);
    assert.deepEqual([copy.count, copy.get(9).state, copy.get(39).position], [40, 'flying', [39, 78, 0]]);
    assert.deepEqual(copy.positions().subarray(114, 120), Float64Array.of(38, 76, 0, 39, 78, 0));
    const out = new Float64Array(200);
    assert.equal(copy.positions(out), out);
    shots.clear();
    assert.equal(shots.count, 0);
    for (const index of [40, 41]) throwsCode('OUT_OF_RANGE', () => copy.get(index), /no projectile/);
    throwsCode('BAD_CALL', () => copy.get(-1), /index/);
    throwsCode('BAD_CALL', () => copy.get(0.5), /index/);
    const before = copy.get(3);
    throwsCode('BAD_CALL', () => copy.set(3, { position: [9, 9, 9], speed: 3 }), /there is no speed/);
    throwsCode('BAD_CALL', () => copy.set(3, { position: [9, 9, 9], state: 'gone' }), /state must be one of flying/);
    throwsCode('BAD_CALL', () => copy.set(3, { position: [9, 9, 9], velocity: [1] }), /velocity must have 3/);
    assert.deepEqual(copy.get(3), before);
    throwsCode('BAD_CALL', () => copy.add(), /must be an object/);
    throwsCode('BAD_CALL', () => new Projectiles([]), /Projectiles/);
    throwsCode('BAD_CALL', () => copy.positions([]), /Float64Array/);
});

test('what cannot fly says so, and nothing moves', () => {
    inRoom((room) => {
        const shots = made([[1, 1, 1], [1, 0, 0]], [[2, 2, 2], [1, 0, 0]]);
        const before = games.hashProjectiles(shots);
        const fly = (options, seconds = 0.1) => games.fly(shots, room, seconds, options);
        for (const seconds of [0, -1, 1.5, NaN]) throwsCode('OUT_OF_RANGE', () => fly({}, seconds), /seconds/);
        throwsCode('INVALID', () => fly({ maxImpacts: 0 }));
        throwsCode('INVALID', () => fly({ maxBow: -1 }));
        throwsCode('INVALID', () => fly({ other: { restitution: 2 } }));
        throwsCode('TOO_LARGE', () => fly({ gravity: [0, 0, -1e9] }));
        throwsCode('BAD_CALL', () => fly({ wind: [1, 0, 0] }), /there is no wind/);
        throwsCode('BAD_CALL', () => fly({ other: { bounce: 1 } }), /other: there is no bounce/);
        throwsCode('BAD_CALL', () => fly({ matters: {} }), /matters must be an array/);
        throwsCode('BAD_CALL', () => fly({ matters: [{}, { bounce: 1 }] }), /matters\[1\]: there is no bounce/);
        throwsCode('BAD_CALL', () => fly({ events: 1 }), /events must be true or false/);
        throwsCode('BAD_CALL', () => games.fly([], room, 0.1), /Projectiles/);
        throwsCode('BAD_CALL', () => games.hashProjectiles([]), /Projectiles/);
        throwsCode('BAD_HANDLE', () => games.fly(shots, shots, 0.1), /not a world/);
        throwsCode('BAD_HANDLE', () => fly({ bodies: room }), /bodies/);
        assert.equal(games.hashProjectiles(shots), before);
        shots.set(1, { velocity: [NaN, 0, 0] });
        throwsCode('OUT_OF_RANGE', () => fly({}), /projectile 1/);
        near(shots.get(0).position[0], 1, 0);
        assert.equal(games.fly(new Projectiles(), room, 0.1).flying, 0);
    });
});
