// SPDX-License-Identifier: MIT
// Questions as the module takes them, and its answers as JavaScript has them.
import { badCall } from './errors.js';
import { CAST_OPTIONS, CAST_COUNTS, FEATURE_NAMES, HIT, NEAR, STATUS_NAMES } from './layout.js';
import { flag, mask, number, object, vector } from './arguments.js';

/** What `face` and `otherFace` of a batch are where there is none. */
export const NO_FACE = 0xffffffff;

const F64 = (offset) => offset >>> 3;
const U32 = (offset) => offset >>> 2;
const noFace = (id) => (id === NO_FACE ? null : id);

/** { centre, radius, path } to the fixed input. */
export function putInput(core, input, place) {
    if (typeof input !== 'object' || input === null) throw badCall(place, 'the cast must be { centre, radius, path }');
    const { centre, radius, path } = input;
    vector(centre, 3, place, 'centre');
    number(radius, place, 'radius');
    vector(path, 3, place, 'path');
    const f64 = core.f64;
    const k = core.at.input >>> 3;
    f64[k] = centre[0];
    f64[k + 1] = centre[1];
    f64[k + 2] = centre[2];
    f64[k + 3] = radius;
    f64[k + 4] = path[0];
    f64[k + 5] = path[1];
    f64[k + 6] = path[2];
    return core.at.input;
}

/** The options' address, or 0 for none. */
export function putCastOptions(core, options, place) {
    if (options === undefined) return 0;
    object(options, place, 'the options');
    const bits = options.mask === undefined ? 0xffffffff : mask(options.mask, place);
    const sides = flag(options.bothSides, place, 'bothSides');
    const skin = options.skin === undefined ? -1 : number(options.skin, place, 'skin');
    const at = core.at.castOptions;
    core.setU32(at + CAST_OPTIONS.size, CAST_OPTIONS.sizeof);
    core.setU32(at + CAST_OPTIONS.mask, bits);
    core.setU32(at + CAST_OPTIONS.sides, sides);
    core.setU32(at + CAST_OPTIONS.reserved, 0);
    core.setF64(at + CAST_OPTIONS.skin, skin);
    return at;
}

/** Where counts go: set to 0, or 0 when nobody wants them. */
export function clearCounts(core, options, place) {
    if (options?.counts === undefined) return 0;
    object(options.counts, place, 'counts');
    core.u64.fill(0n, core.at.counts >>> 3, (core.at.counts + CAST_COUNTS.sizeof) >>> 3);
    return core.at.counts;
}

/** Adds what clearCounts()'s place has to options.counts. */
export function addCounts(core, at, options) {
    if (at === 0) return;
    for (const name of ['bins', 'boxes', 'faces', 'precise'])
        options.counts[name] = (options.counts[name] ?? 0) + core.getCount(at + CAST_COUNTS[name]);
}

export function getHit(core, at) {
    const d = at >>> 3;
    const w = at >>> 2;
    const f64 = core.f64;
    const u32 = core.u32;
    const three = (k) => [f64[k], f64[k + 1], f64[k + 2]];
    return {
        status: STATUS_NAMES[u32[w + U32(HIT.status)]],
        fraction: f64[d + F64(HIT.fraction)],
        safeFraction: f64[d + F64(HIT.safeFraction)],
        centre: three(d + F64(HIT.centre)),
        point: three(d + F64(HIT.point)),
        normal: three(d + F64(HIT.normal)),
        faceNormal: three(d + F64(HIT.faceNormal)),
        feature: FEATURE_NAMES[u32[w + U32(HIT.feature)]],
        featureIndex: u32[w + U32(HIT.featureIndex)],
        face: noFace(u32[w + U32(HIT.face)]),
        otherFace: noFace(u32[w + U32(HIT.otherFace)]),
        source: u32[w + U32(HIT.source)],
        sourceEdit: u32[w + U32(HIT.sourceEdit)],
        material: u32[w + U32(HIT.material)],
        room: u32[w + U32(HIT.room)],
        roomsPassed: u32[w + U32(HIT.roomsPassed)],
        version: core.getCount(at + HIT.version),
    };
}

