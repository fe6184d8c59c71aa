// SPDX-License-Identifier: MIT
// Capsules, boxes and hulls: made, cast, overlapped; where they touch; many casts at once.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { HitBatch, NO_FACE } from '../src/index.js';
import { boxMesh, firma, levelBytes, readers, releasing, throwsCode, withLevel } from './helpers.js';
import { randomCasts } from './scenario.js';

const inBox = (work) => releasing([firma.worldFromMesh(boxMesh()), firma.hullBox([0.5, 0.5, 0.5])], work);
const down = [0, 0, -8];
const pill = (z) => ({ from: [4, 4, z], to: [4, 4, z + 1], radius: 0.5 });

test('hulls have the corners that they need', () => {
    const pyramid = [0, 0, 1, 1, 1, -1, -1, 1, -1, -1, -1, -1, 1, -1, -1, 0, 0, 0];
    const made = [
        firma.hullFromPoints(pyramid),
        firma.hullFromPoints(Float32Array.from(pyramid)),
        firma.hullBox([1, 2, 3], [0, 1, 0, -1, 0, 0, 0, 0, 1]),
    ];
    releasing(made, (one, other, box) => {
        const corners = one.corners();
        assert.equal(corners.length, 15);
        assert.deepEqual(other.corners(), corners);
        assert.ok(!corners.subarray(3).some((x, k) => x === 0 && k % 3 === 2), 'the middle is no corner');
        assert.equal(box.corners().length, 24);
        assert.deepEqual(Array.from(box.corners().subarray(0, 3), Math.abs), [2, 1, 3]);
    });
    throwsCode('BAD_HANDLE', () => made[0].corners(), /hull/);
    throwsCode('INVALID', () => firma.hullFromPoints(pyramid.slice(0, 9)));
    throwsCode('INVALID', () => firma.hullBox([1, 1, 0]));
    throwsCode('TOO_LARGE', () => firma.hullFromPoints(new Float64Array(65 * 3)), /64/);
    throwsCode('OUT_OF_RANGE', () => firma.hullFromPoints([...pyramid, 0, NaN, 0]), /6/);
    for (const wrong of [undefined, [1, 2], 'abc', [1, 2, '3']]) {
        throwsCode('BAD_CALL', () => firma.hullFromPoints(wrong));
        throwsCode('BAD_CALL', () => firma.hullBox(wrong));
    }
    throwsCode('BAD_CALL', () => firma.hullBox([1, 1, 1], [1, 0, 0]), /9/);
});

test('a box and a capsule fall on the floor', () => {
    inBox((world, hull) => {
        const counts = {};
        const landed = world.cast({ hull, at: [4, 4, 2], path: down }, { counts });
        assert.deepEqual(
            [landed.status, landed.fraction, landed.centre, landed.normal, landed.feature],
            ['hit', 1.5 / 8, [4, 4, 0.5], [0, 0, 1], 'face'],
        );
        assert.ok(counts.faces > 0);
        const points = world.contactPoints(hull, landed);
        assert.equal(points.length, 4);
        for (const [x, y, z] of points) assert.deepEqual([Math.abs(x - 4), Math.abs(y - 4), z], [0.5, 0.5, 0]);
        const stood = world.cast({ ...pill(2), path: down });
        assert.deepEqual([stood.fraction, stood.centre, stood.point], [1.5 / 8, [4, 4, 1], [4, 4, 0]]);
        assert.equal(world.castAny({ ...pill(2), path: down }), true);
        assert.equal(world.castAny({ hull, at: [4, 4, 2], path: [0, 0, -1] }), false);
        const missed = world.cast({ hull, at: [4, 4, 2], path: [0, 0, -1] });
        assert.deepEqual([missed.hit, missed.centre, world.contactPoints(hull, missed)], [false, [4, 4, 1], []]);
        throwsCode('INVALID', () => world.contactPoints(hull, { ...landed, face: 99 }), /no such face/);
        throwsCode('INVALID', () => world.contactPoints(hull, { ...landed, portal: 9 }), /no such portal/);
        for (const wrong of [null, 5, {}, { ...landed, status: 'met' }])
            throwsCode('BAD_CALL', () => world.contactPoints(hull, wrong));
        throwsCode('BAD_HANDLE', () => world.contactPoints(world.copy, landed));
        const through = { bothSides: true };
        for (const shape of [{ hull, at: [4, 4, 10] }, pill(10)]) {
            const path = [0, 0, -12];
            const all = world.castAll({ ...shape, path }, through);
            assert.deepEqual(all.map((hit) => hit.fraction), [1.5 / 12, 9.5 / 12]);
            const seen = [];
            assert.ok(world.castEach({ ...shape, path }, (hit) => void seen.push(hit), through));
            assert.deepEqual(seen.sort((a, b) => a.fraction - b.fraction), all);
        }
    });
});

