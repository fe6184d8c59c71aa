// SPDX-License-Identifier: MIT
// Bodies: shapes, steps, names of bodies, snapshots, chunks, parts that carry them; what is refused.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { games, inRoom, makeBall, makeRoom, makeSlab, near, TICK } from './game_helpers.js';
import { boxMesh, releasing, throwsCode } from './helpers.js';

const at = (x, y, z) => ({ position: [x, y, z] });
/** work(room, bodies, ball's shape) */
const withBodies = (work) => releasing([makeRoom(), games.bodies(), makeBall()], work);
function step(bodies, scene, ticks) {
    let report;
    for (let k = 0; k < ticks; ++k) report = bodies.step(scene, TICK);
    return report;
}

test('masses of balls and boxes', () => {
    const box = games.massOfBox([1, 0.5, 0.25], 1000);
    assert.deepEqual([box.volume, box.mass, box.centre], [1, 1000, [0, 0, 0]]);
    near(box.inertia[0], (1000 * (0.25 + 0.0625)) / 3, 1e-9);
    assert.deepEqual([box.inertia.length, box.inertia[1]], [9, 0]);
    near(games.massOfBall(0.5, 600).mass, 314.159265358979, 1e-9);
    throwsCode('OUT_OF_RANGE', () => games.massOfBall(0, 1000), /radius/);
    throwsCode('OUT_OF_RANGE', () => games.massOfBall(1, NaN), /density/);
    throwsCode('OUT_OF_RANGE', () => games.massOfBox([1, 0, 1], 1000), /side/);
    throwsCode('BAD_CALL', () => games.massOfBall('1', 1000), /radius must be a number/);
    throwsCode('BAD_CALL', () => games.massOfBox([1, 1], 1000), /half must have 3 numbers/);
});

test('shapes that are none are refused', () => {
    const mass = games.massOfBall(0.5, 1000);
    throwsCode('INVALID', () => games.bodyShape([], mass));
    throwsCode('INVALID', () => games.bodyShape([0, 0, 0, -1], mass));
    throwsCode('INVALID', () => games.bodyShape([0, NaN, 0, 1], mass));
    throwsCode('INVALID', () => games.bodyShape([0, 0, 0, 1], { ...mass, mass: 0 }));
    throwsCode('INVALID', () => games.bodyShape(new Float64Array(4 * 4097).fill(1), mass));
    throwsCode('BAD_CALL', () => games.bodyShape([0, 0, 0], mass), /4 numbers for each/);
    throwsCode('BAD_CALL', () => games.bodyShape([0, 0, 0, 1]), /the mass must be an object/);
    throwsCode('BAD_CALL', () => games.bodyShape([0, 0, 0, 1], { ...mass, weight: 1 }), /there is no weight/);
    throwsCode('BAD_CALL', () => games.bodyShape([0, 0, 0, 1], { ...mass, inertia: [1, 2, 3] }), /inertia.*9/);
    throwsCode('BAD_CALL', () => games.bodyShape([0, 0, 0, 1], { ...mass, centre: undefined }), /centre/);
});

