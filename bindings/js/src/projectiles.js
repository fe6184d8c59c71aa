// SPDX-License-Identifier: MIT
// Projectiles: plain data of JavaScript's, which a call lets fly and brings back with what happened.
import { getBodyId } from './bodies.js';
import { badCall, FirmaError } from './errors.js';
import { idOf, makeHandle } from './handle.js';
import { noFace } from './hits.js';
import {
    FLY_OPTIONS,
    FLY_REPORT,
    PROJECTILE,
    PROJECTILE_STATE_NAMES,
    SHOT_EVENT,
    SHOT_EVENT_KIND_NAMES,
    SHOT_LENGTH,
    SHOT_TERMS,
    SHOT_VIEW,
} from './layout.js';
import { flag, longWord, mask, number, object, vector, word } from './arguments.js';
import { fresh, orNull, putMembers, toFill } from './structs.js';

const SIZE = PROJECTILE.sizeof;
const NAMES = ['position', 'velocity', 'mass', 'age', 'mask', 'user', 'worldHash', 'state'];
/** As firma_projectile_defaults() has them. */
const DEFAULTS = { position: [0, 0, 0], velocity: [0, 0, 0], mass: 0.01, age: 0, mask: 0xffffffff, user: 0, worldHash: 0n, state: 'flying' };
export const TERM_KINDS = { ricochetBelow: 'number', restitution: 'number', friction: 'number', resistance: 'number' };
const TERM_NAMES = Object.keys(TERM_KINDS);
const FLY_KINDS = {
    maxImpacts: 'word',
    gravity: 'vector',
    maxBow: 'number',
    maxAge: 'number',
    stopSpeed: 'number',
    maxThickness: 'number',
    paneEnergy: 'number',
};
const FLY_NAMES = [...Object.keys(FLY_KINDS), 'other', 'ofBodies', 'matters', 'bodies', 'events'];

/** For those who let them fly. */
const BYTES = Symbol('bytes');

/** Members as they are given, checked: nothing of a projectile is changed before all are. */
function readProjectile(given, place) {
    if (given === undefined) throw badCall(place, 'the projectile must be an object');
    const read = { ...object(given, place, 'the projectile', NAMES) };
    for (const name in read) if (read[name] === undefined) delete read[name];
    for (const name of ['position', 'velocity']) if (name in read) vector(read[name], 3, place, name);
    for (const name of ['mass', 'age']) if (name in read) number(read[name], place, name);
    if ('mask' in read) mask(read.mask, place);
    if ('user' in read) word(read.user, place, 'user');
    if ('worldHash' in read) read.worldHash = longWord(read.worldHash, place, 'worldHash');
    if ('state' in read && !PROJECTILE_STATE_NAMES.includes(read.state))
        throw badCall(place, `state must be one of ${PROJECTILE_STATE_NAMES.join(', ')}`);
    return read;
}

export class Projectiles {
    #count = 0;
    #u8 = new Uint8Array(0);
    #u32;
    #f64;
    #u64;

    constructor(from) {
        if (from !== undefined && !(from instanceof Projectiles))
            throw badCall('Projectiles', 'what is copied must be Projectiles');
        this.#reserve(from?.count ?? 16);
        if (from === undefined) return;
        this.#u8.set(from[BYTES]);
        this.#count = from.count;
    }

    get count() {
        return this.#count;
    }

    get [BYTES]() {
        return this.#u8.subarray(0, this.#count * SIZE);
    }

