// SPDX-License-Identifier: MIT
// Casts: alone, any, all, in batches; what is near; numbers that are no good.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { HitBatch, NO_FACE } from '../src/index.js';
import { boxMesh, firma, releasing, throwsCode, withLevel } from './helpers.js';
import { randomCasts } from './scenario.js';

const castOf = (inputs, k) => ({
    centre: inputs.subarray(7 * k, 7 * k + 3),
    radius: inputs[7 * k + 3],
    path: Array.from(inputs.subarray(7 * k + 4, 7 * k + 7)),
});
const inBox = (mesh, work) => releasing([firma.worldFromMesh({ ...boxMesh(), ...mesh })], work);
const toWall = { centre: [4, 4, 4], radius: 1, path: [6, 0, 0] };

test('a hit has all that the C API says', () => {
    inBox({ materials: [0, 0, 0, 1, 0, 0], materialNames: ['a', 'b'] }, (world) => {
        const met = world.cast(toWall);
        const { safeFraction, face, corner, material, ...rest } = met;
        assert.deepEqual(rest, {
            status: 'hit',
            hit: true,
            fraction: 0.5,
            centre: [7, 4, 4],
            point: [8, 4, 4],
            normal: [-1, 0, 0],
            faceNormal: [-1, 0, 0],
            feature: 'face',
            featureIndex: 0,
            portal: null,
        });
        assert.deepEqual(
            corner.map((steps) => steps / 262144),
            Array.from(world.findFace(face).corners.subarray(0, 3)),
        );
        const info = world.hitInfo(met);
        const { source } = info;
        assert.deepEqual(info, {
            room: 0,
            source,
            sourceEdit: 0,
            mask: 0xffffffff,
            twoSided: false,
            solid: true,
            otherFace: null,
        });
        throwsCode('INVALID', () => world.hitInfo({ ...met, face: 100 }), /no such face/);
        throwsCode('INVALID', () => world.hitInfo({ ...met, portal: 0 }), /no such portal/);
        throwsCode('INVALID', () => world.hitInfo(world.cast({ ...toWall, path: [1, 0, 0] })), /a miss/);
        for (const wrong of [null, 5, {}, { ...met, feature: 'rim' }, { ...met, corner: [1, 2] }])
            throwsCode('BAD_CALL', () => world.hitInfo(wrong));
        assert.ok(safeFraction < 0.5 && safeFraction > 0.499);
        assert.equal(world.findFace(face).normal[0], -1);
        assert.equal(world.findFace(face).source, source);
        assert.equal(world.findFace(face).material, material);
        const miss = world.cast({ ...toWall, path: [1, 0, 0] });
        assert.equal(miss.status, 'miss');
        assert.equal(miss.face, null);
        assert.deepEqual([miss.hit, miss.fraction, miss.safeFraction, miss.centre], [false, 1, 1, [5, 4, 4]]);
        assert.equal(world.cast({ ...toWall, centre: [7.5, 4, 4] }).status, 'touching');
        assert.equal(world.cast({ ...toWall, path: [0, 0, 0] }).status, 'miss');
        assert.equal(world.cast({ centre: [4, 4, 4], radius: 0, path: [0, 0, -8] }).fraction, 0.5);
    });
});