test('balls fall, touch, come to rest and sleep', () => {
    withBodies((room, bodies, ball) => {
        const [a, b] = [bodies.add(ball, at(4, 4, 3)), bodies.add(ball, at(2, 4, 0.75))];
        assert.equal(typeof a, 'bigint');
        assert.deepEqual([bodies.count(), bodies.list()], [2, [a, b]]);
        const begun = bodies.get(a);
        assert.deepEqual([begun.position, begun.rotation, begun.velocity], [[4, 4, 3], [0, 0, 0, 1], [0, 0, 0]]);
        assert.deepEqual([begun.friction, begun.restitution, begun.rolling, begun.mask], [0.6, 0.1, 0.02, 0xffffffff]);
        near(begun.mass, (1000 * Math.PI) / 6, 1e-9);
        const first = bodies.step(room, TICK);
        assert.deepEqual([first.awake, first.stuck, first.crushed], [2, 0, 0]);
        // On Newton's parabola, to rounding.
        near(bodies.get(a).position[2], 3 - (9.81 * TICK * TICK) / 2, 1e-12);
        near(bodies.get(a).velocity[2], -9.81 * TICK, 1e-12);
        assert.equal(step(bodies, room, 250).awake, 0);
        const rested = bodies.get(a);
        assert.equal(rested.asleep, true);
        near(rested.position[2], 0.5, 0.0011);
        const contacts = bodies.contacts();
        assert.equal(contacts.length, 2);
        const [one] = contacts;
        assert.deepEqual([one.body, one.other, one.part, one.portal], [a, null, null, null]);
        assert.ok(one.normal[2] > 0.999 && typeof one.face === 'number' && one.corner.length === 3);
        assert.equal(room.face(one).normal[2], 1);
        near(one.force, rested.mass * 9.81, rested.mass * 0.5);

        bodies.push(a, [200, 0, 0], rested.position);
        assert.equal(bodies.get(a).asleep, false);
        near(bodies.get(a).velocity[0], 200 / rested.mass, 1e-12);
        bodies.set(b, { velocity: [0, 0, 3], mask: 6 });
        assert.deepEqual([bodies.get(b).velocity, bodies.get(b).mask], [[0, 0, 3], 6]);
        assert.deepEqual(bodies.get(b).position[0], 2);
        bodies.set(a, bodies.get(a)); // all of it comes back
        bodies.remove(a);
        assert.deepEqual([bodies.count(), bodies.list()], [1, [b]]);
        for (const call of ['get', 'pose', 'wake', 'remove']) throwsCode('INVALID', () => bodies[call](a), /no such body/);
        // Its place is used again, its name is not.
        const c = bodies.add(ball, at(6, 6, 3));
        assert.notEqual(c, a);
        throwsCode('INVALID', () => bodies.get(a), /no such body/);
    });
});

test('poses of all go into one array', () => {
    withBodies((room, bodies, ball) => {
        assert.equal(bodies.poses().length, 0);
        const ids = [1, 2, 3].map((x) => bodies.add(ball, { position: [x, 4, 4], rotation: [0, 0, 1, 1] }));
        bodies.remove(ids[1]);
        step(bodies, room, 8);
        const poses = bodies.poses();
        assert.equal(poses.length, 14);
        bodies.list().forEach((id, k) => {
            const { position, rotation, scale } = bodies.pose(id);
            assert.equal(scale, 1);
            assert.deepEqual(Array.from(poses.subarray(7 * k, 7 * k + 7)), [...position, ...rotation]);
        });
        const longer = new Float64Array(20).fill(-1);
        assert.equal(bodies.poses(longer), longer);
        assert.deepEqual(longer.subarray(0, 14), poses);
        assert.ok(longer.subarray(14).every((x) => x === -1));
        assert.equal(bodies.poses(new Float64Array(13)).length, 14);
        throwsCode('BAD_CALL', () => bodies.poses([]), /Float64Array/);
    });
});

test('a copy goes the same way, to the bit', () => {
    withBodies((room, bodies, ball) => {
        for (let k = 0; k < 8; ++k) bodies.set(bodies.add(ball, at(1 + 0.8 * k, 4, 1 + k / 2)), { spin: [k, 1, 2] });
        step(bodies, room, 20);
        releasing([bodies.copy()], (copy) => {
            assert.equal(copy.hash(), bodies.hash());
            step(bodies, room, 100);
            assert.notEqual(copy.hash(), bodies.hash());
            step(copy, { world: room }, 100);
            assert.equal(copy.hash(), bodies.hash());
            assert.deepEqual(copy.poses(), bodies.poses());
        });
    });
});

