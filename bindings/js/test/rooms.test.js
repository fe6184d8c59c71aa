// SPDX-License-Identifier: MIT
// Levels of brushes, their rooms and portals, doors, and casts by room.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { HitBatch, NO_PORTAL } from '../src/index.js';
import { brush as box, firma, levelBytes, readers, releasing, throwsCode, twoRooms } from './helpers.js';

const depot = readFileSync(new URL('../../../levels/depot.map', import.meta.url));

const withRooms = (work) => releasing([readers.worldFromMap(twoRooms, { name: 'two.map' })], work);
const roomAt = (world, x) => world.locate([x, 2, 2]).room;

test('a .map from a string and from bytes', () => {
    withRooms((world) => {
        const facts = world.facts();
        assert.deepEqual([facts.roomCount, facts.portalCount], [3, 1]);
        assert.deepEqual(facts.materials.filter((name) => ['wall', 'floor', 'roof'].includes(name)).length, 3);
        world.check();
        assert.equal(world.measure().volume, 9 * 5 * 5 - 8 * 4 * 4);
        releasing([readers.worldFromMap(new TextEncoder().encode(twoRooms))], (again) =>
            assert.equal(again.hash(), world.hash()),
        );
        releasing([readers.worldFromMap(twoRooms, { scale: 1 })], (large) => assert.equal(large.facts().high[0], 272));
    });
    throwsCode(
        'MALFORMED',
        () => readers.worldFromMap('{\n"classname" "worldspawn"\n}\n', { name: 'nothing.map' }),
        /nothing\.map: no face is left that a cast could meet; 0 brushes/,
    );
    throwsCode(
        'MALFORMED',
        () => readers.worldFromObj('v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n', { name: 'flat.obj' }),
        /flat\.obj: no face is left that a cast could meet; left out: faces without area: 1/,
    );
    throwsCode('MALFORMED', () => readers.worldFromMap('{\n{ ( 1 2', { name: 'torn.map' }), /torn\.map:2/);
    throwsCode('BAD_CALL', () => readers.worldFromMap(5));
});

test('where a point is', () => {
    withRooms((world) => {
        assert.equal(new Set([1, 7, 99].map((x) => roomAt(world, x))).size, 3);
        assert.deepEqual(world.locate([-0.25, 2, 2]), { where: 'solid', room: null });
        assert.deepEqual(world.locate([2, 2, 0]), { where: 'surface', room: null });
        throwsCode('OUT_OF_RANGE', () => world.locate([0, NaN, 0]));
        throwsCode('BAD_CALL', () => world.locate([0, 0]));
    });
});

test('rooms and portals, and what leads where', () => {
    withRooms((world) => {
        const [west, east, outside] = [1, 7, 99].map((x) => roomAt(world, x));
        assert.deepEqual(world.room(west), {
            name: 'größe',
            low: [0, 0, 0],
            high: [4, 4, 4],
            faceCount: 5,
            exterior: false,
            mergedInto: west,
            portals: [0],
        });
        assert.equal(world.room(outside).exterior, true);
        const { polygons, mask, material, ...portal } = world.portal(0);
        const rooms = [...portal.rooms];
        assert.deepEqual(portal, { name: 'gate', low: [4, 0, 0], high: [4, 4, 4], rooms, open: true });
        assert.deepEqual(rooms.sort(), [west, east].sort());
        assert.ok(mask !== 0 && material < world.facts().materials.length);
        let area = 0;
        for (const corners of polygons)
            for (let k = 3; k + 3 < corners.length; k += 3) {
                const [a, b, c] = [0, k, k + 3].map((at) => corners.subarray(at, at + 3));
                area += ((b[1] - a[1]) * (c[2] - a[2]) - (b[2] - a[2]) * (c[1] - a[1])) / 2;
            }
        assert.equal(Math.abs(area), 16);
        assert.equal(Math.sign(area), portal.rooms[0] === west ? -1 : 1); // counter-clockwise seen from rooms[0]

        assert.deepEqual(world.neighbours(west), [east]);
        assert.deepEqual(world.neighbours(outside), []);
        assert.deepEqual(world.path(west, east), [0]);
        assert.deepEqual(world.path(west, west), []);
        assert.equal(world.path(west, outside, { allOpen: true }), null);
        for (const call of [() => world.room(3), () => world.portal(1), () => world.neighbours(3), () => world.path(0, 3)])
            throwsCode('INVALID', call, /no (room|portal) \d/);
        for (const call of [() => world.room(-1), () => world.portal(), () => world.path(0), () => world.neighbours(0.5)])
            throwsCode('BAD_CALL', call);
        throwsCode('BAD_CALL', () => world.path(0, 1, { allOpen: 1 }));
    });
});

