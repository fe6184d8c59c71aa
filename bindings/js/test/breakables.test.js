// SPDX-License-Identifier: MIT
// Parts that break: what they bear, broken at once, carved until they do; what is refused.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { throwsCode, twoRooms } from './helpers.js';
import { boxCutter, boxWorld, holding, makeLowRoom, recordings } from './recording_helpers.js';

const near = (actual, expected, error = 1e-9) =>
    assert.ok(Math.abs(actual - expected) <= error, `${actual} is not ${expected} to ${error}`);

/** The low room with a crate of 1 m3 and a wall of 2 x 0.5 x 2 m, both on the floor. */
function makeScene(hold) {
    const level = hold(makeLowRoom());
    const parts = hold(recordings.parts());
    const crate = hold(boxWorld([-0.5, -0.5, 0], [0.5, 0.5, 1], true));
    const wall = hold(boxWorld([-1, -0.25, 0], [1, 0.25, 2], true));
    parts.add({ world: crate, motion: { position: [2, 2, 0] } });
    parts.add({ world: wall, motion: { position: [5, 5, 0] } });
    return { level, parts, bodies: hold(recordings.bodies()), debris: hold(recordings.debris()) };
}

test('what a part bears, and what hurts it', () => {
    holding((hold) => {
        const { level, parts } = makeScene(hold);
        const bears = recordings.breakable(parts, 0);
        assert.deepEqual(bears, { matter: null, health: 0, whole: 1, maxTaken: 0.5, damage: 0, broken: false });
        // Of a health of 0 nothing hurts it.
        assert.deepEqual(recordings.hurt(bears, 1000), { breakable: bears, breaks: false });
        const crate = { ...bears, health: 40 };
        const hurt = recordings.hurt(crate, 30);
        assert.deepEqual([hurt.breakable.health, hurt.breaks, crate.health], [10, false, 40]);
        // A blast 3 m before its face, of a radius of 6; with a wall between them it feels nothing.
        const blast = { at: [5.5, 2, 0.5] };
        const share = recordings.blastFelt(parts, 0, level, blast);
        near(share, 0.25);
        const wall = hold(boxCutter([3, -1, -1], [3.5, 9, 5]));
        const walled = hold(level.carve(wall, { position: [0, 0, 0] }, { fill: true }).world);
        assert.equal(recordings.blastFelt(parts, 0, walled, blast), 0);
        const again = recordings.hurt(hurt.breakable, 40 * share);
        assert.equal(again.breaks, true);
        throwsCode('OUT_OF_RANGE', () => recordings.breakable(parts, 2), /no part/);
        throwsCode('OUT_OF_RANGE', () => recordings.partWorld(parts, 2), /no part/);
        throwsCode('OUT_OF_RANGE', () => recordings.hurt(crate, NaN), /damage/);
        throwsCode('OUT_OF_RANGE', () => recordings.hurt({ ...crate, maxTaken: 2 }, 1), /breakable/);
        throwsCode('OUT_OF_RANGE', () => recordings.blastFelt(parts, 0, level, {}, 2), /fraction/);
        throwsCode('BAD_CALL', () => recordings.hurt({ health: 4 }, 1), /hurt: the breakable has no matter/);
        throwsCode('BAD_CALL', () => recordings.hurt({ ...crate, armour: 1 }, 1), /there is no armour/);
        throwsCode('BAD_CALL', () => recordings.hurt(undefined, 1), /the breakable must be an object/);
        throwsCode('BAD_CALL', () => recordings.breakable(parts, -1), /breakable: the part/);
        throwsCode('BAD_HANDLE', () => recordings.breakable(level, 0), /parts/);
    });
});

test('a crate breaks into debris', () => {
    holding((hold) => {
        const { level, parts, bodies, debris } = makeScene(hold);
        const crate = { ...recordings.breakable(parts, 0), health: 40 };
        const options = { breakable: crate, impact: [1.5, 2, 0.5], maxPieces: 8 };
        const { world, breakable, report } = debris.breakPart(bodies, parts, 0, level, options);
        assert.equal(hold(world).hash(), level.hash());
        assert.deepEqual([breakable.broken, crate.broken], [true, false]);
        assert.ok(report.pieces.length >= 4 && report.pieces.length <= 8);
        assert.deepEqual([report.unfit, report.opened], [0, 0]);
        assert.deepEqual(bodies.list().sort(), [...report.pieces].sort());
        const piece = debris.get(bodies, report.pieces[0]);
        assert.deepEqual([piece.ofPart, piece.broken], [true, 1]);
        assert.equal(hold(recordings.partWorld(parts, 0)).facts().faceCount, 0);
        const volume = report.pieces.reduce((sum, id) => sum + hold(debris.world(bodies, id)).mass(1).volume, 0);
        if (report.dust === 0) near(volume, 1, 1e-12);
        else assert.ok(volume < 1 && volume > 0.9);
        // Once more: nothing is there.
        const again = debris.breakPart(bodies, parts, 0, level);
        hold(again.world);
        assert.deepEqual([again.report.pieces, again.breakable], [[], null]);
        // The wall falls as it is.
        const fallen = debris.breakPart(bodies, parts, 1, level, { unbroken: true, seed: 3n, portals: [] });
        hold(fallen.world);
        assert.equal(fallen.report.pieces.length, 1);
        near(hold(debris.world(bodies, fallen.report.pieces[0])).mass(1).volume, 2);

        const before = [bodies.hash(), debris.hash()];
        const broken = (given, part = 1) => debris.breakPart(bodies, parts, part, level, given);
        throwsCode('OUT_OF_RANGE', () => broken({ fraction: 2 }), /option/);
        throwsCode('OUT_OF_RANGE', () => broken({ maxPieces: 0 }), /option/);
        throwsCode('OUT_OF_RANGE', () => broken({}, 9), /no part 9/);
        throwsCode('INVALID', () => broken({ breakable: { ...crate, matter: 99 } }, 0), /matter/);
        throwsCode('BAD_CALL', () => broken({ pieces: 4 }), /breakPart: the options: there is no pieces/);
        throwsCode('BAD_CALL', () => broken({ unbroken: 1 }), /unbroken must be true or false/);
        throwsCode('BAD_CALL', () => broken({ portals: [-1] }), /portals/);
        throwsCode('BAD_HANDLE', () => debris.breakPart(debris, parts, 1, level), /bodies/);
        assert.deepEqual([bodies.hash(), debris.hash()], before);
    });
});