test('a chunk becomes a body and falls', () => {
    const ceiling = boxMesh([0, 0, 0], [8, 8, 8]);
    releasing([games.worldFromMesh(ceiling), games.bodies()], (room, bodies) => {
        // A pillar from floor to ceiling, cut through: nothing holds its middle.
        const box = games.crater('box', 1);
        const pillar = room.carve(box, { position: [4, 4, 4], scale: 1 }, { fill: true });
        const column = [2, 6].reduce(
            (world, z) => {
                const { world: next } = world.carve(box, { position: [4, 4, z] }, { fill: true });
                world.release();
                return next;
            },
            pillar.world,
        );
        const above = column.carve(box, { position: [4, 4, 7.4] }, { fill: true });
        column.release();
        const low = above.world.carve(box, { position: [4, 4, 1.4] }, { chunks: true });
        const cut = low.world.carve(box, { position: [4, 4, 6.9] }, { chunks: true });
        releasing([box, above.world, low.world, cut.world, low.report.loose, cut.report.loose].filter(Boolean), () => {
            const loose = cut.report.loose ?? low.report.loose;
            assert.ok(loose, 'nothing came loose');
            const [chunk] = loose.list();
            const id = bodies.addChunk(loose, 0, { maxSpheres: 20, maxError: 0.3 });
            near(bodies.get(id).mass, chunk.mass, 1e-6);
            const from = bodies.pose(id);
            assert.deepEqual(from.position, chunk.origin);
            step(bodies, cut.world, 128);
            assert.ok(bodies.pose(id).position[2] < from.position[2] - 0.3);
            assert.equal(bodies.get(id).stuck, false);
            throwsCode('OUT_OF_RANGE', () => bodies.addChunk(loose, 1), /no such chunk/);
            throwsCode('INVALID', () => bodies.addChunk(loose, 0, { maxSpheres: 5000 }));
            throwsCode('BAD_CALL', () => bodies.addChunk(loose, 0, { spheres: 5 }), /there is no spheres/);
            throwsCode('BAD_CALL', () => bodies.addChunk(loose, -1), /chunk/);
            throwsCode('BAD_HANDLE', () => bodies.addChunk(room, 0), /chunks/);
        });
    });
});

test('a lift carries a ball, and crushes one', () => {
    withBodies((room, bodies, ball) => {
        releasing([games.parts(), makeSlab(1, 1, 0.5)], (parts, slab) => {
            parts.add({ world: slab, motion: { position: [4, 4, 0.5] } });
            const id = bodies.add(ball, at(4, 4, 1.5));
            for (let k = 0; k < 64; ++k) {
                parts.setMotions([{ position: [4, 4, 0.5 + k * TICK], path: [0, 0, TICK] }]);
                assert.equal(bodies.step({ world: room, parts }, TICK).crushed, 0);
            }
            near(bodies.get(id).position[2], 2.5, 0.01);
            assert.deepEqual([bodies.contacts().length, bodies.contacts()[0].part], [1, 0]);
            bodies.set(id, { position: [4, 4, 0.5] });
            let crushed = 0;
            for (let k = 0; k < 64; ++k) {
                parts.setMotions([{ position: [4, 4, 1.75 - k * TICK], path: [0, 0, -TICK] }]);
                const report = bodies.step({ world: room, parts }, TICK);
                assert.equal(bodies.get(id).crushed, report.crushed === 1);
                crushed += report.crushed;
            }
            assert.ok(crushed > 0);
        });
    });
});