test('a closed door is a wall', () => {
    withRooms((open) => {
        const [west, east] = [1, 7].map((x) => roomAt(open, x));
        releasing([open.setPortalOpen(0, false)], (closed) => {
            assert.equal(closed.facts().version, 1);
            assert.equal(closed.portal(0).open, false);
            assert.equal(closed.path(west, east), null);
            assert.deepEqual(closed.path(west, east, { allOpen: true }), [0]);
            const hit = closed.cast({ centre: [1, 2, 2], radius: 0.5, path: [6, 0, 0] });
            assert.deepEqual([hit.status, hit.portal, hit.face, hit.fraction], ['hit', 0, null, 2.5 / 6]);
            assert.equal(closed.hitInfo(hit).room, west);
            const diff = open.diff(closed);
            assert.deepEqual([[...diff.closed], [...diff.opened], diff.removed.length], [[0], [], 0]);
            const near = closed.closest([3.5, 2, 2], 1);
            assert.deepEqual([near.portal, near.face, near.distance], [0, null, 0.5]);
            assert.deepEqual(closed.overlap([3.5, 2, 2], 1).map((one) => one.portal), [0]);
            assert.equal(open.closest([3.5, 2, 2], 1), null);
            releasing([closed.setPortalOpen(0, true)], (again) => assert.equal(again.closest([3.5, 2, 2], 1), null));
        });
        throwsCode('BAD_CALL', () => open.setPortalOpen(0, 1));
        throwsCode('INVALID', () => open.setPortalOpen(5, true));
    });
});

test('casts by room', () => {
    withRooms((world) => {
        const [west, east] = [1, 7].map((x) => roomAt(world, x));
        const through = { centre: [1, 2, 2], radius: 0.5, path: [10, 0, 0] };
        const any = world.cast(through);
        assert.deepEqual([any.portal, world.hitInfo(any).room], [null, east]);
        const all = [7];
        world.cast(through, { passed: all });
        assert.deepEqual(all, []);
        for (const room of [west, 'locate']) {
            const passed = [];
            const hit = world.cast(through, { room, passed });
            assert.deepEqual(hit, any);
            assert.deepEqual(passed, [west, east]);
            assert.equal(world.castAny(through, { room }), true);
            assert.equal(world.castAll(through, { room })[0].face, any.face);
            const batch = world.castBatch([...through.centre, 0.5, ...through.path], { room }, new HitBatch());
            assert.deepEqual(batch.hit(0), hit);
            assert.equal(batch.portal[0], NO_PORTAL);
        }
        assert.deepEqual(world.cast(through, { room: 'any' }), any);
        assert.equal(world.cast(through, { room: 17 }).status, 'invalid');
        for (const ask of ['castAny', 'castAll'])
            throwsCode('INVALID', () => world[ask](through, { room: 17 }), /the world has no room 17$/);
        throwsCode('INVALID', () => world.castEach(through, () => true, { room: 17 }), /castEach: .* no room 17$/);
        for (const room of ['locate', 0]) {
            const bad = { ...through, radius: -1 };
            throwsCode('OUT_OF_RANGE', () => world.castAny(bad, { room }), /radius/);
            throwsCode('OUT_OF_RANGE', () => world.castAll(bad, { room }), /radius/);
        }
        for (const room of [-1, 'toString', null, 1.5]) throwsCode('BAD_CALL', () => world.cast(through, { room }));
    });
});

/** A place in a room beside a portal: a metre along its thinnest axis. */
function placeBeside(world, { low, high }, room) {
    const middle = low.map((x, axis) => (x + high[axis]) / 2);
    const sizes = low.map((x, axis) => high[axis] - x);
    const axis = sizes.indexOf(Math.min(...sizes));
    const places = [-1, 1].map((way) => middle.map((x, k) => (k === axis ? x + way : x)));
    return places.find((place) => world.locate(place).room === room);
}

test('the depot: rooms by name, ways, a cut at a portal', () => {
    releasing([readers.worldFromMap(depot, { name: 'depot.map' })], (world) => {
        const { roomCount, portalCount } = world.facts();
        assert.ok(roomCount > 12 && portalCount > 12);
        const rooms = Array.from({ length: roomCount }, (_, k) => world.room(k));
        const named = (name) => rooms.findIndex((room) => room.name === name);
        const [hall, boilers] = [named('hall'), named('boiler_room')];
        assert.ok(hall >= 0 && boilers >= 0);
        assert.equal(rooms.filter((room) => room.exterior).length, 1);
        const way = world.path(hall, boilers);
        let room = hall;
        for (const k of way) {
            const { rooms: pair } = world.portal(k);
            assert.ok(pair.includes(room));
            room = pair[0] === room ? pair[1] : pair[0];
        }
        assert.equal(room, boilers);
        const portal = world.portal(way[0]);
        const middle = portal.low.map((x, axis) => (x + portal.high[axis]) / 2);
        const pose = { position: [middle[0], middle[1], portal.low[2]], scale: 0.4 };
        const below = [middle[0], middle[1], portal.low[2] - 0.15];
        releasing([firma.crater('rocky', 1)], (cutter) => {
            for (const room of portal.rooms) {
                const from = placeBeside(world, portal, room);
                const { world: after, report } = world.carve(cutter, pose, { from });
                releasing([after], () => {
                    assert.equal(report.status, 'done');
                    assert.ok(report.portals >= 1);
                    assert.ok(after.portal(way[0]).polygons.length > 0);
                    assert.equal(after.room(room).mergedInto, room);
                    assert.equal(after.locate(below).room, room);
                    const { portalsAdded } = world.diff(after);
                    assert.equal(portalsAdded.length, report.portals);
                    after.check();
                });
            }
            throwsCode('BAD_CALL', () => world.carve(cutter, pose, { from: [0, 0] }));
        });
    });
});

