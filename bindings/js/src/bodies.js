// SPDX-License-Identifier: MIT
// Bodies: their shapes, lists of them, and steps.
import { getPose, putPose } from './carving.js';
import { getMassAt } from './chunks.js';
import { badCall } from './errors.js';
import { CORE, Handle, ID, idOf, makeHandle } from './handle.js';
import { noFace } from './hits.js';
import { BODY, BODY_CONTACT, FIT_OPTIONS, MASS, POSE, STEP_OPTIONS, STEP_REPORT } from './layout.js';
import { doubles, number, object, vector, word } from './arguments.js';
import { fresh, getMembers, orNull, putMembers, toFill } from './structs.js';
import { putScene } from './scenes.js';

const MASS_NAMES = ['volume', 'mass', 'centre', 'inertia'];
export const BODY_KINDS = {
    position: 'vector',
    rotation: 'quaternion',
    velocity: 'vector',
    spin: 'vector',
    force: 'vector',
    torque: 'vector',
    mask: 'mask',
    friction: 'number',
    restitution: 'number',
    rolling: 'number',
};
/** Told, not taken. */
const TOLD_KINDS = { mass: 'number', asleep: 'flag', stuck: 'flag', crushed: 'flag' };
const BODY_NAMES = [...Object.keys(BODY_KINDS), ...Object.keys(TOLD_KINDS)];
const FIT_KINDS = { maxSpheres: 'word', maxError: 'number', margin: 'number' };
const FIT_NAMES = Object.keys(FIT_KINDS);
export const STEP_KINDS = {
    substepsASecond: 'word',
    maxBounces: 'word',
    gravity: 'vector',
    contactFriction: 'number',
    contactOffset: 'number',
    sleepSpeed: 'number',
    sleepAfter: 'number',
};
const STEP_NAMES = Object.keys(STEP_KINDS);
export const COUNTS = ['awake', 'contacts', 'swept', 'bounces', 'woken', 'stuck', 'crushed'];
/** The slot of no body, in the low half of a body's name. */
const NO_BODY = 0xffffffffn;

/** A body's name at an address, as the BigInt that it is here; null for none. */
export function getBodyId(core, at) {
    const id = core.u64[at >>> 3];
    return BigInt.asUintN(32, id) === NO_BODY ? null : id;
}

/** A body's name to an address, which is returned. */
export function putBodyIdAt(core, at, id, place) {
    if (typeof id !== 'bigint' || BigInt.asUintN(64, id) !== id)
        throw badCall(place, 'the body must be what add() gave, a BigInt');
    core.setU64(at, id);
    return at;
}

/** A body's name to where the module finds it: structs of two words go by address. @returns the address */
export const putBodyId = (core, id, place) => putBodyIdAt(core, core.at.out + 8, id, place);

/** How spheres are fitted into a solid. @returns the address of the struct */
export function putFit(core, fit, place) {
    const at = fresh(core, 'fitOptions');
    putMembers(core, at, FIT_OPTIONS, FIT_KINDS, object(fit, place, 'the fit', FIT_NAMES), place);
    return at;
}

export function massOfBall(core, radius, density) {
    const place = 'massOfBall';
    core.run('firma_mass_of_ball', number(radius, place, 'radius'), number(density, place, 'density'), core.at.mass);
    return getMassAt(core, core.at.mass);
}

export function massOfBox(core, half, density) {
    const place = 'massOfBox';
    core.setVector(core.at.input, vector(half, 3, place, 'half'));
    core.run('firma_mass_of_box', core.at.input, number(density, place, 'density'), core.at.mass);
    return getMassAt(core, core.at.mass);
}

/** What massOfBall() gives; of a chunk only what is the mass is looked at. @returns the address of the struct */
function putMass(core, mass, place) {
    if (mass === undefined) throw badCall(place, 'the mass must be an object');
    const given = object(mass, place, 'the mass', [...MASS_NAMES, 'origin', 'faceCount', 'low', 'high', 'matters']);
    const at = core.at.mass;
    const [volume, whole] = ['volume', 'mass'].map((name) => number(given[name], place, name));
    core.setF64(at + MASS.volume, volume);
    core.setF64(at + MASS.mass, whole);
    core.setVector(at + MASS.centre, vector(given.centre, 3, place, 'centre'));
    core.setVector(at + MASS.inertia, vector(given.inertia, 9, place, 'inertia'));
    return at;
}

export class BodyShape extends Handle {
    constructor(core, id) {
        super(core, id, 'firma_body_shape_release');
    }

    static make(core, spheres, mass) {
        const place = 'bodyShape';
        doubles(spheres, 4, place, 'the spheres');
        const heavy = putMass(core, mass, place);
        return core.borrow((lent) => {
            const at = lent.doubles(spheres);
            return new BodyShape(core, makeHandle(core, 'firma_body_shape_spheres', at, spheres.length / 4, heavy));
        });
    }
}

export class Bodies extends Handle {
    constructor(core, id) {
        super(core, id, 'firma_bodies_release');
    }

    static create(core) {
        return new Bodies(core, makeHandle(core, 'firma_bodies_create'));
    }

    copy() {
        const core = this[CORE];
        return new Bodies(core, makeHandle(core, 'firma_bodies_copy', this[ID]));
    }

    count() {
        const core = this[CORE];
        core.run('firma_bodies_get_count', this[ID], core.at.out);
        return core.getU32(core.at.out);
    }

