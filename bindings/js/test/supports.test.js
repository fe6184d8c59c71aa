// SPDX-License-Identifier: MIT
// What faces hold, and what an edit takes of it. The things are those of the C tests.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { throwsCode } from './helpers.js';
import { boxCutter, holding, makeLowRoom, recordings } from './recording_helpers.js';

const here = { position: [0, 0, 0] };
const things = [
    { entity: 11, kind: 'touches', low: [1, 1, 0], high: [3, 2, 1] },
    { entity: 12, kind: 'stands', low: [5, 5, 2], high: [6, 6, 3], reach: 10 },
    { entity: 13, kind: 'hangs', low: [4, 4, 3], high: [4.5, 4.5, 3.5], reach: 1 },
];
const near = (actual, expected) =>
    assert.ok(Math.abs(actual - expected) < 1e-9, `${actual} is not ${expected}`);

test('things are held by the floor and the ceiling', () => {
    holding((hold) => {
        const room = hold(makeLowRoom());
        const supports = hold(recordings.findSupports(room, things));
        assert.equal(supports.count(), 3);
        [2, 1, 0.25].forEach((area, k) => {
            const support = supports.get(k);
            near(support.area, area);
            assert.deepEqual([support.entity, support.kind, support.faceCount], [11 + k, things[k].kind, 1]);
            assert.equal(support.lowered, k === 1 ? 2 : 0);
        });
        const [[floor], [ceiling]] = [supports.faces(0), supports.faces(2)];
        assert.deepEqual([floor.face, ceiling.face], [0, 1]);
        near(floor.area, 2);
        // What is left out is as said: a thing that touches, numbered by its place, held by what stops walkers.
        const box = { low: [1, 1, 0], high: [3, 2, 1] };
        const plain = hold(recordings.findSupports(room, [box, box]));
        assert.deepEqual([plain.get(0).kind, plain.get(0).entity, plain.get(1).entity], ['touches', 0, 1]);
        near(plain.get(0).area, 2);
        const clips = hold(makeLowRoom({ masks: [2, 2, 2, 2, 2, 2] }));
        const masked = hold(recordings.findSupports(clips, [box, { ...box, mask: 2 }]));
        assert.deepEqual([masked.get(0).area, masked.faces(0)], [0, []]);
        near(masked.get(1).area, 2);
        assert.equal(hold(recordings.findSupports(room, [])).count(), 0);
    });
});

test('an edit takes half of what holds a thing, and gives it back', () => {
    holding((hold) => {
        const room = hold(makeLowRoom());
        const supports = hold(recordings.findSupports(room, things));
        const cut = hold(room.carve(hold(boxCutter([2, 0, -1], [4, 4, 1])), here).world);
        const { changes, after } = supports.diff(cut, room);
        hold(after);
        const [change, ...others] = changes;
        assert.deepEqual([change.thing, change.entity, change.loss, change.lost, change.buried], [0, 11, 'less', 1, false]);
        near(change.before, 2);
        near(change.after, 1);
        for (const other of others) assert.deepEqual([other.thing, other.loss], [1, 'kept']);
        near(after.get(0).area, 1);
        const everywhere = supports.diff(cut);
        hold(everywhere.after);
        assert.deepEqual(everywhere.changes, changes);
        const back = after.diff(room, cut);
        hold(back.after);
        assert.deepEqual([back.changes[0].thing, back.changes[0].loss], [0, 'kept']);
        near(back.changes[0].after, 2);
        const same = supports.diff(room, room);
        hold(same.after);
        assert.deepEqual(same.changes, []);
        // All of what a thing stands on is taken, and another is filled in.
        const pit = hold(room.carve(hold(boxCutter([0, 0, -1], [4, 4, 1])), here).world);
        const lost = supports.diff(pit, room);
        hold(lost.after);
        assert.deepEqual([lost.changes[0].thing, lost.changes[0].loss, lost.changes[0].after], [0, 'lost', 0]);
        const block = hold(room.carve(hold(boxCutter([0.5, 0.5, -1], [3.5, 2.5, 2])), here, { fill: true }).world);
        const buried = supports.diff(block, room);
        hold(buried.after);
        assert.deepEqual([buried.changes[0].thing, buried.changes[0].buried], [0, true]);
        throwsCode('INVALID', () => supports.diff(room, cut), /was/);
    });
});

test('what is no thing says so', () => {
    holding((hold) => {
        const room = hold(makeLowRoom());
        const supports = hold(recordings.findSupports(room, things));
        const find = (...changed) => recordings.findSupports(room, changed.map((one) => ({ ...things[0], ...one })));
        throwsCode('INVALID', () => find({}, { reach: NaN }), /thing 1/);
        throwsCode('BAD_CALL', () => find({ kind: 'floats' }), /findSupports: thing 0: kind must be one of touches, stands, hangs/);
        throwsCode('BAD_CALL', () => find({}, { low: [0, 0] }), /thing 1: low must have 3/);
        throwsCode('BAD_CALL', () => find({ height: 4 }), /thing 0: there is no height/);
        throwsCode('BAD_CALL', () => find({ entity: -1 }), /thing 0: entity/);
        throwsCode('BAD_CALL', () => recordings.findSupports(room), /the things must be an array/);
        throwsCode('BAD_CALL', () => recordings.findSupports(room, [undefined]), /thing 0 must be an object/);
        throwsCode('BAD_HANDLE', () => recordings.findSupports(supports, things), /world/);
        throwsCode('OUT_OF_RANGE', () => supports.get(3), /no such thing/);
        throwsCode('OUT_OF_RANGE', () => supports.faces(3), /no such thing/);
        throwsCode('BAD_CALL', () => supports.get(-1), /get: the thing/);
        throwsCode('BAD_HANDLE', () => supports.diff(supports, room), /world/);
    });
});
