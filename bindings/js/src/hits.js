// SPDX-License-Identifier: MIT
// Questions as the module takes them, and its answers as JavaScript has them.
import { badCall } from './errors.js';
import {
    CAST_COUNTS,
    CAST_OPTIONS,
    FACE_SOLID,
    FACE_TWO_SIDED,
    FEATURE_NAMES,
    HIT,
    HIT_INFO,
    NEAR,
    NEAR_OPTIONS,
    STATUS_NAMES,
} from './layout.js';
import { flag, mask, number, object, vector, word } from './arguments.js';
import { NO_FACE } from './faces.js';
import { NO_PORTAL } from './rooms.js';

const F64 = (offset) => offset >>> 3;
const U32 = (offset) => offset >>> 2;
/** Null for none. */
export const noFace = (id) => (id === NO_FACE ? null : id);
/** Of the numbers of firma_status. */
const isHit = (status) => status === 1 || status === 2;
export const noPortal = (id) => (id === NO_PORTAL ? null : id);
const ROOMS = new Map([
    [undefined, 0xffffffff],
    ['any', 0xffffffff],
    ['locate', 0xfffffffe],
]);

const OPTION_NAMES = ['mask', 'bothSides', 'contactOffset', 'room'];
const NEAR_OPTION_NAMES = ['mask', 'room'];
const COUNT_NAMES = ['nodes', 'boxes', 'faces', 'precise'];

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

/** The options' address, or 0 for none. @param more  names of options that the caller looks at itself */
export function putCastOptions(core, options, place, more = []) {
    if (options === undefined) return 0;
    object(options, place, 'the options', [...OPTION_NAMES, ...more]);
    const bits = options.mask === undefined ? 0xffffffff : mask(options.mask, place);
    const sides = flag(options.bothSides, place, 'bothSides');
    const contactOffset = options.contactOffset === undefined ? -1 : number(options.contactOffset, place, 'contactOffset');
    const room = ROOMS.get(options.room) ?? word(options.room, place, "room, where not 'any' or 'locate',");
    const at = core.at.castOptions;
    core.setU32(at + CAST_OPTIONS.size, CAST_OPTIONS.sizeof);
    core.setU32(at + CAST_OPTIONS.mask, bits);
    core.setU32(at + CAST_OPTIONS.sides, sides);
    core.setU32(at + CAST_OPTIONS.room, room);
    core.setF64(at + CAST_OPTIONS.contactOffset, contactOffset);
    core.setU32(at + CAST_OPTIONS.passed, 0);
    core.setU32(at + CAST_OPTIONS.passedCapacity, 0);
    core.setU32(at + CAST_OPTIONS.passedCount, 0);
    core.setU32(at + CAST_OPTIONS.passedPortals, 0);
    return at;
}

/** Runs cast(given, options), and again with more room where options.passed wants more rooms than fit. */
export function withPassed(core, options, at, cast) {
    const lists = ['passed', 'passedPortals'].filter((name) => options?.[name] !== undefined);
    if (lists.length === 0) return cast(at);
    for (const name of lists)
        if (!Array.isArray(options[name])) throw badCall('cast', `${name} must be an array, which gets the numbers`);
    return core.borrow((lent) => {
        const count = lent.take(16);
        for (let capacity = 64; ; capacity = core.getU32(count)) {
            const [rooms, portals] = [lent.take(4 * capacity), lent.take(4 * capacity)];
            core.setU32(count, 0);
            core.setU32(at + CAST_OPTIONS.passed, rooms);
            core.setU32(at + CAST_OPTIONS.passedPortals, portals);
            core.setU32(at + CAST_OPTIONS.passedCapacity, capacity);
            core.setU32(at + CAST_OPTIONS.passedCount, count);
            const code = cast(at);
            core.refresh();
            if (code !== 0) return code;
            const passed = core.getU32(count);
            if (passed > capacity) continue;
            const words = (from) => Array.from(core.u32.subarray(from >>> 2, (from >>> 2) + passed));
            const fill = (list, numbers) => {
                list.length = 0;
                for (const value of numbers) list.push(value);
            };
            if (options.passed) fill(options.passed, words(rooms));
            if (options.passedPortals) fill(options.passedPortals, words(portals).map(noPortal));
            return code;
        }
    });
}

