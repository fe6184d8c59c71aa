// SPDX-License-Identifier: MIT
// Levels with parts that move: lists of parts, and what is cast and overlapped among them.
import { badCall, FirmaError } from './errors.js';
import { CORE, Handle, ID, idOf, makeHandle } from './handle.js';
import { getHit, getNear, getOverlap, putCastOptions, putNearOptions } from './hits.js';
import { MOTION, PART, PART_HIT, PART_NEAR, SCENE, STATUS_NAMES } from './layout.js';
import { mask, number, object, vector, word } from './arguments.js';
import { putMover, putMoving } from './movers.js';
import { MOTION_KINDS } from './part_paths.js';
import { fresh, orNull, putMembers, toFill } from './structs.js';
import { World } from './world.js';

const MOTION_NAMES = Object.keys(MOTION_KINDS);
const PART_NAMES = ['world', 'mask', 'motion'];
const SCENE_NAMES = ['world', 'parts', 'from', 'to'];

/** Over a motion of zeros, not turned. */
export function putMotion(core, at, motion, place, what) {
    core.f64.fill(0, at >>> 3, (at + MOTION.sizeof) >>> 3);
    core.setF64(at + MOTION.rotation + 24, 1);
    putMembers(core, at, MOTION, MOTION_KINDS, object(motion, place, what, MOTION_NAMES), place);
}

/** @returns the address of the struct */
function putPart(core, part, place) {
    if (part === undefined) throw badCall(place, 'the part must be an object');
    const given = object(part, place, 'the part', PART_NAMES);
    const at = fresh(core, 'part');
    core.setU64(at + PART.world, idOf(given.world, core, place, 'world'));
    if (given.mask !== undefined) core.setU32(at + PART.mask, mask(given.mask, place));
    putMotion(core, at + PART.motion, given.motion, place, 'the motion');
    return at;
}

export class Parts extends Handle {
    constructor(core, id) {
        super(core, id, 'firma_parts_release');
    }

    static create(core) {
        return new Parts(core, makeHandle(core, 'firma_parts_create'));
    }

    count() {
        const core = this[CORE];
        core.run('firma_parts_get_count', this[ID], core.at.out);
        return core.getU32(core.at.out);
    }

    add(part) {
        const core = this[CORE];
        core.run('firma_parts_add', this[ID], putPart(core, part, 'add'), core.at.out);
        return core.getU32(core.at.out);
    }

    set(index, part) {
        const core = this[CORE];
        word(index, 'set', 'the index');
        core.run('firma_parts_set', this[ID], index, putPart(core, part, 'set'));
    }

    setMotions(motions) {
        const core = this[CORE];
        const place = 'setMotions';
        if (!Array.isArray(motions)) throw badCall(place, 'the motions must be an array');
        core.borrow((lent) => {
            const at = lent.take(motions.length * MOTION.sizeof);
            motions.forEach((motion, k) => {
                const what = `motion ${k}`;
                if (motion === undefined) throw badCall(place, `${what} must be an object`);
                putMotion(core, at + k * MOTION.sizeof, motion, place, what);
            });
            core.run('firma_parts_set_motions', this[ID], at, motions.length);
        });
    }
}

/** A World, or one with parts, to the fixed scene. @returns its address */
export function putScene(core, scene, place) {
    if (scene === undefined) throw badCall(place, 'the scene must be a World or { world, parts, from, to }');
    const given = scene instanceof World ? { world: scene } : object(scene, place, 'the scene', SCENE_NAMES);
    const at = fresh(core, 'scene');
    core.setU64(at + SCENE.world, idOf(given.world, core, place, 'world'));
    if (given.parts !== undefined) core.setU64(at + SCENE.parts, idOf(given.parts, core, place, 'list of parts'));
    if (given.from !== undefined) core.setF64(at + SCENE.from, number(given.from, place, 'from'));
    if (given.to !== undefined) core.setF64(at + SCENE.to, number(given.to, place, 'to'));
    return at;
}

export const ofPart = (core, at, fields) => ({
    part: orNull(core.getU32(at + fields.part)),
    surfaceVelocity: core.getVector(at + fields.surfaceVelocity),
});

export function castScene(core, scene, input, options) {
    const place = 'castScene';
    const asked = putScene(core, scene, place);
    const [mover, path] = putMoving(core, input, place);
    const chosen = putCastOptions(core, options, place);
    const at = toFill(core, 'partHit');
    core.run('firma_cast_scene', asked, mover, path, chosen, at);
    return { ...getHit(core, at + PART_HIT.hit), ...ofPart(core, at, PART_HIT) };
}

export function castSceneAny(core, scene, input, options) {
    const place = 'castSceneAny';
    const asked = putScene(core, scene, place);
    const [mover, path] = putMoving(core, input, place);
    const chosen = putCastOptions(core, options, place);
    core.run('firma_cast_scene_any', asked, mover, path, chosen, core.at.out);
    const status = STATUS_NAMES[core.getU32(core.at.out)];
    if (status === 'invalid')
        throw new FirmaError('OUT_OF_RANGE', `${place}: a number, the room or the scene's stretch is out of range`);
    return status !== 'miss';
}

export function overlapScene(core, scene, shape, options) {
    const place = 'overlapScene';
    const { fraction = 0, ...near } = object(options, place, 'the options', ['fraction', 'mask', 'room']);
    number(fraction, place, 'fraction');
    return core.borrow((lent) => {
        for (let capacity = 16; ; capacity = core.getU32(core.at.out)) {
            const found = lent.take(capacity * PART_NEAR.sizeof);
            const asked = putScene(core, scene, place);
            const mover = putMover(core, shape, place);
            const chosen = putNearOptions(core, near, place);
            core.run('firma_overlap_scene', asked, mover, fraction, chosen, found, capacity, core.at.out);
            const count = core.getU32(core.at.out);
            if (count > capacity) continue;
            return Array.from({ length: count }, (_, k) => {
                const at = found + k * PART_NEAR.sizeof;
                return { ...getOverlap(core, at + PART_NEAR.near), ...ofPart(core, at, PART_NEAR) };
            });
        }
    });
}

export function closestInScene(core, scene, point, options) {
    const place = 'closestInScene';
    const names = ['reach', 'fraction', 'mask', 'room'];
    const { reach = Infinity, fraction = 0, ...near } = object(options, place, 'the options', names);
    vector(point, 3, place, 'point');
    number(reach, place, 'reach');
    number(fraction, place, 'fraction');
    const asked = putScene(core, scene, place);
    const chosen = putNearOptions(core, near, place);
    const at = toFill(core, 'partNear');
    core.setVector(core.at.input, point);
    core.run('firma_closest_scene', asked, core.at.input, reach, fraction, chosen, at, core.at.out);
    if (core.getU32(core.at.out) === 0) return null;
    return { ...getNear(core, at + PART_NEAR.near), ...ofPart(core, at, PART_NEAR) };
}
