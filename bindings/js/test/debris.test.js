// SPDX-License-Identifier: MIT
// Fractures, debris that breaks, blasts, rubble that becomes ground; what is refused. The scenes are those of the C tests.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { throwsCode } from './helpers.js';
import { boxCutter, boxWorld, holding, makeLowRoom, recordings } from './recording_helpers.js';

const here = { position: [0, 0, 0] };
const lumps = (size) => ({ style: 'lumps', sizeOfPiece: [size, size, size], growth: 1, crooked: 0.5 });
const near = (actual, expected, error) =>
    assert.ok(Math.abs(actual - expected) <= error, `${actual} is not ${expected} to ${error}`);

/** A column that hangs from the ceiling, cut through: what was below, and the world without it. */
function fallenColumn(hold, room) {
    const hung = hold(boxCutter([3, 3, 1], [4, 4, 5]));
    const cut = hold(boxCutter([2.5, 2.5, 2.25], [4.5, 4.5, 2.75]));
    const filled = hold(room.carve(hung, here, { fill: true }).world);
    const { world, report } = filled.carve(cut, here, { chunks: { density: 2000 } });
    return { world: hold(world), chunks: hold(report.loose) };
}

const massOfAll = (bodies) => bodies.list().reduce((sum, id) => sum + bodies.get(id).mass, 0);

test('a solid breaks into pieces that fill it', () => {
    holding((hold) => {
        const room = hold(makeLowRoom());
        const told = recordings.fracturePattern(room, 0);
        assert.equal(told.style, 'lumps');
        assert.ok(told.sizeOfPiece.every((size) => size > 0));
        assert.deepEqual([told.axes, told.brickCorner], [null, null]);
        const { chunks } = fallenColumn(hold, room);
        const solid = hold(chunks.world(0));
        const options = { maxPieces: 8, density: 1000, impact: [0, 0, 0] };
        const pieces = hold(recordings.fracture(solid, lumps(0.3), options)).list();
        assert.equal(pieces.length, 8);
        near(pieces.reduce((sum, { volume }) => sum + volume, 0), 1.25, 1e-12);
        near(pieces.reduce((sum, { mass }) => sum + mass, 0), 1250, 1e-9);
        for (const piece of pieces) {
            assert.deepEqual([piece.origin, piece.matters], [[0, 0, 0], []]);
            assert.ok(piece.faceCount >= 4);
        }
        // What is told may be given; bricks lie where they are said to.
        hold(recordings.fracture(solid, told, options));
        const bricks = { style: 'bricks', sizeOfPiece: [0.5, 0.5, 0.25], axes: [0, 0, 0, 1], brickCorner: [-0.5, -0.5, -0.625] };
        const rows = hold(recordings.fracture(solid, bricks, { maxPieces: 64 })).list();
        assert.ok(rows.length > 4, `${rows.length} bricks`);
        for (const { volume, low, high } of rows) {
            const size = high.map((x, axis) => x - low[axis]);
            near(volume, size[0] * size[1] * size[2], 1e-4); // a box, along these axes
            assert.ok(size[2] < 0.5);
        }

        throwsCode('INVALID', () => recordings.fracturePattern(room, 99), /no such matter/);
        throwsCode('BAD_CALL', () => recordings.fracturePattern(room, -1), /fracturePattern: the matter/);
        throwsCode('INVALID', () => recordings.fracture(room, lumps(0.3)), /rock/);
        throwsCode('INVALID', () => recordings.fracture(solid, lumps(0)));
        throwsCode('INVALID', () => recordings.fracture(solid, lumps(0.3), { maxPieces: 5000 }), /pieces/);
        throwsCode('INVALID', () => recordings.fracture(solid, { ...lumps(0.3), axes: [0, 0, 0, 0] }), /axes/);
        throwsCode('BAD_CALL', () => recordings.fracture(solid), /fracture: the pattern must be an object/);
        throwsCode('BAD_CALL', () => recordings.fracture(solid, { style: 'lumps' }), /sizeOfPiece/);
        throwsCode('BAD_CALL', () => recordings.fracture(solid, { ...lumps(1), style: 'cubes' }), /style must be one of lumps, bricks, shards/);
        throwsCode('BAD_CALL', () => recordings.fracture(solid, lumps(1), { pieces: 4 }), /there is no pieces/);
        throwsCode('BAD_CALL', () => recordings.fracture(solid, lumps(1), { seed: -1 }), /seed/);
        throwsCode('BAD_HANDLE', () => recordings.fracture({}, lumps(1)), /not a world/);
    });
});

