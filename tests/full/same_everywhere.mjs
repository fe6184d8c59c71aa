// SPDX-License-Identifier: MIT
// What same_everywhere.c does, draw by draw, through the JavaScript API: prints the same hashes, or something is wrong.
// Change both or none.
//
//   node same_everywhere.mjs FIRMA.wasm LEVEL.obj|LEVEL.bsp CUTS CASTS
import { loadFirma } from '../../bindings/js/src/index.js';

const PORTIONS = 10;
const BATCH = 100;
const MOST = 64;
const SINGLES = 50;
const SHAPES = ['rocky', 'spiky', 'drill', 'wedge', 'box'];

// ---- random numbers ----

let state = 20031;

function next() {
    state = (state + 0x9e3779b9) | 0;
    let z = state;
    z = Math.imul(z ^ (z >>> 16), 0x85ebca6b);
    z = Math.imul(z ^ (z >>> 13), 0xc2b2ae35);
    return (z ^ (z >>> 16)) >>> 0;
}
const below = (count) => next() % count;
function seed() {
    const high = BigInt(next());
    const low = BigInt(next());
    return (high << 32n) | low;
}
const signUnit = () => (below(2001) - 1000) / 1000;

// ---- the hash of all bits that came back ----

let hashA = 1;
let hashB = 2;
const double = new Float64Array(1);
const halves = new Uint32Array(double.buffer);

function mix(word) {
    hashA = Math.imul(hashA ^ word, 0x9e3779b1);
    hashA ^= hashA >>> 15;
    hashB = Math.imul((hashB + word) | 0, 0x85ebca6b);
    hashB ^= hashB >>> 13;
}
/** A whole number below 2^53. */
function mixLong(value) {
    mix(value >>> 0);
    mix(Math.floor(value / 2 ** 32));
}
function mixDouble(value) {
    double[0] = value;
    mix(halves[0]);
    mix(halves[1]);
}
const mixAll = (values) => {
    for (let k = 0; k < values.length; ++k) mixDouble(values[k]);
};
/** A name as the number that the C API has for it. */
function mixName(names, name) {
    const number = names.indexOf(name);
    if (number < 0) throw new Error(`what is '${name}'?`);
    mix(number);
}
const mixFace = (face) => mix(face === null ? 0xffffffff : face);
const STATUSES = ['miss', 'hit', 'touching', 'invalid'];
const FEATURES = ['face', 'edge', 'vertex'];

function mixHit(world, hit) {
    mixName(STATUSES, hit.status);
    mixDouble(hit.fraction);
    mixDouble(hit.safeFraction);
    mixAll(hit.centre);
    mixAll(hit.point);
    mixAll(hit.normal);
    mixAll(hit.faceNormal);
    mixName(FEATURES, hit.feature);
    mix(hit.featureIndex);
    mixFace(hit.face);
    hit.corner.forEach(mix);
    mix(hit.material);
    if (!hit.hit) return;
    const info = world.hitInfo(hit);
    mix(info.room);
    mix(info.source);
    mix(info.sourceEdit);
    mix(info.mask);
    mix((info.twoSided ? 1 : 0) | (info.solid ? 2 : 0));
    mixFace(info.otherFace);
}
function mixNear(near) {
    mixAll(near.point);
    mixDouble(near.distance);
    mixAll(near.direction ?? [0, 0, 0]); // of overlaps alone
    mixDouble(near.depth ?? 0);
    mixFace(near.face);
    mix(near.material);
    mixName(FEATURES, near.feature);
    mix(near.featureIndex);
}
function mixReport(report) {
    mixName(['done', 'nothing', 'refused'], report.status);
    mix(report.retries);
    mixLong(report.candidateFaces);
    mixLong(report.facesCut);
    mixLong(report.facesRemoved);
    mixLong(report.facesAdded);
    mixDouble(report.scale);
    mixDouble(report.volume);
}

// ---- where things happen ----

let low, high;
const lastCut = [0, 0, 0];

function somewhere() {
    const point = [0, 0, 0];
    for (let axis = 0; axis < 3; ++axis) {
        const cells = Math.trunc((high[axis] - low[axis]) * 4096);
        point[axis] = low[axis] + below(cells + 1) / 4096;
    }
    return point;
}

// ---- cuts ----

let cutsDone = 0;
let retries = 0;

function drawCutter(firma) {
    const corners = [1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1];
    const triangles = [0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5];
    const shape = below(6);
    const from = seed();
    return shape === 5 ? firma.cutterFromMesh(corners, triangles, 'octahedron') : firma.crater(SHAPES[shape], from);
}

function drawPose(firma) {
    const kind = below(3);
    const pose = { position: somewhere(), rotation: [0, 0, 0, 1], scale: 1 };
    if (kind === 0) for (let axis = 0; axis < 3; ++axis) pose.position[axis] = Math.trunc(pose.position[axis]) + 0; // no -0, as in C
    for (let axis = 0; axis < 3; ++axis) lastCut[axis] = pose.position[axis];
    if (kind === 1) for (let k = 0; k < 4; ++k) pose.rotation[k] = below(201) - 100 + (k === 3 ? 0.5 : 0);
    if (kind === 2) pose.rotation = firma.randomTurn(seed());
    pose.scale = (5 + below(26)) / 10;
    return pose;
}

