// SPDX-License-Identifier: MIT
// The playground as a browser shows it: load, walk into a wall, fire until there is a hole, walk through it, undo.
//
// Time is stepped by hand: nothing here waits for a frame rate. Pictures go to build/playground_shots.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { call, kFirma, kRoot, load, open, shoot } from './harness.mjs';

const kRadius = 0.35;
const kThinWall = 10.05; // x of its eastern side; 5 cm of rock between two rooms
let session;

before(async () => (session = await open()));
after(async () => assert.equal(await session.close(), 0)); // Ctrl-C is how the server is meant to end

const state = (page) => call(page, 'state');

async function assertClear(page) {
    const { distance, inSolid } = await call(page, 'clearance');
    assert.equal(inSolid, false);
    assert.ok(distance >= kRadius - 1e-9, `${distance} m`);
}

/** Walks to a place in a straight line, at most so many steps of a fifth of a second. */
async function walkTo(page, x, y, most = 60) {
    for (let k = 0; k < most; ++k) {
        const { position } = await state(page);
        const [dx, dy] = [x - position[0], y - position[1]];
        if (Math.hypot(dx, dy) < 0.15) break;
        await call(page, 'look', Math.atan2(dy, dx), 0);
        await call(page, 'step', Math.min(0.2, Math.hypot(dx, dy) / 4.5), { forward: true });
    }
    return (await state(page)).position;
}

/** How many colours there are on the canvas itself. */
const coloursDrawn = (page) =>
    page.evaluate(() => {
        window.firmaPlayground.draw();
        const gl = document.querySelector('canvas').getContext('webgl2');
        const pixels = new Uint8Array(4 * gl.drawingBufferWidth * gl.drawingBufferHeight);
        gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
        return new Set(new Uint32Array(pixels.buffer)).size;
    });

/** Whether what is drawn is just what of the world is to be seen: the triangles of each face, and nothing else. */
const drawnWrong = (page) =>
    page.evaluate(() => {
        const { game } = window.firmaPlayground;
        const faces = game.launcher.world.faces();
        const drawn = new Map(); // id -> corners of its triangles, one behind the other
        let count = 0;
        for (const { geometry, group, origin, ids } of game.meshes.regions.values()) {
            const { index, attributes } = geometry;
            if (group.parent !== game.meshes.group || group.position.toArray().some((x, a) => x !== origin[a])) return ['a region that is not drawn where it is'];
            if (index.count !== 3 * ids.length || geometry.drawRange.count !== Infinity) return ['a region of which a part is drawn'];
            ids.forEach((id, t) => {
                if (!drawn.has(id)) drawn.set(id, []);
                for (let c = 0; c < 3; ++c) {
                    const vertex = index.array[3 * t + c];
                    drawn.get(id).push([0, 1, 2].map((a) => attributes.position.array[3 * vertex + a] + origin[a]));
                }
            });
            count += group.children.filter((mesh) => mesh.geometry === geometry && mesh.visible).length;
        }
        const wrong = count < game.meshes.regions.size ? ['a region without a mesh'] : [];
        const area = ([p, q, r]) => {
            const [u, v] = [q, r].map((x) => x.map((y, a) => y - p[a]));
            return Math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) / 2;
        };
        for (let k = 0; k < faces.ids.length; ++k) {
            const id = faces.ids[k];
            const its = drawn.get(id) ?? [];
            drawn.delete(id);
            if ((faces.masks[k] & 14) === 0) {
                if (its.length > 0) wrong.push(`face ${id} is drawn, and stops nothing but walkers`);
                continue;
            }
            const corners = Array.from({ length: faces.cornerCounts[k] }, (_, c) => [0, 1, 2].map((a) => faces.corners[3 * (faces.firstCorners[k] + c) + a]));
            if (its.length !== 3 * (corners.length - 2)) wrong.push(`face ${id}`);
            const known = new Set(corners.map(String));
            if (its.some((corner) => !known.has(String(corner)))) wrong.push(`corner of face ${id}`);
            const fan = corners.slice(2).reduce((sum, corner, c) => sum + area([corners[0], corners[c + 1], corner]), 0);
            let own = 0;
            for (let t = 0; t < its.length; t += 3) own += area(its.slice(t, t + 3));
            if (Math.abs(own - fan) > 1e-9 * Math.max(1, fan)) wrong.push(`face ${id}: ${own} m2 of ${fan}`);
        }
        for (const id of drawn.keys()) wrong.push(`face ${id} is drawn, and not there`);
        return wrong.slice(0, 5);
    });

