// SPDX-License-Identifier: MIT
// The same sphere casts and rays by Firma, jolt-physics and rapier in node, in turn, and what they answer.
//
//   node bench_casts.mjs [--quick] [--csv FOLDER]
import { fileURLToPath } from 'node:url';
import { loadFirma } from '../../bindings/js/src/index.js';
import { firmaBatch, firmaSingle, jolt, MISS, rapier } from './casters.mjs';
import { count, finish, median, number, race, ratio, settings, times } from './race.mjs';
import { bumpyRooms, castsInAir, triangulatedObj } from './scene.mjs';

const RADIUS = 0.4;
const SETS = [
    { name: 'spheres, 0.1-2 m', kind: 'balls', radius: RADIUS, shortest: 0.1, longest: 2 },
    { name: 'spheres, 5-50 m', kind: 'balls', radius: RADIUS, shortest: 5, longest: 50 },
    { name: 'rays, 1-2 m', kind: 'rays', radius: 0, shortest: 1, longest: 2 },
    { name: 'rays, 5-100 m', kind: 'rays', radius: 0, shortest: 5, longest: 100 },
];
const root = (path) => fileURLToPath(new URL(`../../${path}`, import.meta.url));

/** How another's fractions differ from Firma's. A graze that one meets and the other does not counts for itself. */
function compare(inputs, ours, theirs) {
    const difference = { missed: 0, extra: 0, early: 0, late: 0, largest: 0 };
    for (let k = 0; k < ours.length; ++k) {
        if ((ours[k] === MISS) !== (theirs[k] === MISS)) {
            ++difference[theirs[k] === MISS ? 'missed' : 'extra'];
            continue;
        }
        const by = theirs[k] - ours[k];
        if (by > 1e-3) ++difference.late;
        if (by < -1e-3) ++difference.early;
        difference.largest = Math.max(difference.largest, Math.abs(by) * Math.hypot(...inputs.subarray(7 * k + 4, 7 * k + 7)));
    }
    return difference;
}

async function castersOf(firma, mesh) {
    const before = performance.now();
    const world = firma.worldFromMesh(mesh);
    const buildMs = performance.now() - before;
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
const rows = [];
const builds = [];
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
        casters.forEach((caster, k) => {
            const { missed, extra, early, late, largest } = compare(inputs, fractions[0], fractions[k]);
            const hits = fractions[k].filter((fraction) => fraction !== MISS).length;
            const ns = (median(laps[k]) * 1e6) / casts;
            const speed = [number(ns), times(ratio(laps[k], laps[0])), times(ratio(laps[k], laps[1]))];
            const answers = [hits, missed, extra, early, late].map(count);
            rows.push([scene.name, triangles, set.name, caster.name, ...speed, ...answers, number(largest * 1e3)]);
        });
    }
}
const asked = ['scene', 'triangles', 'casts', 'who', 'ns a cast', 'to Firma one by one', 'to Firma in a batch'];
const answered = ['hits', 'missed', 'extra', 'early', 'late', 'largest difference mm'];
await finish('node_casts', [...asked, ...answered], rows, csv);
await finish('node_builds', ['scene', 'triangles', 'who', 'build ms'], builds, csv);
process.exit(0);
