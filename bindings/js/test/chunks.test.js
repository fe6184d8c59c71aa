// SPDX-License-Identifier: MIT
// A bridge shot at both ends: its middle comes loose, is asked and cut as a world of its own, and becomes ground.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { boxMesh, firma, releasing, throwsCode } from './helpers.js';

const here = { position: [0, 0, 0] };
const boxCutter = (low, high) => {
    const { positions, corners } = boxMesh(low, high);
    const triangles = [];
    for (let k = 0; k < corners.length; k += 4) {
        const [a, b, c, d] = corners.slice(k, k + 4);
        triangles.push(a, c, b, a, d, c);
    }
    return firma.cutterFromMesh(positions, triangles);
};

/** work(world, blade, release later): the room with a bridge whose one end is cut, and what cuts the other. */
const withBridge = (work) =>
    releasing(
        [
            firma.worldFromMesh(boxMesh()),
            boxCutter([-0.5, 3, 2], [8.5, 5, 2.5]),
            boxCutter([0.5, 2, 1], [1, 6, 3]),
            boxCutter([7, 2, 1], [7.5, 6, 3]),
        ],
        (room, bar, first, second) => {
            const bridge = room.carve(bar, here, { fill: true, material: 'plaster' }).world;
            const cut = bridge.carve(first, here, { chunks: true });
            assert.equal(cut.report.loose, null);
            const kept = [bridge, cut.world];
            releasing(kept, () => work(cut.world, second, (object) => (kept.push(object), object)));
        },
    );

test('a chunk leaves with its mass, and is a world', () => {
    withBridge((world, blade, keep) => {
        const { world: after, report } = world.carve(blade, here, { chunks: { density: 1000 } });
        keep(after).check();
        assert.deepEqual([report.chunks, report.chunkVolume, report.crumbs, report.crumbVolume], [1, 6, 0, 0]);
        const loose = keep(report.loose);
        const [chunk, ...others] = loose.list();
        assert.deepEqual(others, []);
        assert.deepEqual([chunk.volume, chunk.mass, chunk.faceCount], [6, 6000, 6]);
        assert.deepEqual(chunk.origin.map((at, axis) => at + chunk.centre[axis]), [4, 4, 2.25]);
        assert.deepEqual(chunk.low.map((at, axis) => at + chunk.origin[axis]), [1, 3, 2]);
        const about = (a, b) => (6000 / 12) * (a * a + b * b);
        for (const [k, moment] of [[0, about(2, 0.5)], [4, about(6, 0.5)], [8, about(6, 2)]])
            assert.ok(Math.abs(chunk.inertia[k] - moment) < 1e-9);
        const piece = keep(loose.world(0));
        const hit = piece.cast({ centre: [0, 0, 2], radius: 0, path: [0, 0, -4] });
        assert.equal(piece.material(hit.material), 'plaster');
        assert.equal(piece.triangles().faces.length, 12);
        assert.deepEqual(piece.mass(1000), { volume: 6, mass: 6000, centre: chunk.centre, inertia: chunk.inertia });
        throwsCode('OUT_OF_RANGE', () => loose.world(1), /no such chunk/);
        throwsCode('BAD_CALL', () => loose.world(-1), /chunk/);
        throwsCode('OUT_OF_RANGE', () => piece.mass(NaN), /density/);
        assert.equal(world.mass(1).volume, 0); // rock that reaches to infinity

        const { world: broken } = keep(piece).carve(keep(boxCutter([-1, -3, -3], [1, 3, 3])), here);
        const halves = keep(keep(broken).pieces(500));
        assert.deepEqual(halves.list().map(({ volume, mass, origin }) => [volume, mass, origin]), [
            [2, 1000, [0, 0, 0]],
            [2, 1000, [0, 0, 0]],
        ]);
        keep(halves.world(1)).check();
    });
});

test('a chunk put back is the ground that it was', () => {
    withBridge((world, blade, keep) => {
        const hanging = keep(world.carve(blade, here).world);
        const { world: after, report } = world.carve(blade, here, { chunks: true });
        const loose = keep(report.loose);
        const piece = keep(loose.world(0));
        const position = loose.list()[0].origin;
        const rest = firma.cutterAtRest(piece, { position }, 'middle');
        keep(rest.cutter);
        assert.deepEqual([rest.volumeChange, rest.mended, rest.pose.scale], [0, 0, 1]);
        const put = keep(after).carve(rest.cutter, rest.pose, { fill: true });
        assert.ok(keep(put.world).sameSolid(hanging));
        const turned = firma.cutterAtRest(piece, { position: [4, 4, 1], rotation: [0, 0, 0.1, 1] });
        keep(turned.cutter);
        const ground = after.carve(turned.cutter, turned.pose, { fill: true });
        keep(ground.world).check();
        assert.ok(Math.abs(ground.report.volume + 6 + turned.volumeChange) < 1e-9);
        throwsCode('INVALID', () => firma.cutterAtRest(after, here), /infinity/);
        throwsCode('OUT_OF_RANGE', () => firma.cutterAtRest(piece, { position: [NaN, 0, 0] }));
        throwsCode('BAD_HANDLE', () => firma.cutterAtRest(blade, here), /./);
        throwsCode('BAD_CALL', () => firma.cutterAtRest(piece, { at: 5 }), /there is no at/);
    });
});

