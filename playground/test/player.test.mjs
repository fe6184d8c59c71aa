// SPDX-License-Identifier: MIT
// Somebody walks through our level, by node alone: never into a wall, not even with craters all over.
import assert from 'node:assert/strict';
import test from 'node:test';
import { Launcher } from '../src/launcher.js';
import { kCentres, kRadius, Player } from '../src/player.js';
import { Probe } from '../src/probe.js';
import { Rooms } from '../src/rooms.js';
import { findSpawn, startOf } from '../src/spawn.js';
import { direction } from '../src/vector.js';
import { firma, readers, readLevel } from './engine.mjs';

const level = readLevel('first.obj');

let seed = 7;
const chance = () => (seed = (seed * 48271) % 2147483647) / 2147483647;

function begin(text = level, name = 'first.obj') {
    const world = readers.worldFromObj(text, { name });
    const probe = new Probe(world);
    const player = new Player(firma, probe);
    const launcher = new Launcher(firma, world, probe, () => {});
    const spawn = findSpawn(player, world, name);
    player.place(spawn.feet);
    player.look(spawn.yaw, spawn.pitch);
    return { world, probe, player, launcher, spawn };
}

/** No sphere is in rock or nearer to a face than its radius, but for rounding. */
function assertClear({ player, probe }) {
    for (const height of kCentres) {
        const centre = [player.feet[0], player.feet[1], player.feet[2] + height];
        assert.notEqual(probe.world.locate(centre).where, 'solid', `in rock at ${centre}`);
        const near = probe.world.closest(centre, 2);
        assert.ok(!near || near.distance >= kRadius - 1e-9, `${near?.distance} m from a face at ${centre}`);
    }
}

/** Walks to a place in a straight line; whether it got there. */
function walkTo(game, x, y, seconds = 12) {
    for (let t = 0; t < seconds; t += 1 / 60) {
        const [dx, dy] = [x - game.player.feet[0], y - game.player.feet[1]];
        if (Math.hypot(dx, dy) < 0.12) return true;
        game.player.look(Math.atan2(dy, dx), 0);
        game.player.step(1 / 60, { forward: true });
    }
    return false;
}

test('no gap between the spheres', () => {
    assert.ok(kCentres[0] <= kRadius + 1e-9);
    for (let k = 1; k < kCentres.length; ++k) assert.ok(kCentres[k] - kCentres[k - 1] < 1.5 * kRadius);
});

test('stands on the floor, and stays there', () => {
    const game = begin();
    game.player.step(1, {});
    const { feet } = game.player;
    assert.ok(game.player.grounded);
    assert.ok(Math.abs(feet[2]) < 0.005);
    game.player.step(5, {});
    assert.deepEqual(game.player.feet.map((x) => x.toFixed(6)), feet.map((x) => x.toFixed(6)));
    assertClear(game);
});

test('through doors, up the stairs, over the bridge, down the tunnel', () => {
    const game = begin();
    const way = [[12.5, 25.75, 0], [11.5, 23.75, 0], [8.5, 23.75, 0], [5, 27, 0], [5, 36.5, 2.5], [7.2, 36.5, 2.5], [13, 36.5, 5], [16, 29, 5],
        [40, 29, 5], [47, 29, 5], [53.8, 29, 5], [70, 29.2, 0.3], [75, 27, 0], [75, 20, 0]];
    for (const [x, y, z] of way) {
        assert.ok(walkTo(game, x, y), `to ${x}, ${y}: at ${game.player.feet}`);
        assert.ok(Math.abs(game.player.feet[2] - z) < 0.7, `at ${game.player.feet}`);
        assertClear(game);
    }
    assert.ok(walkTo(game, 75, 23) && walkTo(game, 75, 27) && walkTo(game, 70, 29.2) && walkTo(game, 53.8, 29), 'and back up');
});

