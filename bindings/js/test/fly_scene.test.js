// SPDX-License-Identifier: MIT
// Projectiles among parts that move: the wall that comes, as in the C tests; without parts as fly().
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Projectiles } from '../src/recordings.js';
import { throwsCode } from './helpers.js';
import { boxWorld, holding, makeLowRoom, recordings } from './recording_helpers.js';

const step = 1 / 64;
const near = (actual, expected, error = 1e-9) =>
    assert.ok(Math.abs(actual - expected) <= error, `${actual} is not ${expected} to ${error}`);
const shot = (position, velocity) => {
    const shots = new Projectiles();
    shots.add({ position, velocity });
    return shots;
};
const bits = (shots) => recordings.hashProjectiles(shots);

/** The low room, and a wall of 0.5 m that comes at 20 m/s and goes up at 60. */
function makeScene(hold) {
    const world = hold(makeLowRoom());
    const parts = hold(recordings.parts());
    const motion = { position: [4, 4, 1.5], path: [-20 * step, 0, 60 * step] };
    parts.add({ world: hold(boxWorld([0, -1, -1], [0.5, 1, 1], true)), motion });
    return { world, parts, motion };
}

test('a shot into a wall that comes stays in it, and goes along', () => {
    holding((hold) => {
        const { world, parts, motion } = makeScene(hold);
        const shots = shot([2, 4, 2], [220, 0, 0]); // the wall sees (240, 0, -60): 306 J
        const options = { gravity: [0, 0, 0], other: { resistance: 1000 } };
        const { impacts, flying, events } = recordings.flyScene(shots, { world, parts }, step, options);
        assert.deepEqual([impacts, flying], [1, 0]);
        assert.deepEqual(events.map(({ kind, part }) => [kind, part]), [['entered', 0], ['stopped', 0]]);
        const [, stopped] = events;
        near(stopped.time, 2 / 240);
        near(stopped.energy, 306, 1e-6);
        near(stopped.thickness, 0.306);
        near(stopped.inPart[0], (0.306 * 240) / Math.hypot(240, 60));
        // Of the whole way through the wall, of which it got so far.
        assert.deepEqual([stopped.lengths.length, stopped.lengths[0].from], [1, 0]);
        near(stopped.lengths[0].to, 0.306 / ((0.5 * Math.hypot(240, 60)) / 240));
        const { state, velocity, position } = shots.get(0);
        assert.equal(state, 'stopped');
        near(velocity[0], -20);
        position.forEach((at, axis) => near(at, motion.position[axis] + motion.path[axis] + stopped.inPart[axis]));
    });
});

test('without parts as fly(), to the bit', () => {
    holding((hold) => {
        const { world } = makeScene(hold);
        const [one, other, third] = [0, 1, 2].map(() => shot([2, 4, 1], [150, 0, -90]));
        const report = recordings.flyScene(one, { world }, step);
        assert.ok(report.events.length > 0);
        assert.deepEqual(report.events.map(({ part, inPart }) => [part, inPart]), report.events.map(() => [null, [0, 0, 0]]));
        const plain = recordings.fly(other, world, step);
        assert.equal(bits(one), bits(other));
        const events = report.events.map(({ part, inPart, ...event }) => event);
        assert.deepEqual({ ...report, events }, plain);
        assert.deepEqual(recordings.flyScene(third, world, step, { events: false }), { ...plain, events: [] });
    });
});