function countReport(report) {
    mixReport(report);
    cutsDone += report.status === 'done';
    retries += report.retries;
}

const carveNow = (world, ...order) => world.carve(...order);

function carveInSlices(world, cutter, pose, options) {
    const job = world.startCarve(cutter, pose, options);
    while (!job.run(20));
    const result = job.result();
    job.release();
    return result;
}

function carveThree(world, cutter, pose, options) {
    const edit = world.edit();
    let report;
    for (let k = 0; k < 3; ++k) {
        if (k) countReport(report);
        report = edit.carve(cutter, pose, options);
        pose.position[k] += 0.75;
    }
    const after = edit.finish();
    edit.release();
    return { world: after, report };
}

function cutOnce(firma, world) {
    const cutter = drawCutter(firma);
    const pose = drawPose(firma);
    const kind = below(10);
    const options = { fill: kind === 0, material: kind < 5 ? 'crater' : '' };
    const way = below(8);
    const edit = [carveInSlices, carveThree][way] ?? carveNow;
    const { world: after, report } = edit(world, cutter, pose, options);
    countReport(report);
    cutter.release();
    world.release();
    return after;
}

// ---- casts ----

function drawCast() {
    const input = { centre: somewhere(), radius: 0, path: [0, 0, 0] };
    if (below(3) === 0) for (let axis = 0; axis < 3; ++axis) input.centre[axis] = lastCut[axis] + signUnit();
    const thousandths = below(700);
    input.radius = below(2) ? 0 : thousandths / 1000;
    const length = below(2) ? 1 : 30;
    for (let axis = 0; axis < 3; ++axis) input.path[axis] = signUnit() * length;
    if (below(8) === 0) input.path[below(3)] = 0;
    return input;
}

function drawOptions() {
    const options = { mask: 0xffffffff, bothSides: below(4) === 0 };
    if (below(8) === 0) options.contactOffset = 0.0625;
    return options;
}

function askMore(world, input, options) {
    mix(world.castAny(input, options) ? 1 : 0);
    const hits = world.castAll(input, options);
    mix(hits.length);
    hits.slice(0, MOST).forEach((hit) => mixHit(world, hit));
    const found = world.overlap(input.centre, input.radius + 0.25);
    mix(found.length);
    found.slice(0, MOST).forEach(mixNear);
    const near = world.closest(input.centre, 5);
    mix(near === null ? 0 : 1);
    if (near !== null) mixNear(near);
    mixName(['air', 'solid', 'surface', 'unknown'], world.locate(input.centre).where);
}

let hitCount = 0;
const met = (hit) => hit.status === 'hit' || hit.status === 'touching';

let answers;
function oneBatch(world, count) {
    const inputs = new Float64Array(7 * count);
    for (let k = 0; k < count; ++k) {
        const { centre, radius, path } = drawCast();
        inputs.set([...centre, radius, ...path], 7 * k);
    }
    const options = drawOptions();
    answers = world.castBatch(inputs, options, answers);
    for (let k = 0; k < count; ++k) {
        const hit = answers.hit(k);
        mixHit(world, hit);
        hitCount += met(hit);
    }
}

function oneByOne(world, count) {
    for (let k = 0; k < count; ++k) {
        const input = drawCast();
        const options = drawOptions();
        const hit = world.cast(input, options);
        mixHit(world, hit);
        hitCount += met(hit);
        if (k % 8 === 0) askMore(world, input, options);
    }
}

function castMany(world, count) {
    while (count) {
        const singles = Math.min(count, SINGLES);
        oneByOne(world, singles);
        count -= singles;
        const batch = Math.min(count, BATCH);
        oneBatch(world, batch);
        count -= batch;
    }
}

// ---- the whole ----

const hex = (number, digits) => number.toString(16).padStart(digits, '0');
const answersSoFar = () => hex(hashA >>> 0, 8) + hex(hashB >>> 0, 8);

function say(print, world, cuts, casts) {
    print(
        `cuts=${cuts} done=${cutsDone} retries=${retries} casts=${casts} hits=${hitCount} ` +
            `faces=${world.facts().faceCount} world=${hex(world.hash(), 16)} answers=${answersSoFar()}`,
    );
}

function sayMesh(print, firma, world) {
    const faces = world.faces();
    const made = firma.worldFromMesh(
        {
            positions: faces.corners,
            corners: Uint32Array.from({ length: faces.corners.length / 3 }, (_, k) => k),
            cornerCounts: faces.cornerCounts,
            materials: faces.materials,
            materialNames: world.facts().materials,
            masks: faces.masks,
            twoSided: faces.flags.map((flags) => flags & 1),
        },
        { name: 'mesh' },
    );
    print(`mesh=${faces.ids.length} world=${hex(made.hash(), 16)}`);
    made.release();
}

function withRules(world) {
    const zone = { name: 'left half', low, high: [(low[0] + high[0]) / 2, high[1], high[2]], hardness: 0.3 };
    return world.withRules({ zones: [zone] });
}

