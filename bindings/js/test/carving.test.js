// SPDX-License-Identifier: MIT
// Cutters, edits in one go, in slices, several at once; rules; differences; histories.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { boxMesh, firma, readers, releasing, throwsCode, withLevel } from './helpers.js';
import { surfacePoints } from './scenario.js';

const tetrahedron = { positions: [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1], corners: [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3] };
/** work(world, cutter, release later) in a box of air. */
const carving = (work) =>
    releasing([firma.worldFromMesh(boxMesh()), firma.crater('rocky', 1)], (world, cutter) => {
        const kept = [];
        releasing(kept, () => work(world, cutter, (object) => (kept.push(object), object)));
    });
const atWall = { position: [8, 4, 4] };

test('cutters of every shape and seed', () => {
    for (const shape of ['rocky', 'spiky', 'drill', 'wedge', 'box']) firma.crater(shape, 1).release();
    firma.crater('rocky', 2n ** 64n - 1n).release();
    for (const shape of ['round', 0, undefined, '', Symbol('box')])
        throwsCode('BAD_CALL', () => firma.crater(shape, 1), /shape/);
    for (const seed of [-1, 1.5, NaN, 2 ** 53, 2n ** 64n, -1n, '1', undefined])
        throwsCode('BAD_CALL', () => firma.crater('box', seed), /seed/);
});

test('solids as cutters: what a cut took is taken out and put back', () => {
    carving((rock, _, keep) => {
        throwsCode('INVALID', () => firma.cutterFromWorld(rock), /reaches to infinity/);
        throwsCode('BAD_HANDLE', () => firma.cutterFromWorld());
        throwsCode('BAD_CALL', () => firma.cutterFromWorld(rock, 5));
        const block = keep(readers.worldFromObj(
            'v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 0 0 2\nv 2 0 2\nv 2 2 2\nv 0 2 2\n' +
            'f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n',
        ));
        const crater = keep(firma.crater('rocky', 7));
        const cut = block.carve(crater, { position: [2, 2, 2], scale: 0.5 });
        const after = keep(cut.world);
        const here = { position: [0, 0, 0] };
        const chunk = keep(block.carve(keep(firma.cutterFromWorld(after, 'rest')), here).world);
        assert.ok(Math.abs(chunk.measure().volume - cut.report.volume) < 1e-9);
        const again = after.carve(keep(firma.cutterFromWorld(chunk)), here, { fill: true });
        assert.ok(keep(again.world).sameSolid(block));
    });
});

test('cutters from meshes', () => {
    carving((world, _, keep) => {
        const cutter = keep(firma.cutterFromMesh(tetrahedron.positions, tetrahedron.corners, 'tetra'));
        const typed = keep(
            firma.cutterFromMesh(Float64Array.from(tetrahedron.positions), Uint32Array.from(tetrahedron.corners)),
        );
        const obj = tetrahedron.positions.map((x, k) => (k % 3 === 0 ? '\nv ' : ' ') + x).join('');
        const text = obj + tetrahedron.corners.map((v, k) => (k % 3 === 0 ? '\nf ' : ' ') + (v + 1)).join('');
        const fromObj = keep(readers.cutterFromObj(text, 'tetra.obj'));
        const pose = { position: [7.5, 4, 4], scale: 2 };
        const hashes = [cutter, typed, fromObj].map((one) => {
            const { world: after, report } = world.carve(one, pose);
            keep(after).check();
            assert.equal(report.status, 'done');
            assert.ok(report.volume > 0 && report.volume < 8 / 6);
            return after.hash();
        });
        assert.deepEqual(hashes, [hashes[0], hashes[0], hashes[0]]);
        const { positions, corners } = tetrahedron;
        assert.throws(() => firma.cutterFromMesh(positions, corners.slice(3), 'open'), /open/);
        assert.throws(() => firma.cutterFromMesh(positions, [9, ...corners.slice(1)]));
        assert.throws(() => firma.cutterFromMesh([], []));
        throwsCode('OUT_OF_RANGE', () =>
            firma.cutterFromMesh(
                positions.map(() => NaN),
                corners,
            ),
        );
        throwsCode('BAD_CALL', () => firma.cutterFromMesh(positions.slice(1), corners));
        throwsCode('BAD_CALL', () => firma.cutterFromMesh(positions, corners.slice(1)));
        throwsCode('BAD_CALL', () => firma.cutterFromMesh(positions, 'corners'));
        throwsCode('BAD_CALL', () => firma.cutterFromMesh(positions, corners, 5));
        assert.throws(() => readers.cutterFromObj('v 0 0 0', 'nothing.obj'), /nothing\.obj/);
        throwsCode('BAD_CALL', () => readers.cutterFromObj());
    });
});

