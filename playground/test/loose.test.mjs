// SPDX-License-Identifier: MIT
// The scenes that the page plays by itself, and what is drawn of pieces that came loose, without a browser.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import path from 'node:path';
import test from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { describeSet, describeShot } from '../src/hud.js';
import { Launcher } from '../src/launcher.js';
import { countChunks, LooseChunks } from '../src/loose_chunks.js';
import { Painter } from '../src/painter.js';
import { Probe } from '../src/probe.js';
import { areaOf, Rooms } from '../src/rooms.js';
import { SetShots } from '../src/set_shots.js';

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');
const index = process.env.FIRMA_JS ?? path.join(root, 'bindings/js/src/index.js');
const { loadFirma } = await import(pathToFileURL(index));
const { loadReaders } = await import(pathToFileURL(path.join(path.dirname(index), 'readers.js')));
const firma = await loadFirma(process.env.FIRMA_WASM ?? path.join(root, 'build/wasm/bin/firma.wasm'));
const readers = await loadReaders(firma);

/** A level with a launcher, whose loose pieces are kept. */
function begin(name, readWorld) {
    const read = readWorld(readFileSync(path.join(root, 'levels', name), 'utf8'));
    const world = read.withAnchors();
    read.release();
    const disposed = [];
    const materials = () => Object.fromEntries(['solid', 'clear'].map((kind) => [kind, { opacity: 1, dispose: () => disposed.push(kind) }]));
    const rooms = new Rooms(world);
    const launcher = new Launcher(firma, world, new Probe(world), (before, after) => {
        rooms.learn(after);
        painter.learn(after.facts().materials);
    }, (given) => loose.add(given));
    const painter = new Painter(launcher.materials, (edit, point) => launcher.depth(edit, point));
    const loose = new LooseChunks(materials, painter);
    return { launcher, rooms, loose, disposed, sets: new SetShots(launcher, rooms, name) };
}

const first = () => begin('first.obj', (text) => readers.worldFromObj(text, { name: 'first.obj' }));

function end({ launcher }) {
    launcher.world.release();
    launcher.store.release();
}

test('the bridge: a shot a step, then its piece, where it was, until it has faded', () => {
    const scene = first();
    const { sets, launcher, loose, disposed } = scene;
    assert.equal(sets.start('no such'), null);
    assert.equal(new SetShots(launcher, scene.rooms, 'other.map').start('bridge'), null);
    const stand = sets.start('bridge');
    assert.equal(stand.feet.length, 3);
    assert.match(describeSet(sets.told), /^the bridge: 0 of 2 shots: shooting$/);
    assert.equal(sets.step(0.2), null);
    assert.deepEqual(sets.step(100).position, [22, 29, 4.75]);
    assert.deepEqual([sets.told.shots, sets.told.after, loose.triangles], [1, null, 0]);
    assert.equal(launcher.last.chunks.count, 0);
    const shot = sets.step(100);
    assert.deepEqual([shot.position, shot.status, shot.chunks.count], [[42, 29, 4.75], 'done', 1]);
    assert.equal(sets.step(100), null);
    // As docs/chunks.md has it.
    assert.ok(Math.abs(sets.told.volume - 29.43) < 0.005 && Math.abs(sets.told.mass - 70638) < 0.5, JSON.stringify(sets.told));
    assert.match(describeSet(sets.told), /^the bridge: 2 of 2 shots: 1 chunk of 29\.43 m\u00b3, 70,638 kg left the level, the largest 29\.43 m\u00b3, 70,638 kg$/);
    assert.match(describeShot({ ...launcher.last, portals: [] }), /; 1 chunk of 29\.43 m\u00b3, 70,638 kg came loose$/);
    assert.equal(launcher.last.report.loose, null);

    // Its surface as it is drawn encloses what it has of volume, and its middle is where the bridge was.
    let volume = 0;
    const middle = [0, 0, 0];
    for (const { geometry, group } of loose.fading[0].meshes.regions.values()) {
        const at = geometry.attributes.position.array;
        const corner = (v) => [0, 1, 2].map((axis) => at[3 * v + axis] + group.position.toArray()[axis] - [32, 29, 4.75][axis]);
        const { array } = geometry.index;
        for (let k = 0; k < array.length; k += 3) {
            const [p, q, r] = [0, 1, 2].map((c) => corner(array[k + c]));
            const six = p[0] * (q[1] * r[2] - q[2] * r[1]) + p[1] * (q[2] * r[0] - q[0] * r[2]) + p[2] * (q[0] * r[1] - q[1] * r[0]);
            volume += six / 6;
            for (let axis = 0; axis < 3; ++axis) middle[axis] += (six / 24) * (p[axis] + q[axis] + r[axis]);
        }
    }
    assert.ok(Math.abs(volume - sets.told.volume) < 1e-3, `${volume}`);
    assert.ok(middle.every((x) => Math.abs(x / volume) < 0.3), `${middle.map((x) => x / volume)}`);

    const opacity = () => loose.fading[0].materials.solid.opacity;
    loose.step(0.5);
    const early = opacity();
    loose.step(1.5);
    assert.ok(early < 1 && early > 0.8 && opacity() < early && opacity() > 0, `${early} ${opacity()}`);
    const [{ meshes }] = loose.fading;
    loose.step(1.5);
    assert.deepEqual([loose.fading.length, loose.triangles, loose.group.children.length, meshes.regions.size, disposed.length], [0, 0, 0, 0, 2]);

    // Undone, shot again, cleared at once; what a stopped scene has left is never shot.
    assert.ok(launcher.undo());
    launcher.shootAt({ position: [42, 29, 4.75], scale: 3, seed: 1 });
    assert.ok(loose.triangles > 0);
    loose.clear();
    assert.deepEqual([loose.triangles, disposed.length], [0, 4]);
    sets.start('bridge');
    sets.stop();
    assert.deepEqual([sets.step(100), sets.told], [null, null]);
    end(scene);
});

