// SPDX-License-Identifier: MIT
// The same sphere casts and rays by Firma, jolt-physics and rapier in node, in turn, and what they answer.
//
//   node bench_casts.mjs [--quick] [--csv FOLDER]
import { fileURLToPath } from 'node:url';
import { loadFirma } from '../../bindings/js/src/index.js';
import { firmaBatch, firmaSingle, jolt, MISS, rapier } from './casters.mjs';
import { clock, count, finish, median, number, race, ratio, settings, times } from './race.mjs';
import { bumpyRooms, castsInAir, triangulatedObj } from './scene.mjs';

const RADIUS = 0.4;
const SETS = [
    { name: 'spheres, 0.1-2 m', kind: 'balls', radius: RADIUS, shortest: 0.1, longest: 2 },
    { name: 'spheres, 5-50 m', kind: 'balls', radius: RADIUS, shortest: 5, longest: 50 },
    { name: 'rays, 1-2 m', kind: 'rays', radius: 0, shortest: 1, longest: 2 },
    { name: 'rays, 5-100 m', kind: 'rays', radius: 0, shortest: 5, longest: 100 },
];
// Places of the casters, in the order of their turns.
const [SINGLE, BATCH] = [0, 1];
const PEERS = [2, 3];
const root = (path) => fileURLToPath(new URL(`../../${path}`, import.meta.url));

/** How another's fractions differ from Firma's: of the path, by more than a thousandth; and how far from the nearest surface
 * each sphere stops, by Firma's closest(). A graze that one meets and the other does not counts for itself. */
function compare(world, inputs, ours, theirs) {
    const found = { hits: 0, missed: 0, extra: 0, early: 0, late: 0, gap: 0, deep: 0 };
    for (let k = 0; k < ours.length; ++k) {
        const [x, y, z, radius, ...path] = inputs.subarray(7 * k, 7 * k + 7);
        const stop = [x, y, z].map((start, axis) => start + theirs[k] * path[axis]);
        const by = theirs[k] - ours[k];
        if (theirs[k] === MISS) found.missed += ours[k] !== MISS;
        else if (ours[k] === MISS) ++found.extra;
        else if (Math.abs(by) > 1e-3) ++found[by > 0 ? 'late' : 'early'];
        if (theirs[k] === MISS) continue;
        ++found.hits;
        const near = world.closest(stop, radius + 1);
        const gap = near === null ? Infinity : near.distance - radius;
        found.gap = Math.max(found.gap, gap);
        found.deep = Math.max(found.deep, -gap);
    }
    return found;
}

async function castersOf(firma, mesh) {
    const before = clock();
    const world = firma.worldFromMesh(mesh);
    const buildMs = clock() - before;
    const casters = [firmaSingle(world, buildMs), firmaBatch(world, buildMs), await jolt(mesh, RADIUS), await rapier(mesh, RADIUS)];
    return { world, casters };
}

const { quick, csv } = settings();
const casts = quick ? 500 : 20_000;
const rounds = quick ? 1 : 9;
const firma = await loadFirma(root('build/wasm/bin/firma.wasm'));
const rooms = quick ? 2 : 6;
const scenes = [
    { name: 'our level', mesh: await triangulatedObj(root('levels/first.obj')) },
    { name: 'bumpy rooms', mesh: bumpyRooms(rooms), low: [0, 0, 0], high: [rooms * 13.5, rooms * 13.5, 6] },
];
const [speeds, answers, builds] = [[], [], []];
for (const scene of scenes) {
    const { world, casters } = await castersOf(firma, scene.mesh);
    const triangles = count(scene.mesh.corners.length / 3);
    for (const caster of casters)
        if (caster.name !== 'Firma, batch') builds.push([scene.name, triangles, caster.name.split(',')[0], number(caster.buildMs)]);
    const { low, high } = { ...world.facts(), ...scene };
    for (const set of SETS) {
        const inputs = castsInAir(world, low, high, set.radius, set.shortest, set.longest, casts, 11);
        const fractions = casters.map(() => new Float64Array(casts));
        const laps = race(casters.map((caster, k) => () => caster[set.kind](inputs, fractions[k])), rounds);
        const ns = laps.map((lap) => number((median(lap) * 1e6) / casts));
        const ratios = PEERS.flatMap((peer) => [SINGLE, BATCH].map((own) => times(ratio(laps[peer], laps[own]))));
        speeds.push([scene.name, triangles, set.name, ...ns, ...ratios]);
        for (const peer of [BATCH, ...PEERS]) {
            const found = compare(world, inputs, fractions[SINGLE], fractions[peer]);
            const counts = [found.hits, found.missed, found.extra, found.early, found.late].map(count);
            const lengths = [found.gap, found.deep].map((metres) => number(metres * 1e3));
            answers.push([scene.name, set.name, casters[peer].name, count(casts), ...counts, ...lengths]);
        }
    }
    world.release();
}
const who = ['Firma one by one', 'Firma in a batch', 'jolt-physics', 'rapier3d-simd-compat'];
const against = ['jolt to one by one', 'jolt to batch', 'rapier to one by one', 'rapier to batch'];
await finish('node_casts', ['scene', 'triangles', 'casts', ...who.map((name) => `${name} ns`), ...against], speeds, csv);
const differences = ['hits', 'missed', 'extra', 'early', 'late', 'stops short by at most mm', 'goes too deep by at most mm'];
await finish('node_answers', ['scene', 'casts', 'who', 'asked', ...differences], answers, csv);
await finish('node_builds', ['scene', 'triangles', 'who', 'build ms'], builds, csv);
process.exit(0);