test('a random turn is of length one, and the same for the same seed', () => {
    const turn = firma.randomTurn(5);
    assert.equal(turn.length, 4);
    assert.ok(Math.abs(Math.hypot(...turn) - 1) < 1e-12);
    assert.deepEqual(firma.randomTurn(5n), turn);
    assert.notDeepEqual(firma.randomTurn(6), turn);
    throwsCode('BAD_CALL', () => firma.randomTurn(-1));
});

test('a report tells what a crater takes of faces that bound no solid', () => {
    const sheet = firma.worldFromMesh({ positions: [0, 0, 0, 8, 0, 0, 8, 8, 0], corners: [0, 1, 2] });
    releasing([sheet, firma.crater('rocky', 1)], (world, cutter) => {
        for (const [z, status, trimmed] of [[0, 'done', 1], [4, 'nothing', 0]]) {
            const { world: after, report } = world.carve(cutter, { position: [5, 3, z] });
            assert.equal(after.facts().faceCount > 1, trimmed === 1);
            after.release();
            assert.deepEqual([report.status, report.openTrimmed, report.openRemoved], [status, trimmed, 0]);
            assert.deepEqual([report.facesCastableOnly, report.volume], [0, 0]);
        }
    });
});

test('a cut, its report, and the world before', () => {
    carving((world, cutter, keep) => {
        const before = world.hash();
        const { world: after, report } = world.carve(
            cutter,
            { ...atWall, rotation: [0, 0, 0, 2], scale: 1.5 },
            { material: 'größe' },
        );
        keep(after).check();
        assert.equal(world.hash(), before);
        assert.equal(report.status, 'done');
        assert.equal(report.reason, '');
        assert.ok(report.facesAdded > 50 && report.facesCut >= 1 && report.facesRemoved >= 1 && report.candidateFaces >= 1);
        assert.equal(report.scale, 1);
        assert.ok(Math.abs(world.measure().volume - after.measure().volume - report.volume) < 1e-6);
        const { total, ...phases } = report.times;
        assert.deepEqual(Object.keys(phases), ['place', 'gather', 'cut', 'label', 'trace', 'facets', 'chunks', 'tree']);
        assert.ok(total > 0 && Math.abs(total - Object.values(phases).reduce((a, b) => a + b)) < 1e-6);
        assert.deepEqual([after.facts().version, after.facts().edits], [1, 1]);
        assert.ok(after.facts().materials.includes('größe'));
        const hit = after.cast({ centre: [4, 4, 4], radius: 0, path: [10, 0, 0] });
        assert.ok(hit.point[0] > 8);
        assert.deepEqual([after.hitInfo(hit).sourceEdit, after.hitInfo(hit).room], [1, 0]);
        assert.equal(after.facts().materials[hit.material], 'größe');
        const { world: filled, report: fill } = after.carve(cutter, { ...atWall, scale: 1.5 }, { fill: true });
        keep(filled).check();
        assert.equal(fill.status, 'done');
        assert.ok(fill.volume < 0);
        assert.deepEqual([world.sameSolid(after), after.sameSolid(filled), after.sameSolid(keep(after.copy()))], [false, false, true]);
    });
});

test('nothing met, and refusals: each gives the world before, as a handle of its own', () => {
    carving((world, cutter, keep) => {
        const nothing = world.carve(cutter, { position: [4, 4, 4] });
        assert.equal(nothing.report.status, 'nothing');
        assert.equal(keep(nothing.world).hash(), world.hash());
        for (const pose of [
            { position: [NaN, 4, 4] },
            { ...atWall, scale: 0 },
            { ...atWall, scale: -1 },
            { ...atWall, rotation: [0, 0, 0, 0] },
            { ...atWall, scale: 1e9 },
        ]) {
            const { world: same, report } = world.carve(cutter, pose);
            assert.equal(keep(same).hash(), world.hash());
            assert.equal(report.status, 'refused');
            assert.notEqual(report.reason, '');
        }
        const wrong = [
            undefined,
            null,
            5,
            {},
            { position: [1, 2] },
            { ...atWall, rotation: [0, 0, 1] },
            { ...atWall, scale: '1' },
        ];
        for (const pose of wrong) throwsCode('BAD_CALL', () => world.carve(cutter, pose), /^carve: /);
        for (const options of [null, 5, { fill: 1 }, { material: 5 }, { material: 'a\0' }])
            throwsCode('BAD_CALL', () => world.carve(cutter, atWall, options));
        for (const one of [undefined, null, {}, 'rocky', world])
            throwsCode('BAD_HANDLE', () => world.carve(one, atWall), /cutter/);
    });
});