/** The options' address of overlap() and closest(), or 0 for none. */
export function putNearOptions(core, options, place) {
    if (options === undefined) return 0;
    object(options, place, 'the options', NEAR_OPTION_NAMES);
    const bits = options.mask === undefined ? 0xffffffff : mask(options.mask, place);
    const room = options.room === undefined ? 0xffffffff : word(options.room, place, 'room');
    const at = core.at.nearOptions;
    core.setU32(at + NEAR_OPTIONS.size, NEAR_OPTIONS.sizeof);
    core.setU32(at + NEAR_OPTIONS.mask, bits);
    core.setU32(at + NEAR_OPTIONS.room, room);
    core.setU32(at + NEAR_OPTIONS.reserved, 0);
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
    const i32 = core.i32;
    const three = (k) => [f64[k], f64[k + 1], f64[k + 2]];
    const corner = w + U32(HIT.corner);
    return {
        status: STATUS_NAMES[u32[w + U32(HIT.status)]],
        hit: isHit(u32[w + U32(HIT.status)]),
        fraction: f64[d + F64(HIT.fraction)],
        safeFraction: f64[d + F64(HIT.safeFraction)],
        centre: three(d + F64(HIT.centre)),
        point: three(d + F64(HIT.point)),
        normal: three(d + F64(HIT.normal)),
        faceNormal: three(d + F64(HIT.faceNormal)),
        feature: FEATURE_NAMES[u32[w + U32(HIT.feature)]],
        featureIndex: u32[w + U32(HIT.featureIndex)],
        face: noFace(u32[w + U32(HIT.face)]),
        corner: [i32[corner], i32[corner + 1], i32[corner + 2]],
        portal: noPortal(u32[w + U32(HIT.portal)]),
        material: u32[w + U32(HIT.material)],
    };
}

/**
 * What a hit of this world was, as cast() gave it, to the fixed hit: what firma_world_hit_info() looks at, and
 * with `whole` what firma_contact_points() does.
 */
export function putHit(core, hit, place, whole = false) {
    if (hit === undefined) throw badCall(place, 'the hit must be one that cast() gave');
    object(hit, place, 'the hit');
    const at = core.at.hit;
    const id = (value, name, none) => (value === null ? none : word(value, place, name));
    const feature = FEATURE_NAMES.indexOf(hit.feature);
    if (feature < 0) throw badCall(place, 'the hit must be one that cast() gave');
    core.setU32(at + HIT.feature, feature);
    core.setU32(at + HIT.featureIndex, word(hit.featureIndex, place, 'featureIndex'));
    core.setU32(at + HIT.face, id(hit.face, 'face', NO_FACE));
    core.setU32(at + HIT.portal, id(hit.portal, 'portal', NO_PORTAL));
    core.i32.set(vector(hit.corner, 3, place, 'corner'), (at + HIT.corner) >>> 2);
    core.setVector(at + HIT.normal, vector(hit.normal, 3, place, 'normal'));
    core.setVector(at + HIT.faceNormal, vector(hit.faceNormal, 3, place, 'faceNormal'));
    if (!whole) return at;
    const status = STATUS_NAMES.indexOf(hit.status);
    if (status < 0) throw badCall(place, 'the hit must be one that cast() gave');
    core.setU32(at + HIT.status, status);
    core.setF64(at + HIT.fraction, number(hit.fraction, place, 'fraction'));
    core.setVector(at + HIT.centre, vector(hit.centre, 3, place, 'centre'));
    core.setVector(at + HIT.point, vector(hit.point, 3, place, 'point'));
    return at;
}

export function getHitInfo(core, at) {
    const flags = core.getU32(at + HIT_INFO.flags);
    return {
        room: core.getU32(at + HIT_INFO.room),
        source: core.getU32(at + HIT_INFO.source),
        sourceEdit: core.getU32(at + HIT_INFO.sourceEdit),
        mask: core.getU32(at + HIT_INFO.mask),
        twoSided: (flags & FACE_TWO_SIDED) !== 0,
        solid: (flags & FACE_SOLID) !== 0,
        otherFace: noFace(core.getU32(at + HIT_INFO.otherFace)),
    };
}

export function getNear(core, at) {
    const corner = (at + NEAR.corner) >>> 2;
    return {
        point: core.getVector(at + NEAR.point),
        distance: core.getF64(at + NEAR.distance),
        face: noFace(core.getU32(at + NEAR.face)),
        corner: Array.from(core.i32.subarray(corner, corner + 3)),
        portal: noPortal(core.getU32(at + NEAR.portal)),
        material: core.getU32(at + NEAR.material),
        feature: FEATURE_NAMES[core.getU32(at + NEAR.feature)],
        featureIndex: core.getU32(at + NEAR.featureIndex),
    };
}

