// SPDX-License-Identifier: MIT
// Doors of the depot: they swing, stop walkers, shots and rubble, shut their portals, are shot to pieces; without a browser.
import assert from 'node:assert/strict';
import test from 'node:test';
import { Doors } from '../src/doors.js';
import { Grenades } from '../src/grenades.js';
import { Launcher } from '../src/launcher.js';
import { Player } from '../src/player.js';
import { Probe } from '../src/probe.js';
import { Rooms } from '../src/rooms.js';
import { firma, makeWorld, Projectiles } from './engine.mjs';

const kStep = 1 / 60;

function begin() {
    const world = makeWorld('depot.map');
    const rooms = new Rooms(world);
    const probe = new Probe(world);
    const launcher = new Launcher(firma, world, probe, (before, after) => {
        rooms.learn(after);
        doors?.follow(rooms.portals);
    });
    let doors = null;
    const player = new Player(firma, probe);
    const changes = [];
    doors = new Doors(firma, rooms.portals, (portal) => launcher.turnPortal(portal), (changed) => changes.push(changed));
    launcher.scene = () => doors.scene(launcher.world);
    return { launcher, rooms, player, doors, changes };
}

function end({ launcher, player, doors }) {
    doors.release();
    player.release();
    launcher.world.release();
    launcher.store.release();
}

/** Time goes on for everybody. */
function step({ doors, player, launcher }, seconds, keys = {}) {
    for (let t = 0; t < seconds - 1e-9; t += kStep) {
        doors.begin(kStep);
        player.step(kStep, keys, doors.scene(launcher.world));
        doors.arrive(player.caught);
    }
}

const doorOf = ({ doors, rooms }, name) => doors.all.find((door) => rooms.portals[door.portal].name === name);

test('a door shuts, closes its portal, and stops who walks; it opens, and lets him through', () => {
    const before = firma.liveHandles();
    const game = begin();
    const { rooms, doors, player, launcher } = game;
    assert.ok(doors.all.length > 20, `${doors.all.length}`);
    const door = doorOf(game, 'hall_office_west');
    player.place([4.45, 13, 0.01]);
    player.look(Math.PI / 2, 0);
    doors.shut(door);
    step(game, 0.3);
    assert.ok(doors.moving && rooms.portals[door.portal].open, 'not yet');
    step(game, 1);
    assert.ok(!doors.moving && !rooms.portals[door.portal].open);
    step(game, 1.5, { forward: true });
    assert.ok(player.feet[1] < 14.5 - 0.35 && player.feet[1] > 13.9, `${player.feet}`);
    assert.equal(launcher.meet([4.4, 12, 1], [0, 10, 0]).material, 'part');

    launcher.turnPortal(door.portal);
    step(game, 1.5, { forward: true });
    assert.ok(rooms.portals[door.portal].open && !doors.moving);
    assert.ok(player.feet[1] > 15.5, `${player.feet}`);
    assert.notEqual(launcher.meet([4.4, 12, 1], [0, 10, 0])?.material, 'part');

    // Undo takes the door along: first what opened it, then what shut it.
    launcher.undo();
    step(game, 1);
    assert.equal(door.angle, 0);
    launcher.undo();
    step(game, 1);
    assert.ok(door.angle > 1.5 && rooms.portals[door.portal].open);
    end(game);
    assert.equal(firma.liveHandles(), before);
});

test('who stands in the way is pushed aside, or the door goes back; nobody is in it or in the wall', () => {
    const game = begin();
    const { doors, player, launcher } = game;
    const door = doorOf(game, 'hall_office_middle');
    for (const [x, y] of [[10.87, 14.5], [10.7, 14.9], [11.1, 14.3], [10.87, 15.4]]) {
        player.place([x, y, 0.01]);
        step(game, 0.1);
        doors.shut(door);
        for (let k = 0; k < 120; ++k) {
            step(game, kStep);
            assert.notEqual(launcher.world.locate([player.feet[0], player.feet[1], 0.9]).where, 'solid');
            assert.ok(firma.playerFits(doors.scene(launcher.world), player.shape, player.feet) || player.caught !== null, `at ${player.feet}, the door at ${door.angle}`);
        }
        player.place([10.87, 10, 0.01]);
        if (!game.rooms.portals[door.portal].open) launcher.turnPortal(door.portal);
        step(game, 1.5);
        assert.ok(door.angle > 1.5);
    }
    end(game);
});

test('a blast takes of a leaf what it reaches, and the rest goes on swinging', () => {
    const game = begin();
    const { doors, changes, launcher } = game;
    const door = doorOf(game, 'hall_office_west');
    doors.shut(door);
    step(game, 1.5);
    const whole = door.world.measure().volume;
    const cutter = firma.crater('rocky', 2);
    assert.deepEqual(doors.blast(cutter, { position: [4.4, 14.5, 2.2], scale: 0.4 }), []);
    const left = door.world.measure().volume;
    assert.ok(left < whole && left > 0.5 * whole && !door.broken, `${left} of ${whole}`);
    assert.deepEqual(changes, [door]);
    assert.equal(launcher.meet([4.4, 12, 2.2], [0, 4, 0])?.material, 'closed portal', 'through the hole');
    launcher.turnPortal(door.portal);
    step(game, 1.5);
    assert.ok(door.angle > 1.5);
    assert.deepEqual(doors.blast(cutter, { position: doors.middle(door), scale: 1.5 }), [door.portal]);
    assert.equal(doors.of(door.portal), null);
    cutter.release();
    end(game);
});

test('grenades bounce, lie still, go off when their time is up; a shut door stops them', () => {
    const game = begin();
    const { doors, launcher } = game;
    const grenades = new Grenades(firma, Projectiles);
    const bodies = firma.bodies();
    const fly = () => {
        let bounces = 0;
        let blasts = [];
        let seconds = 0;
        for (; seconds < 5 && blasts.length === 0; seconds += kStep) {
            const done = grenades.step(launcher.world, bodies, kStep);
            bounces += done.bounces.length;
            blasts = done.blasts;
            for (const { at } of grenades.seen()) assert.notEqual(launcher.world.locate(at).where, 'solid', `${at}`);
        }
        return { bounces, blasts, seconds };
    };
    grenades.throw([18.75, 7, 1.5], [-1, 0, 0.1]);
    const { bounces, blasts, seconds } = fly();
    assert.ok(bounces >= 3 && blasts.length === 1 && grenades.count === 0, `${bounces} bounces`);
    assert.ok(Math.abs(seconds - 2.4) < 0.05 && blasts[0][2] < 1, `${seconds} s, at ${blasts}`);

    const door = doorOf(game, 'hall_office_west');
    grenades.throw([4.4, 12.5, 1.2], [0, 1, 0]);
    const open = fly().blasts[0];
    doors.shut(door);
    step(game, 1.5);
    grenades.throw([4.4, 12.5, 1.2], [0, 1, 0]);
    const shut = fly().blasts[0];
    assert.ok(open[1] > 15 && shut[1] < 14.5, `${open} ${shut}`);

    const shot = launcher.burst(shut);
    assert.ok(['done', 'nothing'].includes(shot.status) && Math.abs(Math.hypot(...shot.normal) - 1) < 1e-9);
    bodies.release();
    end(game);
});