/** Which regions a shot replaces: only those that it changes. */
const markRegions = (page) =>
    page.evaluate(() => {
        for (const { geometry } of window.firmaPlayground.game.meshes.regions.values()) geometry.userData.kept = true;
    });
const replacedRegions = (page) =>
    page.evaluate(() => {
        const all = [...window.firmaPlayground.game.meshes.regions.values()];
        return { all: all.length, replaced: all.filter(({ geometry }) => !geometry.userData.kept).length };
    });

test('loads and draws', async () => {
    const { page, errors, error } = await load(session, '?level=first.obj&picture=full');
    assert.equal(error, null);
    const s = await state(page);
    assert.equal(s.faces, 5944);
    assert.equal(s.drawnFaces, 5944);
    assert.equal(s.version, 0);
    assert.equal(await page.evaluate(() => crossOriginIsolated), true); // a clock of 5 us
    assert.ok(s.aim.met && s.aim.counts.nodes > 0 && s.aim.counts.faces > 0);
    const { move } = await call(page, 'step', 0.1, { forward: true });
    assert.ok(move.moves === 6 && move.us > 0, JSON.stringify(move));
    assert.deepEqual(await drawnWrong(page), []);
    await assertClear(page);
    assert.ok((await coloursDrawn(page)) > 1000); // not one colour all over
    await shoot(page, '1_loaded');
    const drawn = () => page.evaluate(() => (({ width, height }) => [width, height])(document.querySelector('canvas')));
    assert.deepEqual([await call(page, 'picture'), await drawn()], [{ share: 1, full: true }, [1120, 630]]);
    const words = await page.textContent('#hud');
    for (const part of [/at 4\d\.\d\d, /, /room 0/, /version 0/, /5,944 faces/, /\d+ nodes, \d+ boxes, \d+ faces/, /frame /, /a move of the player /, /0 bodies/, /cut /])
        assert.match(words, part);
    assert.equal(await page.isVisible('#hud'), false); // the figures are behind a key
    await page.keyboard.press('i');
    assert.equal(await page.isVisible('#hud'), true);
    assert.deepEqual(errors, []);
    await page.close();
});

test('walks into a wall and stops', async () => {
    const { page, errors } = await load(session, '?level=first.obj');
    await walkTo(page, 42.5, 32.5);
    await call(page, 'look', 0, 0); // the wall at x = 44
    for (let k = 0; k < 12; ++k) {
        await call(page, 'step', 0.25, { forward: true });
        await assertClear(page);
    }
    const { position } = await state(page);
    assert.ok(Math.abs(position[0] - (44 - kRadius)) < 0.01, `${position}`);
    await call(page, 'look', 0.7, 0); // askew: along it
    await call(page, 'step', 0.5, { forward: true });
    const slid = (await state(page)).position;
    assert.ok(slid[1] > position[1] + 0.7 && slid[0] <= 44 - kRadius, `${slid}`);
    await assertClear(page);
    await shoot(page, '2_at_the_wall');
    assert.deepEqual(errors, []);
    await page.close();
});