test('hits one by one: filtered, shortened, ended', () => {
    inBox({}, (world) => {
        const through = { centre: [4, 4, 12], radius: 0.5, path: [0, 0, -16] };
        const both = { bothSides: true };
        const seen = [];
        assert.equal(world.castEach(through, (hit) => void seen.push(hit), both), true);
        assert.deepEqual(
            seen.sort((a, b) => a.fraction - b.fraction),
            world.castAll(through, both),
        );
        assert.equal(seen.length, 2);
        let nearest = 1;
        world.castEach(through, (hit) => (nearest = Math.min(nearest, hit.fraction)), both);
        assert.equal(nearest, seen[0].fraction);
        for (const enough of [false, 0, -1]) {
            let calls = 0;
            assert.equal(world.castEach(through, () => (++calls, enough), both), true);
            assert.equal(calls, 1);
        }
        assert.equal(world.castEach({ ...through, path: [0, 0, 16] }, () => assert.fail()), false);
        // A visitor may ask, too; what it throws is thrown, and the world goes on.
        world.castEach(through, (hit) => {
            assert.equal(world.cast(toWall).status, 'hit');
            assert.equal(world.castEach(toWall, () => true), true);
            assert.equal(world.faces().ids.length, 6);
            return hit.fraction;
        });
        let calls = 0;
        const wrong = new Error('of the visitor');
        assert.throws(() => world.castEach(through, () => { ++calls; throw wrong; }, both), (error) => error === wrong);
        assert.equal(calls, 1);
        assert.throws(() => world.castEach(through, () => 'x', both), { code: 'BAD_CALL' });
        assert.throws(() => world.castEach(through), { code: 'BAD_CALL' });
        assert.throws(() => world.castEach({ ...through, radius: -1 }, () => 1), { code: 'OUT_OF_RANGE' });
        assert.equal(world.cast(toWall).status, 'hit');

        const copy = world.copy();
        copy.castEach(through, (hit) => {
            if (!copy.released) copy.release();
            return hit.fraction;
        }, both);
        assert.equal(copy.released, true);

        const inCorner = [0.2, 0.2, 0.2];
        const found = [];
        assert.equal(world.overlapEach(inCorner, 0.5, (one) => void found.push(one)), true);
        assert.deepEqual(found.sort((a, b) => a.face - b.face), world.overlap(inCorner, 0.5));
        assert.equal(found.length, 3);
        let some = 0;
        world.overlapEach(inCorner, 0.5, () => ++some < 2);
        assert.equal(some, 2);
        assert.equal(world.overlapEach([4, 4, 4], 0.5, () => true), false);
        assert.throws(() => world.overlapEach([4, 4, NaN], 0.5, () => true), { code: 'OUT_OF_RANGE' });
    });
});

test('faces by filter and by hit; hashes', () => {
    inBox({}, (world) => {
        const all = world.faces();
        assert.deepEqual(world.faces({}).ids.sort(), all.ids);
        assert.deepEqual(world.faces({ room: 0 }).ids.sort(), all.ids);
        assert.equal(world.faces({ box: { low: [1, 1, -1], high: [2, 2, 1] } }).ids.length, 1);
        assert.equal(world.faces({ region: [0, 0, 0] }).ids.length, 6);
        assert.equal(world.faces({ region: [-1, 0, 0] }).ids.length, 0);
        assert.throws(() => world.faces({ room: 7 }), { code: 'INVALID' });
        assert.throws(() => world.faces({ room: 0, region: [0, 0, 0] }), { code: 'INVALID' });
        assert.throws(() => world.faces({ rooms: 0 }), { code: 'BAD_CALL' });
        assert.throws(() => world.faces({ region: [0.5, 0, 0] }), { code: 'BAD_CALL' });
        assert.throws(() => world.faces({ box: { low: [0, 0, 0], high: [0, 0, NaN] } }), { code: 'OUT_OF_RANGE' });

        const byId = (a, b) => a.id - b.id;
        const filters = [undefined, {}, { room: 0 }, { box: { low: [1, 1, -1], high: [2, 2, 1] } }, { region: [1, 0, 0] }];
        for (const filter of filters) {
            const shown = [];
            assert.equal(world.eachFace(filter, (one) => void shown.push(one)), true);
            const listed = world.faces(filter);
            assert.deepEqual(shown.map((one) => one.id).sort(), Array.from(listed.ids).sort());
            assert.deepEqual(shown.sort(byId), shown.map((one) => world.face(one)));
        }
        let calls = 0;
        assert.equal(world.eachFace({}, () => ++calls < 2), false);
        assert.equal(calls, 2);
        // A visitor may ask, too; what it throws is thrown, and the world goes on.
        assert.equal(world.eachFace({}, (one) => {
            assert.deepEqual(world.findFace(one.id), one);
            assert.equal(world.eachFace({ region: [0, 0, 0] }, () => false), false);
        }), true);
        const wrong = new Error('of the visitor');
        assert.throws(() => world.eachFace({}, () => { throw wrong; }), (error) => error === wrong);
        assert.throws(() => world.eachFace({ room: 7 }, () => true), { code: 'INVALID' });
        assert.throws(() => world.eachFace({ box: { low: [0, 0, 0], high: [0, 0, NaN] } }, () => true), { code: 'OUT_OF_RANGE' });
        assert.throws(() => world.eachFace({ rooms: 0 }, () => true), { code: 'BAD_CALL' });
        assert.throws(() => world.eachFace(() => true), { code: 'BAD_CALL' });
        const copy = world.copy();
        assert.equal(copy.eachFace({}, () => copy.released || copy.release()), true);

        const hit = world.cast(toWall);
        const face = world.face(hit);
        assert.deepEqual(face, world.findFace(hit.face));
        assert.deepEqual(face, world.face(face));
        assert.deepEqual(face, world.face({ face: hit.face, corner: hit.corner }));
        throwsCode('INVALID', () => world.face({ ...hit, corner: [1, 2, 3] }), /no such face/);
        throwsCode('INVALID', () => world.face(world.cast({ ...toWall, path: [-1e-3, 0, 0] })), /no such face/); // a miss
        assert.equal(world.findFace(1234), null); // a search
        assert.throws(() => world.face(), { code: 'BAD_CALL' });
        assert.throws(() => world.face({ id: 0 }), { code: 'BAD_CALL' });

        assert.equal(typeof world.hashSolid(), 'bigint');
        assert.equal(world.sameSolid(world), true);
        inBox({}, (other) => {
            assert.equal(world.sameSolid(other), true);
            assert.throws(() => world.sameSolid(other.hash()), { code: 'BAD_HANDLE' });
        });
        assert.throws(() => world.sameSolid(), { code: 'BAD_HANDLE' });
        const regions = world.hashRegions();
        assert.deepEqual(regions.map((one) => one.region), [[0, 0, 0]]);
        assert.ok(regions[0].faces !== 0n && regions[0].points !== 0n);
    });
});