/** With the way out. */
export function getOverlap(core, at) {
    return {
        ...getNear(core, at),
        direction: core.getVector(at + NEAR.direction),
        depth: core.getF64(at + NEAR.depth),
    };
}

const BYTES = ['status', 'feature'];
const WORDS = ['featureIndex', 'face', 'portal', 'material'];
const DOUBLES = ['fraction', 'safeFraction'];
const VECTORS = ['centre', 'point', 'normal', 'faceNormal'];

/** Set by HitBatch, which keeps its capacity to itself. */
let reserveHits;

/** The answers of a batch, an array for each field. */
export class HitBatch {
    /** How many answers there are; the arrays may be longer. */
    count = 0;
    #capacity = -1;

    constructor() {
        reserveHits(this, 0);
    }

    static {
        reserveHits = (batch, count) => {
            if (batch.#capacity < count) {
                for (const name of BYTES) batch[name] = new Uint8Array(count);
                for (const name of WORDS) batch[name] = new Uint32Array(count);
                batch.corner = new Int32Array(3 * count);
                for (const name of DOUBLES) batch[name] = new Float64Array(count);
                for (const name of VECTORS) batch[name] = new Float64Array(3 * count);
                batch.#capacity = count;
            }
            batch.count = 0; // until the answers are there
        };
    }

    /** Answer k as cast() gives it; null beyond the last. */
    hit(k) {
        if (!(k >= 0 && k < this.count)) return null;
        const three = (all) => [all[3 * k], all[3 * k + 1], all[3 * k + 2]];
        return {
            status: STATUS_NAMES[this.status[k]],
            hit: isHit(this.status[k]),
            fraction: this.fraction[k],
            safeFraction: this.safeFraction[k],
            centre: three(this.centre),
            point: three(this.point),
            normal: three(this.normal),
            faceNormal: three(this.faceNormal),
            feature: FEATURE_NAMES[this.feature[k]],
            featureIndex: this.featureIndex[k],
            face: noFace(this.face[k]),
            corner: three(this.corner),
            portal: noPortal(this.portal[k]),
            material: this.material[k],
        };
    }
}

/** The hits at `at` become answers `begin` and on. In one loop each array is of one type to the engine. */
export function getHits(core, at, count, batch, begin) {
    const { f64, u32, i32 } = core;
    const { status, feature, featureIndex, face, corner, portal, material } = batch;
    const { fraction, safeFraction, centre, point, normal, faceNormal } = batch;
    for (let k = 0; k < count; ++k) {
        const to = begin + k;
        const w = (at + k * HIT.sizeof) >>> 2;
        const d = w >>> 1;
        status[to] = u32[w + U32(HIT.status)];
        feature[to] = u32[w + U32(HIT.feature)];
        featureIndex[to] = u32[w + U32(HIT.featureIndex)];
        face[to] = u32[w + U32(HIT.face)];
        portal[to] = u32[w + U32(HIT.portal)];
        material[to] = u32[w + U32(HIT.material)];
        fraction[to] = f64[d + F64(HIT.fraction)];
        safeFraction[to] = f64[d + F64(HIT.safeFraction)];
        for (let axis = 0; axis < 3; ++axis) {
            corner[3 * to + axis] = i32[w + U32(HIT.corner) + axis];
            centre[3 * to + axis] = f64[d + F64(HIT.centre) + axis];
            point[3 * to + axis] = f64[d + F64(HIT.point) + axis];
            normal[3 * to + axis] = f64[d + F64(HIT.normal) + axis];
            faceNormal[3 * to + axis] = f64[d + F64(HIT.faceNormal) + axis];
        }
    }
}

/** Answers `begin` and on are those of casts that were not made: status 'invalid', as where nothing could be asked. */
export function missHits(batch, begin, end) {
    if (begin >= end) return;
    for (const name of [...BYTES, ...WORDS, ...DOUBLES]) batch[name].fill(0, begin, end);
    for (const name of ['corner', ...VECTORS]) batch[name].fill(0, 3 * begin, 3 * end);
    batch.status.fill(STATUS_NAMES.indexOf('invalid'), begin, end);
    batch.face.fill(NO_FACE, begin, end);
    batch.portal.fill(NO_PORTAL, begin, end);
}

/** Empties a batch and makes room for `count` answers, in the arrays that it has when they are long enough. */
export const reserve = (batch, count) => reserveHits(batch, count);
