// SPDX-License-Identifier: MIT
// Takes the pictures of docs/playground.md anew: node playground/make_pictures.mjs [FOLDER [NAME]], all, or
// those that have NAME in their name. They leave out the line of times: frames that a program steps, drawn in software, say nothing about them.
import { writeFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { call, load, open, shoot } from './test/harness.mjs';

const folder = process.argv[2] ?? path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../docs/pictures');
const viewport = { width: 860, height: 484 };
const session = await open();

/** Of the insides: feet, yaw and pitch to look by, and the shots before. */
const kInsides = [
    [[22.8, 9.8, 0.01], 0, 0.62, [[0.05, 0.72], [-0.05, 0.6]]], // a wall of brick
    [[21.2, 3.25, 0.01], Math.PI, 0, [[Math.PI, 0], [Math.PI, -0.2]]], // a pillar of concrete
    [[60.4, 17, -0.99], Math.PI, -0.1, [[Math.PI, 0], [Math.PI - 0.25, -0.1]]], // a hut of wood
    [[9.6, 6.6, 0.01], 0, 0.55, [[0.05, 0.55]]], // the bridge's steel
];
const only = process.argv[3] ?? '';
const wanted = (...names) => names.some((name) => name.includes(only));

/** A page without its help and times, somebody standing there. @param figures  whether the engine's are shown */
async function stand(x, y, z, level = 'first.obj', figures = false) {
    const { page } = await load(session, `?picture=full&level=${level}`, viewport);
    await page.evaluate((shown) => {
        document.body.classList.add('without-help', 'locked');
        document.body.classList.toggle('figures', shown);
        document.querySelector('#hud .times').hidden = true;
        document.querySelector('#corner').hidden = true;
    }, figures);
    await call(page, 'place', x, y, z);
    await call(page, 'step', 1 / 60, {});
    return page;
}

/** Plays a scene, to just after its last shot. */
async function play(page, name) {
    if (!(await call(page, 'startSet', name))) throw new Error(`no ${name}`);
    for (let left = true; left; ) {
        await call(page, 'draw', 0.4);
        const { set } = await call(page, 'step', 0.7, {});
        left = set.shots < set.all;
    }
}

/** Draws now and keeps the picture in the page, without what lies over it. */
const keep = (page, dt) => page.evaluate((seconds) => {
    window.firmaPlayground.draw(seconds);
    const canvas = document.querySelector('canvas');
    const copy = document.createElement('canvas');
    [copy.width, copy.height] = [canvas.width / 2, canvas.height / 2];
    copy.getContext('2d').drawImage(canvas, 0, 0, copy.width, copy.height);
    (window.kept ??= []).push(copy);
}, dt);

/** The kept pictures, so many in a row, as one file. @param file  with its ending, png or jpeg */
async function writeStrip(page, file, across) {
    const data = await page.evaluate(([columns, type]) => {
        const { width, height } = window.kept[0];
        const gap = 3;
        const strip = document.createElement('canvas');
        strip.width = columns * (width + gap) - gap;
        strip.height = Math.ceil(window.kept.length / columns) * (height + gap) - gap;
        const context = strip.getContext('2d');
        window.kept.forEach((picture, k) => context.drawImage(picture, (k % columns) * (width + gap), Math.floor(k / columns) * (height + gap)));
        window.kept = [];
        return strip.toDataURL(`image/${type}`, 0.9).split(',')[1];
    }, [across, path.extname(file).slice(1)]);
    writeFileSync(path.join(folder, file), Buffer.from(data, 'base64'));
}

/** Steps with these keys held, so many times. */
async function go(page, dt, count, keys = {}) {
    for (let k = 0; k < count; ++k) await call(page, 'step', dt, keys);
}

async function fire(page, shots) {
    for (const [yaw, pitch] of shots) {
        await call(page, 'look', yaw, pitch);
        const { status, text } = await call(page, 'fire');
        if (status !== 'done') throw new Error(text);
    }
}

// A fire fight in the depot: a rocket at a wall of brick, the bridge comes down and breaks, a shot into what lies there.
if (wanted('playground_fire_fight')) {
    const page = await stand(21.5, 3.5, 0.01, 'depot.map');
    await page.evaluate(() => (document.querySelector('#cross').hidden = true));
    await call(page, 'look', 1.637, 0.02);
    await go(page, 0.05, 1, { rocket: true });
    await go(page, 0.05, 2);
    await keep(page, 0.03);
    for (let k = 0; k < 20; ++k) if ((await call(page, 'step', 0.03, {})).version > 0) break;
    await keep(page, 0.06);
    await call(page, 'place', 21.3, 10.6, 0.01);
    await go(page, 0.1, 4);
    await keep(page, 1.4);
    await call(page, 'startSet', 'bridge');
    await call(page, 'place', 20.5, 9.6, 0.01);
    await call(page, 'look', 3.5, 0.16);
    await go(page, 0.6, 1);
    await call(page, 'draw', 0.3);
    await go(page, 0.7, 1);
    await keep(page, 0.08);
    await go(page, 0.1, 4);
    await keep(page, 0.35);
    await go(page, 0.1, 4);
    await keep(page, 0.3);
    await go(page, 0.1, 30);
    await call(page, 'place', 18.6, 10.4, 0.01);
    await call(page, 'look', 3.75, -0.1);
    await keep(page, 6);
    await go(page, 0.05, 1, { rocket: true });
    for (let k = 0; k < 20; ++k) if ((await call(page, 'step', 0.03, {})).rockets === 0) break;
    await keep(page, 0.06);
    await go(page, 0.1, 4);
    await keep(page, 0.35);
    await writeStrip(page, 'playground_fire_fight.jpeg', 3);
    await page.close();
}

// The inside of brick, concrete, wood and steel, near by.
if (wanted('playground_insides')) {
    const page = await stand(18.75, 9.4, 0.01, 'depot.map');
    await page.evaluate(() => (document.querySelector('#cross').hidden = true));
    for (const [feet, yaw, pitch, shots] of kInsides) {
        await call(page, 'place', ...feet);
        await fire(page, shots);
        await call(page, 'look', yaw, pitch);
        await go(page, 1 / 60, 1);
        await keep(page, 10);
    }
    await writeStrip(page, 'playground_insides.jpeg', 2);
    await page.close();
}

// A phone, upright.
if (wanted('playground_phone')) {
    const { page } = await load(session, '?picture=full', { width: 390, height: 844 }, { hasTouch: true, isMobile: true, deviceScaleFactor: 1 });
    await call(page, 'look', 2.95, 0.12);
    await call(page, 'fire');
    await call(page, 'step', 0.02, {});
    await shoot(page, 'playground_phone', 0.1, folder);
    await page.close();
}

// The hall, from its eastern side, after some shots.
if (wanted('playground_hall')) {
    const page = await stand(37, 25.4, 0.01);
    await fire(page, [[2.93, 0.28], [2.8, 0.36], [3.05, 0.02], [3.2, 0.1], [3.35, -0.16], [2.62, 0.2], [2.72, -0.12], [3.52, 0.12], [2.95, -0.2], [2.45, 0.1]]);
    await call(page, 'step', 1 / 60, {});
    await call(page, 'look', 2.9, 0.1);
    await shoot(page, 'playground_hall', 10, folder);
    await page.close();
}

// A hole through five centimetres of wall, just now.
if (wanted('playground_hole')) {
    const page = await stand(13.6, 27.7, 0.01, 'first.obj', true);
    await fire(page, [[Math.PI, -0.02], [Math.PI - 0.2, -0.25], [Math.PI + 0.03, 0]]);
    await call(page, 'step', 1 / 60, {});
    await call(page, 'look', Math.PI - 0.02, -0.06);
    await shoot(page, 'playground_hole', 10, folder);
    await page.close();
}

// Outside, a cliff.
if (wanted('playground_cliff')) {
    const page = await stand(52, 4, 0.2);
    await fire(page, [[-0.55, 0.06], [-0.72, 0.12], [-0.9, 0.02], [-0.4, 0.2], [-0.62, -0.12], [-1.1, 0.16]]);
    await call(page, 'step', 1 / 60, {});
    await call(page, 'look', -0.7, 0.04);
    await shoot(page, 'playground_cliff', 10, folder);
    await page.close();
}

// A crater from near by.
if (wanted('playground_crater')) {
    const page = await stand(52, 4, 0.2);
    await fire(page, [[-0.72, 0.12], [-0.75, 0.14], [-0.7, 0.15]]);
    await call(page, 'place', 58.2, -1.9, 0.4);
    await call(page, 'look', -0.62, 0.3);
    await page.evaluate(() => (document.querySelector('#hud').hidden = true));
    await shoot(page, 'playground_crater', 10, folder);
    await page.close();
}

// The depot's hall, its portals shown.
if (wanted('playground_depot')) {
    const page = await stand(18.75, 9.4, 0.01, 'depot.map');
    await call(page, 'togglePortals');
    await fire(page, [[3.05, 0.35], [3.3, -0.1]]);
    await call(page, 'step', 1 / 60, {});
    await call(page, 'look', 2.75, 0.12);
    await shoot(page, 'playground_depot', 10, folder);
    await page.close();
}

// Its bridge, just after the shot at the other end; then as it goes.
if (wanted('playground_bridge', 'playground_bridge_lies', 'playground_portal')) {
    const page = await stand(18.75, 9.4, 0.01, 'depot.map');
    await play(page, 'bridge');
    await shoot(page, 'playground_bridge', 0.16, folder);
    await go(page, 0.1, 40);
    await shoot(page, 'playground_bridge_lies', 5, folder);

    // And the wall between two offices.
    await play(page, 'wall');
    await call(page, 'togglePortals');
    await call(page, 'step', 1 / 60, {});
    await shoot(page, 'playground_portal', 10, folder);
    await page.close();
}

await session.close();