test('jumps, and comes down again', () => {
    const game = begin();
    game.player.step(0.2, {});
    let top = 0;
    game.player.step(1 / 60, { jump: true });
    for (let k = 0; k < 120; ++k) {
        game.player.step(1 / 60, {});
        top = Math.max(top, game.player.feet[2]);
    }
    assert.ok(top > 0.8 && top < 1.2, `${top}`);
    assert.ok(game.player.grounded && Math.abs(game.player.feet[2]) < 0.005);
});

test('slides along a wall', () => {
    const game = begin();
    game.player.place([43, 31.5, 0.01]);
    game.player.look(0.6, 0); // toward the wall at x = 44, askew
    game.player.step(1.5, { forward: true });
    const [x, y] = game.player.feet;
    assert.ok(Math.abs(x - (44 - kRadius)) < 0.01, `${x}`);
    assert.ok(y > 34, `${y}`);
    assertClear(game);
});

test('never into a wall: wandering, running, jumping, firing, undoing', () => {
    const game = begin();
    const { player, launcher } = game;
    let craters = 0;
    let undone = 0;
    for (let k = 0; k < 2500; ++k) {
        if (k % 8 === 0) player.look(chance() * 7, (chance() - 0.5) * 2);
        const keys = { forward: chance() < 0.9, left: chance() < 0.2, right: chance() < 0.2, run: chance() < 0.4, jump: chance() < 0.2 };
        player.step(1 / 30, keys);
        assertClear(game);
        if (k % 12 === 5 && launcher.fire(player.eye(), direction(player.yaw, player.pitch)).status === 'done') ++craters;
        if (k % 100 === 99) {
            for (let n = 0; n < 5; ++n) undone += launcher.undo();
            if (!player.freeYourself()) player.place(game.spawn.feet);
            if (k % 200 === 199) launcher.redo();
            if (!player.freeYourself()) player.place(game.spawn.feet);
        }
        assertClear(game);
    }
    launcher.world.check();
    assert.ok(craters > 100 && undone > 50, `${craters} craters, ${undone} undone`);
});

test('undo puts nobody into rock', () => {
    const game = begin();
    const { player, launcher } = game;
    assert.ok(walkTo(game, 43, 33));
    player.look(0, -0.15);
    for (let k = 0; k < 8 && player.feet[0] < 44.6; ++k) { // a niche in the thick wall at x = 44
        assert.equal(launcher.fire(player.eye(), direction(0, -0.25 + 0.1 * (k % 3))).status, 'done');
        player.look(0, -0.15);
        player.step(1, { forward: true });
        assertClear(game);
    }
    assert.ok(player.feet[0] > 44.4, `${player.feet}`);
    const inside = [...player.feet];
    while (launcher.undo());
    assert.equal(player.isFree(inside), false);
    assert.ok(player.freeYourself());
    assert.ok(player.feet[0] <= 44 - kRadius);
    assertClear(game);
});

test('the sky is not carved, and a shot at nothing is none', () => {
    const game = begin();
    game.player.place([60, -8, 0.5]);
    const before = game.launcher.world.hash();
    assert.equal(game.launcher.fire(game.player.eye(), [0, 0, 1]).status, 'sky');
    assert.equal(game.launcher.world.hash(), before);
    assert.equal(game.launcher.undo(), false);
    assert.equal(game.launcher.redo(), false);
});

test('a level nobody knows: begins on its floor', () => {
    const corner = (k) => [k & 1 ? 9 : 0, k & 2 ? 7 : 0, k & 4 ? 4 : 0];
    const faces = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]];
    const text = [...Array(8).keys()].map((k) => `v ${corner(k).join(' ')}\n`).join('') + faces.map((f) => `f ${f.map((k) => k + 1).join(' ')}\n`).join('');
    const game = begin(text, 'box.obj');
    assertClear(game);
    game.player.step(0.5, {});
    assert.ok(game.player.grounded && Math.abs(game.player.feet[2]) < 0.01);
});

