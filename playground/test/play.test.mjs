// SPDX-License-Identifier: MIT
// Somebody plays: a fire fight in the depot at 1280x720 by keys, and on a phone by fingers, upright and on its side; both
// bring the bridge down.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { call, load, open, shoot } from './harness.mjs';

const kPhone = { hasTouch: true, isMobile: true, deviceScaleFactor: 2 };
let session;
before(async () => (session = await open()));
after(async () => assert.equal(await session.close(), 0));

const state = (page) => call(page, 'state');

/** Steps until something holds; the state then. */
async function until(page, dt, keys, holds, most = 80) {
    for (let k = 0; k < most; ++k) {
        const s = await call(page, 'step', dt, keys);
        if (holds(s)) return s;
    }
    throw new Error(`not within ${most} steps: ${JSON.stringify(await state(page))}`);
}

test('a fire fight at 1280x720: rockets, grenades, rubble, a door', async () => {
    const { page, errors } = await load(session, '', { width: 1280, height: 720 });
    assert.equal(await page.isVisible('#hud'), false);
    assert.equal(await page.isVisible('#buttons'), false);
    await shoot(page, '20_play_start', 0.1);
    const first = await call(page, 'hash');

    // Held, it fires on; rockets take their time; a blast flashes, throws specks, shakes the view.
    await call(page, 'look', 2.9, 0.2);
    let s = await call(page, 'step', 0.05, { rocket: true });
    assert.deepEqual([s.rockets, s.version], [1, 0]);
    await call(page, 'step', 0.05, { rocket: true });
    await shoot(page, '21_rocket', 0.02);
    s = await until(page, 0.05, { rocket: true }, ({ version }) => version > 0);
    assert.ok(s.specks > 40, `${s.specks}`);
    const seen = () => page.evaluate(() => {
        const { stage, show } = window.firmaPlayground.game;
        window.firmaPlayground.draw(0.02);
        return { flash: stage.blast.light.intensity, shake: Math.max(...show.shake.turn().map(Math.abs)) };
    });
    const now = await seen();
    assert.ok(now.flash > 5 && now.shake > 1e-4, JSON.stringify(now));
    await shoot(page, '22_blast', 0.04);
    s = await until(page, 0.1, { rocket: true }, ({ version }) => version >= 4);
    s = await until(page, 0.1, {}, ({ rockets }) => rockets === 0);
    await shoot(page, '23_dust', 0.3);
    await call(page, 'draw', 8);
    assert.equal((await state(page)).specks, 0);
    assert.ok((await seen()).flash === 0);

    // A grenade bounces and goes off.
    const { version } = await state(page);
    await call(page, 'look', 3.1, 0.1);
    s = await call(page, 'step', 0.05, { grenade: true });
    assert.equal(s.grenades, 1);
    await call(page, 'step', 0.3, {});
    await shoot(page, '24_grenade', 0.02);
    s = await until(page, 0.1, {}, ({ grenades }) => grenades === 0);
    assert.ok(s.version > version);
    await shoot(page, '25_grenade_blast', 0.05);
    assert.deepEqual([(await call(page, 'clearance')).inSolid], [false]);

    // The bridge comes down, and breaks.
    await call(page, 'startSet', 'bridge');
    s = await until(page, 0.1, {}, ({ set }) => set.shots === 2);
    assert.ok(s.debris.bodies > 0);
    await until(page, 0.1, {}, ({ debris }) => debris.awake === 0, 150);
    await shoot(page, '26_rubble', 0.1);
    await call(page, 'check');

    // A door swings.
    await call(page, 'place', 4.45, 12.6, 0.01);
    await call(page, 'look', Math.PI / 2, -0.05);
    await call(page, 'step', 0.05, {});
    await shoot(page, '27_door_open', 0.1);
    assert.equal(await call(page, 'turnPortal'), true);
    s = await call(page, 'step', 0.3, {});
    assert.ok(s.doors.moving);
    await shoot(page, '28_door_swings', 0.1);
    s = await until(page, 0.1, {}, ({ doors }) => !doors.moving);
    await shoot(page, '29_door_shut', 0.1);
    s = await call(page, 'step', 1.5, { forward: true });
    assert.ok(s.position[1] < 14.2, `${s.position}`);
    assert.equal(await call(page, 'turnPortal'), true);
    s = await call(page, 'step', 0.6, {});
    s = await call(page, 'step', 1.5, { forward: true });
    assert.ok(s.position[1] > 15, `${s.position}`);

    while (await call(page, 'undo'));
    assert.equal(await call(page, 'hash'), first);
    assert.equal((await state(page)).debris.bodies, 0);
    assert.deepEqual(errors, []);
    await page.close();
});

