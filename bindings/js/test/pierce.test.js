// SPDX-License-Identifier: MIT
// What straight paths go through: walls, from inside, nothing; what is refused.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { throwsCode } from './helpers.js';
import { boxCutter, holding, makeLowRoom, recordings } from './recording_helpers.js';

const near = (actual, expected, error = 1e-9) =>
    assert.ok(Math.abs(actual - expected) <= error, `${actual} is not ${expected} to ${error}`);

/** Without the signs of zeros. */
const plain = (numbers) => numbers.map((x) => x + 0);

/** The low room with a wall of half a metre across it, from x = 4 on. */
function walledRoom(hold) {
    const slab = hold(boxCutter([4, -1, -1], [4.5, 9, 5]));
    return hold(hold(makeLowRoom()).carve(slab, { position: [0, 0, 0] }, { fill: true, material: 'plaster' }).world);
}

test('a path through a wall of half a metre', () => {
    holding((hold) => {
        const walled = walledRoom(hold);
        const way = { start: [2, 4, 2], path: [5, 0, 0] };
        const { status, thickness, spans } = recordings.pierce(walled, way);
        assert.deepEqual([status, spans.length], ['hit', 1]);
        near(thickness, 0.5);
        const [span] = spans;
        near(span.thickness, 0.5);
        near(span.in.fraction, 0.4);
        near(span.out.fraction, 0.5);
        near(span.out.point[0], 4.5);
        assert.deepEqual([plain(span.in.normal), plain(span.out.normal)], [[-1, 0, 0], [1, 0, 0]]);
        assert.equal(walled.material(span.in.material), 'plaster');
        assert.deepEqual(plain(walled.face(span.in).normal), [-1, 0, 0]);
        assert.deepEqual([span.portal, span.pane, span.startsInside, span.endsInside], [null, false, false, false]);
        assert.equal(span.lengths.length, 1);
        near(span.lengths[0].from, 0.4);
        near(span.lengths[0].to, 0.5);
        assert.equal(span.lengths[0].matter, walled.matterAt([4.25, 4, 2]));
        const bare = recordings.pierce(walled, way, { matters: false });
        assert.deepEqual(bare.spans, [{ ...span, lengths: [] }]);
    });
});

test('from within solid, into solid, and nothing', () => {
    holding((hold) => {
        const walled = walledRoom(hold);
        const inside = recordings.pierce(walled, { start: [4.25, 4, 2], path: [8, 0, 0] });
        assert.deepEqual([inside.status, inside.spans.length], ['touching', 2]);
        near(inside.thickness, 0.25 + 4.25);
        const [first, last] = inside.spans;
        assert.deepEqual([first.startsInside, first.endsInside, first.in.face], [true, false, null]);
        assert.deepEqual([first.in.fraction, first.in.normal], [0, [0, 0, 0]]);
        assert.deepEqual([last.startsInside, last.endsInside, last.out.face, last.out.fraction], [false, true, null, 1]);
        assert.deepEqual(recordings.pierce(walled, { start: [2, 4, 2], path: [0, 0, 1] }), { status: 'miss', thickness: 0, spans: [] });
        assert.equal(recordings.pierce(walled, { start: [2, 4, 2], path: [0, 0, 0] }).status, 'miss');
        // A mask of no face leaves out the stretch.
        assert.equal(recordings.pierce(walled, { start: [2, 4, 2], path: [5, 0, 0] }, { mask: 0 }).spans.length, 0);
    });
});

test('a pane has no thickness', () => {
    holding((hold) => {
        // A square at x = 4 that bounds no solid, in the air.
        const pane = hold(recordings.worldFromMesh({
            positions: [4, 3, 1, 4, 5, 1, 4, 5, 3, 4, 3, 3],
            corners: [0, 3, 2, 1],
            cornerCounts: [4],
        }));
        const way = { start: [2, 4, 2], path: [4, 0, 0] };
        const back = { start: [6, 4, 2], path: [-4, 0, 0] };
        const { spans, thickness } = recordings.pierce(pane, way);
        assert.deepEqual([spans.length, thickness], [1, 0]);
        assert.deepEqual([spans[0].pane, spans[0].in, spans[0].lengths], [true, spans[0].out, []]);
        near(spans[0].in.fraction, 0.5);
        assert.equal(recordings.pierce(pane, way, { panes: false }).spans.length, 0);
        assert.equal(recordings.pierce(pane, back).spans.length, 0);
        assert.equal(recordings.pierce(pane, back, { bothSides: true }).spans.length, 1);
    });
});

test('what is no path says so', () => {
    holding((hold) => {
        const walled = walledRoom(hold);
        const way = { start: [2, 4, 2], path: [5, 0, 0] };
        throwsCode('OUT_OF_RANGE', () => recordings.pierce(walled, { ...way, start: [NaN, 0, 0] }), /number/);
        throwsCode('OUT_OF_RANGE', () => recordings.pierce(walled, { ...way, path: [1e300, 0, 0] }), /number/);
        throwsCode('BAD_CALL', () => recordings.pierce(walled), /pierce: the way must be/);
        throwsCode('BAD_CALL', () => recordings.pierce(walled, { start: [2, 4, 2] }), /pierce: path/);
        throwsCode('BAD_CALL', () => recordings.pierce(walled, { ...way, radius: 1 }), /there is no radius/);
        throwsCode('BAD_CALL', () => recordings.pierce(walled, way, { sides: 2 }), /there is no sides/);
        throwsCode('BAD_CALL', () => recordings.pierce(walled, way, { panes: 0 }), /panes must be true or false/);
        throwsCode('BAD_HANDLE', () => recordings.pierce(undefined, way), /not a world/);
    });
});
