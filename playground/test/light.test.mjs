// SPDX-License-Identifier: MIT
// What is seen is held against what casts say: where the sun shines and where not, and what the inside of a wall is of.
// Pixels are compared with each other, not with a picture.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { kKinds } from '../src/painter.js';
import { call, load, open, shoot } from './harness.mjs';

let session;
before(async () => (session = await open()));
after(async () => assert.equal(await session.close(), 0));

const median = (values) => [...values].sort((a, b) => a - b)[values.length >> 1];

/**
 * What a picture shows on a grid, so many pixels apart: { point, facing: the sun, as the cosine says, material, matter, cut: whether
 * an edit made the face, colour: red, green, blue as linear light, sun: 1 where nothing is toward the sun for 30 cm around,
 * 0 where all is covered, else between }. What moves and what one sees through are left out.
 */
const look = (page, every) =>
    page.evaluate((step) => {
        const { game, draw } = window.firmaPlayground;
        draw(0);
        const gl = document.querySelector('canvas').getContext('webgl2');
        const [width, height] = [gl.drawingBufferWidth, gl.drawingBufferHeight];
        const pixels = new Uint8Array(4 * width * height);
        gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
        const { camera, sun } = game.stage;
        const { world, matters, materials } = game.launcher;
        const toSun = sun.light.position.clone().sub(sun.light.target.position).normalize().toArray();
        const cast = (centre, path) => game.firma.castScene(game.launcher.scene(), { centre, radius: 0, path }, { mask: 4 });
        const isCovered = (at) => {
            const hit = cast(at, toSun.map((x) => 300 * x));
            return hit.hit && (hit.part !== null || !/sky/.test(materials[hit.material]));
        };
        const linear = (c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
        const seen = [];
        for (let y = step >> 1; y < height; y += step) {
            for (let x = step >> 1; x < width; x += step) {
                const way = camera.position.clone().set((2 * (x + 0.5)) / width - 1, (2 * (y + 0.5)) / height - 1, 0.5).unproject(camera).sub(camera.position).normalize();
                const hit = cast(camera.position.toArray(), way.multiplyScalar(100).toArray());
                if (!hit.hit || hit.part !== null || hit.face === null) continue;
                const { point, faceNormal: n } = hit;
                const [a, b] = Math.abs(n[2]) > 0.9 ? [[1, 0, 0], [0, 1, 0]] : [[0, 0, 1], [-n[1], n[0], 0]];
                const around = [[0, 0], [1, 0], [-1, 0], [0, 1], [0, -1]].map(([u, v]) => point.map((c, k) => c + 0.03 * n[k] + 0.3 * (u * a[k] + v * b[k])));
                const at = 4 * (width * y + x);
                seen.push({
                    point, facing: n[0] * toSun[0] + n[1] * toSun[1] + n[2] * toSun[2], material: materials[hit.material], matter: matters[world.matterOf(hit)].name, cut: world.hitInfo(hit).sourceEdit > 0,
                    colour: [0, 1, 2].map((c) => linear(pixels[at + c] / 255)), sun: around.filter((one) => !isCovered(one)).length / around.length,
                });
            }
        }
        return seen;
    }, every);

const light = ({ colour: [r, g, b] }) => 0.2126 * r + 0.7152 * g + 0.0722 * b;

/**
 * What the shadows do to a picture: it is drawn with them and without. @returns of points that face the sun, how much light
 * is left of those in its shade and of those where it shines (medians), how many there are, and the share that is as casts say
 */
async function judgeShadows(page) {
    const castShadow = (on) => page.evaluate((value) => {
        const { sun } = window.firmaPlayground.game.stage;
        sun.light.castShadow = value;
        sun.changed();
    }, on);
    const drawn = await look(page, 6);
    await castShadow(false);
    const without = await look(page, 6);
    await castShadow(true);
    const left = drawn.map((one, k) => ({ ...one, left: light(one) / light(without[k]) })).filter(({ facing, sun }) => facing > 0.3 && (sun === 0 || sun === 1));
    const [shade, sunny] = [0, 1].map((sun) => left.filter((one) => one.sun === sun).map((one) => one.left));
    const right = shade.filter((x) => x < 0.85).length + sunny.filter((x) => x > 0.95).length;
    return { shade: median(shade), shaded: shade.length, sun: median(sunny), sunny: sunny.length, right: right / left.length };
}

/** A page without what lies over the picture. */
async function begin(query) {
    const { page, errors } = await load(session, query, { width: 640, height: 360 });
    await page.evaluate(() => document.body.classList.add('without-help', 'locked'));
    return { page, errors };
}

async function stand(page, feet, [yaw, pitch]) {
    await call(page, 'place', ...feet);
    await call(page, 'look', yaw, pitch);
    await call(page, 'step', 1 / 60, {});
}

test('the sun shines where casts toward it meet nothing, and nowhere else', async () => {
    const { page, errors } = await begin('?level=first.obj&picture=full');
    await stand(page, [52, 4, 0.2], [-0.7, -0.25]);
    await shoot(page, '40_sun', 10);
    const told = await judgeShadows(page);
    assert.ok(told.shaded > 200 && told.sunny > 200, JSON.stringify(told));
    assert.ok(told.shade < 0.75 && told.right > 0.95, JSON.stringify(told));
    assert.deepEqual(errors, []);
    await page.close();
});

test('the sun shines through a hole that was shot', async () => {
    const { page, errors } = await begin('?picture=full');
    await stand(page, [20.5, 9.6, 0.01], [3.6, -0.35]);
    const before = await judgeShadows(page);
    // Craters on the way from a place on the floor to the sun, until that is free.
    const shots = await page.evaluate(() => {
        const { launcher, stage } = window.firmaPlayground.game;
        const { light } = stage.sun;
        const toSun = light.position.clone().sub(light.target.position).normalize().multiplyScalar(300).toArray();
        for (let shot = 0; shot < 8; ++shot) {
            const hit = launcher.world.cast({ centre: [17, 7.5, 0.05], radius: 0, path: toSun }, { mask: 4 });
            if (!hit.hit || /sky/.test(launcher.materials[hit.material])) return shot;
            launcher.shootAt({ position: hit.point, scale: 1.8, seed: shot + 1 });
        }
        return null;
    });
    assert.ok(shots > 0, `${shots}`);
    for (let k = 0; k < 30; ++k) await call(page, 'step', 0.1, {}); // what came loose lies
    await shoot(page, '41_sun_through_a_hole', 10);
    const told = await judgeShadows(page);
    assert.ok(told.sunny > before.sunny + 15 && told.shaded > 200, `${before.sunny} before, ${JSON.stringify(told)}`);
    assert.ok(told.shade < 0.75 && told.sun > 0.95 && told.right > 0.95, JSON.stringify(told));
    assert.deepEqual(errors, []);
    await page.close();
});

/** Of the inside of walls: feet, yaw and pitch to look by, and the shots before. */
const kInsides = {
    brick: [[22.8, 9.8, 0.01], [0, 0.62], [[0.05, 0.72], [-0.05, 0.6]]],
    concrete: [[21.2, 3.25, 0.01], [Math.PI, 0], [[Math.PI, 0], [Math.PI, -0.2]]],
    wood: [[60.4, 17, -0.99], [Math.PI, -0.1], [[Math.PI, 0], [Math.PI - 0.25, -0.1]]],
    steel: [[9.6, 6.6, 0.01], [0, 0.55], [[0.05, 0.55]]],
};

/** Metres from a point to the mortar around its brick, as inside_patterns.js lays them. */
function fromMortar([x, y, z]) {
    const size = [0.26, 0.13, 0.085];
    const at = [x, y, z].map((c, k) => c / size[k]);
    at[0] += 0.5 * (((Math.floor(at[2]) % 2) + 2) % 2);
    return Math.min(...at.map((c, k) => (0.5 - Math.abs(c - Math.floor(c) - 0.5)) * size[k]));
}

/**
 * Kinds of surface in the buffers, of faces that an edit made and whose material is the inside of a matter. `flat`: from now
 * on they are drawn as plain ones.
 */
const insideKinds = (page, matter, flat = false) =>
    page.evaluate(([name, makeFlat]) => {
        const { meshes, launcher } = window.firmaPlayground.game;
        const { ids, materials, sourceEdits } = launcher.world.faces();
        const its = new Set([...ids].filter((id, k) => sourceEdits[k] > 0 && launcher.materials[materials[k]] === `matter/${name}`));
        const kinds = new Set();
        for (const { geometry, ids: of } of meshes.regions.values()) {
            const surface = geometry.getAttribute('surface');
            geometry.index.array.forEach((vertex, corner) => {
                if (!its.has(of[Math.floor(corner / 3)])) return;
                kinds.add(surface.array[4 * vertex + 3]);
                if (makeFlat) surface.array[4 * vertex + 3] = 0;
            });
            surface.needsUpdate = makeFlat;
        }
        return [...kinds];
    }, [matter, flat]);

test('the inside of a wall is drawn by its matter', async () => {
    const { page, errors } = await begin('?picture=full');
    const shares = {}; // of red, green and blue in what is seen of each
    for (const [matter, [feet, way, shots]] of Object.entries(kInsides)) {
        await stand(page, feet, way);
        for (const shot of shots) {
            await call(page, 'look', ...shot);
            assert.equal((await call(page, 'fire')).status, 'done');
        }
        await stand(page, feet, way);
        await shoot(page, `42_inside_${matter}`, 10);
        assert.deepEqual(await insideKinds(page, matter), [kKinds[matter]]);
        const isInside = (one) => one.cut && one.material === `matter/${matter}`;
        const drawn = await look(page, 3);
        const inside = drawn.filter(isInside);
        assert.ok(inside.length > 200 && inside.filter((one) => one.matter === matter).length > 0.9 * inside.length, `${matter}: ${inside.length}`);
        shares[matter] = [0, 1, 2].map((c) => median(inside.map(({ colour }) => colour[c] / (colour[0] + colour[1] + colour[2]))));
        if (matter === 'brick') {
            const [mortar, bricks] = [inside.filter(({ point }) => fromMortar(point) < 0.002), inside.filter(({ point }) => fromMortar(point) > 0.015)];
            const grey = (points) => median(points.map(({ colour }) => colour[1] / colour[0]));
            assert.ok(mortar.length > 20 && bricks.length > 100, `${mortar.length}, ${bricks.length}`);
            assert.ok(grey(mortar) > 1.2 * grey(bricks), `${grey(mortar)}, ${grey(bricks)}`);
        }
        // What is drawn goes by the kind: as plain ones they are without a pattern.
        await insideKinds(page, matter, true);
        const flat = await look(page, 3);
        const changes = drawn.flatMap((one, k) => (isInside(one) ? [light(one) / light(flat[k])] : []));
        const spread = (values) => Math.sqrt(values.reduce((sum, x) => sum + Math.log(x / median(values)) ** 2, 0) / values.length);
        assert.ok(spread(changes) > 0.06, `${matter}: ${spread(changes)}`);
    }
    assert.ok(shares.brick[0] > 0.65, `brick ${shares.brick}`); // red
    assert.ok(shares.wood[1] > 0.27 && shares.wood[2] < 0.12, `wood ${shares.wood}`); // yellow
    assert.ok(shares.concrete[0] < 0.48, `concrete ${shares.concrete}`); // grey
    assert.ok(shares.steel[2] > 1.15 * shares.concrete[2], `steel ${shares.steel}`); // bluer
    assert.deepEqual(errors, []);
    await page.close();
});