test('fires until there is a hole, walks through it, undoes it', async () => {
    const { page, errors } = await load(session, '?level=first.obj');
    const first = await call(page, 'hash');
    await walkTo(page, 12.5, 25.75); // through the door into the room with the thin wall
    await walkTo(page, 12.8, 27.6);
    await call(page, 'look', Math.PI, 0);
    await call(page, 'step', 1.5, { forward: true });
    let { position } = await state(page);
    assert.ok(Math.abs(position[0] - (kThinWall + kRadius)) < 0.01, `${position}`); // stopped by it
    await call(page, 'step', 0.5, { back: true });
    await shoot(page, '3_before_the_thin_wall');

    let shots = 0;
    while (position[0] > 9 && shots < 12) {
        await call(page, 'look', Math.PI, [-0.35, -0.1, 0.15][shots % 3]);
        await markRegions(page);
        assert.equal((await call(page, 'fire')).status, 'done');
        ++shots;
        const { all, replaced } = await replacedRegions(page);
        assert.ok(replaced > 0 && replaced <= 8 && all > 2 * replaced, `${replaced} of ${all} regions`);
        assert.equal((await state(page)).version, shots);
        if (shots === 1) await shoot(page, '4_first_shot', 0.08);
        if (shots === 1) await shoot(page, '5_hole');
        await call(page, 'look', Math.PI, 0);
        for (let k = 0; k < 10; ++k) {
            await call(page, 'step', 0.1, { forward: true });
            await assertClear(page);
        }
        ({ position } = await state(page));
        if (position[0] > 9) await call(page, 'step', 0.3, { back: true });
    }
    assert.ok(position[0] < 9, `still at ${position} after ${shots} shots`);
    await call(page, 'check');
    assert.deepEqual(await drawnWrong(page), []);
    const holed = await call(page, 'hash');
    assert.notEqual(holed, first);
    await call(page, 'look', 0.15, 0);
    await shoot(page, '6_through_the_hole');

    for (let k = 0; k < shots; ++k) assert.equal(await call(page, 'undo'), true);
    assert.equal(await call(page, 'undo'), false);
    const undone = await state(page);
    assert.deepEqual([undone.faces, undone.drawnFaces, await call(page, 'hash')], [5944, 5944, first]);
    assert.deepEqual(await drawnWrong(page), []);
    await call(page, 'look', 0, 0);
    await call(page, 'step', 2, { forward: true });
    const stopped = (await state(page)).position;
    assert.ok(Math.abs(stopped[0] - (10 - kRadius)) < 0.01, `${stopped}`); // the wall is back
    await assertClear(page);
    await shoot(page, '7_undone');

    await call(page, 'step', 0.5, { back: true });
    for (let k = 0; k < shots; ++k) assert.equal(await call(page, 'redo'), true);
    assert.equal(await call(page, 'redo'), false);
    assert.equal(await call(page, 'hash'), holed);
    assert.deepEqual(await drawnWrong(page), []);
    assert.deepEqual(errors, []);
    await page.close();
});

test('many craters: what is drawn stays what is there', async () => {
    const { page, errors } = await load(session, '?level=first.obj');
    const first = await call(page, 'hash');
    await walkTo(page, 36, 25.75);
    for (let k = 0; k < 80; ++k) {
        await call(page, 'look', 0.41 * k, 0.5 * Math.sin(k));
        await call(page, 'fire');
        if (k % 10 === 9) assert.equal(await call(page, 'undo'), true);
    }
    const s = await state(page);
    assert.ok(s.drawnTriangles > 16384, `${s.drawnTriangles}`);
    assert.deepEqual(await drawnWrong(page), []);
    await call(page, 'check');
    await call(page, 'look', 2.6, 0.12);
    await call(page, 'step', 0.2, {});
    await shoot(page, '8_many_craters');
    while (await call(page, 'undo'));
    assert.equal(await call(page, 'hash'), first);
    assert.deepEqual(await drawnWrong(page), []);
    assert.deepEqual(errors, []);
    await page.close();
});

