// SPDX-License-Identifier: MIT
// Questions as the module takes them, and its answers as JavaScript has them.
import { badCall } from './errors.js';
import { CAST_OPTIONS, CAST_COUNTS, FEATURE_NAMES, HIT, NEAR, STATUS_NAMES } from './layout.js';
import { flag, mask, number, object, vector, word } from './arguments.js';
import { NO_PORTAL } from './rooms.js';

/** What `face` and `otherFace` of a batch are where there is none. */
export const NO_FACE = 0xffffffff;

const F64 = (offset) => offset >>> 3;
const U32 = (offset) => offset >>> 2;
const noFace = (id) => (id === NO_FACE ? null : id);
const noPortal = (id) => (id === NO_PORTAL ? null : id);
/** Rooms that a hit lists at most. */
const PASSED = (HIT.portal - HIT.passed) / 4;
const ROOMS = new Map([
    [undefined, 0xffffffff],
    ['any', 0xffffffff],
    ['locate', 0xfffffffe],
]);

const OPTION_NAMES = ['mask', 'bothSides', 'skin', 'room'];
const COUNTED_OPTION_NAMES = [...OPTION_NAMES, 'counts'];
const COUNT_NAMES = ['bins', 'boxes', 'faces', 'precise'];

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

/** The options' address, or 0 for none. @param counted  whether `counts` is one of them */
export function putCastOptions(core, options, place, counted = false) {
    if (options === undefined) return 0;
    object(options, place, 'the options', counted ? COUNTED_OPTION_NAMES : OPTION_NAMES);
    const bits = options.mask === undefined ? 0xffffffff : mask(options.mask, place);
    const sides = flag(options.bothSides, place, 'bothSides');
    const skin = options.skin === undefined ? -1 : number(options.skin, place, 'skin');
    const room = ROOMS.get(options.room) ?? word(options.room, place, "room, where not 'any' or 'locate',");
    const at = core.at.castOptions;
    core.setU32(at + CAST_OPTIONS.size, CAST_OPTIONS.sizeof);
    core.setU32(at + CAST_OPTIONS.mask, bits);
    core.setU32(at + CAST_OPTIONS.sides, sides);
    core.setU32(at + CAST_OPTIONS.room, room);
    core.setF64(at + CAST_OPTIONS.skin, skin);
    core.setU32(at + CAST_OPTIONS.passed, 0);
    core.setU32(at + CAST_OPTIONS.passedCapacity, 0);
    return at;
}

/** Where counts go: set to 0, or 0 when nobody wants them. */
export function clearCounts(core, options, place) {
    if (options?.counts === undefined) return 0;
    object(options.counts, place, 'counts', COUNT_NAMES);
    for (const name in options.counts) number(options.counts[name], place, name);
    core.u64.fill(0n, core.at.counts >>> 3, (core.at.counts + CAST_COUNTS.sizeof) >>> 3);
    return core.at.counts;
}

/** Adds what clearCounts()'s place has to options.counts. */
export function addCounts(core, at, options) {
    if (at === 0) return;
    for (const name of COUNT_NAMES)
        options.counts[name] = (options.counts[name] ?? 0) + core.getCount(at + CAST_COUNTS[name]);
}

export function getHit(core, at) {
    const d = at >>> 3;
    const w = at >>> 2;
    const f64 = core.f64;
    const u32 = core.u32;
    const three = (k) => [f64[k], f64[k + 1], f64[k + 2]];
    const roomsPassed = u32[w + U32(HIT.roomsPassed)];
    const passed = w + U32(HIT.passed);
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
        roomsPassed,
        passed: Array.from(u32.subarray(passed, passed + Math.min(roomsPassed, PASSED))),
        portal: noPortal(u32[w + U32(HIT.portal)]),
        version: core.getCount(at + HIT.version),
    };
}

export function getNear(core, at) {
    return {
        point: core.getVector(at + NEAR.point),
        distance: core.getF64(at + NEAR.distance),
        face: noFace(core.getU32(at + NEAR.face)),
        portal: noPortal(core.getU32(at + NEAR.portal)),
        source: core.getU32(at + NEAR.source),
        sourceEdit: core.getU32(at + NEAR.sourceEdit),
        material: core.getU32(at + NEAR.material),
        feature: FEATURE_NAMES[core.getU32(at + NEAR.feature)],
        featureIndex: core.getU32(at + NEAR.featureIndex),
    };
}

const BYTES = ['status', 'feature'];
const WORDS = ['featureIndex', 'face', 'otherFace', 'source', 'sourceEdit', 'material', 'room', 'roomsPassed', 'portal'];
const DOUBLES = ['fraction', 'safeFraction'];
const VECTORS = ['centre', 'point', 'normal', 'faceNormal'];

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
                for (const name of BYTES) batch[name] = new Uint8Array(count);
                for (const name of WORDS) batch[name] = new Uint32Array(count);
                batch.passed = new Uint32Array(PASSED * count);
                for (const name of DOUBLES) batch[name] = new Float64Array(count);
                for (const name of VECTORS) batch[name] = new Float64Array(3 * count);
                batch.#capacity = count;
            }
            batch.count = 0; // until the answers are there
            batch.version = 0;
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
            passed: Array.from(this.passed.subarray(PASSED * k, PASSED * k + Math.min(this.roomsPassed[k], PASSED))),
            portal: noPortal(this.portal[k]),
            version: this.version,
        };
    }
}

/** The hits at `at` become answers `begin` and on. In one loop each array is of one type to the engine. */
export function getHits(core, at, count, batch, begin) {
    const { f64, u32 } = core;
    const { status, feature, featureIndex, face, otherFace, source, sourceEdit, material, room, roomsPassed } = batch;
    const { passed, portal } = batch;
    const { fraction, safeFraction, centre, point, normal, faceNormal } = batch;
    for (let k = 0; k < count; ++k) {
        const to = begin + k;
        const w = (at + k * HIT.sizeof) >>> 2;
        const d = w >>> 1;
        status[to] = u32[w + U32(HIT.status)];
        feature[to] = u32[w + U32(HIT.feature)];
        featureIndex[to] = u32[w + U32(HIT.featureIndex)];
        face[to] = u32[w + U32(HIT.face)];
        otherFace[to] = u32[w + U32(HIT.otherFace)];
        source[to] = u32[w + U32(HIT.source)];
        sourceEdit[to] = u32[w + U32(HIT.sourceEdit)];
        material[to] = u32[w + U32(HIT.material)];
        room[to] = u32[w + U32(HIT.room)];
        const rooms = u32[w + U32(HIT.roomsPassed)];
        roomsPassed[to] = rooms;
        for (let p = 0; p < rooms && p < PASSED; ++p) passed[PASSED * to + p] = u32[w + U32(HIT.passed) + p];
        portal[to] = u32[w + U32(HIT.portal)];
        fraction[to] = f64[d + F64(HIT.fraction)];
        safeFraction[to] = f64[d + F64(HIT.safeFraction)];
        for (let axis = 0; axis < 3; ++axis) {
            centre[3 * to + axis] = f64[d + F64(HIT.centre) + axis];
            point[3 * to + axis] = f64[d + F64(HIT.point) + axis];
            normal[3 * to + axis] = f64[d + F64(HIT.normal) + axis];
            faceNormal[3 * to + axis] = f64[d + F64(HIT.faceNormal) + axis];
        }
    }
    if (count > 0) batch.version = core.getCount(at + HIT.version);
}

/** Empties a batch and makes room for `count` answers, in the arrays that it has when they are long enough. */
export const reserve = (batch, count) => reserveHits(batch, count);