test('sound is off at first, and can be heard when it is on', async () => {
    const { page, errors } = await load(session, '?level=first.obj', { width: 640, height: 360 });
    const sound = () => page.evaluate(() => (({ on, played, context }) => ({ on, played, context: context?.state ?? null }))(window.firmaPlayground.game.show.sound));
    await call(page, 'step', 0.05, { rocket: true });
    assert.deepEqual(await sound(), { on: false, played: 0, context: null });
    await page.keyboard.press('m');
    assert.equal((await sound()).on, true);
    await until(page, 0.1, { rocket: true }, ({ version }) => version > 1);
    assert.ok((await sound()).played >= 2);
    await page.keyboard.press('m');
    const { on, played } = await sound();
    await call(page, 'step', 0.5, { rocket: true });
    assert.deepEqual([on, (await sound()).played], [false, played]);
    for (const name of await call(page, 'sounds')) {
        const { peak, energy, finite } = await page.evaluate((one) => window.firmaPlayground.renderSound(one), name);
        assert.ok(finite && peak > 0.02 && peak < 2 && energy > 0.5, `${name}: ${peak}, ${energy}`);
    }
    assert.deepEqual(errors, []);
    await page.close();
});

/** Boxes of what can be touched, and what is wrong with them. */
const wrongLayout = (page) =>
    page.evaluate(() => {
        const wrong = [];
        const boxes = [...document.querySelectorAll('button')].filter((button) => button.checkVisibility()).map((button) => ({ name: button.id || button.dataset.do, box: button.getBoundingClientRect() }));
        const cross = document.querySelector('#cross').getBoundingClientRect();
        const meets = (a, b) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
        for (const { name, box } of boxes) {
            if (box.width < 36 || box.height < 36) wrong.push(`${name} is ${box.width} x ${box.height}`);
            if (box.left < 0 || box.top < 0 || box.right > innerWidth || box.bottom > innerHeight) wrong.push(`${name} is not on the page`);
            if (meets(box, cross)) wrong.push(`${name} is over the cross`);
            for (const other of boxes) if (other.name > name && meets(box, other.box)) wrong.push(`${name} and ${other.name} overlap`);
        }
        for (const id of ['#hud', '#told', '#corner']) {
            const part = document.querySelector(id);
            if (!part.checkVisibility()) continue;
            const box = part.getBoundingClientRect();
            if (box.left < 0 || box.right > innerWidth + 0.5 || box.bottom > innerHeight) wrong.push(`${id} is not on the page`);
        }
        if (document.documentElement.scrollWidth > innerWidth || document.documentElement.scrollHeight > innerHeight) wrong.push('the page scrolls');
        return { wrong, buttons: boxes.map(({ name }) => name) };
    });

/** Fingers on the page, as a phone tells of them. */
async function fingers(page) {
    const client = await page.context().newCDPSession(page);
    return (type, ...points) => client.send('Input.dispatchTouchEvent', { type, touchPoints: points.map(([x, y, id]) => ({ x, y, id })) });
}