test('keys and the mouse', async () => {
    const { page, errors } = await load(session, '?level=first.obj'); // its frames are those of the clock
    const until = (condition, value) => page.waitForFunction(condition, value);
    // Drawn in software, fewer pixels than the page has.
    const { share, full } = await call(page, 'picture');
    assert.ok(share <= 0.5 && !full, `${share}`);
    await page.evaluate(() => window.firmaPlayground.resume());
    const x = (await state(page)).position[0];
    await page.keyboard.down('w');
    await until((from) => window.firmaPlayground.state().position[0] < from - 0.5, x);
    await page.keyboard.up('w');
    const { yaw } = await state(page);
    await page.keyboard.down('ArrowLeft');
    await until((from) => window.firmaPlayground.state().yaw > from + 0.2, yaw);
    await page.keyboard.up('ArrowLeft');
    await page.keyboard.press('f');
    await until(() => window.firmaPlayground.state().version === 1);
    await page.keyboard.press('z');
    await until(() => window.firmaPlayground.state().version === 0);
    await page.keyboard.press('y');
    await until(() => window.firmaPlayground.state().version === 1);
    for (const [key, name, shots] of [['b', 'bridge', 2], ['t', 'wall', 1]]) {
        await page.keyboard.press(key);
        await until(([is, of]) => ((set) => set?.name === is && set.shots === of)(window.firmaPlayground.state().set), [name, shots]);
    }
    for (let version = 3; version >= 1; --version) {
        await page.keyboard.press('z');
        await until((v) => window.firmaPlayground.state().version === v, version);
    }

    await page.mouse.click(500, 300); // takes the pointer, does not fire
    await until(() => document.pointerLockElement !== null);
    assert.equal((await state(page)).version, 1);
    const turned = (await state(page)).yaw;
    await page.mouse.move(600, 320);
    await until((from) => window.firmaPlayground.state().yaw !== from, turned);
    await page.mouse.down(); // held, it goes on firing
    await until(() => window.firmaPlayground.game.actors.rockets.fired >= 5);
    await page.mouse.up();
    await until(() => window.firmaPlayground.state().rockets === 0 && window.firmaPlayground.state().version > 1);
    const { fired } = await page.evaluate(() => window.firmaPlayground.game.actors.rockets);
    await page.mouse.down({ button: 'right' });
    await page.mouse.up({ button: 'right' });
    await until(() => window.firmaPlayground.state().grenades === 1);
    await until(() => window.firmaPlayground.state().grenades === 0);
    assert.equal(await page.evaluate(() => window.firmaPlayground.game.actors.rockets.fired), fired);
    await page.keyboard.press('h');
    await until(() => document.body.classList.contains('without-help'));
    assert.deepEqual(errors, []);
    await page.close();
});

test('another level, and none', async () => {
    const missing = await load(session, '?level=nothing.obj');
    assert.match(missing.error, /nothing\.obj: 404/);
    assert.match(await missing.page.textContent('#message'), /nothing\.obj/);
    await missing.page.close();
    const outside = await load(session, '?level=..%2Ffirst.obj');
    assert.match(outside.error, /a level is/);
    await outside.page.close();
    const { page, error } = await load(session, '?level=first.obj');
    assert.equal(error, null);
    await page.evaluate(() => window.firmaPlayground.resume());
    await Promise.all([page.waitForNavigation(), page.keyboard.press('l')]); // the other one
    await page.waitForFunction(() => window.firmaPlayground?.done);
    assert.match(await page.textContent('#title'), /depot\.map/);
    await page.close();
});

test('the depot: rooms by name, portals shown, a door closed', async () => {
    const { page, errors, error } = await load(session);
    assert.equal(error, null);
    assert.match(await page.textContent('#title'), /depot\.map/);
    let s = await state(page);
    assert.equal(s.room.name, 'hall');
    assert.ok(s.rooms > 12 && s.portals.open === s.portals.all && s.portals.all > 12);
    assert.deepEqual(await drawnWrong(page), []);
    await assertClear(page);
    assert.match(await page.textContent('#hud'), /room hall \(\d+\)/);
    await shoot(page, '9_depot');

    await call(page, 'togglePortals');
    const shownPanes = () => page.evaluate(() => window.firmaPlayground.game.panes.group.children.length);
    assert.equal(await shownPanes(), 2); // panes and rims of open ones
    for (const [x, y] of [[18.75, 9.4], [25, 9.4], [25, 10.5]]) await walkTo(page, x, y);
    await call(page, 'look', 0, 0); // through the gate to the dock
    await shoot(page, '10_portals');
    await call(page, 'togglePortals');
    assert.equal(await shownPanes(), 0);
    assert.match(await page.textContent('#hud'), /through hall, dock/);

    assert.equal(await call(page, 'turnPortal'), true);
    assert.equal((await state(page)).portals.open, s.portals.all - 1);
    assert.equal(await shownPanes(), 2); // the closed one
    await call(page, 'step', 1.5, { forward: true });
    s = await state(page);
    assert.equal(s.room.name, 'hall');
    await shoot(page, '11_closed');
    assert.equal(await call(page, 'undo'), true);
    await call(page, 'step', 1, { forward: true });
    await call(page, 'draw');
    s = await state(page);
    assert.equal(s.room.name, 'dock');
    await assertClear(page);

    await call(page, 'look', 1.2, -0.2);
    assert.equal((await call(page, 'fire')).status, 'done');
    assert.deepEqual(await drawnWrong(page), []);
    await call(page, 'check');
    await shoot(page, '12_dock');
    assert.deepEqual(errors, []);
    await page.close();
});

