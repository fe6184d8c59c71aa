// SPDX-License-Identifier: MIT
// The scenes that the page plays by itself, and rubble as bodies, without a browser.
import assert from 'node:assert/strict';
import test from 'node:test';
import { countChunks } from '../src/chunk_counts.js';
import { Debris } from '../src/debris.js';
import { meshesOf } from '../src/debris_view.js';
import { describeSet, describeShot } from '../src/hud.js';
import { Launcher } from '../src/launcher.js';
import { kKinds } from '../src/painter.js';
import { Probe } from '../src/probe.js';
import { areaOf, Rooms } from '../src/rooms.js';
import { SetShots } from '../src/set_shots.js';
import { firma, makeWorld } from './engine.mjs';

/** A level with a launcher, whose loose pieces become bodies. */
function begin(name) {
    const world = makeWorld(name);
    const rooms = new Rooms(world);
    const told = { added: 0, removed: 0 };
    const launcher = new Launcher(firma, world, new Probe(world), (before, after) => rooms.learn(after),
        (cutter, pose) => debris.blast(launcher.world, pose.position, pose.scale));
    const debris = new Debris(firma, launcher.matters, ({ added, removed }) => {
        told.added += added.length;
        told.removed += removed.length;
    });
    launcher.carve = (before, cutter, pose) => debris.carve(before, cutter, pose);
    return { launcher, rooms, debris, told, sets: new SetShots(launcher, rooms, name) };
}

function end({ launcher, debris }) {
    debris.release();
    launcher.world.release();
    launcher.store.release();
}

/** No sphere's worth of a body is in rock: its middle is in air, and none has left the level. */
function assertClear({ launcher, debris }) {
    const { low, high } = launcher.world.facts();
    for (const { id, at } of debris.pieces.values()) {
        assert.ok(at.every((x, axis) => x >= low[axis] && x <= high[axis]), `out of the level at ${at}`);
        assert.equal(debris.bodies.get(id).stuck, false, `stuck at ${at}`);
    }
}

test('the bridge: a shot a step, then its piece falls, breaks, comes to rest on the floor', () => {
    const before = firma.liveHandles();
    const scene = begin('first.obj');
    const { sets, launcher, debris, told: changes } = scene;
    assert.equal(sets.start('no such'), null);
    assert.equal(new SetShots(launcher, scene.rooms, 'other.map').start('bridge'), null);
    const stand = sets.start('bridge');
    assert.equal(stand.feet.length, 3);
    assert.match(describeSet(sets.told), /^the bridge: 0 of 2 shots: shooting$/);
    assert.equal(sets.step(0.2), null);
    assert.deepEqual(sets.step(100).position, [22, 29, 4.75]);
    assert.deepEqual([sets.told.shots, sets.told.after, debris.pieces.size], [1, null, 0]);
    assert.equal(launcher.last.chunks.count, 0);
    const shot = sets.step(100);
    assert.deepEqual([shot.position, shot.status, shot.chunks.count], [[42, 29, 4.75], 'done', 1]);
    assert.equal(sets.step(100), null);
    // As docs/chunks.md has it.
    assert.ok(Math.abs(sets.told.volume - 29.43) < 0.005 && Math.abs(sets.told.mass - 70638) < 0.5, JSON.stringify(sets.told));
    assert.match(describeSet(sets.told), /^the bridge: 2 of 2 shots: 1 chunk of 29\.43 m\u00b3, 70,638 kg left the level, the largest 29\.43 m\u00b3, 70,638 kg$/);
    assert.match(describeShot({ ...launcher.last, portals: [] }), /; 1 chunk of 29\.43 m\u00b3, 70,638 kg came loose$/);
    assert.equal(launcher.last.report.loose, null);

    const mass = () => [...debris.pieces.values()].reduce((sum, piece) => sum + piece.mass, 0);
    const [whole] = debris.pieces.values();
    assert.ok(Math.abs(mass() - 70638) < 0.5 && Math.abs(whole.at[2] - 4.75) < 0.3, `${mass()} kg at ${whole.at}`);
    const hits = [];
    let seconds = 0;
    for (; seconds < 20 && (debris.moving || seconds < 0.5); seconds += 1 / 30) {
        hits.push(...debris.step({ world: launcher.world }, 1 / 30));
        assertClear(scene);
    }
    assert.ok(!debris.moving, 'at rest');
    assert.ok(hits.some(({ speed }) => speed > 5), 'it came down hard');
    assert.ok(debris.pieces.size >= 2 && debris.pieces.size <= 16, `${debris.pieces.size} pieces`);
    assert.deepEqual([changes.added - changes.removed, changes.removed > 0], [debris.pieces.size, true]);
    assert.ok(mass() < 70638.5 && mass() > 0.98 * 70638, `${mass()} kg are left`); // but for dust
    for (const { at, size } of debris.pieces.values()) assert.ok(at[2] < Math.max(1, size), `${at}`);

    // What lies there is cut and thrown by the next blast.
    const [largest] = [...debris.pieces.values()].sort((a, b) => b.mass - a.mass);
    const pieces = debris.pieces.size;
    launcher.shootAt({ position: [largest.at[0], largest.at[1], largest.at[2] + 0.3], scale: 1.2, seed: 5 });
    assert.ok(!debris.pieces.has(largest.id) && debris.pieces.size >= pieces, 'cut');
    assert.ok(debris.moving);

    // Undone, it is part of the level again; a snapshot of nothing is left.
    launcher.undo();
    debris.undo(launcher.world.facts().version);
    assert.ok(debris.pieces.size >= pieces, 'the shot that was undone cut nothing loose');
    launcher.undo();
    debris.undo(launcher.world.facts().version);
    assert.equal(debris.pieces.size, 0);
    sets.start('bridge');
    sets.stop();
    assert.deepEqual([sets.step(100), sets.told], [null, null]);
    end(scene);
    assert.equal(firma.liveHandles(), before);
});

