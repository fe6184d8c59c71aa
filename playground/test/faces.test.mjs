// SPDX-License-Identifier: MIT
// What needs no browser: the buffers of regions, the picture of bumps, colours, samples, names of levels.
import assert from 'node:assert/strict';
import test from 'node:test';
import { makeHeights, makePixels } from '../src/detail_texture.js';
import { levelName } from '../src/load_level.js';
import { kKinds, Painter } from '../src/painter.js';
import { rimOf } from '../src/portal_panes.js';
import { RegionMeshes } from '../src/region_meshes.js';
import { Samples } from '../src/samples.js';

/** A square somewhere for each id, as a mesh of World.regionMeshes(): those above 1000 are of an edit. */
function regionOf(place, ids) {
    const size = 16;
    const own = [...ids].sort((a, b) => (a > 1000) - (b > 1000) || a - b);
    const positions = own.flatMap((id) => [0, 0, id, 1, 0, id, 1, 1, id, 0, 1, id]);
    const each = (value) => Uint32Array.from(own, value);
    const runs = [false, true].map((cut) => {
        const count = own.filter((id) => id > 1000 === cut).length;
        const first = cut ? own.length - count : 0;
        return { material: 0, cut, twoSided: false, uvUnit: cut ? 'metres' : 'repeats', firstTriangle: 2 * first, triangleCount: 2 * count };
    });
    return {
        place, origin: place.map((x) => size * x), low: place.map((x) => size * x), high: place.map((x) => size * x + 1),
        positions: Float32Array.from(positions),
        normals: Float32Array.from(own.flatMap(() => [0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1])),
        tangents: Float32Array.from(own.flatMap(() => Array(4).fill([1, 0, 0, 1]).flat())),
        uvs: Float32Array.from(own.flatMap(() => Array(8).fill(3))),
        blends: new Uint8Array(16 * own.length),
        corners: Uint32Array.from(own.flatMap((_, k) => [0, 1, 2, 0, 2, 3].map((c) => 4 * k + c))),
        faces: Uint32Array.from(own.flatMap((id) => [id, id])),
        runs: runs.filter((run) => run.triangleCount > 0),
        parts: {
            faces: each((id) => id), sources: each((id) => id), sourceEdits: each((id) => (id > 1000 ? 7 : 0)),
            firstTriangles: each((_, k) => 2 * k), triangleCounts: each(() => 2), firstVertices: each((_, k) => 4 * k), vertexCounts: each(() => 4),
        },
    };
}

const painter = { paint: (face, x, y, z, out) => out.set([face.sourceEdit, x, z % 256, face.source % 5]) };

test('regions are put in, replaced and taken out, and no other is touched', () => {
    const meshes = new RegionMeshes({}, painter);
    meshes.replace([regionOf([0, 0, 0], [1, 2, 3]), regionOf([1, 0, -1], [4])]);
    assert.deepEqual([meshes.faceCount, meshes.triangles, meshes.group.children.length, meshes.sent], [4, 8, 2, 16]);
    const other = meshes.regions.get('0,0,0').geometry;
    const old = meshes.regions.get('1,0,-1').geometry;
    let disposed = 0;
    old.addEventListener('dispose', () => ++disposed);
    meshes.replace([regionOf([1, 0, -1], [5, 1001])]);
    assert.equal(meshes.regions.get('0,0,0').geometry, other);
    assert.deepEqual([meshes.faceCount, meshes.sent, disposed], [5, 8, 1]);
    const { group, geometry, faces, ids } = meshes.regions.get('1,0,-1');
    assert.deepEqual([...faces], [5, 1001]);
    assert.deepEqual([...ids], [5, 5, 1001, 1001]);
    assert.deepEqual(group.position.toArray(), [16, 0, -16]);
    assert.equal(group.children.length, 1, 'nothing to see through');
    assert.deepEqual([...geometry.getAttribute('surface').array.subarray(0, 8)], [0, 16, 245, 0, 0, 17, 245, 0]);
    assert.deepEqual([...geometry.getAttribute('surface').array.subarray(16, 20)], [7, 16, 1001 - 16 - 768, 1]);
    assert.deepEqual([...geometry.getAttribute('uv').array.subarray(6, 10)], [3, 3, 1.5, 1.5], 'metres become repeats');
    meshes.replace([regionOf([0, 0, 0], []), regionOf([9, 9, 9], [])]);
    assert.deepEqual([meshes.faceCount, meshes.triangles, meshes.regions.size, meshes.group.children.length], [2, 4, 1, 1]);
});