test('rules refuse cuts, and their order does not matter to the world', () => {
    carving((world, cutter, keep) => {
        const zone = { name: 'bunker', low: [6, 0, 0], high: [9.5, 8, 8], hardness: 1 };
        const guarded = keep(world.withRules({ zones: [zone, { low: [0, 0, 0], high: [1, 1, 1], hardness: 0 }] }));
        const { world: same, report } = guarded.carve(cutter, atWall);
        assert.equal(keep(same).hash(), guarded.hash());
        assert.equal(report.status, 'refused');
        assert.match(report.reason, /bunker/);
        const hard = keep(world.withRules({ hardness: [0.5] }));
        const shrunk = hard.carve(cutter, atWall);
        keep(shrunk.world);
        assert.ok(shrunk.report.status === 'done' && shrunk.report.scale < 1);
        for (const rules of [
            { maxFaces: 10 },
            { maxNewFaces: 3 },
            { maxCutterTriangles: 20 },
            { maxCutterSize: 0.5 },
            { maxCandidateFaces: 1, maxPairs: 1, maxCorners: 1 },
        ]) {
            const limited = keep(world.withRules(rules));
            const tried = limited.carve(cutter, atWall);
            keep(tried.world);
            assert.equal(tried.report.status, 'refused', JSON.stringify(rules));
        }
        // Larger than what the module can count is no limit, not a small one.
        const all = ['maxFaces', 'maxCandidateFaces', 'maxNewFaces', 'maxCutterTriangles', 'maxPairs', 'maxCorners'];
        const free = keep(world.withRules(Object.fromEntries(all.map((name) => [name, 2 ** 32]))));
        const cut = free.carve(cutter, atWall);
        keep(cut.world);
        assert.equal(cut.report.status, 'done', cut.report.reason);
        keep(world.withRules({}));
        const sheet = keep(readers.worldFromObj('v 0 0 0\nv 8 0 0\nv 8 8 0\nv 0 8 0\nf 1 2 3 4\n'));
        for (const [openFaces, status, stays] of [[undefined, 'done', 0], [true, 'done', 0], [false, 'nothing', 1]]) {
            const cut = keep(sheet.withRules({ openFaces })).carve(cutter, { position: [4, 4, 0] });
            keep(cut.world);
            assert.deepEqual([cut.report.status, cut.report.facesCastableOnly], [status, stays]);
        }
        throwsCode('BAD_CALL', () => world.withRules({ openFaces: 1 }), /openFaces/);
        throwsCode('INVALID', () => world.withRules({ zones: [{ ...zone, hardness: 2 }] }), /zone 0/);
        throwsCode('INVALID', () => world.withRules({ zones: [zone, { ...zone, low: [10, 0, 0] }] }), /zone 1/);
        throwsCode('INVALID', () => world.withRules({ zones: [{ ...zone, low: [NaN, 0, 0] }] }));
        throwsCode('INVALID', () => world.withRules({ hardness: [0, NaN] }), /material 1/);
        throwsCode('INVALID', () => world.withRules({ maxCutterSize: -1 }));
        const wrong = [
            null,
            5,
            { zones: zone },
            { zones: [null] },
            { zones: [{ ...zone, low: 0 }] },
            { zones: [{ ...zone, hardness: '1' }] },
        ];
        wrong.push(
            { hardness: 0.5 },
            { maxFaces: -1 },
            { maxFaces: 1.5 },
            { maxCutterSize: '1' },
            { zones: [{ ...zone, name: 7 }] },
        );
        for (const rules of wrong) throwsCode('BAD_CALL', () => world.withRules(rules), /^withRules: /);
    });
});