    list() {
        const core = this[CORE];
        const count = this.count();
        return core.borrow((lent) => {
            const at = lent.take(8 * count);
            core.run('firma_bodies_list', this[ID], at, count, core.at.out);
            return Array.from(core.u64.subarray(at >>> 3, (at >>> 3) + count));
        });
    }

    add(shape, pose) {
        const core = this[CORE];
        const id = idOf(shape, core, 'add', 'body shape');
        return makeHandle(core, 'firma_bodies_add', this[ID], id, putPose(core, pose, 'add'));
    }

    addChunk(chunks, chunk, fit) {
        const core = this[CORE];
        const place = 'addChunk';
        const pieces = idOf(chunks, core, place, 'list of chunks');
        word(chunk, place, 'the chunk');
        return makeHandle(core, 'firma_bodies_add_chunk', this[ID], pieces, chunk, putFit(core, fit, place));
    }

    #id(id, place) {
        return putBodyId(this[CORE], id, place);
    }

    remove(id) {
        this[CORE].run('firma_bodies_remove', this[ID], this.#id(id, 'remove'));
    }

    get(id) {
        const core = this[CORE];
        const at = toFill(core, 'body');
        core.run('firma_bodies_get', this[ID], this.#id(id, 'get'), at);
        return getMembers(core, at, BODY, TOLD_KINDS, getMembers(core, at, BODY, BODY_KINDS));
    }

    set(id, body) {
        const core = this[CORE];
        if (body === undefined) throw badCall('set', 'the body must be an object');
        const given = object(body, 'set', 'the body', BODY_NAMES);
        const at = toFill(core, 'body');
        core.run('firma_bodies_get', this[ID], this.#id(id, 'set'), at);
        putMembers(core, at, BODY, BODY_KINDS, given, 'set');
        core.run('firma_bodies_set', this[ID], this.#id(id, 'set'), at);
    }

    pose(id) {
        const core = this[CORE];
        core.run('firma_bodies_get_pose', this[ID], this.#id(id, 'pose'), core.at.pose);
        return getPose(core, core.at.pose);
    }

    poses(out) {
        const core = this[CORE];
        if (out !== undefined && !(out instanceof Float64Array)) throw badCall('poses', 'out must be a Float64Array');
        const ids = this.list();
        const poses = out !== undefined && out.length >= 7 * ids.length ? out : new Float64Array(7 * ids.length);
        const at = core.at.pose;
        ids.forEach((id, k) => {
            core.run('firma_bodies_get_pose', this[ID], this.#id(id, 'poses'), at);
            const [position, rotation] = [(at + POSE.position) >>> 3, (at + POSE.rotation) >>> 3];
            for (let axis = 0; axis < 3; ++axis) poses[7 * k + axis] = core.f64[position + axis];
            for (let part = 0; part < 4; ++part) poses[7 * k + 3 + part] = core.f64[rotation + part];
        });
        return poses;
    }

    wake(id) {
        this[CORE].run('firma_bodies_wake', this[ID], this.#id(id, 'wake'));
    }

    push(id, impulse, point) {
        const core = this[CORE];
        core.setVector(core.at.input, vector(impulse, 3, 'push', 'impulse'));
        core.setVector(core.at.input + 24, vector(point, 3, 'push', 'point'));
        core.run('firma_bodies_push', this[ID], this.#id(id, 'push'), core.at.input, core.at.input + 24);
    }

    step(scene, seconds, options) {
        const core = this[CORE];
        const there = putScene(core, scene, 'step');
        number(seconds, 'step', 'seconds');
        const given = object(options, 'step', 'the options', STEP_NAMES);
        const chosen = fresh(core, 'stepOptions');
        putMembers(core, chosen, STEP_OPTIONS, STEP_KINDS, given, 'step');
        const at = toFill(core, 'stepReport');
        core.run('firma_bodies_step_scene', this[ID], there, seconds, chosen, at);
        const report = {};
        for (const name of COUNTS) report[name] = core.getCount(at + STEP_REPORT[name]);
        return report;
    }

    contacts() {
        const core = this[CORE];
        return core.borrow((lent) => {
            core.run('firma_bodies_contacts', this[ID], 0, 0, core.at.out);
            const count = core.getU32(core.at.out);
            const all = lent.take(count * BODY_CONTACT.sizeof);
            core.run('firma_bodies_contacts', this[ID], all, count, core.at.out);
            return Array.from({ length: count }, (_, k) => {
                const at = all + k * BODY_CONTACT.sizeof;
                const corner = (at + BODY_CONTACT.corner) >>> 2;
                return {
                    body: getBodyId(core, at + BODY_CONTACT.body),
                    other: getBodyId(core, at + BODY_CONTACT.other),
                    point: core.getVector(at + BODY_CONTACT.point),
                    normal: core.getVector(at + BODY_CONTACT.normal),
                    force: core.getF64(at + BODY_CONTACT.force),
                    face: noFace(core.getU32(at + BODY_CONTACT.face)),
                    corner: Array.from(core.i32.subarray(corner, corner + 3)),
                    portal: orNull(core.getU32(at + BODY_CONTACT.portal)),
                    part: orNull(core.getU32(at + BODY_CONTACT.part)),
                };
            });
        });
    }

    hash() {
        const core = this[CORE];
        core.run('firma_bodies_hash', this[ID], core.at.out);
        return core.u64[core.at.out >>> 3];
    }
}