test('what one sees through is drawn once more, from the same buffers', () => {
    const glass = { paint: (face, x, y, z, out) => out.set([1, 1, 1, face.source === 2 ? kKinds.glass : kKinds.rock]) };
    const meshes = new RegionMeshes({}, glass);
    meshes.replace([regionOf([0, 0, 0], [1, 2])]);
    const { group, geometry } = meshes.regions.get('0,0,0');
    assert.deepEqual(group.children.map((mesh) => mesh.geometry), [geometry, geometry]);
});

test('the picture of bumps goes on where it ends', () => {
    const size = 64;
    const heights = makeHeights(size);
    const [least, most] = [Math.min(...heights), Math.max(...heights)];
    assert.deepEqual([least, most], [0, 1]);
    const step = (x, y, u, v) => Math.abs(heights[size * (y % size) + (x % size)] - heights[size * (v % size) + (u % size)]);
    let within = 0;
    let across = 0;
    for (let k = 0; k < size; ++k) {
        for (let j = 0; j + 1 < size; ++j) within = Math.max(within, step(j, k, j + 1, k), step(k, j, k, j + 1));
        across = Math.max(across, step(size - 1, k, size, k), step(k, size - 1, k, size));
    }
    assert.ok(across <= within, `${across} where it goes on, ${within} elsewhere`);
    const pixels = makePixels(heights, size);
    assert.equal(pixels.length, 4 * size * size);
    const mean = (channel) => pixels.reduce((sum, p, k) => sum + (k % 4 === channel ? p : 0), 0) / (size * size);
    assert.ok(Math.abs(mean(0) - 128) < 2 && Math.abs(mean(1) - 128) < 2, 'level on the whole');
});

test('colours', () => {
    const painter = new Painter(['wall', 'sky'], (edit, point) => point[2]);
    painter.learn(['wall', 'sky', 'rubble']);
    const paint = (k, z) => {
        const out = new Uint8Array(4);
        painter.paint({ material: k, source: k, sourceEdit: [0, 0, 7][k] }, 0, 0, z, out);
        return [...out];
    };
    assert.equal(paint(0, 0)[3], kKinds.panels);
    assert.equal(paint(1, 0)[3], kKinds.sky);
    const [rim, deep] = [paint(2, 0), paint(2, 1)];
    assert.equal(rim[3], kKinds.rock);
    for (const channel of [0, 1, 2]) assert.ok(deep[channel] < 0.75 * rim[channel]); // craters are darker inside
});

test('samples', () => {
    const samples = new Samples(4);
    assert.ok(Number.isNaN(samples.median()) && Number.isNaN(samples.least()));
    for (const value of [9, 1, 5]) samples.add(value);
    assert.deepEqual([samples.least(), samples.median(), samples.last, samples.count], [1, 5, 5, 3]);
    for (const value of [7, 3]) samples.add(value); // 9 falls out
    assert.deepEqual([samples.least(), samples.median(), samples.last, samples.count], [1, 4, 3, 4]);
});

test('levels are files beside the page', () => {
    assert.equal(levelName(''), 'depot.map');
    assert.equal(levelName('?level=first.obj'), 'first.obj');
    assert.equal(levelName('?level=My%20map_2.bsp'), 'My map_2.bsp');
    assert.equal(levelName('?level=a.FIRMA&x=1'), 'a.FIRMA');
    for (const bad of ['../first.obj', 'a/b.obj', '/etc/passwd', 'http://example.com/a.obj', 'first.txt', '', '.obj', 'a.obj/', 'a\\b.obj', '//x/a.obj'])
        assert.throws(() => levelName(`?level=${encodeURIComponent(bad)}`), /a level is/, bad);
});

test('what one sees through', () => {
    const painter = new Painter(['depot/glass', 'depot/liquids/water', 'wall'], () => 0);
    const kinds = [0, 1, 2].map((material) => {
        const out = new Uint8Array(4);
        painter.paint({ material, source: material, sourceEdit: 0 }, 0, 0, 0, out);
        return out[3];
    });
    assert.deepEqual(kinds, [kKinds.glass, kKinds.water, kKinds.panels]);
});

test('the rim of a portal of several polygons has none of the edges between them', () => {
    const polygons = [[0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0], [1, 0, 0, 2, 0, 0, 2, 1, 0, 1, 1, 0]].map((one) => Float64Array.from(one));
    const rim = rimOf(polygons);
    assert.equal(rim.length, 6 * 6);
    for (let k = 0; k < rim.length; k += 6) assert.ok(!(rim[k] === 1 && rim[k + 3] === 1), 'the edge at x = 1 is within');
});