test('a body shatters, and so does its copy', () => {
    holding((hold) => {
        const { world, chunks } = fallenColumn(hold, hold(makeLowRoom()));
        const bodies = hold(recordings.bodies());
        const debris = hold(recordings.debris());
        const id = debris.addChunk(bodies, chunks, 0);
        const whole = debris.get(bodies, id);
        assert.ok(whole.faceCount >= 6);
        assert.deepEqual([whole.broken, whole.ofPart, whole.neverGround, whole.age], [0, false, false, 0]);
        near(whole.origin[2], 1.625, 1e-3);
        near(hold(debris.world(bodies, id)).mass(2000).mass, 2500, 1e-9);

        const [otherBodies, copy] = [hold(bodies.copy()), hold(debris.copy())];
        for (const all of [bodies, otherBodies]) all.push(id, [2500, 0, 0], [3.5, 3.5, 1.625]);
        const options = { maxPieces: 6, seed: 5, maxSpheres: 8, world };
        const report = debris.shatter(bodies, id, lumps(0.4), options);
        assert.equal(report.pieces.length + report.dust, 6);
        assert.ok(report.pieces.length >= 4 && report.cracks >= 5);
        assert.deepEqual(bodies.list().sort(), [...report.pieces].sort());
        near(massOfAll(bodies) + report.dustMass, 2500, 1e-6);
        const momentum = bodies.list().reduce((sum, one) => sum + bodies.get(one).mass * bodies.get(one).velocity[0], 0);
        near(momentum + report.dustMomentum[0], 2500, 1e-6);
        assert.deepEqual(copy.shatter(otherBodies, id, lumps(0.4), { ...options, seed: 5n }), report);
        assert.equal(debris.hash(), copy.hash());
        assert.equal(bodies.hash(), otherBodies.hash());

        const [first, second] = report.pieces;
        assert.equal(debris.get(bodies, first).broken, 1);
        near(bodies.get(first).velocity[0], 1, 1e-9);
        debris.remove(bodies, first);
        assert.equal(bodies.list().includes(first), false);
        throwsCode('INVALID', () => debris.get(bodies, first), /no such body/);
        // What is no debris; what is refused changes nothing.
        const ball = hold(recordings.bodyShape([0, 0, 0, 0.25], recordings.massOfBall(0.25, 1000)));
        const alone = bodies.add(ball, { position: [1, 1, 1] });
        throwsCode('INVALID', () => debris.get(bodies, alone), /no debris/);
        throwsCode('INVALID', () => debris.world(bodies, alone), /no debris/);
        throwsCode('INVALID', () => debris.remove(bodies, alone), /no debris/);
        throwsCode('INVALID', () => debris.shatter(bodies, alone, lumps(1)), /no debris/);
        const before = debris.hash();
        throwsCode('INVALID', () => debris.shatter(bodies, second, lumps(0.1), { maxSpheres: 5000 }), /max_spheres/);
        throwsCode('BAD_CALL', () => debris.shatter(bodies, second, lumps(0.1), { density: 1 }), /there is no density/);
        throwsCode('BAD_CALL', () => debris.shatter(bodies, second, lumps(0.1), { maxSpheres: 0.5 }), /shatter: maxSpheres/);
        throwsCode('BAD_HANDLE', () => debris.shatter(bodies, second, lumps(0.1), { world: bodies }), /world/);
        assert.equal(debris.hash(), before);
        throwsCode('BAD_CALL', () => debris.get(bodies, 7), /get: the body must be/);
        throwsCode('BAD_HANDLE', () => debris.get(debris, second), /bodies/);
        throwsCode('OUT_OF_RANGE', () => debris.addChunk(bodies, chunks, 1), /chunk/);
        throwsCode('BAD_CALL', () => debris.addChunk(bodies, chunks, -1), /addChunk: the chunk/);
        throwsCode('BAD_CALL', () => debris.addChunk(bodies, chunks, 0, { spheres: 4 }), /there is no spheres/);
        copy.release();
        throwsCode('BAD_HANDLE', () => copy.hash(), /debris/);
    });
});

