// SPDX-License-Identifier: MIT
// Parts of a level's entities: a door and a crate, moved by their paths in a game and by hand.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { loadReaders } from '../src/readers.js';
import { brush, throwsCode } from './helpers.js';
import { holding, recordings } from './recording_helpers.js';

const near = (actual, expected, error = 1e-9) =>
    assert.ok(Math.abs(actual - expected) <= error, `${actual} is not ${expected} to ${error}`);

/** A floor of 8 x 8 m, a door of 1 x 0.25 x 2 m on it that slides up at 2 m/s, a crate of 1 m, a train to nowhere. */
const map =
    `{\n"classname" "worldspawn"\n${brush([0, 0, -32], [256, 256, 0], 'rock')}}\n` +
    `{\n"classname" "func_door"\n"angle" "-1"\n"speed" "64"\n"wait" "1"\n"lip" "0"\n${brush([64, 128, 0], [96, 136, 64], 'steel')}}\n` +
    `{\n"classname" "func_breakable"\n"health" "40"\n${brush([128, 128, 0], [160, 160, 32], 'wood')}}\n` +
    `{\n"classname" "func_train"\n"target" "nowhere"\n${brush([192, 128, 0], [224, 160, 32], 'steel')}}\n`;

const withParts = async (work) => {
    const level = await recordings.levelFromMap(map, { name: 'parts.map' });
    holding((hold) => {
        hold(level);
        const made = level.parts();
        for (const { world } of made.parts) hold(world);
        work(hold, level, made);
    });
};

test('what a level says of its parts', () =>
    withParts((hold, level, { parts, notes }) => {
        assert.deepEqual(parts.map(({ entity }) => entity), [1, 2, 3]);
        const [door, crate] = parts;
        assert.deepEqual([door.waits, door.whenBlocked, door.breakable, door.mask], [true, 'returns', null, 0xffffffff]);
        // By its height and two units.
        const way = 66 / 32;
        assert.equal(door.path.stops.length, 2);
        near(door.path.stops[1].position[2] - door.path.stops[0].position[2], way, 1e-12);
        near(door.path.stops[0].seconds, way / 2, 1e-12);
        assert.deepEqual([door.path.stops[1].wait, door.path.repeats, door.path.axis], [1, false, [0, 0, 1]]);
        assert.deepEqual([crate.waits, crate.breakable.health, crate.breakable.broken], [false, 40, false]);
        near(crate.breakable.whole, 1);
        near(crate.world.measure().volume, 1);
        assert.deepEqual(notes.map(({ entity }) => level.entities()[entity].classname), ['func_train']);
        assert.match(notes[0].note, /path_corner/);
        // A world of the module, not of the readers.
        assert.ok(door.world.cast({ centre: [2.5, 0, 1], radius: 0, path: [0, 8, 0] }).hit);
    }));

test('a door goes by its path, by hand', () =>
    withParts((hold, level, { parts: [door] }) => {
        const world = hold(level.world());
        const parts = hold(recordings.parts());
        parts.add({ world: door.world, motion: recordings.pathMotion(door.path, 0, 0) });
        const through = { centre: [2.5, 2, 1], radius: 0.125, path: [0, 4, 0] };
        assert.equal(recordings.castScene({ world, parts }, through).part, 0);
        assert.deepEqual([-1, 0.5, 9].map((time) => recordings.pathAtFirstStop(door.path, time)), [true, false, true]);
        near(recordings.pathNextStop(door.path, 0.25), 66 / 64);
        const { position, rotation, scale } = recordings.pathPose(door.path, 0.5);
        near(position[2], 1);
        assert.deepEqual([position.slice(0, 2), rotation, scale], [[0, 0], [0, 0, 0, 1], 1]);
        const motion = recordings.pathMotion(door.path, 0.25, 0.5);
        near(motion.position[2], 0.5);
        near(motion.path[2], 0.5);
        // Up, it lets through what it stopped.
        parts.setMotions([recordings.pathMotion(door.path, 1.5, 1.5)]);
        assert.equal(recordings.castScene({ world, parts }, through).hit, false);
        assert.equal(recordings.pathNextStop({}, 0), Infinity);
        assert.equal(recordings.pathMotion({ spin: 2 }, 0, 0.5).turn[2], 1);
        throwsCode('OUT_OF_RANGE', () => recordings.pathPose(door.path, NaN));
        throwsCode('BAD_CALL', () => recordings.pathPose(undefined, 0), /the path must be an object/);
        throwsCode('BAD_CALL', () => recordings.pathMotion({ stop: [] }, 0, 1), /there is no stop/);
        throwsCode('BAD_CALL', () => recordings.pathMotion(door.path, 0), /to must be a number/);
    }));

test('parts of a level in a game: set off, the door opens', () =>
    withParts((hold, level, { parts }) => {
        const game = hold(recordings.game(hold(level.world()), 60));
        for (const { breakable, ...part } of parts) game.addPart(part);
        assert.equal(game.facts().parts, 3);
        assert.deepEqual([game.part(0).entity, game.part(0).waits, game.part(0).atFirstStop], [1, true, true]);
        game.setOff(0);
        for (let tick = 0; tick < 60; ++tick) game.step();
        near(game.part(0).motion.position[2], 2 * (59 / 60), 1e-9);
    }));

test('without promises, and what makes no parts', async () => {
    const readers = await loadReaders(recordings);
    holding((hold) => {
        const level = hold(readers.levelFromMap(`{\n"classname" "worldspawn"\n${brush([0, 0, 0], [32, 32, 32], 'rock')}}\n`));
        assert.deepEqual(level.parts(), { parts: [], notes: [] });
        throwsCode('BAD_CALL', () => level.parts({ rooms: 1 }), /there is no rooms/);
        level.release();
        throwsCode('BAD_HANDLE', () => level.parts(), /level/);
    });
});