/** The corners of rubble as it is drawn, low and high. @param which  of what a version's shot cut off, or of the heaviest */
const debrisBounds = (page, which = null) =>
    page.evaluate((of) => {
        window.firmaPlayground.draw();
        const low = [Infinity, Infinity, Infinity];
        const high = low.map((x) => -x);
        const { shown, group } = window.firmaPlayground.game.actors.debrisView;
        const heaviest = [...shown.keys()].reduce((most, piece) => (piece.mass > (most?.mass ?? 0) ? piece : most), null);
        for (const [piece, { regions, group: own }] of shown) {
            if (of === 'heaviest' ? piece !== heaviest : of !== null && Number(piece.version) !== of) continue;
            for (const { geometry } of regions.values()) {
                const corners = geometry.attributes.position;
                const at = own.position.clone();
                for (let k = 0; k < corners.count; ++k) {
                    at.fromBufferAttribute(corners, k).applyQuaternion(own.quaternion).add(own.position);
                    at.toArray().forEach((x, axis) => {
                        low[axis] = Math.min(low[axis], x);
                        high[axis] = Math.max(high[axis], x);
                    });
                }
            }
        }
        return { low, high, drawn: group.children.length };
    }, which);

/** What `firma demo` tells of the same two scenes. */
let told = null;
function toldByDemo() {
    return (told ??= askDemo());
}

function askDemo() {
    const folder = mkdtempSync(path.join(os.tmpdir(), 'firma-playground-'));
    try {
        const call = ['demo', path.join(kRoot, 'levels/depot.map'), '--casts', '100', '--craters', '1', '-o', path.join(folder, 'x.svg'), '--json'];
        return JSON.parse(execFileSync(kFirma, call, { stdio: ['ignore', 'pipe', 'ignore'] })).depot;
    } finally {
        rmSync(folder, { recursive: true });
    }
}

const near = (a, b) => assert.ok(Math.abs(a - b) <= 1e-9 * Math.max(1, Math.abs(b)), `${a} and ${b}`);

