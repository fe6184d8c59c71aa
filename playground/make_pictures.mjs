// SPDX-License-Identifier: MIT
// Takes the pictures of docs/playground.md anew: node playground/make_pictures.mjs [FOLDER]. They leave out the line of
// times: frames that a program steps, drawn in software, say nothing about them.
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { call, load, open, shoot } from './test/harness.mjs';

const folder = process.argv[2] ?? path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../docs/pictures');
const viewport = { width: 860, height: 484 };
const session = await open();

/** A page without its help and times, somebody standing there. */
async function stand(x, y, z, level = 'first.obj') {
    const { page } = await load(session, `?level=${level}`, viewport);
    await page.evaluate(() => {
        document.body.classList.add('without-help', 'locked');
        document.querySelector('#hud .times').hidden = true;
    });
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

async function fire(page, shots) {
    for (const [yaw, pitch] of shots) {
        await call(page, 'look', yaw, pitch);
        const { status, text } = await call(page, 'fire');
        if (status !== 'done') throw new Error(text);
    }
}

// The hall, from its eastern side, after some shots.
let page = await stand(37, 25.4, 0.01);
await fire(page, [[2.93, 0.28], [2.8, 0.36], [3.05, 0.02], [3.2, 0.1], [3.35, -0.16], [2.62, 0.2], [2.72, -0.12], [3.52, 0.12], [2.95, -0.2], [2.45, 0.1]]);
await call(page, 'step', 1 / 60, {});
await call(page, 'look', 2.9, 0.1);
await shoot(page, 'playground_hall', 10, folder);
await page.close();

// A hole through five centimetres of wall, just now.
page = await stand(13.6, 27.7, 0.01);
await fire(page, [[Math.PI, -0.02], [Math.PI - 0.2, -0.25], [Math.PI + 0.03, 0]]);
await call(page, 'step', 1 / 60, {});
await call(page, 'look', Math.PI - 0.02, -0.06);
await shoot(page, 'playground_hole', 10, folder);
await page.close();

// Outside, a cliff.
page = await stand(52, 4, 0.2);
await fire(page, [[-0.55, 0.06], [-0.72, 0.12], [-0.9, 0.02], [-0.4, 0.2], [-0.62, -0.12], [-1.1, 0.16]]);
await call(page, 'step', 1 / 60, {});
await call(page, 'look', -0.7, 0.04);
await shoot(page, 'playground_cliff', 10, folder);

await page.close();

// A crater from near by.
page = await stand(52, 4, 0.2);
await fire(page, [[-0.72, 0.12], [-0.75, 0.14], [-0.7, 0.15]]);
await call(page, 'place', 58.2, -1.9, 0.4);
await call(page, 'look', -0.62, 0.3);
await page.evaluate(() => (document.querySelector('#hud').hidden = true));
await shoot(page, 'playground_crater', 10, folder);
await page.close();

// The depot's hall, its portals shown.
page = await stand(18.75, 9.4, 0.01, 'depot.map');
await call(page, 'togglePortals');
await fire(page, [[3.05, 0.35], [3.3, -0.1]]);
await call(page, 'step', 1 / 60, {});
await call(page, 'look', 2.75, 0.12);
await shoot(page, 'playground_depot', 10, folder);
await page.close();

// Its bridge, just after the shot at the other end; then as it goes.
page = await stand(18.75, 9.4, 0.01, 'depot.map');
await play(page, 'bridge');
await shoot(page, 'playground_bridge', 0.16, folder);
await shoot(page, 'playground_bridge_fading', 1.4, folder);

// And the wall between two offices.
await play(page, 'wall');
await call(page, 'togglePortals');
await call(page, 'step', 1 / 60, {});
await shoot(page, 'playground_portal', 10, folder);
await page.close();

await session.close();
