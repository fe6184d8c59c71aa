// SPDX-License-Identifier: MIT
// Overlapping capsules, cylinders and boxes along a path through a block, at scales from a metre to eight kilometres, by
// Firma and by manifold-3d in node: each cut by one and then by the other, from the same snapped meshes.
//
//   node bench_sweeps.mjs [--quick] [--csv FOLDER]
import { fileURLToPath } from 'node:url';
import initManifold from 'manifold-3d';
import { loadFirma } from '../../bindings/js/src/index.js';
import { FirmaCutter, ManifoldCutter, timed } from './cutters.mjs';
import { count, finish, median, number, quantile, settings, times } from './race.mjs';
import { placed } from './scene.mjs';
import { LARGEST_SWEEP, makeSweep, SWEEP_CUTS, TOOLS } from './sweeps.mjs';

/** A row ends once either has taken as long, milliseconds. */
const MOST = 2000;

const sum = (list) => list.reduce((all, one) => all + one, 0);

/** 'sound', or the first fault of Firma's world. */
function checked(world) {
    try {
        world.check();
        return 'sound';
    } catch (error) {
        return error.message;
    }
}

/** Cut by cut, who begins alternates. */
function compete(firma, library, name, exponent, cuts) {
    const { block, tool, poses } = makeSweep(name, exponent);
    const [ours, theirs] = [new FirmaCutter(firma, block, tool), new ManifoldCutter(library, block, tool)];
    const laps = { ours: [], theirs: [] };
    for (let k = 0; k < cuts && Math.max(sum(laps.ours), sum(laps.theirs)) < MOST; ++k) {
        const mesh = placed(tool, poses[k]);
        const turns = [
            () => timed(laps.ours, () => ours.cut(poses[k])),
            () => timed(laps.theirs, () => theirs.cut(theirs.solid(mesh))),
        ];
        if (k % 2 === 1) turns.reverse();
        turns.forEach((turn) => turn());
    }
    return { ours, theirs, laps };
}

const { quick, csv } = settings();
const firma = await loadFirma(fileURLToPath(new URL('../../build/wasm/bin/firma.wasm', import.meta.url)));
const library = await initManifold();
library.setup();
const rows = [];
/** The first runs are for the engine, which has to compile what is timed. */
for (const warm of TOOLS) {
    const { ours, theirs } = compete(firma, library, warm, 3, quick ? 10 : SWEEP_CUTS);
    ours.release();
    theirs.release();
}
for (const name of TOOLS)
    for (let exponent = 0; exponent <= LARGEST_SWEEP; exponent += quick ? LARGEST_SWEEP : 1) {
        const { ours, theirs, laps } = compete(firma, library, name, exponent, quick ? 10 : SWEEP_CUTS);
        const left = ours.world.measure().volume;
        const theirsLeft = theirs.level.volume();
        rows.push([
            name,
            count(2 ** exponent),
            count(laps.ours.length),
            ...[laps.ours, laps.theirs].flatMap((list) => [median(list), quantile(list, 0.99), sum(list)].map(number)),
            ...[median(laps.theirs) / median(laps.ours), quantile(laps.theirs, 0.99) / quantile(laps.ours, 0.99), sum(laps.theirs) / sum(laps.ours)].map(times),
            ...[ours.refused, theirs.failed].map(count),
            count(ours.world.facts().faceCount),
            count(theirs.level.numTri()),
            (left / 8 ** exponent).toFixed(15),
            number(Math.abs(theirsLeft / left - 1)),
            checked(ours.world),
        ]);
        ours.release();
        theirs.release();
    }
const speed = ['Firma', 'manifold'].flatMap((who) => ['median', 'p99', 'sum'].map((what) => `${who} ${what} ms`));
const ratios = ['median', 'p99', 'sum'].map((what) => `manifold to Firma, ${what}`);
const answers = ['refused by Firma', 'not cut by manifold', 'facets of Firma', 'triangles of manifold'];
const volumes = ['volume left by Firma, share of the block', 'manifold differs by', "Firma's check"];
await finish('node_sweeps', ['tool', 'scale m', 'cuts', ...speed, ...ratios, ...answers, ...volumes], rows, csv);
process.exit(0);