/** Kinds of surface (painter.js) that are drawn of a piece: of the faces of its cracks, and of those that craters left. */
function drawnOf(piece) {
    const { ids, materials, sourceEdits } = piece.world.faces();
    const faces = new Map(Array.from(ids, (id, k) => [id, { crack: materials[k] === piece.names.length - 1, cut: sourceEdits[k] > 0 }]));
    const drawn = { cracks: new Set(), craters: new Set() };
    for (const { geometry, ids: of } of meshesOf(piece.world, piece.names, { bodies: {} }, () => 0).regions.values()) {
        const surface = geometry.getAttribute('surface').array;
        geometry.index.array.forEach((vertex, corner) => {
            const { crack, cut } = faces.get(of[Math.floor(corner / 3)]);
            if (crack || cut) drawn[crack ? 'cracks' : 'craters'].add(surface[4 * vertex + 3]);
        });
    }
    return drawn;
}

test('steel and concrete of the depot: pieces break as their matter does, are drawn as it inside, and come to rest', () => {
    const scene = begin('depot.map');
    const { sets, launcher, debris } = scene;
    sets.start('bridge');
    sets.step(100);
    sets.step(100);
    assert.ok(debris.pieces.size >= 2);
    for (const z of [1.3, 8.4]) launcher.shootAt({ position: [18.5, 3.25, z], scale: 1.2, seed: 3 }); // a pillar's foot and head
    const whole = { steel: [], concrete: [] };
    for (const piece of debris.pieces.values()) {
        whole[piece.matter].push(piece);
        assert.ok(piece.world.faces().materials.every((material) => material < piece.names.length - 1), 'no cracks yet');
        assert.deepEqual([...drawnOf(piece).craters], [kKinds[piece.matter]]);
    }
    assert.ok(whole.steel.length > 0 && whole.concrete.length > 0);
    let seconds = 0;
    for (; seconds < 15 && (debris.moving || seconds < 0.5); seconds += 1 / 30) debris.step({ world: launcher.world }, 1 / 30);
    assert.ok(!debris.moving, 'at rest');
    assertClear(scene);
    assert.ok([...debris.pieces.values()].some(({ breaks, matter }) => breaks > 0 && matter === 'steel'), 'broken by the fall');
    const [pillar] = [...debris.pieces.values()].filter(({ matter }) => matter === 'concrete').sort((a, b) => b.mass - a.mass);
    launcher.shootAt({ position: pillar.at, scale: 1.2, seed: 5 });
    const broken = { steel: 0, concrete: 0 };
    for (const piece of debris.pieces.values()) {
        if (piece.breaks === 0) continue;
        ++broken[piece.matter];
        assert.deepEqual([...drawnOf(piece).cracks], [kKinds[piece.matter]], piece.matter);
    }
    assert.ok(broken.steel >= 2 && broken.concrete >= 3, JSON.stringify(broken));
    end(scene);
});

test('the wall: the portal and the cast through it are told; a wall within one room has none', () => {
    const depot = begin('depot.map');
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

    const scene = begin('first.obj');
    scene.sets.start('wall');
    scene.sets.step(1);
    assert.match(describeSet(scene.sets.told), /^the thin wall: one room on both sides, so no portal; a cast met wall in room 0 after 2\.95 m before, meets wall in room 0 after 11\.00 m now$/);
    scene.sets.start('wall'); // there is nothing any more
    scene.sets.step(1);
    assert.match(describeSet(scene.sets.told), /^the thin wall: nothing is left there to shoot at; /);
    end(scene);
});

test('numbers of pieces, and areas', () => {
    assert.deepEqual(countChunks({ chunks: 0, chunkVolume: 0, crumbs: 2, largest: 0 }), { count: 0, volume: 0, mass: 0, largest: { volume: 0, mass: 0 }, crumbs: 2 });
    assert.deepEqual(countChunks({ chunks: 3, chunkVolume: 2, crumbs: 0, largest: 3600 }), { count: 3, volume: 2, mass: 4800, largest: { volume: 1.5, mass: 3600 }, crumbs: 0 });
    assert.equal(areaOf([Float64Array.of(0, 0, 0, 2, 0, 0, 2, 3, 0, 0, 3, 0), Float64Array.of(0, 0, 0, 0, 1, 0, 0, 0, 1)]), 6.5);
});