test('what cannot fly says so, and nothing moves', () => {
    holding((hold) => {
        const { world, parts, motion } = makeScene(hold);
        const shots = shot([2, 4, 2], [220, 0, 0]);
        const before = bits(shots);
        const fly = (scene, seconds = step, options = {}) => recordings.flyScene(shots, scene, seconds, options);
        throwsCode('OUT_OF_RANGE', () => fly({ world, parts, to: 2 }), /stretch/);
        throwsCode('OUT_OF_RANGE', () => fly({ world, parts }, 0), /seconds/);
        parts.setMotions([{ ...motion, path: [0, 1e30, 0] }]);
        throwsCode('INVALID', () => fly({ world, parts }), /part 0/);
        throwsCode('BAD_CALL', () => fly(undefined), /flyScene: the scene/);
        throwsCode('BAD_CALL', () => fly({ world, part: 0 }), /there is no part/);
        throwsCode('BAD_CALL', () => fly({ world }, step, { wind: 1 }), /flyScene: the options: there is no wind/);
        throwsCode('BAD_CALL', () => recordings.flyScene([], { world }, step), /Projectiles/);
        throwsCode('BAD_HANDLE', () => fly({ world, parts: world }), /parts/);
        assert.equal(bits(shots), before);
    });
});

test('a rule is asked for each matter, and taken over the tables', () => {
    holding((hold) => {
        const { world, parts } = makeScene(hold);
        const fixed = { gravity: [0, 0, 0] };
        const byTable = shot([2, 4, 2], [220, 0, 0]);
        recordings.flyScene(byTable, { world, parts }, step, { ...fixed, other: { resistance: 1000 } });
        const byRule = shot([2, 4, 2], [220, 0, 0]);
        const asked = [];
        const rule = (impact, matter, usual) => {
            asked.push({ impact, matter, usual });
            return { resistance: 1000 };
        };
        recordings.flyScene(byRule, { world, parts }, step, { ...fixed, rule });
        assert.equal(bits(byRule), bits(byTable));
        const [{ impact, matter, usual }] = asked;
        assert.deepEqual([impact.part, impact.projectile, impact.mass, impact.body, impact.pane], [0, 0, 0.01, null, false]);
        assert.deepEqual([impact.velocity, impact.normal, typeof impact.face], [[220, 0, 0], [-1, 0, 0], 'number']);
        near(impact.surface[0], -20);
        near(impact.surface[2], 60);
        assert.equal(typeof matter, 'number');
        assert.deepEqual([usual.friction, usual.ricochetBelow], [0.3, 0.25]);
        // What is not said is as usual; nothing said is all as usual.
        const silent = shot([2, 4, 2], [220, 0, 0]);
        recordings.flyScene(silent, { world, parts }, step, { ...fixed, other: { resistance: 1000 }, rule: () => undefined });
        assert.equal(bits(silent), bits(byTable));
        // A body: with the terms of bodies.
        const bodies = hold(recordings.bodies());
        const id = bodies.add(hold(recordings.bodyShape([0, 0, 0, 0.5], recordings.massOfBall(0.5, 100))), { position: [6, 4, 2] });
        const atBody = shot([7.5, 4, 2], [-300, 0, 0]);
        let seen;
        const noting = (one, of, terms) => void (seen = [one.body, of, terms.friction]);
        recordings.flyScene(atBody, world, step, { ...fixed, bodies, ofBodies: { friction: 0.125 }, rule: noting });
        assert.deepEqual(seen, [id, 0, 0.125]);
    });
});

test('what a rule throws is thrown, and projectiles stay', () => {
    holding((hold) => {
        const { world, parts } = makeScene(hold);
        const shots = shot([2, 4, 2], [220, 0, 0]);
        const before = bits(shots);
        const fly = (rule) => recordings.flyScene(shots, { world, parts }, step, { rule });
        assert.throws(() => fly(() => { throw new RangeError('no'); }), RangeError);
        throwsCode('BAD_CALL', () => fly(() => ({ resistance: '1' })), /resistance must be a number/);
        throwsCode('BAD_CALL', () => fly(() => ({ weight: 1 })), /there is no weight/);
        throwsCode('BAD_CALL', () => fly(5), /the rule must be a function/);
        assert.equal(bits(shots), before);
        // Out of range it stops; the module goes on.
        fly(() => ({ restitution: 2 }));
        assert.equal(shots.get(0).state, 'stopped');
        throwsCode('BAD_CALL', () => recordings.fly(shots, world, step, { rule: () => undefined }), /there is no rule/);
    });
});
