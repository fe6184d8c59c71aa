// SPDX-License-Identifier: MIT
// Shapes that move: spheres, capsules and hulls, one by one and many.
import { CORE, Handle, ID, idOf, makeHandle } from './handle.js';
import { badCall, FirmaError } from './errors.js';
import { ANSWERS, CASTS, HIT, MANY_OPTIONS, MOVER, MOVER_KIND_NAMES } from './layout.js';
import { doubles, number, object, vector, words } from './arguments.js';
import {
    addCounts,
    clearCounts,
    getHits,
    HitBatch,
    missHits,
    putCastOptions,
    putHit,
    reserve,
} from './hits.js';

const [SPHERE, CAPSULE, HULL] = ['sphere', 'capsule', 'hull'].map((name) => MOVER_KIND_NAMES.indexOf(name));
const MEMBERS = [['centre', 'radius'], ['from', 'to', 'radius'], ['hull', 'at']];

/** A convex hull or box, turned as it is. */
export class Hull extends Handle {
    constructor(core, id) {
        super(core, id, 'firma_hull_release');
    }

    corners() {
        const core = this[CORE];
        const most = 64;
        return core.borrow((lent) => {
            const at = lent.take(24 * most);
            core.run('firma_hull_corners', this[ID], at, most, core.at.out);
            return core.f64.slice(at >>> 3, (at >>> 3) + 3 * core.getU32(core.at.out));
        });
    }
}

export function hullFromPoints(core, points) {
    doubles(points, 3, 'hullFromPoints', 'points');
    return core.borrow((lent) => {
        const at = lent.doubles(points);
        return new Hull(core, makeHandle(core, 'firma_hull_from_points', at, points.length / 3));
    });
}

export function hullBox(core, half, axes) {
    vector(half, 3, 'hullBox', 'half');
    if (axes !== undefined) vector(axes, 9, 'hullBox', 'axes');
    return core.borrow((lent) => {
        const [size, turn] = [lent.doubles(half), axes === undefined ? 0 : lent.doubles(axes)];
        return new Hull(core, makeHandle(core, 'firma_hull_box', size, turn));
    });
}

/** Whether a cast is of another shape than a sphere. */
export const isOther = (input) => input?.hull !== undefined || input?.from !== undefined;

/** A sphere, capsule or hull to the fixed mover. @param more  members that the caller looks at itself */
export function putMover(core, mover, place, more = []) {
    if (mover === undefined) throw badCall(place, 'the shape must be an object');
    object(mover, place, 'the shape');
    const kind = mover.hull !== undefined ? HULL : mover.from !== undefined ? CAPSULE : SPHERE;
    object(mover, place, `the ${MOVER_KIND_NAMES[kind]}`, [...MEMBERS[kind], ...more]);
    const at = core.at.mover;
    core.setU32(at + MOVER.size, MOVER.sizeof);
    core.setU32(at + MOVER.kind, kind);
    const start = ['centre', 'from', 'at'][kind];
    core.setVector(at + MOVER.at, vector(mover[start], 3, place, start));
    if (kind === CAPSULE) core.setVector(at + MOVER.to, vector(mover.to, 3, place, 'to'));
    core.setF64(at + MOVER.radius, kind === HULL ? 0 : number(mover.radius, place, 'radius'));
    core.setU64(at + MOVER.hull, kind === HULL ? idOf(mover.hull, core, place, 'hull') : 0n);
    return at;
}

/** The same with its path. @returns [address of the mover, address of the path] */
export function putMoving(core, input, place) {
    const at = putMover(core, input, place, ['path']);
    core.setVector(core.at.input, vector(input.path, 3, place, 'path'));
    return [at, core.at.input];
}

export function contactPoints(world, hull, hit) {
    const core = world[CORE];
    const id = idOf(hull, core, 'contactPoints', 'hull');
    const at = putHit(core, hit, 'contactPoints', true);
    return core.borrow((lent) => {
        const points = lent.take(96);
        core.run('firma_contact_points', world[ID], id, at, points, core.at.out);
        return Array.from({ length: core.getU32(core.at.out) }, (_, k) => core.getVector(points + 24 * k));
    });
}

/** Casts that are handed over at a time: their columns and answers are copied, and take memory of the module. */
const MANY_AT_ONCE = 32768;
const COLUMNS = ['x', 'y', 'z', 'pathX', 'pathY', 'pathZ'];
const ENDS = ['toX', 'toY', 'toZ'];

