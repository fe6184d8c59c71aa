// SPDX-License-Identifier: MIT
// The same bodies moved by Firma, jolt-physics and rapier in node, each scene in turn by each: time a step, bodies lost,
// depth, energy that comes from nowhere, time to rest.
//
//   node bench_bodies.mjs [--quick] [--csv FOLDER]
//
// The scenes are those that bench_bodies wrote into build/body_scenes (bench/node/run.sh).
import { fileURLToPath } from 'node:url';
import { FACE_SOLID, loadGames } from '../../bindings/js/src/games.js';
import { firmaBodies, joltBodies, NUMBERS, rapierBodies, statesOf, TICK } from './body_engines.mjs';
import { bodyScenes } from './body_scenes.mjs';
import { clock, count, finish, number, settings, times } from './race.mjs';

const GRAVITY = 9.81;
const LOOK_EVERY = 6; // steps
const root = (path) => fileURLToPath(new URL(`../../${path}`, import.meta.url));

/** A vector turned by a unit quaternion. */
function turned([x, y, z, w], v) {
    const t = [2 * (y * v[2] - z * v[1]), 2 * (z * v[0] - x * v[2]), 2 * (x * v[1] - y * v[0])];
    return [
        v[0] + w * t[0] + y * t[2] - z * t[1],
        v[1] + w * t[1] + z * t[0] - x * t[2],
        v[2] + w * t[2] + x * t[1] - y * t[0],
    ];
}

/** Joules of all bodies: of motion, spin, and height. */
function energyOf(scene, { numbers }) {
    return scene.bodies.reduce((sum, { mass, inertia }, k) => {
        const at = numbers.subarray(NUMBERS * k, NUMBERS * (k + 1));
        const [x, y, z, w] = at.subarray(3, 7);
        const spin = turned([-x, -y, -z, w], at.subarray(10, 13));
        const [vx, vy, vz] = at.subarray(7, 10);
        const turning = spin.reduce((all, rate, axis) => all + inertia[axis] * rate * rate, 0);
        return sum + (mass * (vx * vx + vy * vy + vz * vz) + turning) / 2 + mass * GRAVITY * at[2];
    }, 0);
}

/** Bodies with a sphere's centre in solid, below the level or nowhere; and how deep the deepest other sphere is. */
function look(scene, { numbers }, figures) {
    const { world, low } = scene.level;
    figures.lost = 0;
    scene.bodies.forEach(({ spheres }, k) => {
        const at = numbers.subarray(NUMBERS * k, NUMBERS * (k + 1));
        if (!(at[2] >= low[2])) return void ++figures.lost; // what is no number, too
        let deepest = 0;
        for (let s = 0; s < spheres.length; s += 4) {
            const centre = turned(at.subarray(3, 7), spheres.subarray(s, s + 3)).map((part, axis) => part + at[axis]);
            if (world.locate(centre).where === 'solid') return void ++figures.lost;
            const near = world.closest(centre, spheres[s + 3]);
            if (near !== null && near.face !== null && world.face({ id: near.face, corner: near.corner }).flags & FACE_SOLID) deepest = Math.max(deepest, spheres[s + 3] - near.distance);
        }
        figures.deepest = Math.max(figures.deepest, deepest);
    });
}

function run(engine, scene) {
    const figures = { steps: [], lost: 0, deepest: 0, gained: 0, rest: Infinity, awake: scene.bodies.length };
    const states = statesOf(scene.bodies.length);
    engine.start(scene);
    engine.read(states);
    const first = energyOf(scene, states);
    let least = first;
    const steps = Math.round(scene.seconds / TICK);
    for (let k = 1; k <= steps; ++k) {
        const before = clock();
        engine.step();
        figures.steps.push(clock() - before);
        engine.read(states);
        const energy = energyOf(scene, states);
        figures.gained = Math.max(figures.gained, energy - least);
        least = Math.min(least, energy);
        figures.awake = states.asleep.reduce((sum, asleep) => sum + (asleep ? 0 : 1), 0);
        if (figures.rest === Infinity && figures.awake * 20 <= scene.bodies.length) figures.rest = k * TICK;
        if (k % LOOK_EVERY === 0 || k === steps) look(scene, states, figures);
    }
    figures.spent = first - energyOf(scene, states);
    engine.finish();
    return figures;
}

const { quick, csv } = settings();
const games = await loadGames(root('build/wasm/bin/firma_games.wasm'));
const scenes = bodyScenes(games, root('build/body_scenes')).map((scene) => (quick ? { ...scene, bodies: scene.bodies.slice(0, 10), seconds: 0.5 } : scene));
const engines = [firmaBodies(games), await joltBodies(false), await joltBodies(true), await rapierBodies(false), await rapierBodies(true)];
// The first runs are for the engine, which has to compile what is timed.
for (const engine of engines) run(engine, { ...scenes[0], seconds: quick ? 0.1 : 1 });
const rows = [];
for (const scene of scenes) {
    let ours = 0;
    for (const engine of engines) {
        const boxes = engine.name.endsWith('boxes');
        if (boxes && !scene.bodies[0].half) continue;
        const { steps, lost, deepest, gained, spent, rest, awake } = run(engine, scene);
        const mean = steps.reduce((sum, ms) => sum + ms, 0) / steps.length;
        if (ours === 0) ours = mean;
        rows.push([
            scene.name,
            engine.name,
            count(scene.bodies.length),
            number(mean),
            number(Math.max(...steps)),
            number(scene.bodies.length / mean),
            engine === engines[0] ? '' : times(mean / ours),
            count(lost),
            boxes ? '' : number(1e3 * deepest),
            `${number((100 * gained) / Math.max(spent, 1e-9))}%`,
            rest === Infinity ? 'no' : number(rest),
            count(awake),
        ]);
    }
}
const columns = ['scene', 'library', 'bodies', 'ms a step', 'worst ms', 'bodies a ms', "of Firma's time", 'lost', 'deepest mm', 'energy gained', 'at rest after s', 'awake at the end'];
await finish('node_bodies', columns, rows, csv);
process.exit(0);
