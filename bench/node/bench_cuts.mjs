// SPDX-License-Identifier: MIT
// The same craters in the same levels by Firma and by manifold-3d in node, a few of one and a few of the other in turn, and
// whether both took the same volume away.
//
//   node bench_cuts.mjs [--quick] [--csv FOLDER]
import { fileURLToPath } from 'node:url';
import initManifold from 'manifold-3d';
import { loadFirma } from '../../bindings/js/src/index.js';
import { FirmaCutter, ManifoldCutter, timed } from './cutters.mjs';
import { count, finish, median, number, quantile, ratio, settings, times } from './race.mjs';
import { bumpyRooms, craterPose, placed, rockyBall } from './scene.mjs';

const TURN = 5;

/** A few cuts by each in turn; who begins alternates. */
function compete(firma, ours, theirs, rooms, inCorner, cuts) {
    const laps = { ours: [], theirs: [], placing: [] };
    for (let from = 0; from < cuts; from += TURN) {
        const poses = Array.from({ length: TURN }, (_, k) => craterPose(firma, rooms, inCorner, from + k));
        const turns = [
            () => poses.forEach((pose) => timed(laps.ours, () => ours.cut(pose))),
            () =>
                poses.forEach((pose) => {
                    const mesh = placed(theirs.tool, pose);
                    const solid = timed(laps.placing, () => theirs.solid(mesh));
                    timed(laps.theirs, () => theirs.cut(solid));
                }),
        ];
        if ((from / TURN) % 2 === 1) turns.reverse();
        turns.forEach((turn) => turn());
    }
    return laps;
}

const { quick, csv } = settings();
const cuts = quick ? 10 : 200;
const firma = await loadFirma(fileURLToPath(new URL('../../build/wasm/bin/firma.wasm', import.meta.url)));
const library = await initManifold();
library.setup();
const ball = rockyBall(3);
/** So that the engine has compiled what is timed. */
function warmUp() {
    const mesh = bumpyRooms(1);
    const [ours, theirs] = [new FirmaCutter(firma, mesh, ball), new ManifoldCutter(library, mesh, ball)];
    compete(firma, ours, theirs, 1, false, 8 * TURN);
    ours.release();
    theirs.release();
}

warmUp();
const rows = [];
for (const inCorner of [false, true])
    for (const rooms of quick ? [2] : [2, 6]) {
        const mesh = bumpyRooms(rooms);
        const ours = new FirmaCutter(firma, mesh, ball);
        const theirs = new ManifoldCutter(library, mesh, ball);
        const laps = compete(firma, ours, theirs, rooms, inCorner, cuts);
        const whole = laps.theirs.map((ms, k) => ms + laps.placing[k]);
        ours.world.check();
        const [taken, theirsTaken] = [ours.taken, theirs.taken];
        rows.push([
            count(mesh.corners.length / 3),
            inCorner ? 'in one corner' : 'spread',
            count(cuts),
            ...[median(laps.ours), quantile(laps.ours, 0.99), median(laps.theirs), quantile(laps.theirs, 0.99), median(whole)].map(number),
            times(ratio(laps.theirs, laps.ours)),
            times(ratio(whole, laps.ours)),
            ...[ours.retries, ours.refused, theirs.failed].map(count),
            taken.toFixed(6),
            theirsTaken.toFixed(6),
            number(Math.abs(theirsTaken / taken - 1)),
            count(ours.world.facts().faceCount),
            count(theirs.level.numTri()),
        ]);
        ours.release();
        theirs.release();
    }
const speed = ['Firma median ms', 'Firma p99 ms', 'manifold median ms', 'manifold p99 ms', 'manifold with the crater made, median ms'];
const ratios = ['manifold to Firma', 'with the crater made, to Firma'];
const answers = ["Firma's retries", 'not cut by Firma', 'not cut by manifold', 'Firma took m3', 'manifold took m3', 'differ by'];
await finish('node_cuts', ['triangles', 'craters', 'cuts', ...speed, ...ratios, ...answers, 'facets of Firma', 'triangles of manifold'], rows, csv);
process.exit(0);