test('options: mask, sides, contactOffset, counts', () => {
    inBox({ masks: [1, 2, 4, 8, 16, 32] }, (world) => {
        const wall = world.findFace(world.cast(toWall).face);
        assert.equal(world.cast(toWall, { mask: wall.mask }).status, 'hit');
        assert.equal(world.cast(toWall, { mask: ~wall.mask }).status, 'miss');
        assert.equal(world.cast(toWall, { mask: -1 }).status, 'hit');
        assert.equal(world.cast(toWall, { mask: 0 }).status, 'miss');
        assert.equal(world.cast(toWall, {}).status, 'hit');
        const fromRock = { centre: [12, 4, 4], radius: 1, path: [-6, 0, 0] };
        assert.notEqual(world.cast(fromRock).point[0], 8);
        assert.equal(world.cast(fromRock, { bothSides: true }).point[0], 8);
        assert.equal(world.cast(toWall, { contactOffset: 0.6 }).safeFraction, 0.4);
        assert.equal(world.cast(toWall, { contactOffset: 0 }).safeFraction, 0.5);
        const counts = { faces: 100 };
        world.cast(toWall, { counts });
        const once = { ...counts };
        assert.ok(once.faces > 100 && once.boxes > 0 && once.nodes > 0, JSON.stringify(once));
        assert.equal(typeof once.precise, 'number');
        world.castBatch([4, 4, 4, 1, 6, 0, 0], { counts });
        assert.equal(counts.faces - once.faces, once.faces - 100);
        for (const options of [
            { mask: 1.5 },
            { mask: 2 ** 32 },
            { mask: 'all' },
            { bothSides: 1 },
            { contactOffset: '1' },
            { counts: 5 },
            null,
            5,
        ])
            for (const ask of ['cast', 'castBatch'])
                throwsCode(
                    'BAD_CALL',
                    () => world[ask](ask === 'cast' ? toWall : [], options),
                    new RegExp(`^${ask}: `),
                );
        throwsCode('INVALID', () => world.cast(toWall, { contactOffset: NaN }), /contact offset/);
        throwsCode('INVALID', () => world.castBatch([], { contactOffset: Infinity }), /contact offset/);
    });
});

test('a batch answers what single casts answer, beyond one piece of it', () => {
    withLevel((world) => {
        const inputs = randomCasts(2500, world.facts(), 5);
        inputs[7 * 3] = NaN;
        inputs[7 * 1500 + 3] = -1;
        const batch = world.castBatch(inputs);
        assert.equal(batch.count, 2500);
        let met = 0;
        for (let k = 0; k < batch.count; ++k) {
            const one = world.cast(castOf(inputs, k));
            assert.deepEqual(batch.hit(k), one);
            assert.equal(batch.face[k], one.face ?? NO_FACE);
            if (one.status !== 'invalid') assert.equal(world.castAny(castOf(inputs, k)), one.face !== null);
            met += one.face !== null;
        }
        assert.ok(met > 300 && met < 2400, `${met} met something`);
        assert.equal(batch.hit(3).status, 'invalid');
        assert.equal(batch.hit(1500).status, 'invalid');
        for (const k of [-1, 2500, NaN, undefined]) assert.equal(batch.hit(k), null);
    });
});