test('a door that breaks opens the portal that it closed', async () => {
    const rooms = await recordings.worldFromMap(twoRooms);
    holding((hold) => {
        const level = hold(hold(rooms).setPortalOpen(0, false));
        const [parts, bodies, debris] = [hold(recordings.parts()), hold(recordings.bodies()), hold(recordings.debris())];
        const door = hold(boxWorld([-0.25, -0.25, -0.25], [0.25, 4.25, 4.25], true));
        parts.add({ world: door, motion: { position: [4, 0, 0] } });
        parts.add({ world: door, motion: { position: [2, 0, 0] } });
        assert.deepEqual([recordings.partPortals(parts, 0, level), recordings.partPortals(parts, 1, level)], [[0], []]);
        const beside = debris.breakPart(bodies, parts, 1, level);
        assert.deepEqual([beside.report.opened, hold(beside.world).portal(0).open], [0, false]);
        const { world, report } = debris.breakPart(bodies, parts, 0, level, { maxPieces: 4 });
        assert.deepEqual([report.opened, hold(world).portal(0).open, level.portal(0).open], [1, true, false]);
        throwsCode('OUT_OF_RANGE', () => recordings.partPortals(parts, 2, level), /no part/);
        throwsCode('BAD_HANDLE', () => recordings.partPortals(parts, 0, parts), /world/);
    });
});

test('a wall is sawn through: what is above falls, the foot stays, and then breaks', () => {
    holding((hold) => {
        const { level, parts, bodies, debris } = makeScene(hold);
        const here = { position: [0, 0, 0] };
        const saw = hold(boxCutter([3, 4, 1], [7, 6, 1.5]));
        const carve = (cutter, options) => {
            const result = debris.carvePart(bodies, parts, 1, level, cutter, here, options);
            hold(result.world);
            return result;
        };
        const foot = { ...recordings.breakable(parts, 1), maxTaken: 0.8 };
        const { breakable, report } = carve(saw, { breakable: foot, carve: { material: 'sawn' } });
        assert.deepEqual([report.status, report.reason, report.unfit, report.opened, report.rest], ['done', '', 0, 0, null]);
        assert.deepEqual(breakable, foot);
        near(report.volume, 0.5); // 2 x 0.5 x 0.5 m
        assert.equal(report.loose.length, 1);
        near(hold(debris.world(bodies, report.loose[0])).mass(1).volume, 0.5);
        const left = hold(recordings.partWorld(parts, 1));
        near(left.mass(1).volume, 1);
        assert.equal(left.facts().high[2], 1);
        assert.ok(left.facts().materials.includes('sawn'));
        const nothing = carve(saw).report;
        assert.deepEqual([nothing.status, nothing.loose, nothing.volume], ['nothing', [], 0]);
        // Most of the foot: the rest breaks.
        const chisel = hold(boxCutter([3, 4, -1], [5.75, 6, 2]));
        const broken = carve(chisel, { breakable: foot, pieces: { maxPieces: 4 } });
        assert.equal(broken.breakable.broken, true);
        assert.ok(broken.report.rest.pieces.length >= 1 && broken.report.rest.pieces.length <= 4);
        assert.equal(hold(recordings.partWorld(parts, 1)).facts().faceCount, 0);

        const before = bodies.hash();
        throwsCode('OUT_OF_RANGE', () => carve(saw, { touch: NaN }), /touch/);
        throwsCode('INVALID', () => carve(saw, { carve: { fill: true } }), /fill/);
        throwsCode('BAD_CALL', () => carve(saw, { hold: 'largest' }), /carvePart: the options: there is no hold/);
        throwsCode('BAD_CALL', () => carve(saw, { holdLargest: 'yes' }), /holdLargest must be true or false/);
        throwsCode('BAD_CALL', () => carve(saw, { pieces: { most: 4 } }), /pieces: there is no most/);
        throwsCode('BAD_CALL', () => debris.carvePart(bodies, parts, 1, level, saw), /position/);
        throwsCode('BAD_HANDLE', () => carve(level), /cutter/);
        assert.equal(bodies.hash(), before);
    });
});