test('what cannot be a step, a body or a name says so', () => {
    withBodies((room, bodies, ball) => {
        const id = bodies.add(ball, at(4, 4, 3));
        const before = bodies.hash();
        for (const seconds of [0, -1, NaN, Infinity]) throwsCode('OUT_OF_RANGE', () => bodies.step(room, seconds), /seconds/);
        for (const options of [
            { substepsASecond: 0 },
            { substepsASecond: 10001 },
            { maxBounces: 1001 },
            { gravity: [0, NaN, 0] },
            { contactFriction: -1 },
            { contactOffset: Infinity },
            { sleepSpeed: NaN },
            { sleepAfter: -1 },
        ])
            throwsCode('OUT_OF_RANGE', () => bodies.step(room, TICK, options), /option/);
        throwsCode('BAD_CALL', () => bodies.step(room, TICK, { gravity: -9.81 }), /gravity must be an array/);
        throwsCode('BAD_CALL', () => bodies.step(room, TICK, { substeps: 4 }), /there is no substeps/);
        throwsCode('BAD_CALL', () => bodies.step(room, '1'), /seconds must be a number/);
        throwsCode('BAD_CALL', () => bodies.step(undefined, TICK), /scene/);
        throwsCode('BAD_CALL', () => bodies.step({ world: room, part: 1 }, TICK), /there is no part,/);
        throwsCode('BAD_HANDLE', () => bodies.step({}, TICK), /not a world/);
        throwsCode('BAD_HANDLE', () => bodies.step(bodies, TICK));
        throwsCode('BAD_HANDLE', () => bodies.step({ world: room, parts: room }, TICK), /parts/);
        throwsCode('OUT_OF_RANGE', () => bodies.step({ world: room, from: 0.5, to: 0.25 }, TICK), /stretch/);
        for (const body of [
            { position: [0, Infinity, 0] },
            { rotation: [0, 0, 0, 0] },
            { velocity: [NaN, 0, 0] },
            { friction: -1 },
            { restitution: 2 },
            { rolling: NaN },
        ])
            throwsCode('OUT_OF_RANGE', () => bodies.set(id, body), /number of the body/);
        throwsCode('BAD_CALL', () => bodies.set(id, { speed: [1, 0, 0] }), /there is no speed/);
        throwsCode('BAD_CALL', () => bodies.set(id, { rotation: [0, 0, 0] }), /rotation must have 4/);
        throwsCode('BAD_CALL', () => bodies.set(id), /must be an object/);
        throwsCode('OUT_OF_RANGE', () => bodies.add(ball, at(NaN, 0, 0)), /pose/);
        throwsCode('OUT_OF_RANGE', () => bodies.add(ball, { position: [1, 1, 1], rotation: [0, 0, 0, 0] }), /rotation/);
        throwsCode('BAD_HANDLE', () => bodies.add(room, at(1, 1, 1)), /shape/);
        throwsCode('OUT_OF_RANGE', () => bodies.push(id, [NaN, 0, 0], [0, 0, 0]), /impulse/);
        for (const wrong of [undefined, 0, '0', -1n, 2n ** 64n, { slot: 0 }])
            throwsCode('BAD_CALL', () => bodies.get(wrong), /BigInt/);
        throwsCode('INVALID', () => bodies.get(77n), /no such body/);
        assert.equal(bodies.hash(), before);
        // Without gravity it stays.
        bodies.step(room, TICK, { gravity: [0, 0, 0], sleepAfter: Infinity });
        assert.equal(bodies.get(id).position[2], 3);
    });
});

test('no body goes through a wall, at any speed', () => {
    inRoom((room) => {
        releasing([games.bodies(), makeBall(0.25)], (bodies, ball) => {
            for (let k = 0; k < 20; ++k) {
                const id = bodies.add(ball, at(1 + 0.3 * k, 1 + 0.3 * k, 4));
                bodies.set(id, { velocity: [k * 53 - 500, 700 - 61 * k, k * 17 - 100], spin: [k, -k, 9] });
            }
            for (let k = 0; k < 120; ++k) {
                bodies.step(room, 1 / 30);
                for (const id of bodies.list()) {
                    const { position, stuck } = bodies.get(id);
                    assert.equal(stuck, false);
                    for (const x of position) assert.ok(x > 0.2489 && x < 7.7511, `${position}`);
                }
            }
        });
    });
});