export function getNear(core, at) {
    return {
        point: core.getVector(at + NEAR.point),
        distance: core.getF64(at + NEAR.distance),
        face: core.getU32(at + NEAR.face),
        source: core.getU32(at + NEAR.source),
        sourceEdit: core.getU32(at + NEAR.sourceEdit),
        material: core.getU32(at + NEAR.material),
        feature: FEATURE_NAMES[core.getU32(at + NEAR.feature)],
        featureIndex: core.getU32(at + NEAR.featureIndex),
    };
}

const BYTES = { status: HIT.status, feature: HIT.feature };
const WORDS = {
    featureIndex: HIT.featureIndex,
    face: HIT.face,
    otherFace: HIT.otherFace,
    source: HIT.source,
    sourceEdit: HIT.sourceEdit,
    material: HIT.material,
    room: HIT.room,
    roomsPassed: HIT.roomsPassed,
};
const DOUBLES = { fraction: HIT.fraction, safeFraction: HIT.safeFraction };
const VECTORS = { centre: HIT.centre, point: HIT.point, normal: HIT.normal, faceNormal: HIT.faceNormal };

/** Set by HitBatch, which keeps its capacity to itself. */
let reserveHits;

/** The answers of a batch, an array for each field. */
export class HitBatch {
    /** How many answers there are; the arrays may be longer. */
    count = 0;
    version = 0;
    #capacity = -1;

    constructor() {
        reserveHits(this, 0);
    }

    static {
        reserveHits = (batch, count) => {
            if (batch.#capacity < count) {
                for (const name in BYTES) batch[name] = new Uint8Array(count);
                for (const name in WORDS) batch[name] = new Uint32Array(count);
                for (const name in DOUBLES) batch[name] = new Float64Array(count);
                for (const name in VECTORS) batch[name] = new Float64Array(3 * count);
                batch.#capacity = count;
            }
            batch.count = count;
        };
    }

    /** Answer k as cast() gives it; null beyond the last. */
    hit(k) {
        if (!(k >= 0 && k < this.count)) return null;
        const three = (all) => [all[3 * k], all[3 * k + 1], all[3 * k + 2]];
        return {
            status: STATUS_NAMES[this.status[k]],
            fraction: this.fraction[k],
            safeFraction: this.safeFraction[k],
            centre: three(this.centre),
            point: three(this.point),
            normal: three(this.normal),
            faceNormal: three(this.faceNormal),
            feature: FEATURE_NAMES[this.feature[k]],
            featureIndex: this.featureIndex[k],
            face: noFace(this.face[k]),
            otherFace: noFace(this.otherFace[k]),
            source: this.source[k],
            sourceEdit: this.sourceEdit[k],
            material: this.material[k],
            room: this.room[k],
            roomsPassed: this.roomsPassed[k],
            version: this.version,
        };
    }
}

/** One field of hits that lie one after the other from `from`, into an array from its place `begin`. */
function gather(source, from, stride, count, target, begin) {
    for (let k = 0, at = from; k < count; ++k, at += stride) target[begin + k] = source[at];
}

function gatherVectors(source, from, stride, count, target, begin) {
    for (let k = 0, at = from, to = 3 * begin; k < count; ++k, at += stride, to += 3) {
        target[to] = source[at];
        target[to + 1] = source[at + 1];
        target[to + 2] = source[at + 2];
    }
}

/** The hits at `at` become answers `begin` and on. */
export function getHits(core, at, count, batch, begin) {
    for (const name in BYTES) gather(core.u32, (at + BYTES[name]) >>> 2, HIT.sizeof / 4, count, batch[name], begin);
    for (const name in WORDS) gather(core.u32, (at + WORDS[name]) >>> 2, HIT.sizeof / 4, count, batch[name], begin);
    for (const name in DOUBLES) gather(core.f64, (at + DOUBLES[name]) >>> 3, HIT.sizeof / 8, count, batch[name], begin);
    for (const name in VECTORS)
        gatherVectors(core.f64, (at + VECTORS[name]) >>> 3, HIT.sizeof / 8, count, batch[name], begin);
    if (count > 0) batch.version = core.getCount(at + HIT.version);
}

/** Makes room for `count` answers, in the arrays that the batch has when they are long enough. */
export const reserve = (batch, count) => reserveHits(batch, count);