test('entities of a level, and its world', () => {
    releasing([readers.levelFromMap(depot, { name: 'depot.map' })], (level) => {
        const entities = level.entities();
        assert.equal(entities[0].classname, 'worldspawn');
        assert.equal(entities[0].origin, null);
        assert.equal(level.metresPerUnit, 1 / 32);
        const [start] = entities.filter((entity) => entity.classname === 'info_player_start');
        const numbers = start.values.get('origin').split(' ').map(Number);
        assert.deepEqual(start.origin, numbers.map((x) => x / 32));
        assert.ok(start.line > 1 && start.keys.some(([key, value]) => key === 'classname' && value === start.classname));
        assert.ok(entities.filter((entity) => entity.classname === 'firma_room').length > 12);
        assert.ok(Array.isArray(level.notes()));
        releasing([level.world({ contactOffset: 0.01 }), readers.worldFromMap(depot, { contactOffset: 0.01 })], (world, other) => {
            assert.equal(world.hash(), other.hash());
            assert.equal(world.locate(start.origin).where, 'air');
        });
    });
    const noted = '{ "classname" "worldspawn" { brushDef9 { } } }\n{ "classname" "light" "origin" "1 2" "größe" "ü" "a" "1" "a" "2" }';
    releasing([readers.levelFromMap(noted, { scale: 0.5 })], (level) => {
        const [, light] = level.entities();
        assert.equal(light.origin, null);
        assert.deepEqual([light.values.get('größe'), light.values.get('a'), light.keys.length], ['ü', '1', 5]);
        assert.equal(level.metresPerUnit, 0.5);
        assert.match(level.notes().join(), /brushDef9/);
        assert.deepEqual(level.omissions().map(({ count }) => count), [1]);
        assert.match(level.omissions()[0].first, /^map:1/);
        assert.match(level.omissions()[0].what, /brushDef9/);
        throwsCode('MALFORMED', () => level.world());
    });
    throwsCode('MALFORMED', () => readers.levelFromMap('{', { name: 'torn.map' }), /torn\.map/);
    throwsCode('INVALID', () => readers.levelFromMap('{}', { scale: -1 }), /scale/);
    throwsCode('BAD_CALL', () => readers.levelFromMap(5));
    throwsCode('BAD_CALL', () => readers.levelFromMap('{}', { scale: '1' }));
});

test('rooms and portals by name, materials, and the portals that a cast passes', () => {
    releasing([readers.worldFromMap(depot), readers.levelFromMap(depot)], (world, level) => {
        const { materials, roomCount } = world.facts();
        assert.equal(world.material(3), materials[3]);
        throwsCode('INVALID', () => world.material(materials.length));
        for (let room = 0; room < roomCount; ++room) {
            const { name } = world.room(room);
            if (name !== '') assert.equal(world.room(world.findRoom(name)).name, name);
        }
        assert.equal(world.findRoom('no such room'), null);
        assert.equal(world.findRoom(''), null);
        assert.equal(world.findPortal('no such portal'), null);
        throwsCode('BAD_CALL', () => world.findRoom(3));
        const start = level.entities().find(({ classname }) => classname === 'info_player_start').origin;
        const [passed, passedPortals] = [[7, 7, 7], []];
        let far = 0;
        for (let k = 0; k < 64; ++k) {
            const path = [80 * Math.cos(k), 80 * Math.sin(k), 0];
            world.cast({ centre: start, radius: 0, path }, { room: 'locate', passed, passedPortals });
            assert.equal(passed.length, passedPortals.length);
            assert.equal(passedPortals[0], null);
            for (let n = 1; n < passed.length; ++n) assert.ok(world.portal(passedPortals[n]).rooms.includes(passed[n]));
            far = Math.max(far, passed.length);
        }
        assert.ok(far > 1);
        throwsCode('BAD_CALL', () => world.cast({ centre: start, radius: 0, path: [1, 0, 0] }, { passedPortals: 3 }));
        // A call that fails leaves the lists as they were.
        const list = [1, 2, 3];
        const failing = { centre: start, radius: 0, path: [1, 0, 0] };
        throwsCode('INVALID', () => world.cast(failing, { contactOffset: NaN, passed: list, passedPortals: list }));
        const gone = world.copy();
        gone.release();
        throwsCode('BAD_HANDLE', () => gone.cast(failing, { passed: list }));
        assert.deepEqual(list, [1, 2, 3]);
    });
});

test('a level without rooms has one', () => {
    releasing([readers.worldFromObj(levelBytes)], (world) => {
        assert.deepEqual([world.facts().roomCount, world.facts().portalCount], [1, 0]);
        assert.equal(world.room(0).faceCount, world.facts().faceCount);
        assert.deepEqual(world.neighbours(0), []);
        throwsCode('INVALID', () => world.portal(0));
    });
});