test('the bridge shot at both ends falls, as firma demo has it, and comes to rest', async () => {
    const told = toldByDemo().bridge;
    const { page, errors } = await load(session);
    const first = await call(page, 'hash');
    assert.equal(await page.textContent('#bridge'), 'Shoot the bridge (B)');
    await page.click('#bridge');
    assert.equal((await call(page, 'step', 0.3, {})).version, 0); // one looks first
    assert.match(await page.evaluate(() => (window.firmaPlayground.draw(), document.querySelector('#hud .set').textContent)), /the bridge: 0 of 2 shots: shooting/);
    await shoot(page, '13_bridge_before');
    assert.equal((await call(page, 'step', 0.3, {})).version, 1);
    let s = await call(page, 'step', 5, {}); // a shot a step at most
    assert.equal(s.version, 2);
    assert.deepEqual([s.set.shots, s.set.done, s.set.chunks, s.set.crumbs], [2, 2, told.chunks, told.crumbs]);
    for (const [is, should] of [[s.set.volume, told.volume], [s.set.mass, told.mass], [s.set.largest.volume, told.largest.volume], [s.set.largest.mass, told.largest.mass]])
        near(is, should);
    assert.ok(s.set.largest.volume > 8 && s.set.chunks >= 2);

    // It is drawn where it was, as something of its own.
    assert.deepEqual(await drawnWrong(page), []);
    assert.ok(s.debris.triangles > 100 && s.debris.bodies >= 1 && s.debris.mass > 0.99 * told.largest.mass, JSON.stringify(s.debris));
    const { low, high, drawn } = await debrisBounds(page, 2); // what the first shot cut off fell meanwhile
    assert.equal(drawn, s.debris.bodies);
    // The deck is 2 m wide; ends of its rails, which reach toward the walls, are loose as well.
    assert.ok(low[0] >= 12.5 && high[0] <= 15.5 && low[1] > 0 && high[1] < 14 && low[2] >= 2.9 && high[2] <= 5.3 && high[1] - low[1] > 5, `${low} ${high}`);
    await call(page, 'step', 0.4, {});
    await shoot(page, '14_bridge_falls', 0.1);
    const words = await page.textContent('#told');
    assert.ok(words.includes(`${told.chunks} chunks of ${told.volume.toFixed(2)} m\u00b3`) && words.includes(`the largest ${told.largest.volume.toFixed(2)} m\u00b3`), words);
    assert.equal(await page.isVisible('#told'), true);
    for (let k = 0; k < 8; ++k) await call(page, 'step', 0.1, {});
    await shoot(page, '15_bridge_comes_down', 0.1);
    const falling = await debrisBounds(page, 'heaviest'); // lighter ones are thrown up
    assert.ok(falling.high[2] < high[2] - 2, `${falling.high}`);
    for (let k = 0; k < 20 && (await state(page)).debris.awake > 0; ++k) await call(page, 'step', 0.5, {});
    s = await state(page);
    assert.equal(s.debris.awake, 0);
    const lies = await debrisBounds(page);
    assert.ok(lies.low[2] > -0.3 && lies.high[2] < 2.6, `${lies.low} ${lies.high}`); // on the floor of the hall, not in it
    await shoot(page, '16_bridge_lies');
    await call(page, 'check');

    // What lies there is shot to pieces and thrown about.
    await call(page, 'look', Math.atan2(7 - s.eye[1], 14 - s.eye[0]), -0.12);
    assert.ok((await call(page, 'step', 0.1, { rocket: true })).rockets === 1);
    while ((await call(page, 'step', 0.05, {})).rockets > 0);
    await shoot(page, '16_bridge_shot', 0.05);
    assert.ok((await state(page)).debris.awake > 0);

    // Undone, all is back, and nothing lies there any more.
    while (await call(page, 'undo'));
    assert.equal(await call(page, 'hash'), first);
    s = await state(page);
    assert.deepEqual([s.set, s.debris.bodies, await drawnWrong(page)], [null, 0, []]);

    // Who fires himself ends it.
    await call(page, 'startSet', 'bridge');
    await call(page, 'step', 0.6, {});
    const { version } = await state(page);
    await call(page, 'look', 3.1, -0.4);
    assert.equal((await call(page, 'fire')).status, 'done');
    s = await call(page, 'step', 3, {});
    assert.deepEqual([s.version, s.set], [version + 1, null]);
    assert.deepEqual(errors, []);
    await page.close();
});

test('a hole through the thin wall is a portal, and a cast goes through it, as firma demo has it', async () => {
    const told = toldByDemo().hole;
    const { page, errors } = await load(session);
    const before = await state(page);
    await page.click('#wall');
    const s = await call(page, 'step', 0.6, {});
    assert.equal(s.room.name, 'office_west');
    assert.equal(s.portals.all, before.portals.all + 1);
    const [portal] = s.set.portals;
    assert.deepEqual([portal.id, [...portal.rooms].sort()], [told.portal, [...told.rooms].sort()]);
    near(portal.area, told.area);
    for (const when of ['before', 'after']) {
        assert.deepEqual([s.set[when].material, s.set[when].room], [told[when].material, told[when].room]);
        near(s.set[when].distance, told[when].distance);
    }
    assert.deepEqual([s.set.before.room, s.set.after.room], ['office_west', 'office_middle']);
    assert.equal(await page.evaluate(() => window.firmaPlayground.game.stage.cast.visible), true);
    await call(page, 'togglePortals');
    await shoot(page, '17_hole', 0.5);
    assert.match(await page.textContent('#hud .set'), /new: portal \d+ between office_\w+ and office_\w+, 0\.\d\d m\u00b2; a cast met \S+ in room office_west after 3\.25 m before, meets \S+ in room office_middle after 9\.\d\d m now/);
    await call(page, 'place', 3, 18, 0.01); // and so does the cross
    await call(page, 'look', 0, -0.02);
    assert.deepEqual((await call(page, 'aim')).rooms, ['office_west', 'office_middle']);
    assert.deepEqual(await drawnWrong(page), []);
    await call(page, 'undo');
    assert.equal((await state(page)).portals.all, before.portals.all);
    assert.deepEqual((await call(page, 'aim')).rooms, ['office_west']);
    assert.equal(await page.evaluate(() => window.firmaPlayground.game.stage.cast.visible), false);
    assert.deepEqual(errors, []);
    await page.close();

    const other = await load(session, '?level=first.obj'); // of one room
    await other.page.click('#wall');
    const { set } = await call(other.page, 'step', 0.6, {});
    assert.ok(set.portals.length === 0 && set.after.distance > set.before.distance + 5, JSON.stringify(set));
    await call(other.page, 'draw');
    assert.match(await other.page.textContent('#hud .set'), /one room on both sides, so no portal/);
    await shoot(other.page, '18_hole_in_first');
    await other.page.close();
});