test('chunks of jobs and of several edits; crumbs; options', () => {
    withBridge((world, blade, keep) => {
        const { world: after, report } = world.carve(blade, here, { chunks: { minVolume: 7 } });
        assert.deepEqual([report.chunks, report.crumbs, report.crumbVolume, report.loose], [0, 1, 6, null]);
        keep(after);
        const job = keep(world.startCarve(blade, here, { chunks: true }));
        while (!job.run(0));
        for (let twice = 0; twice < 2; ++twice) {
            const result = job.result();
            keep(result.world);
            assert.equal(keep(result.report.loose).list()[0].volume, 6);
        }
        const edit = keep(world.edit());
        assert.equal(keep(edit.carve(blade, here, { chunks: true }).loose).list().length, 1);
        assert.equal(keep(edit.finish()).hash(), after.hash());
        const numbered = keep(world.carve(blade, here, { edit: 90, chunks: false }).world);
        assert.equal(numbered.facts().edits, 90);
        const again = numbered.carve(blade, { position: [-3, 0, 0] }, { edit: 90 });
        keep(again.world);
        assert.equal(again.report.status, 'refused');
        for (const chunks of [null, 5, 'yes', { volume: 1 }, { density: 'x' }])
            throwsCode('BAD_CALL', () => world.carve(blade, here, { chunks }));
        throwsCode('INVALID', () => world.carve(blade, here, { chunks: { minVolume: -1 } }), /min_chunk_volume/);
        throwsCode('INVALID', () => world.carve(blade, here, { chunks: { density: Infinity } }), /density/);
        throwsCode('BAD_CALL', () => world.carve(blade, here, { edit: -1 }), /edit/);
    });
});

test('chunks of commands', () => {
    withBridge((world, blade, keep) => {
        const options = { fill: false, material: '', edit: 5, chunks: { minVolume: 2, density: 3 } };
        const command = keep(firma.editCommand(5, blade, here, options));
        assert.deepEqual(command.facts().options, options);
        const group = keep(firma.groupCommand([command, keep(firma.editCommand(6, blade, { position: [-2, 0, 0] }))]));
        for (const one of [command, group]) {
            const result = world.apply(one);
            keep(result.world);
            assert.deepEqual(keep(result.report.loose).list().map(({ volume, mass }) => [volume, mass]), [[6, 18]]);
        }
    });
});

test('anchors hold', () => {
    withBridge((world, blade, keep) => {
        const loose = (anchors) => {
            const held = keep(world.withAnchors(anchors));
            assert.equal(held.hash(), world.hash());
            const { world: after, report } = held.carve(blade, here, { chunks: true });
            keep(after);
            if (report.loose) keep(report.loose);
            return report.chunks;
        };
        assert.equal(loose(), 1);
        assert.equal(loose({ hanging: false, materials: ['no such material'], sources: [77] }), 1);
        assert.equal(loose({ materials: ['plaster'] }), 0);
        const everywhere = { low: [-99, -99, -99], high: [99, 99, 99] };
        assert.equal(loose({ volumes: [{ low: [0, 0, 80], high: [1, 1, 81] }, everywhere] }), 0);
        assert.equal(loose({ volumes: [{ low: [0, 0, 80], high: [1, 1, 81] }, { low: [NaN, 0, 0], high: [1, 1, 1] }] }), 1);
        throwsCode('BAD_CALL', () => world.withAnchors({ material: 'plaster' }), /there is no material/);
        throwsCode('BAD_CALL', () => world.withAnchors({ materials: [5] }), /materials/);
        throwsCode('BAD_CALL', () => world.withAnchors({ sources: [-1] }), /sources/);
        throwsCode('BAD_CALL', () => world.withAnchors({ hanging: 0 }), /hanging/);
        throwsCode('BAD_CALL', () => world.withAnchors({ volumes: everywhere }), /volumes must be an array/);
        throwsCode('BAD_CALL', () => world.withAnchors({ volumes: [everywhere, undefined] }), /volume 1: the volume must be an object/);
        throwsCode('BAD_CALL', () => world.withAnchors({ volumes: [{ low: [0, 0], high: [1, 1, 1] }] }), /volume 0: low/);
        throwsCode('BAD_CALL', () => world.withAnchors({ volumes: [{ ...everywhere, hardness: 1 }] }), /there is no hardness/);
    });
});
