// SPDX-License-Identifier: MIT
// How much debris a game keeps: rules as they are given, and as they are told.
import { longWord, object } from './arguments.js';
import { DEBRIS_RULES } from './layout.js';
import { getMembers, putMembers } from './structs.js';

const KINDS = { toGround: 'flag', maxAge: 'number', maxAsleep: 'number', minToGround: 'number', maxOverlap: 'number' };
const COUNTS = ['maxBodies', 'maxSpheres', 'maxToGround'];
const NAMES = [...Object.keys(KINDS), ...COUNTS];

/** Over what is there. @param more  names of rules that the caller puts itself @returns the rules as an object */
export function putDebrisRules(core, at, rules, place, what, more = []) {
    const given = object(rules, place, what, [...NAMES, ...more]);
    putMembers(core, at, DEBRIS_RULES, KINDS, given, place);
    for (const name of COUNTS)
        if (given[name] !== undefined) core.setU64(at + DEBRIS_RULES[name], longWord(given[name], place, name));
    return given;
}

export function getDebrisRules(core, at) {
    const counts = COUNTS.map((name) => [name, core.getCount(at + DEBRIS_RULES[name])]);
    return { ...getMembers(core, at, DEBRIS_RULES, KINDS), ...Object.fromEntries(counts) };
}