// ---- a log ----

function drawPart(firma, number) {
    const kind = below(8);
    if (kind === 0) {
        const portal = below(4);
        return firma.doorCommand(number, portal, below(2) === 1);
    }
    const cutter = drawCutter(firma);
    const pose = drawPose(firma);
    const options = { fill: kind === 1, material: kind < 4 ? 'logged' : '', chunks: kind !== 1 };
    const command = firma.editCommand(number, cutter, pose, options);
    cutter.release();
    if (kind > 5) return command;
    const quantised = command.quantised();
    command.release();
    return quantised;
}

let number = 0;
function drawCommand(firma) {
    if (below(8)) return drawPart(firma, ++number);
    const parts = [];
    for (let k = 0; k < 3; ++k) parts.push(drawPart(firma, ++number));
    const group = firma.groupCommand(parts);
    parts.forEach((part) => part.release());
    return group;
}

function applyCommand(world, command, inSlices) {
    let result;
    if (inSlices) {
        const job = world.startApply(command);
        while (!job.run(20));
        result = job.result();
        job.release();
    } else {
        result = world.apply(command);
    }
    const { world: after, report } = result;
    mixReport(report);
    mixLong(report.chunks);
    mixDouble(report.chunkVolume);
    report.loose?.release();
    world.release();
    return after;
}

function replayPacked(firma, level, log, hash) {
    const bytes = log.pack();
    bytes.forEach(mix);
    const read = firma.unpackLog(bytes, 'log');
    const replay = read.replay(level);
    while (!replay.run(20));
    const { done } = replay.facts();
    const world = replay.result();
    if (world.hash() !== hash) throw new Error(`a replay gives ${hex(world.hash(), 16)}, the commands gave ${hex(hash, 16)}`);
    [world, replay, read].forEach((handle) => handle.release());
    return { done, length: bytes.length };
}

function sayLog(print, firma, level, count) {
    const log = firma.beginLog(level);
    let half = 0;
    let world = level.copy();
    for (let k = 0; k < count; ++k) {
        const command = drawCommand(firma);
        world = applyCommand(world, command, k % 3 === 0);
        log.append(command);
        command.release();
        if (k % 10 === 9) log.checkpoint(world);
        if (k < Math.floor(count / 2)) half = number;
    }
    const hash = world.hash();
    const { done, length } = replayPacked(firma, level, log, hash);
    const compact = log.compact(level, half);
    const { length: compactLength } = replayPacked(firma, level, compact, hash);
    print(
        `log=${length} commands=${count} done=${done} compact=${compactLength} ` +
            `world=${hex(hash, 16)} answers=${answersSoFar()}`,
    );
    [compact, log, world].forEach((handle) => handle.release());
}

function sayRest(print, firma, first, last) {
    const { volume, area } = last.measure();
    mixDouble(volume);
    mixDouble(area);
    const { removed, added, tiles } = first.diff(last, 4);
    removed.forEach(mix);
    added.ids.forEach((id, k) => {
        mix(id);
        mixAll(added.normals.subarray(3 * k, 3 * k + 3));
        mix(added.materials[k]);
    });
    mixAll(added.corners);
    tiles.forEach(mix);
    const bytes = last.pack();
    bytes.forEach(mix);
    const again = firma.unpackWorld(bytes, 'again');
    print(`packed=${bytes.length} world=${hex(again.hash(), 16)} everything=${answersSoFar()}`);
    again.release();
}

/** @param module, level what loadFirma() takes (its readers lie beside it), and the bytes of the .obj or .bsp file; @param print gets each line */
export async function run(module, level, cuts, casts, print) {
    const firma = await loadFirma(module);
    const bsp = level[0] === 0x49 && level[1] === 0x42; // "IBSP"
    const first = await (bsp ? firma.worldFromBsp(level, { name: 'level' }) : firma.worldFromObj(level, { name: 'level' }));
    ({ low, high } = first.facts());
    let world = withRules(first);
    sayMesh(print, firma, first);
    say(print, world, 0, 0);
    let cut = 0;
    let cast = 0;
    for (let portion = 1; portion <= PORTIONS; ++portion) {
        for (; cut < Math.floor((cuts * portion) / PORTIONS); ++cut) world = cutOnce(firma, world);
        const until = Math.floor((casts * portion) / PORTIONS);
        castMany(world, until - cast);
        cast = until;
        say(print, world, cut, cast);
    }
    const begin = withRules(first);
    sayLog(print, firma, begin, Math.floor(cuts / 10));
    begin.release();
    sayRest(print, firma, first, world);
    world.release();
    first.release();
    if (firma.liveHandles() !== 0) throw new Error(`${firma.liveHandles()} handles have leaked`);
}

if (typeof process !== 'undefined' && process.argv[1]?.endsWith('same_everywhere.mjs')) {
    const { readFile } = await import('node:fs/promises');
    const [module, level, cuts, casts] = process.argv.slice(2);
    if (casts === undefined) throw new Error('usage: node same_everywhere.mjs FIRMA.wasm LEVEL CUTS CASTS');
    await run(module, await readFile(level), Number(cuts), Number(casts), console.log);
}