/** Columns of many casts, checked to fit each other. */
function readCasts(core, casts, place) {
    if (casts === undefined) throw badCall(place, 'the casts must be an object');
    const names = [...COLUMNS, ...ENDS, 'radius', 'hulls', 'hullOf'];
    object(casts, place, 'the casts', names);
    const kind = casts.hulls !== undefined ? HULL : ENDS.some((name) => casts[name] !== undefined) ? CAPSULE : SPHERE;
    const wanted = [...COLUMNS, ...(kind === CAPSULE ? ENDS : [])];
    if (kind !== HULL && casts.radius !== undefined) wanted.push('radius');
    for (const name of kind === HULL ? [...ENDS, 'radius'] : ['hullOf'])
        if (casts[name] !== undefined) throw badCall(place, `${name} is of no use to a ${MOVER_KIND_NAMES[kind]}`);
    const read = { kind, columns: {}, count: doubles(casts.x, 1, place, 'x').length };
    for (const name of wanted) {
        const column = doubles(casts[name], 1, place, name);
        if (column.length !== read.count)
            throw badCall(place, `${name} must have as many numbers as x: ${read.count}, not ${column.length}`);
        read.columns[name] = column;
    }
    if (kind === HULL) {
        if (!Array.isArray(casts.hulls)) throw badCall(place, 'hulls must be an array of hulls');
        read.hulls = casts.hulls.map((hull) => idOf(hull, core, place, 'hull'));
        if (casts.hullOf !== undefined) read.hullOf = words(casts.hullOf, read.count, place, 'hullOf');
        const worst = read.hullOf?.findIndex((of) => of >= read.hulls.length) ?? -1;
        if (worst >= 0)
            throw new FirmaError(
                'INVALID',
                `${place}: cast ${worst} is of hull ${read.hullOf[worst]} of ${read.hulls.length}`,
            );
    }
    return read;
}

/** Hands casts over, some at a time; shows(begin, count, address of the answers, `wants`) takes the answers of each. */
function castSome(world, place, casts, options, { any, bytes, wants, show }) {
    const core = world[CORE];
    const read = readCasts(core, casts, place);
    const chosen = putCastOptions(core, options, place, ['counts', 'progress']);
    const progress = options?.progress;
    if (progress !== undefined && typeof progress !== 'function') throw badCall(place, 'progress must be a function');
    const counts = clearCounts(core, options, place);
    const id = world[ID]; // progress may release the world
    const { count } = read;
    core.borrow((lent) => {
        const most = Math.min(MANY_AT_ONCE, count);
        const given = lent.take(CASTS.sizeof);
        const many = lent.take(MANY_OPTIONS.sizeof);
        const answers = lent.take(ANSWERS.sizeof);
        const found = lent.take(most * bytes);
        const columns = Object.fromEntries(Object.keys(read.columns).map((name) => [name, lent.take(8 * most)]));
        const hulls = read.hulls ? lent.take(8 * read.hulls.length) : 0;
        const hullOf = read.hullOf ? lent.take(4 * most) : 0;
        core.u32.fill(0, given >>> 2, (given + CASTS.sizeof) >>> 2);
        core.u32.fill(0, many >>> 2, (many + MANY_OPTIONS.sizeof) >>> 2);
        core.u32.fill(0, answers >>> 2, (answers + ANSWERS.sizeof) >>> 2);
        for (const name in columns) core.setU32(given + CASTS[name], columns[name]);
        core.setU32(given + CASTS.size, CASTS.sizeof);
        core.setU32(given + CASTS.kind, read.kind);
        core.setU32(given + CASTS.hulls, hulls);
        core.setU32(given + CASTS.hullCount, read.hulls?.length ?? 0);
        core.setU32(given + CASTS.hullOf, hullOf);
        if (hulls) core.u64.set(read.hulls, hulls >>> 3);
        core.setU32(many + MANY_OPTIONS.size, MANY_OPTIONS.sizeof);
        core.setU32(many + MANY_OPTIONS.any, any);
        core.setU32(answers + ANSWERS.size, ANSWERS.sizeof);
        core.setU32(answers + ANSWERS[wants], found);
        let begin = 0;
        do {
            const some = Math.min(most, count - begin);
            const part = (list) => (list.subarray ? list.subarray(begin, begin + some) : list.slice(begin, begin + some));
            for (const name in columns) core.f64.set(part(read.columns[name]), columns[name] >>> 3);
            if (hullOf) core.u32.set(part(read.hullOf), hullOf >>> 2);
            core.setU32(given + CASTS.count, some);
            core.run('firma_cast_many', id, given, chosen, many, answers, counts, 0);
            show(begin, some, count, found);
            begin += some;
        } while (begin < count && progress?.(begin, count) !== false);
        if (begin >= count) progress?.(count, count);
        show(begin, 0, count, found);
    });
    addCounts(core, counts, options);
    return count;
}

export function castMany(world, casts, options, out) {
    if (!(out instanceof HitBatch)) throw badCall('castMany', 'out must be a HitBatch, as castMany() returns');
    const core = world[CORE];
    const show = (begin, some, count, found) => {
        if (begin === 0) reserve(out, count); // not before: a call that fails leaves `out` as it was
        if (some > 0) getHits(core, found, some, out, begin);
        else missHits(out, begin, count);
    };
    out.count = castSome(world, 'castMany', casts, options, { any: 0, bytes: HIT.sizeof, wants: 'hits', show });
    return out;
}

export function castManyAny(world, casts, options) {
    const core = world[CORE];
    let statuses;
    const show = (begin, some, count, found) => {
        if (begin === 0) statuses = new Uint8Array(count).fill(3);
        for (let k = 0; k < some; ++k) statuses[begin + k] = core.u32[(found >>> 2) + k];
    };
    castSome(world, 'castManyAny', casts, options, { any: 1, bytes: 4, wants: 'status', show });
    return statuses;
}
