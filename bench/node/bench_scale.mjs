// SPDX-License-Identifier: MIT
// The scenes and casts of bench_scale in node, by Firma's module and by jolt-physics: times, whether the module answers
// with the same bits as the library did natively, and where jolt-physics differs.
//
//   node bench_scale.mjs FOLDER [--quick] [--csv FOLDER]      FOLDER: what bench_scale --dump wrote
import { readdir, readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { loadFirma } from '../../bindings/js/src/index.js';
import { firmaBatch, firmaSingle, jolt, MISS } from './casters.mjs';
import { count, finish, median, number, race, ratio, times } from './race.mjs';

/** Metres along the path that two stops may lie apart, as in bench/scale/differences.h. */
const STOP_TOLERANCE = 0.002;

const { values, positionals } = parseArgs({
    allowPositionals: true,
    options: { quick: { type: 'boolean', default: false }, csv: { type: 'string', default: '' } },
});
const rounds = values.quick ? 1 : 5;

/** A scene as bench/scale/dump.h writes it; casts in double, which is what both modules are given. */
async function readScene(folder, name) {
    const about = JSON.parse(await readFile(join(folder, name), 'utf8'));
    const file = await readFile(join(folder, name.replace(/json$/, 'bin')));
    const bytes = file.buffer.slice(file.byteOffset, file.byteOffset + file.byteLength);
    let at = 0;
    const next = (Kind, length) => {
        const part = new Kind(bytes.slice(at, at + length * Kind.BYTES_PER_ELEMENT));
        at += part.byteLength;
        return part;
    };
    const positions = Float64Array.from(next(Float32Array, 3 * about.vertices));
    const corners = next(Uint32Array, 3 * about.triangles);
    const kinds = about.kinds.map((kind) => ({
        ...kind,
        inputs: Float64Array.from(next(Float32Array, 7 * about.casts)),
        fractions: next(Float64Array, about.casts),
    }));
    return { scene: about.scene, mesh: { positions, corners }, triangles: about.triangles, casts: about.casts, kinds };
}

/** As the others meet them: from both sides. */
function worldOf(firma, mesh) {
    return firma.worldFromMesh({ ...mesh, twoSided: new Uint8Array(mesh.corners.length / 3).fill(1) });
}

const isHit = (fraction) => fraction <= 1;

function differ(ours, theirs, inputs) {
    let found = 0;
    for (let k = 0; k < ours.length; ++k) {
        const rim = STOP_TOLERANCE / Math.hypot(...inputs.subarray(7 * k + 4, 7 * k + 7));
        if (isHit(ours[k]) && isHit(theirs[k])) found += Math.abs(ours[k] - theirs[k]) > rim;
        else found += isHit(ours[k]) !== isHit(theirs[k]) && Math.min(ours[k], theirs[k]) < 1 - rim;
    }
    return found;
}

const misses = (fractions) => fractions.reduce((sum, fraction) => sum + !isHit(fraction), 0);

/** Nothing when the scene does not fit into the memory of jolt-physics' module, which does not grow. */
async function joltOf(mesh, radius) {
    try {
        return await jolt(mesh, radius);
    } catch (error) {
        if (!/OOM/.test(error.message)) throw error;
        console.error('  jolt-physics is out of memory');
        return undefined;
    }
}

const scenes = [];
for (const name of await readdir(positionals[0])) if (name.endsWith('.json')) scenes.push(await readScene(positionals[0], name));
scenes.sort((a, b) => (a.scene === b.scene ? a.triangles - b.triangles : a.scene < b.scene ? -1 : 1));
const firma = await loadFirma(fileURLToPath(new URL('../../build/wasm/bin/firma.wasm', import.meta.url)));
const rows = [];
for (const { scene, mesh, triangles, casts, kinds } of scenes) {
    console.error(`${scene}, ${count(triangles)} triangles, in node`);
    const world = worldOf(firma, mesh);
    const peer = await joltOf(mesh, kinds.find((kind) => kind.shape === 'sphere').radius);
    const casters = [firmaSingle(world), firmaBatch(world), ...(peer ? [peer] : [])];
    for (const kind of kinds) {
        const fractions = casters.map(() => new Float64Array(casts));
        const method = kind.shape === 'ray' ? 'rays' : 'balls';
        const laps = race(casters.map((caster, k) => () => caster[method](kind.inputs, fractions[k])), rounds);
        const ns = laps.map((lap) => number((median(lap) * 1e6) / casts));
        const [single, batch, theirs] = fractions;
        const otherBits = single.reduce((sum, fraction, k) => sum + (fraction !== kind.fractions[k]) + (fraction !== batch[k]), 0);
        const ofPeer = (text) => (peer ? text() : '');
        rows.push([
            kind.name, scene, count(triangles), count(casts), ns[0], ns[1],
            ofPeer(() => ns[2]), ofPeer(() => times(ratio(laps[2], laps[0]))), ofPeer(() => times(ratio(laps[2], laps[1]))),
            count(otherBits),
            ofPeer(() => count(theirs.reduce((sum, fraction) => sum + isHit(fraction), 0))),
            ofPeer(() => count(differ(kind.fractions, theirs, kind.inputs))),
            kind.mustHit ? count(misses(single)) : '', ofPeer(() => (kind.mustHit ? count(misses(theirs)) : '')),
        ]);
    }
    world.release();
}
const order = scenes[0].kinds.map(({ name }) => name);
rows.sort((a, b) => order.indexOf(a[0]) - order.indexOf(b[0]));
const who = ['Firma ns', 'Firma in a batch ns', 'jolt-physics ns', 'jolt-physics to Firma', 'jolt-physics to a batch'];
const answers = ['other bits than natively', 'hits of jolt-physics', 'differ from Firma', 'leaks of Firma', 'leaks of jolt-physics'];
await finish('scale_node', ['casts', 'scene', 'triangles', 'asked', ...who, ...answers], rows, values.csv);
process.exit(0);