for (const [name, viewport] of [['upright', { width: 390, height: 844 }], ['on its side', { width: 844, height: 390 }]]) {
    test(`a phone ${name}: walk, look, fire, jump, the menu`, async () => {
        const { page, errors } = await load(session, '', viewport, kPhone);
        const { width, height } = viewport;
        const short = name.replaceAll(' ', '_');
        await shoot(page, `30_phone_${short}`, 0.1);
        let { wrong, buttons } = await wrongLayout(page);
        assert.deepEqual(wrong, []);
        for (const one of ['fire', 'throw', 'jump', 'use', 'menu']) assert.ok(buttons.includes(one), `${buttons}`);
        assert.equal(await page.isVisible('#help'), false);

        const touch = await fingers(page);
        const held = () => page.evaluate(() => window.firmaPlayground.heldNow());
        const from = await state(page);
        // A stick at the left, and a finger at the right that turns the view, at once.
        await touch('touchStart', [0.2 * width, 0.7 * height, 1]);
        await touch('touchMove', [0.2 * width, 0.7 * height - 50, 1]);
        assert.equal((await held()).forward, true);
        await touch('touchStart', [0.2 * width, 0.7 * height - 50, 1], [0.6 * width, 0.3 * height, 2]);
        await touch('touchMove', [0.2 * width, 0.7 * height - 50, 1], [0.6 * width - 60, 0.3 * height + 20, 2]);
        await shoot(page, `31_phone_${short}_stick`, 0.1);
        await page.evaluate(() => window.firmaPlayground.resume());
        await page.waitForFunction((x) => window.firmaPlayground.state().position[0] < x - 0.5, from.position[0]);
        await page.evaluate(() => window.firmaPlayground.pause());
        await touch('touchEnd');
        assert.ok(!(await held()).forward);
        const turned = await state(page);
        assert.ok(turned.yaw > from.yaw + 0.1 && turned.pitch < from.pitch - 0.02, `${turned.yaw} ${turned.pitch}`);

        // The button that fires, held.
        const middle = await page.evaluate(() => (({ left, right, top, bottom }) => [(left + right) / 2, (top + bottom) / 2])(document.querySelector('#fire').getBoundingClientRect()));
        await page.evaluate(() => window.firmaPlayground.resume());
        await touch('touchStart', [...middle, 3]);
        await page.waitForFunction(() => window.firmaPlayground.game.actors.rockets.fired >= 2);
        await touch('touchEnd');
        await page.tap('#throw');
        await page.waitForFunction(() => window.firmaPlayground.game.actors.grenades.thrown === 1);
        await page.tap('#jump');
        await page.waitForFunction(() => window.firmaPlayground.state().version >= 2);
        await page.evaluate(() => window.firmaPlayground.pause());
        await shoot(page, `32_phone_${short}_fight`, 0.05);

        await page.tap('#menu');
        await page.tap('#more [data-do=figures]');
        await call(page, 'draw');
        ({ wrong, buttons } = await wrongLayout(page));
        assert.deepEqual(wrong.filter((text) => !/over the cross/.test(text)), []);
        for (const one of ['undo', 'redo', 'sound', 'figures', 'respawn', 'bridge', 'wall']) assert.ok(buttons.includes(one), `${buttons}`);
        assert.equal(await page.isVisible('#hud'), true);
        await shoot(page, `33_phone_${short}_menu`, 0.1);
        const { version } = await state(page);
        await page.tap('#more [data-do=undo]');
        assert.equal((await state(page)).version, version - 1);
        assert.deepEqual(errors, []);
        await page.close();
    });
}

test('a phone brings the bridge down by touch: it falls, breaks, comes to rest', async () => {
    const { page, errors } = await load(session, '', { width: 844, height: 390 }, kPhone);
    const first = await call(page, 'hash');
    await page.evaluate(() => window.firmaPlayground.resume());
    await page.tap('#menu');
    await page.tap('#bridge');
    assert.equal(await page.isVisible('#bridge'), false); // the menu does not cover it
    await page.waitForFunction(() => window.firmaPlayground.state().set?.shots === 2);
    await page.evaluate(() => window.firmaPlayground.pause());
    let s = await state(page);
    assert.ok(s.debris.bodies > 0 && s.debris.awake > 0, JSON.stringify(s.debris));
    await shoot(page, '34_phone_bridge_falls', 0.1);
    const { bodies } = s.debris;
    s = await until(page, 0.1, {}, ({ debris }) => debris.awake === 0, 150);
    assert.ok(s.debris.bodies > bodies, `${s.debris.bodies} pieces of ${bodies}`);
    assert.ok(s.debris.mass > 0.98 * s.set.largest.mass, JSON.stringify(s.debris));
    const heights = await page.evaluate(() => [...window.firmaPlayground.game.actors.debris.pieces.values()].map(({ at }) => at[2]));
    assert.ok(heights.every((z) => z > 0 && z < 2.6), `${heights}`);
    assert.match(await page.evaluate(() => (window.firmaPlayground.draw(), document.querySelector('#told').textContent)), /^the bridge: 2 of 2 shots: \d+ chunks of /);
    assert.equal(await page.isVisible('#told'), true);
    await shoot(page, '35_phone_bridge_lies', 5);
    await page.tap('#menu');
    for (const version of [1, 0]) {
        await page.tap('#more [data-do=undo]');
        assert.equal((await state(page)).version, version);
    }
    assert.deepEqual([await call(page, 'hash'), (await state(page)).debris.bodies], [first, 0]);
    assert.deepEqual(errors, []);
    await page.close();
});