test('what sleeps becomes ground, and a log can make the same edit', () => {
    holding((hold) => {
        const { world, chunks } = fallenColumn(hold, hold(makeLowRoom()));
        const bodies = hold(recordings.bodies());
        const debris = hold(recordings.debris());
        const id = debris.addChunk(bodies, chunks, 0);
        const rules = { toGround: true, maxAsleep: 0.25, keepClear: [1, 1, 1, 0.5] };
        let now = world;
        let report = { toGround: [] };
        for (let frame = 0; frame < 600 && report.toGround.length === 0; ++frame) {
            bodies.step(now, 1 / 60);
            ({ world: now, report } = debris.tend(bodies, now, 1 / 60, rules));
            hold(now);
        }
        assert.deepEqual(report, { removed: [], toGround: [id], refused: 0, waiting: 0 });
        assert.equal(bodies.count(), 0);
        assert.notEqual(now.hash(), world.hash());
        const { cutter, pose, material } = debris.fill(0);
        const again = hold(world.carve(hold(cutter), pose, { fill: true, material }).world);
        assert.equal(again.hash(), now.hash());
        throwsCode('OUT_OF_RANGE', () => debris.fill(1), /no such fill/);
        throwsCode('BAD_CALL', () => debris.fill('0'), /fill: the index/);

        // Too many for the rules: they are removed.
        const other = debris.addChunk(bodies, chunks, 0);
        const few = debris.tend(bodies, now, 1 / 60, { maxBodies: 0 });
        hold(few.world);
        assert.deepEqual([few.report.removed, few.report.toGround, bodies.count()], [[other], [], 0]);
        assert.equal(few.world.hash(), now.hash());
        const tend = (given, seconds = 1) => debris.tend(bodies, now, seconds, given);
        throwsCode('OUT_OF_RANGE', () => tend(undefined, NaN), /seconds/);
        throwsCode('OUT_OF_RANGE', () => tend({ maxAge: NaN }), /rule/);
        throwsCode('OUT_OF_RANGE', () => tend({ keepClear: [0, 0, 0, -1] }), /sphere/);
        throwsCode('BAD_CALL', () => tend({ keepClear: [0, 0, 0] }), /keepClear/);
        throwsCode('BAD_CALL', () => tend({ toGround: 1 }), /toGround must be true or false/);
        throwsCode('BAD_CALL', () => tend({ maxBodies: -1 }), /maxBodies/);
        throwsCode('BAD_CALL', () => tend({ budget: 4 }), /there is no budget/);
        throwsCode('BAD_HANDLE', () => debris.tend(bodies, bodies, 1), /world/);
    });
});

test('what blasts give at a distance and behind a wall', () => {
    holding((hold) => {
        const room = hold(makeLowRoom());
        assert.deepEqual([0, 3, 6, 7].map((distance) => recordings.blastShare({}, distance)), [1, 0.25, 0, 0]);
        assert.equal(recordings.blastShare({ radius: 12 }, 3), 0.5625);
        assert.deepEqual(recordings.blastImpulse({}, [0, 0, 3], 2, 0.5), [0, 0, 750]);
        assert.deepEqual(recordings.blastImpulse({ at: [0, 0, 1], impulse: 100 }, [0, 0, 4], 2), [0, 0, 50]);
        const spheres = [2, 4, 2, 0.5, 20, 4, 2, 0.5]; // the second lies behind the wall
        const from = [6, 4, 2];
        assert.equal(recordings.exposure(room, from, spheres.slice(0, 4)), 1);
        assert.equal(recordings.exposure(room, from, spheres), 0.5);
        assert.equal(recordings.exposure(room, from, Float64Array.from(spheres), 0), 1); // nothing covers
        assert.equal(recordings.exposure(room, from, []), 0);
        // A block of 2 m that moves away upward covers as it begins.
        const parts = hold(recordings.parts());
        parts.add({ world: hold(boxWorld([-1, -1, -1], [1, 1, 1], true)), motion: { position: [4, 4, 2], path: [0, 0, 100] } });
        assert.equal(recordings.exposure({ world: room, parts }, from, spheres.slice(0, 4)), 0);
        assert.equal(recordings.exposure({ world: room, parts, from: 1 }, from, spheres.slice(0, 4)), 1);
        assert.equal(recordings.exposure({ world: room, parts, from: 2 }, from, spheres.slice(0, 4)), 0);
        throwsCode('OUT_OF_RANGE', () => recordings.blastShare({}, NaN), /distance/);
        throwsCode('OUT_OF_RANGE', () => recordings.blastShare({ radius: 0 }, 1), /blast/);
        throwsCode('OUT_OF_RANGE', () => recordings.blastImpulse({}, [0, 0, 3], -1), /area/);
        throwsCode('OUT_OF_RANGE', () => recordings.exposure(room, from, [0, 0, 0, -1]), /sphere/);
        throwsCode('BAD_CALL', () => recordings.blastShare(undefined, 1), /blastShare: the blast must be an object/);
        throwsCode('BAD_CALL', () => recordings.blastShare({ reach: 6 }, 1), /there is no reach/);
        throwsCode('BAD_CALL', () => recordings.blastImpulse({}, [0, 0], 1), /point must have 3/);
        throwsCode('BAD_CALL', () => recordings.exposure(room, from, [1, 2, 3]), /the spheres must have 4/);
    });
});

