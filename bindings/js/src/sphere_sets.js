// SPDX-License-Identifier: MIT
// Sets of spheres on their way: against a world, against each other; and fitted into a world's solid.
import { doubles } from './arguments.js';
import { putFit } from './bodies.js';
import { badCall } from './errors.js';
import { idOf } from './handle.js';
import { getHit, putCastOptions } from './hits.js';
import { FIT_OPTIONS, MOTION, PART_HIT, SET_HIT, SET_PAIR_HIT, SET_PART_HIT, STATUS_NAMES } from './layout.js';
import { ofPart, putMotion, putScene } from './scenes.js';
import { orNull, structTable } from './structs.js';

const { toFill } = structTable({ hit: [SET_HIT], pair: [SET_PAIR_HIT], ofPart: [SET_PART_HIT] });
/** As the module has it where none is said. */
const USUAL_SPHERES = 64;

/** A set and its motion. @returns the addresses of both, and how many spheres between them: arguments of a call */
export function putSet(core, lent, spheres, motion, place) {
    doubles(spheres, 4, place, 'the spheres');
    if (motion === undefined) throw badCall(place, 'the motion must be an object');
    const at = lent.doubles(spheres);
    const way = lent.take(MOTION.sizeof);
    putMotion(core, way, motion, place, 'the motion');
    return [at, spheres.length / 4, way];
}

export function castSet(core, world, spheres, motion, options) {
    const place = 'castSet';
    const id = idOf(world, core, place, 'world');
    return core.borrow((lent) => {
        const set = putSet(core, lent, spheres, motion, place);
        const chosen = putCastOptions(core, options, place);
        const at = toFill(core, 'hit');
        core.run('firma_cast_set', id, ...set, chosen, at);
        return { ...getHit(core, at + SET_HIT.hit), sphere: orNull(core.getU32(at + SET_HIT.sphere)) };
    });
}

export function castSetScene(core, scene, spheres, motion, options) {
    const place = 'castSetScene';
    return core.borrow((lent) => {
        const asked = putScene(core, scene, place);
        const set = putSet(core, lent, spheres, motion, place);
        const chosen = putCastOptions(core, options, place);
        const at = toFill(core, 'ofPart');
        core.run('firma_cast_set_scene', asked, ...set, chosen, at);
        const part = at + SET_PART_HIT.hit;
        const sphere = orNull(core.getU32(at + SET_PART_HIT.sphere));
        return { ...getHit(core, part + PART_HIT.hit), ...ofPart(core, part, PART_HIT), sphere };
    });
}

export function castSetPair(core, a, motionA, b, motionB) {
    const place = 'castSetPair';
    return core.borrow((lent) => {
        const sets = [...putSet(core, lent, a, motionA, place), ...putSet(core, lent, b, motionB, place)];
        const at = toFill(core, 'pair');
        core.run('firma_cast_set_pair', ...sets, at);
        const status = STATUS_NAMES[core.getU32(at + SET_PAIR_HIT.status)];
        return {
            status,
            hit: status === 'hit' || status === 'touching',
            fraction: core.getF64(at + SET_PAIR_HIT.fraction),
            point: core.getVector(at + SET_PAIR_HIT.point),
            normal: core.getVector(at + SET_PAIR_HIT.normal),
            sphereA: orNull(core.getU32(at + SET_PAIR_HIT.sphereA)),
            sphereB: orNull(core.getU32(at + SET_PAIR_HIT.sphereB)),
        };
    });
}

export function fitSpheres(core, world, fit) {
    const place = 'fitSpheres';
    const id = idOf(world, core, place, 'world');
    const chosen = putFit(core, fit, place);
    const most = Math.min(core.getU32(chosen + FIT_OPTIONS.maxSpheres) || USUAL_SPHERES, 4096);
    return core.borrow((lent) => {
        const at = lent.take(32 * most);
        const [count, error] = [core.at.out, core.at.out + 8];
        core.run('firma_world_fit_spheres', id, chosen, at, most, count, error);
        const spheres = core.f64.slice(at >>> 3, (at >>> 3) + 4 * core.getU32(count));
        return { spheres, error: core.getF64(error) };
    });
}