test('what a crater of one\'s own cuts off falls', async () => {
    const { page, errors } = await load(session);
    await call(page, 'place', 18.75, 7, 0.01);
    let shot = null;
    for (let k = 0; k < 14 && !shot?.chunks?.count; ++k) {
        const [dx, dy] = [13.9 - 18.75, 1.5 + 0.85 * k - 7]; // along the bridge's rail
        await call(page, 'look', Math.atan2(dy, dx), Math.atan2(3.9 - 1.56, Math.hypot(dx, dy)));
        assert.equal((await call(page, 'fire')).status, 'done');
        const s = await state(page);
        shot = s.shot;
        assert.ok(s.debris.bodies <= shot.chunks.count);
    }
    assert.ok(shot.chunks.count >= 1 && shot.chunks.volume > 0.001, JSON.stringify(shot.chunks));
    near(shot.chunks.mass, 2400 * shot.chunks.volume);
    assert.equal(shot.report.loose, null);
    await shoot(page, '19_own_chunk', 0.3);
    assert.match(await page.textContent('#hud .shot'), /\d chunks? of 0\.\d+ m\u00b3, \d+ kg came loose/);
    assert.deepEqual(await drawnWrong(page), []);
    await call(page, 'check');
    assert.deepEqual(errors, []);
    await page.close();
});

test('times', async () => {
    const { page } = await load(session, '?level=first.obj');
    const measured = await page.evaluate(() => {
        const { game } = window.firmaPlayground;
        const eye = game.player.eye();
        const count = 4000;
        const paths = Array.from({ length: count }, (_, k) => [0.075 * Math.cos(k), 0.075 * Math.sin(k), 0]);
        const median = (values) => values.sort((a, b) => a - b)[values.length >> 1];
        const perCast = (radius, reach) =>
            median(Array.from({ length: 9 }, () => {
                const start = performance.now();
                for (const path of paths) game.launcher.world.cast({ centre: eye, radius, path: path.map((x) => x * reach) });
                return ((performance.now() - start) * 1000) / count;
            }));
        const walking = perCast(0.35, 1);
        const looking = perCast(0, 1000);
        const cuts = [];
        for (let k = 0; k < 60; ++k) {
            game.player.look(0.31 * k, 0.4 * Math.sin(k));
            game.fire();
            cuts.push(game.launcher.last.cutMs);
        }
        const mesh = game.launcher.meshMs;
        return { walking, looking, cut: median(cuts.filter(Number.isFinite)), cuts: cuts.length, leastCut: Math.min(...cuts), mesh: mesh.median() };
    });
    console.log(`# a walking step's sphere cast ${measured.walking.toFixed(2)} us, a view cast ${measured.looking.toFixed(2)} us (medians of 9 x 4,000); ` +
        `a crater ${measured.cut.toFixed(2)} ms (median of ${measured.cuts}; least ${measured.leastCut.toFixed(2)}), drawn anew in ${measured.mesh.toFixed(2)} ms`);
    assert.ok(measured.walking < 500 && measured.looking < 2000 && measured.cut < 500); // orders of magnitude: this machine may be busy
    await page.close();
});