test('a column is shot off the ceiling: it comes loose, breaks and flies', () => {
    holding((hold) => {
        const room = hold(makeLowRoom());
        const hung = hold(boxCutter([3, 3, 1], [4, 4, 5]));
        const held = hold(hold(room.carve(hung, here, { fill: true }).world).withAnchors());
        const bodies = hold(recordings.bodies());
        const debris = hold(recordings.debris());
        const crater = hold(recordings.crater('rocky', 1));
        const blast = { at: [3.5, 2.9, 3.25] };
        const pose = { position: [3.5, 3.5, 3.25] };
        const { world: after, report } = debris.explode(bodies, held, blast, crater, pose);
        hold(after);
        assert.deepEqual([report.carve.status, report.carve.chunks, report.carve.loose], ['done', 1, null]);
        assert.deepEqual([report.broken, report.pieces, report.unfit], [1, [], 0]);
        assert.ok(report.loose.length > 2 && report.pushed > 0 && report.reached >= report.pushed);
        assert.deepEqual(bodies.list().sort(), [...report.loose].sort());
        assert.notEqual(after.hash(), held.hash());
        bodies.step(after, 1 / 60);

        // Another without a crater breaks what lies there; the world is the same.
        const low = { at: [3.5, 3.5, 0.5] };
        const options = { breakRadius: 8, minVolume: 0.0001 };
        const second = debris.explode(bodies, after, low, null, undefined, options);
        assert.equal(hold(second.world).hash(), after.hash());
        assert.deepEqual([second.report.carve.status, second.report.loose], ['nothing', []]);
        assert.ok(second.report.pieces.length > 0 && second.report.broken > 0);
        const pushed = recordings.pushBlast(after, bodies, low);
        assert.ok(pushed.pushed > 0 && pushed.reached >= pushed.pushed);
        const gentle = hold(bodies.copy());
        recordings.pushBlast(after, gentle, low, { maxSpeed: 0 });
        assert.deepEqual(gentle.list().map((id) => gentle.get(id).velocity), bodies.list().map((id) => bodies.get(id).velocity));

        const before = bodies.hash();
        const explode = (given, of = low, at = pose) => debris.explode(bodies, after, of, crater, at, given);
        throwsCode('OUT_OF_RANGE', () => explode({ maxPieces: 0 }), /option/);
        throwsCode('INVALID', () => explode({ carve: { fill: true } }), /fill/);
        throwsCode('OUT_OF_RANGE', () => explode({ maxSpeed: NaN }), /max_speed/);
        throwsCode('OUT_OF_RANGE', () => explode({}, { radius: -1 }), /blast/);
        throwsCode('BAD_CALL', () => explode({ radius: 4 }), /explode: the options: there is no radius/);
        throwsCode('BAD_CALL', () => explode({ carve: { hollow: true } }), /there is no hollow/);
        throwsCode('BAD_CALL', () => debris.explode(bodies, after, low, crater), /position/);
        throwsCode('BAD_HANDLE', () => debris.explode(bodies, after, low, after, pose), /cutter/);
        throwsCode('BAD_HANDLE', () => debris.explode(debris, after, low, crater, pose), /bodies/);
        assert.equal(bodies.hash(), before);
        // A crater that is refused: the push happens all the same.
        const far = explode({}, low, { position: [1e9, 0, 0] });
        assert.equal(hold(far.world).hash(), after.hash());
        assert.equal(far.report.carve.status, 'refused');
        assert.notEqual(far.report.carve.reason, '');
        assert.ok(far.report.pushed > 0);
        assert.notEqual(bodies.hash(), before);
    });
});

test('options of the crater, and without looking for loose pieces', () => {
    holding((hold) => {
        const room = hold(makeLowRoom());
        const hung = hold(boxCutter([3, 3, 1], [4, 4, 5]));
        const held = hold(hold(room.carve(hung, here, { fill: true }).world).withAnchors());
        const crater = hold(recordings.crater('rocky', 1));
        const shot = (carve) => {
            const [bodies, debris] = [hold(recordings.bodies()), hold(recordings.debris())];
            const pose = { position: [3.5, 3.5, 3.25] };
            const { world, report } = debris.explode(bodies, held, { at: [3.5, 2.9, 3.25] }, crater, pose, { carve });
            return { world: hold(world), loose: report.loose.length };
        };
        const usual = shot(undefined);
        const named = shot({ material: 'soot' });
        assert.equal(named.loose, usual.loose);
        assert.deepEqual([usual, named].map(({ world }) => world.facts().materials.includes('soot')), [false, true]);
        assert.equal(shot({ chunks: false }).loose, 0);
    });
});