test('the wall: the portal and the cast through it are told; a wall within one room has none', () => {
    const depot = begin('depot.map', (text) => {
        const level = readers.levelFromMap(text, { name: 'depot.map' });
        const world = level.world();
        level.release();
        return world;
    });
    depot.sets.start('wall');
    const shot = depot.sets.step(1);
    const { told } = depot.sets;
    assert.deepEqual([told.shots, told.portals.length, told.before.room, told.after.room], [1, 1, 'office_west', 'office_middle']);
    assert.deepEqual(shot.portals, told.portals);
    assert.ok(told.before.distance === 3.25 && Math.abs(told.after.distance - 9.5) < 0.1);
    const { rooms: sides, polygons, open } = depot.rooms.portals[told.portals[0]];
    assert.equal(open, true);
    assert.deepEqual(sides.map((room) => depot.rooms.name(room)).sort(), ['office_middle', 'office_west']);
    assert.ok(areaOf(polygons) > 0.3 && areaOf(polygons) < 1.2);
    end(depot);

    const scene = first();
    scene.sets.start('wall');
    scene.sets.step(1);
    assert.match(describeSet(scene.sets.told), /^the thin wall: one room on both sides, so no portal; a cast met wall in room 0 after 2\.95 m before, meets wall in room 0 after 11\.00 m now$/);
    scene.sets.start('wall'); // there is nothing any more
    scene.sets.step(1);
    assert.match(describeSet(scene.sets.told), /^the thin wall: nothing is left there to shoot at; /);
    end(scene);
});

test('numbers of pieces, and areas', () => {
    assert.deepEqual(countChunks({ loose: null, crumbs: 2 }), { count: 0, volume: 0, mass: 0, largest: { volume: 0, mass: 0 }, crumbs: 2 });
    const loose = { list: () => [{ volume: 1, mass: 5 }, { volume: 2, mass: 9 }, { volume: 3, mass: 8 }] };
    assert.deepEqual(countChunks({ loose, crumbs: 0 }), { count: 3, volume: 6, mass: 22, largest: { volume: 2, mass: 9 }, crumbs: 0 });
    assert.equal(areaOf([Float64Array.of(0, 0, 0, 2, 0, 0, 2, 3, 0, 0, 3, 0), Float64Array.of(0, 0, 0, 0, 1, 0, 0, 0, 1)]), 6.5);
});
