// SPDX-License-Identifier: MIT
// What needs no browser: the buffers that faces come to and go from, colours, samples, names of levels.
import assert from 'node:assert/strict';
import test from 'node:test';
import { FaceMesh } from '../src/face_mesh.js';
import { levelName } from '../src/load_level.js';
import { kKinds, Painter } from '../src/painter.js';
import { rimOf } from '../src/portal_panes.js';
import { Samples } from '../src/samples.js';

let seed = 1;
const chance = () => (seed = (seed * 48271) % 2147483647) / 2147483647;

/** A convex polygon somewhere, as World.faces() would list it. */
function polygons(ids) {
    const faces = { ids: Uint32Array.from(ids), normals: [], materials: [], sources: [], sourceEdits: [], firstCorners: [], cornerCounts: [], corners: [] };
    for (const id of ids) {
        const count = 3 + Math.floor(chance() * 6);
        const [x, y] = [chance() * 100, chance() * 100];
        faces.firstCorners.push(faces.corners.length / 3);
        faces.cornerCounts.push(count);
        faces.normals.push(0, 0, 1);
        faces.materials.push(0);
        faces.sources.push(id);
        faces.sourceEdits.push(0);
        for (let c = 0; c < count; ++c) {
            const angle = (2 * Math.PI * c) / count;
            faces.corners.push(x + Math.cos(angle), y + Math.sin(angle), id);
        }
    }
    return faces;
}

const painter = { paint: (faces, k, x, y, z, out) => out.set([1, 2, 3, faces.ids[k] % 5]) };

/** Area of each face as drawn: z is its id. Triangles without area are gone ones. */
function drawnAreas(mesh) {
    const areas = new Map();
    const p = mesh.position.array;
    assert.equal(mesh.mesh.geometry.drawRange.count, mesh.used * 3);
    for (let t = 0; t < mesh.used; ++t) {
        const [ax, ay, az, bx, by, bz, cx, cy, cz] = p.subarray(9 * t, 9 * t + 9);
        const area = ((bx - ax) * (cy - ay) - (by - ay) * (cx - ax)) / 2;
        if (area === 0) continue;
        assert.ok(area > 0 && az === bz && bz === cz);
        areas.set(az, (areas.get(az) ?? 0) + area);
        assert.equal(mesh.colour.array[12 * t + 3], az % 5);
    }
    return areas;
}

function areaOf(faces, k) {
    const count = faces.cornerCounts[k];
    return (count / 2) * Math.sin((2 * Math.PI) / count);
}

test('faces come and go, buffers grow, and what is drawn is what is there', () => {
    const mesh = new FaceMesh(undefined, painter);
    const there = new Map();
    let next = 1;
    let most = 0;
    for (let round = 0; round < 60; ++round) {
        const gone = [...there.keys()].filter(() => chance() < 0.2);
        const come = polygons(Array.from({ length: 40 + Math.floor(chance() * 300) }, () => next++));
        mesh.remove(gone);
        mesh.add(come);
        for (const id of gone) there.delete(id);
        come.ids.forEach((id, k) => there.set(id, areaOf(come, k)));
        assert.equal(mesh.faceCount, there.size);
        most = Math.max(most, mesh.triangles);
    }
    const areas = drawnAreas(mesh);
    assert.deepEqual([...areas.keys()].sort((a, b) => a - b), [...there.keys()].sort((a, b) => a - b));
    for (const [id, area] of there) assert.ok(Math.abs(areas.get(id) - area) < 1e-3, `face ${id}`);
    assert.ok(mesh.used < 1.5 * most, `${mesh.used} triangles hold up to ${most}`); // gaps are used again
});

test('more faces than there was room for', () => {
    const mesh = new FaceMesh(undefined, painter);
    const first = mesh.capacity;
    const many = polygons(Array.from({ length: 12000 }, (_, k) => k + 1));
    mesh.add(many);
    assert.ok(mesh.capacity > first);
    const areas = drawnAreas(mesh);
    assert.equal(areas.size, 12000);
    many.ids.forEach((id, k) => assert.ok(Math.abs(areas.get(id) - areaOf(many, k)) < 1e-3));
});

test('only what changed is sent', () => {
    const mesh = new FaceMesh(undefined, painter);
    mesh.add(polygons(Array.from({ length: 1000 }, (_, k) => k + 1)));
    for (const attribute of [mesh.position, mesh.normal, mesh.colour]) attribute.clearUpdateRanges();
    mesh.remove([500]);
    mesh.add(polygons([2000, 2001]));
    for (const attribute of [mesh.position, mesh.normal, mesh.colour]) {
        const sent = attribute.updateRanges.reduce((sum, range) => sum + range.count, 0);
        assert.ok(sent > 0 && sent <= 3 * 6 * 3 * attribute.itemSize, `${sent}`);
    }
});

test('a face that is there twice, or goes without having come, is an error', () => {
    const mesh = new FaceMesh(undefined, painter);
    mesh.add(polygons([1, 2]));
    assert.throws(() => mesh.add(polygons([2])), /face 2/);
    assert.throws(() => mesh.remove([3]), /face 3/);
});

test('colours', () => {
    const painter = new Painter(['wall', 'sky'], (edit, point) => point[2]);
    painter.learn(['wall', 'sky', 'rubble']);
    const faces = { materials: [0, 1, 2], sourceEdits: [0, 0, 7], sources: [0, 1, 2] };
    const paint = (k, z) => {
        const out = new Uint8Array(4);
        painter.paint(faces, k, 0, 0, z, out);
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

test('what one sees through, and what nobody sees', () => {
    const painter = new Painter(['depot/glass', 'depot/liquids/water', 'wall'], () => 0);
    const faces = { materials: [0, 1, 2, 2], masks: [3, 8, 1, 7], sourceEdits: [0, 0, 0, 0], sources: [0, 1, 2, 3] };
    const kinds = faces.materials.map((_, k) => {
        const out = new Uint8Array(4);
        painter.paint(faces, k, 0, 0, 0, out);
        return out[3];
    });
    assert.deepEqual(kinds, [kKinds.glass, kKinds.water, kKinds.hidden, kKinds.panels]);
});

test('the rim of a portal of several polygons has none of the edges between them', () => {
    const polygons = [[0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0], [1, 0, 0, 2, 0, 0, 2, 1, 0, 1, 1, 0]].map((one) => Float64Array.from(one));
    const rim = rimOf(polygons);
    assert.equal(rim.length, 6 * 6);
    for (let k = 0; k < rim.length; k += 6) assert.ok(!(rim[k] === 1 && rim[k + 3] === 1), 'the edge at x = 1 is within');
});