test('a job in slices gives the same bits as one go', () => {
    withLevel((world) => {
        releasing([firma.crater('spiky', 9)], (cutter) => {
            surfacePoints(world, 6, 21).forEach((position, k) => {
                const pose = { position, rotation: firma.randomTurn(k), scale: 1.25 };
                const options = { fill: k % 2 === 1, material: 'rock' };
                const whole = world.carve(cutter, pose, options);
                const job = world.startCarve(cutter, pose, options);
                throwsCode('BAD_CALL', () => job.result(), /not finished/);
                let slices = 1;
                while (!job.run(0)) ++slices;
                assert.ok(slices > 3, `${slices} slices`);
                assert.equal(job.run(0), true);
                const first = job.result();
                const again = job.result();
                job.release();
                throwsCode('BAD_HANDLE', () => job.run(1), /job/);
                throwsCode('BAD_HANDLE', () => job.result(), /job/);
                releasing([whole.world, first.world, again.world], () => {
                    assert.equal(first.world.hash(), whole.world.hash());
                    assert.equal(again.world.hash(), whole.world.hash());
                    const { times: a, ...one } = first.report;
                    const { times: b, ...other } = whole.report;
                    assert.deepEqual(one, other);
                });
            });
            const job = world.startCarve(cutter, { position: [NaN, 0, 0] });
            for (const time of [-1, NaN]) throwsCode('INVALID', () => job.run(time));
            throwsCode('BAD_CALL', () => job.run());
            assert.equal(job.run(Infinity), true);
            const refused = job.result();
            assert.equal(refused.report.status, 'refused');
            assert.match(refused.report.reason, /position/);
            refused.world.release();
            job.release();
            world.startCarve(cutter, { position: [0, 0, 0] }).release(); // never run
            throwsCode('BAD_CALL', () => world.startCarve(cutter));
        });
    });
});

test('a job outlives the world and cutter it began with', () => {
    const world = firma.worldFromMesh(boxMesh());
    const cutter = firma.crater('rocky', 1);
    const job = world.startCarve(cutter, atWall);
    const edit = world.edit();
    world.release();
    cutter.release();
    job.run(Infinity);
    const { world: after, report } = job.result();
    assert.equal(report.status, 'done');
    throwsCode('BAD_HANDLE', () => edit.carve(cutter, atWall), /cutter/);
    releasing([after, job, edit, edit.finish()], () => after.check());
});

test('several edits become one version', () => {
    carving((world, cutter, keep) => {
        const edit = keep(world.edit());
        const positions = [
            [8, 4, 4],
            [0, 4, 4],
            [4, 8, 4],
        ];
        for (const position of positions) assert.equal(edit.carve(cutter, { position }).status, 'done');
        assert.equal(edit.carve(cutter, { position: [4, 4, 4] }).status, 'nothing');
        const refused = edit.carve(cutter, { position: [NaN, 4, 4] });
        assert.deepEqual([refused.status, refused.reason !== ''], ['refused', true]);
        throwsCode('BAD_CALL', () => edit.carve(cutter, {}));
        const after = keep(edit.finish());
        assert.equal(after.facts().version, 1);
        assert.equal(after.facts().edits, 3);
        after.check();
        let each = keep(world.copy());
        for (const position of positions) each = keep(each.carve(cutter, { position }).world);
        assert.deepEqual(after.faces(), each.faces());
        // It goes on, and every finish() is one version after the first.
        assert.equal(edit.carve(cutter, { position: [4, 4, 8] }).status, 'done');
        const more = keep(edit.finish());
        assert.deepEqual([more.facts().version, more.facts().edits], [1, 4]);
        assert.equal(after.facts().edits, 3);
        const untouched = keep(world.edit());
        assert.equal(keep(untouched.finish()).hash(), world.hash());
    });
});

/** Faces by id, each with all that faces() tells of it. */
function facesById(faces) {
    const found = new Map();
    faces.ids.forEach((id, k) => {
        const begin = 3 * faces.firstCorners[k];
        found.set(id, {
            normal: [...faces.normals.subarray(3 * k, 3 * k + 3)],
            words: ['materials', 'sources', 'sourceEdits', 'masks', 'flags', 'rooms'].map((name) => faces[name][k]),
            corners: [...faces.corners.subarray(begin, begin + 3 * faces.cornerCounts[k])],
        });
    });
    return found;
}