test('no handle is left behind', () => {
    const before = firma.liveHandles();
    const game = begin();
    for (let k = 0; k < 6; ++k) game.launcher.fire(game.player.eye(), direction(k, 0));
    while (game.launcher.undo());
    game.launcher.redo();
    assert.equal(firma.liveHandles(), before + 3); // the player's shape, the store, and the world of the moment
    game.player.release();
    game.launcher.world.release();
    game.launcher.store.release();
    assert.equal(firma.liveHandles(), before);
});

test('the depot: begins where its author says, rooms on the way, through a closed portal nobody goes', () => {
    const text = readLevel('depot.map');
    const level = readers.levelFromMap(text, { name: 'depot.map' });
    const start = startOf(level.entities());
    assert.deepEqual(start, { point: [18.75, 7, 1], yaw: Math.PI });
    const world = level.world();
    level.release();
    const probe = new Probe(world);
    const player = new Player(firma, probe);
    const launcher = new Launcher(firma, world, probe, (before, after) => rooms.learn(after));
    const rooms = new Rooms(world);
    const spawn = findSpawn(player, world, 'depot.map', start);
    player.place(spawn.feet);
    player.step(0.5, {});
    assert.ok(player.grounded && Math.hypot(player.feet[0] - 18.75, player.feet[1] - 7) < 0.01);
    const game = { player, probe };
    const here = () => rooms.name(rooms.locate(player.eye()));
    assert.equal(here(), 'hall');
    assert.ok(walkTo(game, 18.75, 9.4) && walkTo(game, 25, 9.4) && walkTo(game, 25, 10.5) && walkTo(game, 29.5, 10.5));
    assert.equal(here(), 'dock');
    const gate = rooms.portalAlong(player.eye(), [-1, 0, 0], 5);
    assert.match(rooms.portals[gate.portal].name, /^hall_dock/);
    assert.ok(Math.abs(gate.distance - (29.5 - 26.5)) < 0.6, `${gate.distance}`);
    assert.equal(rooms.portalAlong(player.eye(), [-1, 0, 0], 1), null);
    launcher.turnPortal(gate.portal);
    assert.equal(rooms.portals[gate.portal].open, false);
    assert.equal(walkTo(game, 25, 10.5, 3), false);
    assert.equal(here(), 'dock');
    const seen = launcher.aim(player.eye(), [-1, 0, 0], rooms.here);
    assert.deepEqual([seen.material, seen.hit.portal], ['closed portal', gate.portal]);
    assert.ok(launcher.undo());
    assert.ok(walkTo(game, 25, 10.5, 3));
    assert.equal(here(), 'hall');
    assert.deepEqual(launcher.aim(player.eye(), [1, 0, 0], rooms.here).passed.map((room) => rooms.name(room)).slice(0, 2), ['hall', 'dock']);
    launcher.world.release();
    launcher.store.release();
});

test('where a .map has players start', () => {
    const entity = (...keys) => `{\n${keys.map(([key, value]) => `"${key}" "${value}"\n`).join('')}}\n`;
    const readStart = (text) => {
        const level = readers.levelFromMap(text);
        try {
            return startOf(level.entities());
        } finally {
            level.release();
        }
    };
    const worldspawn = entity(['classname', 'worldspawn'], ['origin', '1 2 3']);
    assert.deepEqual(readStart(worldspawn + entity(['origin', '32 -64 16'], ['classname', 'info_player_start'], ['angle', '90'])), { point: [1, -2, 0.5], yaw: Math.PI / 2 });
    assert.deepEqual(readStart(entity(['classname', 'info_player_deathmatch'], ['origin', ' 32  0 0 '])), { point: [1, 0, 0], yaw: 0 });
    for (const text of [worldspawn, entity(['classname', 'info_player_start']), entity(['classname', 'info_player_start'], ['origin', '1 2']), entity(['classname', 'info_player_start'], ['origin', '1 2 x'])])
        assert.equal(readStart(text), null);
});
