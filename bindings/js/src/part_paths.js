// SPDX-License-Identifier: MIT
// How parts move by time: plain data, and where it leads.
import { number, object } from './arguments.js';
import { badCall } from './errors.js';
import * as layout from './layout.js';
import { MOTION, PART_PATH, PART_STOP } from './layout.js';
import { getMembers, putMembers, structTable } from './structs.js';

const { fresh } = structTable({ path: [PART_PATH], motion: [MOTION] });

const PATH_KINDS = { repeats: 'flag', rotation: 'quaternion', axis: 'vector', spin: 'number' };
const SWING_KINDS = { reach: 'vector', angle: 'number', period: 'number', phase: 'number' };
const SWING_FIELDS = {
    reach: PART_PATH.swingReach,
    angle: PART_PATH.swingAngle,
    period: PART_PATH.swingPeriod,
    phase: PART_PATH.swingPhase,
};
const STOP_KINDS = { position: 'vector', angle: 'number', wait: 'number', seconds: 'number' };
export const MOTION_KINDS = { position: 'vector', rotation: 'quaternion', path: 'vector', turn: 'vector' };
export const WHEN_BLOCKED_NAMES = layout.WHEN_BLOCKED_NAMES.map((name) => name.replace('blocked_', ''));

/** @returns the address of the struct */
export function putPath(core, lent, path, place) {
    const given = object(path, place, 'the path', [...Object.keys(PATH_KINDS), 'stops', 'swing']);
    const at = fresh(core, 'path');
    core.setF64(at + PART_PATH.rotation + 24, 1);
    core.setF64(at + PART_PATH.axis + 16, 1);
    putMembers(core, at, PART_PATH, PATH_KINDS, given, place);
    putMembers(core, at, SWING_FIELDS, SWING_KINDS, object(given.swing, place, 'swing', Object.keys(SWING_KINDS)), place);
    if (given.stops === undefined) return at;
    if (!Array.isArray(given.stops)) throw badCall(place, 'the stops must be an array');
    const stops = lent.take(given.stops.length * PART_STOP.sizeof);
    core.u8.fill(0, stops, stops + given.stops.length * PART_STOP.sizeof);
    given.stops.forEach((stop, k) => {
        const one = object(stop, place, `stop ${k}`, Object.keys(STOP_KINDS));
        putMembers(core, stops + k * PART_STOP.sizeof, PART_STOP, STOP_KINDS, one, place);
    });
    core.setU32(at + PART_PATH.stops, stops);
    core.setU32(at + PART_PATH.stopCount, given.stops.length);
    return at;
}

/** The other way: of a struct of the module. */
export function getPath(core, at) {
    const first = core.getU32(at + PART_PATH.stops);
    return {
        stops: Array.from({ length: core.getU32(at + PART_PATH.stopCount) }, (_, k) =>
            getMembers(core, first + k * PART_STOP.sizeof, PART_STOP, STOP_KINDS),
        ),
        ...getMembers(core, at, PART_PATH, PATH_KINDS),
        swing: getMembers(core, at, SWING_FIELDS, SWING_KINDS),
    };
}

/** Runs work(address) with a path as the module takes it. */
function withPath(core, path, place, work) {
    if (path === undefined) throw badCall(place, 'the path must be an object');
    return core.borrow((lent) => work(putPath(core, lent, path, place)));
}

function motionOf(core, path, from, to, place) {
    return withPath(core, path, place, (at) => {
        const motion = fresh(core, 'motion');
        core.run('firma_part_path_motion', at, from, to, motion);
        return getMembers(core, motion, MOTION, MOTION_KINDS);
    });
}

/** Both ends of a motion are those of the path, exactly. */
export function pathPose(core, path, seconds) {
    number(seconds, 'pathPose', 'seconds');
    const { position, rotation } = motionOf(core, path, seconds, seconds, 'pathPose');
    return { position, rotation, scale: 1 };
}

export function pathMotion(core, path, from, to) {
    number(from, 'pathMotion', 'from');
    number(to, 'pathMotion', 'to');
    return motionOf(core, path, from, to, 'pathMotion');
}

export function pathNextStop(core, path, seconds) {
    number(seconds, 'pathNextStop', 'seconds');
    return withPath(core, path, 'pathNextStop', (at) => {
        core.run('firma_part_path_next_stop', at, seconds, core.at.out);
        return core.getF64(core.at.out);
    });
}

export function pathAtFirstStop(core, path, seconds) {
    number(seconds, 'pathAtFirstStop', 'seconds');
    return withPath(core, path, 'pathAtFirstStop', (at) => {
        core.run('firma_part_path_at_first_stop', at, seconds, core.at.out);
        return core.getU32(core.at.out) !== 0;
    });
}