test('a diff put to the faces of the first world gives those of the second', () => {
    withLevel((first) => {
        const edit = first.edit();
        releasing([firma.crater('rocky', 4)], (cutter) => {
            for (const position of surfacePoints(first, 12, 33)) edit.carve(cutter, { position });
        });
        const second = edit.finish();
        edit.release();
        releasing([second], () => {
            for (const [from, to] of [
                [first, second],
                [second, first],
            ]) {
                const diff = from.diff(to, 2);
                const faces = facesById(from.faces());
                assert.deepEqual(diff.removedFaces.ids, diff.removed);
                diff.removed.forEach((id, k) => {
                    const { ids, firstPoints, rooms, sources, sourceEdits, ...others } = diff.removedFaces;
                    const face = from.face({ id, corner: firstPoints.subarray(3 * k, 3 * k + 3) });
                    assert.deepEqual([face.room, face.source, face.sourceEdit], [rooms[k], sources[k], sourceEdits[k]]);
                    assert.deepEqual([face.material, face.mask], [others.materials[k], others.masks[k]]);
                    assert.deepEqual(face.normal, Array.from(others.normals.subarray(3 * k, 3 * k + 3)));
                    assert.equal(face.flags, others.flags[k]);
                    assert.ok(faces.delete(id), `${id} was removed, but was not there`);
                });
                for (const [id, face] of facesById(diff.added)) {
                    assert.ok(!faces.has(id));
                    faces.set(id, face);
                }
                const sorted = [...faces].sort(([a], [b]) => a - b);
                assert.deepEqual(
                    sorted,
                    [...facesById(to.faces())].sort(([a], [b]) => a - b),
                );
                assert.ok(
                    diff.removed.length > 0 &&
                        diff.added.ids.length > 0 &&
                        diff.tiles.length > 0 &&
                        diff.tiles.length % 3 === 0,
                );
                assert.equal(diff.tooManyTiles, false);
                for (let k = 0; k < diff.added.corners.length; ++k) {
                    assert.ok(diff.added.corners[k] >= diff.low[k % 3] && diff.added.corners[k] <= diff.high[k % 3]);
                    assert.ok(diff.tiles.includes(Math.floor(diff.added.corners[k] / 2)));
                }
            }
            const none = second.diff(second);
            assert.deepEqual([none.removed.length, none.added.ids.length, none.tiles.length], [0, 0, 0]);
            assert.equal(none.removedFaces.ids.length, 0);
            assert.ok(none.low[0] > none.high[0]);
            assert.equal(first.diff(second).tiles.length, 0);
            for (const size of [-1, NaN, 0.01, Infinity]) throwsCode('INVALID', () => first.diff(second, size), /tile/);
            throwsCode('BAD_CALL', () => first.diff(second, '1'));
            for (const after of [undefined, null, 5, {}]) throwsCode('BAD_HANDLE', () => first.diff(after), /world/);
        });
    });
});

test('a history: publish, undo, redo, old versions', () => {
    carving((world, cutter, keep) => {
        const store = keep(firma.openStore(world, Infinity));
        let current = keep(store.current());
        const hashes = [current.hash()];
        for (const position of [
            [8, 4, 4],
            [0, 4, 4],
            [4, 8, 4],
        ]) {
            const { world: after } = current.carve(cutter, { position });
            store.publish(current, keep(after));
            store.publish(after, after);
            current = after;
            hashes.push(after.hash());
        }
        const { bytes, waiting, ...facts } = store.facts();
        assert.deepEqual(facts, { oldest: 0, current: 3, newest: 3, versions: 4 });
        assert.ok(bytes > 0);
        throwsCode('INVALID', () => store.publish(world, keep(world.carve(cutter, atWall).world)), /current version/);
        throwsCode('INVALID', () => store.redo());
        for (const version of [2, 1, 0]) assert.equal(keep(store.undo()).hash(), hashes[version]);
        throwsCode('INVALID', () => store.undo(), /version/);
        assert.equal(store.facts().current, 0);
        assert.equal(keep(store.redo()).hash(), hashes[1]);
        assert.equal(keep(store.current()).hash(), hashes[1]);
        assert.equal(keep(store.at(2)).hash(), hashes[2]);
        assert.equal(keep(store.at(3n)).hash(), hashes[3]);
        throwsCode('INVALID', () => store.at(9), /9/);
        for (const version of [-1, 1.5, '1', undefined]) throwsCode('BAD_CALL', () => store.at(version));
        assert.equal(typeof store.collect(), 'number');
        throwsCode('BAD_HANDLE', () => store.publish(world, null));
        throwsCode('BAD_HANDLE', () => store.publish(cutter, world), /world/);
        const forgetful = keep(firma.openStore(world, 0));
        const before = keep(forgetful.current());
        forgetful.publish(before, keep(before.carve(cutter, atWall).world));
        throwsCode('INVALID', () => forgetful.undo());
        for (const bytesKept of [-1, NaN, '5', undefined, 2n ** 64n])
            throwsCode('BAD_CALL', () => firma.openStore(world, bytesKept));
        for (const one of [undefined, cutter]) throwsCode('BAD_HANDLE', () => firma.openStore(one, 5), /world/);
    });
});