test('paths of more than a thousand kilometres, which go box by box, meet the same', () => {
    const LONGER = 2 ** 22;
    releasing([firma.hullBox([0.5, 0.3, 0.4], [0.8, 0.6, 0, -0.6, 0.8, 0, 0, 0, 1]), readers.worldFromObj(levelBytes)], (hull, world) => {
        const inputs = randomCasts(400, world.facts(), 9, 60);
        const shapes = [
            (centre) => ({ centre, radius: 0 }),
            (centre, radius) => ({ centre, radius }),
            (from, radius) => ({ from, to: from.map((value, axis) => value + [0.4, -0.3, 1][axis]), radius }),
            (at) => ({ hull, at }),
        ];
        for (const shape of shapes) {
            let met = 0;
            for (let at = 0; at < inputs.length; at += 7) {
                const mover = shape(Array.from(inputs.subarray(at, at + 3)), inputs[at + 3]);
                const path = Array.from(inputs.subarray(at + 4, at + 7));
                const near = world.cast({ ...mover, path });
                if (near.status !== 'hit') continue;
                const far = world.cast({ ...mover, path: path.map((along) => along * LONGER) });
                const { status, fraction, face, normal } = near;
                assert.deepEqual({ ...far, fraction: far.fraction * LONGER }, { ...far, status, fraction, face, normal });
                ++met;
            }
            assert.ok(met > 150, `${met} met something`);
        }
    });
});

test('a visitor may release the world and the hull that are cast', () => {
    const [world, hull] = [firma.worldFromMesh(boxMesh()), firma.hullBox([1, 1, 1])];
    let seen = 0;
    const release = () => {
        if (++seen > 1) return;
        world.release();
        hull.release();
    };
    world.castEach({ hull, at: [4, 4, 12], path: [0, 0, -16] }, release, { bothSides: true });
    assert.equal(seen, 2);
});

test('what a box and a capsule overlap, and the way out', () => {
    inBox((world, hull) => {
        const lain = { from: [0.375, 0.375, 0.25], to: [0.375, 0.375, 1.25], radius: 0.5 };
        for (const shape of [{ hull, at: [0.375, 0.375, 0.25] }, lain]) {
            const found = world.overlapShape(shape);
            assert.equal(found.length, 3);
            const depths = found.map((one) => one.depth).sort();
            [0.125, 0.125, 0.25].forEach((depth, k) => assert.ok(Math.abs(depths[k] - depth) < 1e-12));
            for (const { direction, depth } of found) assert.equal(direction[2] === 1, depth > 0.2);
            let shown = 0;
            assert.ok(world.overlapShapeEach(shape, () => ++shown < 2));
            assert.equal(shown, 2);
        }
        const ball = { centre: [0.3, 4, 4], radius: 0.5 };
        assert.deepEqual(world.overlapShape(ball), world.overlap(ball.centre, ball.radius));
        assert.equal(world.overlapShapeEach(pill(2), () => assert.fail()), false);
        throwsCode('OUT_OF_RANGE', () => world.overlapShape({ ...lain, radius: -1 }), /overlap.*radius/);
        throwsCode('INVALID', () => world.overlapShape(lain, { room: 4 }), /no room 4/);
        for (const wrong of [undefined, 5, {}, { ...lain, at: [1, 2, 3] }, { hull }, { from: [1, 2, 3], radius: 1 }])
            throwsCode('BAD_CALL', () => world.overlapShape(wrong));
        throwsCode('BAD_HANDLE', () => world.overlapShape({ hull: world, at: [0, 0, 0] }).length);
    });
});

test('bad shapes say what is wrong with them', () => {
    inBox((world, hull) => {
        assert.equal(world.cast({ hull, at: [NaN, 0, 0], path: down }).status, 'invalid');
        assert.equal(world.cast({ ...pill(2), radius: -1, path: down }).status, 'invalid');
        throwsCode('OUT_OF_RANGE', () => world.castAny({ hull, at: [4, 4, Infinity], path: down }), /castAny/);
        throwsCode('OUT_OF_RANGE', () => world.castAll({ ...pill(NaN), path: down }), /finite/);
        throwsCode('BAD_HANDLE', () => world.cast({ hull: 5, at: [0, 0, 0], path: down }), /not a hull/);
        throwsCode('BAD_CALL', () => world.cast({ hull, at: [0, 0, 0] }), /path/);
        throwsCode('BAD_CALL', () => world.cast({ hull, at: [0, 0, 0], path: down, radius: 1 }), /no radius/);
        throwsCode('BAD_CALL', () => world.cast({ ...pill(2), too: 1, path: down }), /no too/);
        const gone = firma.hullBox([1, 1, 1]);
        gone.release();
        throwsCode('BAD_HANDLE', () => world.cast({ hull: gone, at: [4, 4, 4], path: down }), /hull/);
    });
});

