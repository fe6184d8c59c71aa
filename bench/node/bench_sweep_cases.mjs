// SPDX-License-Identifier: MIT
// Cases of iterated cuts from a folder, as bench_sweep_cases.cpp runs them natively, by Firma's module and by manifold-3d:
// each cut by one and then by the other, from the same snapped meshes.
//
//   node bench_sweep_cases.mjs FOLDER [--scale METRES] [--cuts N] [--csv FOLDER]
import { existsSync } from 'node:fs';
import { readdir, readFile } from 'node:fs/promises';
import { basename, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import initManifold from 'manifold-3d';
import { loadFirma } from '../../bindings/js/src/index.js';
import { timed } from './cutters.mjs';
import { count, finish, median, number, quantile, times } from './race.mjs';
import { meshOfObj } from './scene.mjs';

const { values, positionals } = parseArgs({
    allowPositionals: true,
    options: { scale: { type: 'string', default: '128' }, cuts: { type: 'string', default: 'Infinity' }, csv: { type: 'string', default: '' } },
});
const scale = Number(values.scale);
const folder = positionals[0];

async function findCases() {
    const places = [folder];
    for (const entry of await readdir(folder, { withFileTypes: true })) if (entry.isDirectory()) places.push(join(folder, entry.name));
    const cases = [];
    for (const place of places.sort()) {
        if (!existsSync(join(place, 'workpiece.obj')) || !existsSync(join(place, 'sweeps'))) continue;
        const tools = (await readdir(join(place, 'sweeps'))).filter((name) => name.endsWith('.obj')).sort();
        cases.push({ name: basename(resolve(place)), place, tools: tools.map((name) => join(place, 'sweeps', name)) });
    }
    return cases;
}

/** Turned over where it is inside out, as Firma does by itself with a cutter. */
function outward({ positions, corners }) {
    const at = (k) => positions.subarray(3 * corners[k], 3 * corners[k] + 3);
    let six = 0;
    for (let k = 0; k < corners.length; k += 3) {
        const [a, b, c] = [at(k), at(k + 1), at(k + 2)];
        six += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
    }
    return six < 0 ? { positions, corners: Uint32Array.from(corners).reverse() } : { positions, corners };
}

const sum = (list) => list.reduce((all, one) => all + one, 0);
const identity = { position: [0, 0, 0], rotation: [0, 0, 0, 1], scale: 1 };

/** 'sound', or the first fault of Firma's world. */
function checked(world) {
    try {
        world.check();
        return 'sound';
    } catch (error) {
        return error.message;
    }
}

function manifoldOf(library, { positions, corners }) {
    const solid = new library.Manifold(new library.Mesh({ numProp: 3, vertProperties: Float32Array.from(positions), triVerts: corners }));
    if (solid.status() !== 'NoError') throw new Error(`manifold-3d: ${solid.status()}`);
    return solid;
}

async function runCase(firma, library, { place, tools }) {
    const workpiece = await meshOfObj(join(place, 'workpiece.obj'), scale);
    let world = firma.worldFromMesh(workpiece);
    let theirs = manifoldOf(library, workpiece);
    const run = { ours: [], theirs: [], refused: 0, failed: 0 };
    for (let k = 0; k < Math.min(tools.length, Number(values.cuts)); ++k) {
        const mesh = outward(await meshOfObj(tools[k], scale));
        const cutter = firma.cutterFromMesh(mesh.positions, mesh.corners);
        const cutOurs = () => {
            const result = timed(run.ours, () => {
                const result = world.carve(cutter, identity);
                world.release();
                return result;
            });
            world = result.world;
            run.refused += result.report.status === 'refused';
        };
        const cutTheirs = () => {
            let failed = false;
            const after = timed(run.theirs, () => {
                const tool = manifoldOf(library, mesh);
                const after = theirs.subtract(tool);
                failed = after.numTri() === 0; // cuts here: Manifold is lazy
                tool.delete();
                return after;
            });
            run.failed += failed;
            theirs.delete();
            theirs = after;
        };
        for (const turn of k % 2 === 0 ? [cutOurs, cutTheirs] : [cutTheirs, cutOurs]) turn();
        cutter.release();
    }
    const left = world.measure().volume;
    const done = {
        ...run,
        left: left / scale ** 3,
        differs: Math.abs(theirs.volume() / left - 1),
        facets: world.facts().faceCount,
        triangles: theirs.numTri(),
        check: checked(world),
    };
    world.release();
    theirs.delete();
    return done;
}

const firma = await loadFirma(fileURLToPath(new URL('../../build/wasm/bin/firma.wasm', import.meta.url)));
const library = await initManifold();
library.setup();
const rows = [];
const cases = await findCases();
if (cases.length === 0) throw new Error(`${folder}: no folder with a workpiece.obj and sweeps/*.obj in it`);
for (const one of cases) {
    const run = await runCase(firma, library, one);
    rows.push([
        one.name, count(run.ours.length),
        ...[run.ours, run.theirs].flatMap((list) => [median(list), quantile(list, 0.99), sum(list)].map(number)),
        times(sum(run.theirs) / sum(run.ours)), count(run.refused), count(run.failed),
        count(run.facets), count(run.triangles), run.left.toPrecision(12), number(run.differs), run.check,
    ]);
}
const speed = ['Firma', 'manifold'].flatMap((who) => ['median', 'p99', 'sum'].map((what) => `${who} ${what} ms`));
const answers = ['refused by Firma', 'not cut by manifold', 'facets of Firma', 'triangles of manifold'];
const volumes = ['volume left by Firma, cubic units', 'manifold differs by', "Firma's check"];
await finish('node_sweep_cases', ['case', 'cuts', ...speed, 'manifold to Firma, sum', ...answers, ...volumes], rows, values.csv);
process.exit(0);