test('a batch takes any numbers, and memory that it had', () => {
    withLevel((world) => {
        const inputs = randomCasts(50, world.facts(), 6).map(Math.fround);
        const expected = world.castBatch(inputs);
        const [fromFloats, fromArray] = [Float32Array.from(inputs), Array.from(inputs)].map((given) =>
            world.castBatch(given),
        );
        for (let k = 0; k < 50; ++k) {
            assert.deepEqual(fromFloats.hit(k), expected.hit(k));
            assert.deepEqual(fromArray.hit(k), expected.hit(k));
        }
        const out = new HitBatch();
        assert.equal(out.count, 0);
        assert.equal(out.hit(0), null);
        assert.equal(world.castBatch(inputs, {}, out), out);
        const { point } = out;
        world.castBatch(inputs.subarray(0, 70), {}, out);
        assert.equal(out.count, 10);
        assert.equal(out.point, point);
        assert.deepEqual(out.hit(9), expected.hit(9));
        assert.equal(out.hit(10), null);
        world.castBatch(randomCasts(51, world.facts(), 6), {}, out);
        assert.notEqual(out.point, point);
        assert.equal(world.castBatch([], undefined, out).count, 0);
        assert.equal(world.castBatch(new Float64Array(0)).count, 0);
        for (const wrong of [
            null,
            undefined,
            'x',
            { length: 7 },
            inputs.subarray(1),
            ['1', 2, 3, 4, 5, 6, 7],
            new DataView(new ArrayBuffer(56)),
        ])
            throwsCode('BAD_CALL', () => world.castBatch(wrong), /^castBatch: /);
        throwsCode('BAD_CALL', () => world.castBatch(inputs, {}, {}), /out/);
        world.castBatch(inputs, {}, out);
        throwsCode('INVALID', () => world.castBatch(inputs.subarray(0, 7), { contactOffset: NaN }, out));
        assert.deepEqual([out.count, out.hit(49)], [50, expected.hit(49)]);
    });
});

test('a batch that was refused leaves the answers of before', () => {
    const out = new HitBatch();
    const world = firma.worldFromMesh(boxMesh());
    const inputs = [4, 4, 4, 1, 6, 0, 0, 4, 4, 4, 1, 6, 0, 0];
    world.castBatch(inputs, {}, out);
    assert.equal(out.hit(1).status, 'hit');
    world.release();
    throwsCode('BAD_HANDLE', () => world.castBatch(inputs, {}, out));
    assert.equal(out.count, 2);
    assert.equal(out.hit(1).status, 'hit');
});

test('all that a cast meets, also when that is much', () => {
    withLevel((world) => {
        const through = { centre: [0, 20, 4], radius: 0.5, path: [90, 3, 1] };
        const all = world.castAll(through);
        assert.ok(all.length > 3);
        assert.deepEqual(all[0].face, world.cast(through).face);
        assert.ok(all.every((hit, k) => k === 0 || hit.fraction >= all[k - 1].fraction));
        assert.ok(world.castAll(through, { bothSides: true }).length > all.length);
        // More than there is room for at first.
        const wide = { centre: [-60, 20, 4], radius: 50, path: [200, 0, 0] };
        const many = world.castAll(wide, { bothSides: true });
        assert.ok(many.length > 4000, `${many.length}`);
        assert.equal(new Set(many.map((hit) => hit.face)).size, many.length);
        assert.deepEqual(world.castAll({ ...through, path: [0, 0, 0] }), []);
    });
});