/** Columns of spheres, capsules or hulls that start where random spheres do, and cast k alone. */
function columnsOf(kind, world, count, hulls) {
    const inputs = randomCasts(count, world.facts(), 3);
    const names = ['x', 'y', 'z', 'radius', 'pathX', 'pathY', 'pathZ'];
    const columns = {};
    names.forEach((name, at) => (columns[name] = Float64Array.from({ length: count }, (_, k) => inputs[7 * k + at])));
    columns.pathY[count - 1] = NaN;
    if (kind === 'hull') {
        delete columns.radius;
        columns.hulls = hulls;
        columns.hullOf = Array.from({ length: count }, (_, k) => k % hulls.length);
    }
    if (kind === 'capsule')
        for (const [k, name] of ['toX', 'toY', 'toZ'].entries())
            columns[name] = Array.from(columns['xyz'[k]], (at) => at + 0.25 * (k + 1));
    const three = (all, k) => all.map((name) => columns[name][k]);
    const alone = (k) => {
        const path = three(['pathX', 'pathY', 'pathZ'], k);
        const start = three(['x', 'y', 'z'], k);
        if (kind === 'hull') return { hull: hulls[columns.hullOf[k]], at: start, path };
        if (kind === 'capsule') return { from: start, to: three(['toX', 'toY', 'toZ'], k), radius: columns.radius[k], path };
        return { centre: start, radius: columns.radius[k], path };
    };
    return { columns, alone };
}

test('many casts answer as one by one', () => {
    withLevel((world) => {
        const hulls = [firma.hullBox([0.3, 0.2, 0.8]), firma.hullBox([0.1, 0.1, 0.1])];
        releasing(hulls, () => {
            const count = 1500;
            for (const kind of ['sphere', 'capsule', 'hull']) {
                const { columns, alone } = columnsOf(kind, world, count, hulls);
                const one = {};
                const singles = Array.from({ length: count }, (_, k) => world.cast(alone(k), { counts: one }));
                assert.ok(singles.filter((hit) => hit.hit).length > count / 4, kind);
                assert.equal(singles[count - 1].status, 'invalid');
                const counts = {};
                const out = new HitBatch();
                assert.equal(world.castMany(columns, { counts }, out), out);
                assert.equal(out.count, count);
                singles.forEach((hit, k) => assert.deepEqual(out.hit(k), hit));
                assert.deepEqual(counts, one);
                const statuses = world.castManyAny(columns);
                const names = ['miss', 'hit', 'touching', 'invalid'];
                singles.forEach((hit, k) => {
                    if (names[statuses[k]] !== 'hit') assert.equal(names[statuses[k]], hit.status);
                    else assert.ok(hit.hit);
                });
            }
        });
    });
});

test('many casts are told of, and ended', () => {
    inBox((world) => {
        const count = 70_000;
        const columns = Object.fromEntries(
            ['x', 'y', 'z', 'pathX', 'pathY', 'pathZ'].map((name) => [name, new Float64Array(count).fill(4)]),
        );
        const told = [];
        const whole = world.castMany(columns, { progress: (done, all) => void told.push([done, all]) });
        assert.ok(told.length > 2 && told.every(([done, all], k) => all === count && done > (told[k - 1]?.[0] ?? 0)));
        assert.equal(told.at(-1)[0], count);
        assert.ok(whole.status.subarray(0, count).every((status) => status === 1));
        let done = 0;
        const part = world.castMany(columns, { progress: (so) => ((done = so), false) }, whole);
        assert.ok(done > 0 && done < count && part.count === count);
        assert.ok(part.status.subarray(0, done).every((status) => status === 1));
        assert.ok(part.status.subarray(done, count).every((status) => status === 3));
        assert.deepEqual([part.hit(done).status, part.hit(done).fraction, part.face[done]], ['invalid', 0, NO_FACE]);
        assert.ok(world.castManyAny(columns, { progress: () => false }).subarray(done, count).every((s) => s === 3));
    });
});

test('columns that do not fit say so', () => {
    inBox((world, hull) => {
        const one = { x: [4], y: [4], z: [4], pathX: [1], pathY: [0], pathZ: [0] };
        assert.equal(world.castMany(one).hit(0).status, 'miss');
        const none = Object.fromEntries(Object.keys(one).map((name) => [name, []]));
        assert.equal(world.castMany(none).count, 0);
        assert.equal(world.castManyAny(none).length, 0);
        const wrong = [
            [undefined, /object/],
            [{ ...one, pathY: undefined }, /pathY/],
            [{ ...one, pathY: [1, 2] }, /as many numbers as x: 1, not 2/],
            [{ ...one, toX: [1] }, /toY/],
            [{ ...one, hulls: [hull], radius: [1] }, /radius is of no use to a hull/],
            [{ ...one, hullOf: [0] }, /hullOf is of no use to a sphere/],
            [{ ...one, hulls: hull }, /array of hulls/],
            [{ ...one, radii: [1] }, /no radii/],
        ];
        for (const [casts, message] of wrong) throwsCode('BAD_CALL', () => world.castMany(casts), message);
        throwsCode('INVALID', () => world.castMany({ ...one, hulls: [hull], hullOf: [1] }), /cast 0 is of hull 1 of 1/);
        throwsCode('INVALID', () => world.castMany({ ...one, hulls: [] }), /cast 0 is of hull 0 of 0/);
        throwsCode('BAD_HANDLE', () => world.castMany({ ...one, hulls: [world.cast] }), /hull/);
        throwsCode('BAD_CALL', () => world.castMany(one, { progress: true }), /function/);
        throwsCode('BAD_CALL', () => world.castMany(one, {}, []), /HitBatch/);
    });
});