    add(projectile) {
        const read = readProjectile(projectile, 'add');
        if ((this.#count + 1) * SIZE > this.#u8.length) this.#reserve(2 * this.#count + 16);
        const index = this.#count++;
        this.#u8.fill(0, index * SIZE, (index + 1) * SIZE);
        this.#put(index * SIZE, { ...DEFAULTS, ...read });
        return index;
    }

    get(index) {
        const at = this.#start(index, 'get');
        const [d, w] = [at >>> 3, at >>> 2];
        return {
            position: this.#three(at + PROJECTILE.position),
            velocity: this.#three(at + PROJECTILE.velocity),
            mass: this.#f64[d + PROJECTILE.mass / 8],
            age: this.#f64[d + PROJECTILE.age / 8],
            mask: this.#u32[w + PROJECTILE.mask / 4],
            user: this.#u32[w + PROJECTILE.user / 4],
            worldHash: this.#u64[d + PROJECTILE.worldHash / 8],
            state: PROJECTILE_STATE_NAMES[this.#u32[w + PROJECTILE.state / 4]],
        };
    }

    set(index, projectile) {
        this.#put(this.#start(index, 'set'), readProjectile(projectile, 'set'));
    }

    positions(out) {
        if (out !== undefined && !(out instanceof Float64Array))
            throw badCall('positions', 'out must be a Float64Array');
        const all = out !== undefined && out.length >= 3 * this.#count ? out : new Float64Array(3 * this.#count);
        for (let k = 0; k < this.#count; ++k)
            for (let axis = 0; axis < 3; ++axis)
                all[3 * k + axis] = this.#f64[(k * SIZE + PROJECTILE.position) / 8 + axis];
        return all;
    }

    removeEnded() {
        let kept = 0;
        for (let k = 0; k < this.#count; ++k) {
            if (this.#u32[(k * SIZE + PROJECTILE.state) >>> 2] !== 0) continue;
            this.#u8.copyWithin(kept++ * SIZE, k * SIZE, (k + 1) * SIZE);
        }
        const removed = this.#count - kept;
        this.#count = kept;
        return removed;
    }

    clear() {
        this.#count = 0;
    }

    copy() {
        return new Projectiles(this);
    }

    #reserve(count) {
        const bytes = new Uint8Array(SIZE * count);
        bytes.set(this.#u8.subarray(0, bytes.length));
        this.#u8 = bytes;
        this.#u32 = new Uint32Array(bytes.buffer);
        this.#f64 = new Float64Array(bytes.buffer);
        this.#u64 = new BigUint64Array(bytes.buffer);
    }

    /** Where projectile `index` begins. */
    #start(index, place) {
        if (word(index, place, 'the index') >= this.#count)
            throw new FirmaError('OUT_OF_RANGE', `${place}: there is no projectile ${index}, of ${this.#count}`);
        return index * SIZE;
    }

    #three(at) {
        return Array.from(this.#f64.subarray(at >>> 3, (at >>> 3) + 3));
    }

    #put(at, read) {
        const [d, w] = [at >>> 3, at >>> 2];
        for (const name of ['position', 'velocity'])
            if (name in read) this.#f64.set(read[name], d + PROJECTILE[name] / 8);
        for (const name of ['mass', 'age']) if (name in read) this.#f64[d + PROJECTILE[name] / 8] = read[name];
        for (const name of ['mask', 'user']) if (name in read) this.#u32[w + PROJECTILE[name] / 4] = read[name];
        if ('worldHash' in read) this.#u64[d + PROJECTILE.worldHash / 8] = read.worldHash;
        if ('state' in read) this.#u32[w + PROJECTILE.state / 4] = PROJECTILE_STATE_NAMES.indexOf(read.state);
    }
}

/** Those that lie at an address. */
export function getProjectiles(core, at, count) {
    const projectiles = new Projectiles();
    for (let k = 0; k < count; ++k) projectiles.add({});
    projectiles[BYTES].set(core.u8.subarray(at, at + count * SIZE));
    return projectiles;
}

function bytesOf(projectiles, place) {
    if (!(projectiles instanceof Projectiles)) throw badCall(place, 'the projectiles must be Projectiles');
    return projectiles[BYTES];
}

export function putTerms(core, at, terms, place, what) {
    putMembers(core, at, SHOT_TERMS, TERM_KINDS, object(terms, place, what, TERM_NAMES), place);
}

/** Terms by number of matter, each over those of `other`. */
function putMatters(core, lent, at, matters, place) {
    if (!Array.isArray(matters)) throw badCall(place, 'matters must be an array');
    const all = lent.take(matters.length * SHOT_TERMS.sizeof);
    const other = at + FLY_OPTIONS.other;
    matters.forEach((terms, k) => {
        const one = all + k * SHOT_TERMS.sizeof;
        core.u8.copyWithin(one, other, other + SHOT_TERMS.sizeof);
        putTerms(core, one, terms, place, `matters[${k}]`);
    });
    core.setU32(at + FLY_OPTIONS.matters, all);
    core.setU32(at + FLY_OPTIONS.matterCount, matters.length);
}

function putFlyOptions(core, lent, given, place) {
    const at = fresh(core, 'flyOptions');
    putMembers(core, at, FLY_OPTIONS, FLY_KINDS, given, place);
    putTerms(core, at + FLY_OPTIONS.other, given.other, place, 'other');
    putTerms(core, at + FLY_OPTIONS.bodies, given.ofBodies, place, 'ofBodies');
    if (given.matters !== undefined) putMatters(core, lent, at, given.matters, place);
    return at;
}

export function getEvent(core, at, lengths) {
    const three = (name) => core.getVector(at + SHOT_EVENT[name]);
    const corner = (at + SHOT_EVENT.corner) >>> 2;
    const first = core.getU32(at + SHOT_EVENT.firstLength);
    return {
        kind: SHOT_EVENT_KIND_NAMES[core.getU32(at + SHOT_EVENT.kind)],
        projectile: core.getU32(at + SHOT_EVENT.projectile),
        number: core.getU32(at + SHOT_EVENT.number),
        time: core.getF64(at + SHOT_EVENT.time),
        point: three('point'),
        normal: three('normal'),
        velocity: three('velocity'),
        impulse: three('impulse'),
        energy: core.getF64(at + SHOT_EVENT.energy),
        thickness: core.getF64(at + SHOT_EVENT.thickness),
        face: noFace(core.getU32(at + SHOT_EVENT.face)),
        corner: Array.from(core.i32.subarray(corner, corner + 3)),
        portal: orNull(core.getU32(at + SHOT_EVENT.portal)),
        body: getBodyId(core, at + SHOT_EVENT.body),
        material: core.getU32(at + SHOT_EVENT.material),
        matter: core.getU32(at + SHOT_EVENT.matter),
        lengths: lengths.slice(first, first + core.getU32(at + SHOT_EVENT.lengthCount)),
    };
}

function getEvents(core, handle, get) {
    const at = toFill(core, 'shotView');
    core.run('firma_shot_events_get_view', handle, at);
    const many = (name, { sizeof }, get) => {
        const first = core.getU32(at + SHOT_VIEW[name]);
        const count = core.getU32(at + SHOT_VIEW[`${name.slice(0, -1)}Count`]);
        return Array.from({ length: count }, (_, k) => get(first + k * sizeof));
    };
    const lengths = many('lengths', SHOT_LENGTH, (one) => ({
        from: core.getF64(one + SHOT_LENGTH.from),
        to: core.getF64(one + SHOT_LENGTH.to),
        matter: core.getU32(one + SHOT_LENGTH.matter),
    }));
    return many('events', SHOT_EVENT, (one) => get(core, one, lengths));
}

/** What fly() takes no more of than its options say. */
const PLAIN = { names: [], put: () => undefined };

/**
 * @param called  the function of the module
 * @param where  what it takes after the projectiles: a world's handle, or the address of a scene
 * @param get  of each event, as getEvent()
 * @param more  names of further options, and what puts them: put(core, address, given, place) gives a visitor, or nothing
 */
export function flyIn(core, called, where, projectiles, seconds, options, place, get, more = PLAIN) {
    const bytes = bytesOf(projectiles, place);
    number(seconds, place, 'seconds');
    const given = object(options, place, 'the options', [...FLY_NAMES, ...more.names]);
    const bodies = given.bodies === undefined ? 0n : idOf(given.bodies, core, place, 'list of bodies');
    const wanted = given.events === undefined || flag(given.events, place, 'events') === 1;
    return core.borrow((lent) => {
        const chosen = putFlyOptions(core, lent, given, place);
        const visit = more.put(core, chosen, given, place);
        const at = lent.bytes(bytes);
        const report = toFill(core, 'flyReport');
        const events = wanted ? makeHandle(core, 'firma_shot_events_create') : 0n;
        try {
            core.runVisited(visit, called, at, projectiles.count, where, bodies, seconds, chosen, events, report);
            bytes.set(core.u8.subarray(at, at + bytes.length));
            const counts = ['flying', 'chords', 'impacts'].map((name) => [name, core.getCount(report + FLY_REPORT[name])]);
            return { ...Object.fromEntries(counts), events: wanted ? getEvents(core, events, get) : [] };
        } finally {
            if (wanted && !core.stopped) core.run('firma_shot_events_release', events);
        }
    });
}

export function fly(core, projectiles, world, seconds, options) {
    const id = idOf(world, core, 'fly', 'world');
    return flyIn(core, 'firma_fly', id, projectiles, seconds, options, 'fly', getEvent);
}

export function hashProjectiles(core, projectiles) {
    const bytes = bytesOf(projectiles, 'hashProjectiles');
    return core.borrow((lent) => {
        const at = lent.bytes(bytes);
        core.run('firma_projectiles_hash', at, projectiles.count, core.at.out);
        return core.u64[core.at.out >>> 3];
    });
}