test('overlap, closest, locate', () => {
    inBox({}, (world) => {
        assert.deepEqual(world.overlap([4, 4, 4], 3.9), []);
        const near = world.overlap([7, 4, 7], 1.5);
        assert.equal(near.length, 2);
        const [wall, ceiling] = near.sort((a, b) => b.point[0] - a.point[0]);
        assert.deepEqual(wall.point, [8, 4, 7]);
        assert.equal(wall.distance, 1);
        assert.deepEqual(ceiling.point, [7, 4, 8]);
        assert.deepEqual([wall.direction, wall.depth, ceiling.direction], [[-1, 0, 0], 0.5, [0, 0, -1]]);
        const [behind] = world.overlap([8.25, 4, 4], 0.5);
        assert.deepEqual([behind.direction, behind.depth], [[-1, 0, 0], 0.75], 'out of the solid');
        assert.deepEqual(world.overlap([7, 4, 7], 1.5, { mask: 0 }), []);
        assert.equal(world.overlap([7, 4, 7], 1.5, { room: 0 }).length, 2);
        throwsCode('INVALID', () => world.overlap([7, 4, 7], 1.5, { room: 1 }), /no room 1/);
        throwsCode('INVALID', () => world.overlapEach([7, 4, 7], 1.5, () => true, { room: 1 }), /no room 1/);
        throwsCode('INVALID', () => world.closest([7, 4, 7], 1, { room: 1 }), /no room 1/);
        assert.deepEqual(world.closest([4, 4, 1]).point, [4, 4, 0]);
        assert.equal(world.closest([4, 4, 1]).distance, 1);
        assert.equal(world.closest([4, 4, 1]).feature, 'face');
        assert.equal(world.closest([-1, -1, -1]).feature, 'vertex');
        assert.equal(world.closest([4, 4, 4], 3.9), null);
        assert.equal(world.closest([4, 4, 4], Infinity, { mask: 0 }), null);
        assert.deepEqual(world.locate([4, 4, 4]), { where: 'air', room: 0 });
        assert.deepEqual(world.locate([-4, 4, 4]), { where: 'solid', room: null });
        assert.deepEqual(world.locate([0, 4, 4]), { where: 'surface', room: null });
    });
    withLevel((world) => assert.equal(world.overlap([40, 20, 4], 200).length, world.facts().faceCount));
});

test('numbers that are no good, and what is no number', () => {
    inBox({}, (world) => {
        for (const bad of [NaN, Infinity, -Infinity]) {
            assert.equal(world.cast({ ...toWall, centre: [bad, 4, 4] }).status, 'invalid');
            assert.equal(world.cast({ ...toWall, path: [0, bad, 0] }).status, 'invalid');
            assert.equal(world.cast({ ...toWall, radius: bad }).status, 'invalid');
            for (const ask of ['castAny', 'castAll'])
                throwsCode('OUT_OF_RANGE', () => world[ask]({ ...toWall, radius: bad }));
            throwsCode('OUT_OF_RANGE', () => world.overlap([4, 4, bad], 1));
            throwsCode('OUT_OF_RANGE', () => world.overlap([4, 4, 4], bad));
            throwsCode('OUT_OF_RANGE', () => world.closest([4, bad, 4]));
            throwsCode('OUT_OF_RANGE', () => world.locate([bad, 4, 4]));
        }
        throwsCode('OUT_OF_RANGE', () => world.closest([4, 4, 4], -1));
        throwsCode('OUT_OF_RANGE', () => world.closest([4, 4, 4], NaN));
        const wrong = [
            undefined,
            null,
            5,
            {},
            { ...toWall, centre: [1, 2] },
            { ...toWall, centre: '123' },
            { ...toWall, radius: '1' },
        ];
        wrong.push(
            { ...toWall, path: [1, 2, null] },
            { centre: [4, 4, 4], radius: 1 },
            { ...toWall, path: [1n, 2, 3] },
        );
        for (const input of wrong)
            for (const ask of ['cast', 'castAny', 'castAll'])
                throwsCode('BAD_CALL', () => world[ask](input), new RegExp(`^${ask}: `));
        throwsCode('BAD_CALL', () => world.overlap([1, 2, 3]));
        throwsCode('BAD_CALL', () => world.overlap([1, 2], 3));
        throwsCode('BAD_CALL', () => world.closest());
        throwsCode('BAD_CALL', () => world.closest([1, 2, 3], '1'));
        throwsCode('BAD_CALL', () => world.closest([1, 2, 3], 1, { mask: 0.5 }));
        throwsCode('BAD_CALL', () => world.closest([1, 2, 3], 1, 5));
        throwsCode('BAD_CALL', () => world.cast(toWall, { passed: 5 }));
        throwsCode('BAD_CALL', () => world.locate([1, 2, '3']));
    });
});
