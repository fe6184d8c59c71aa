// SPDX-License-Identifier: MIT
// What levels are made of: tables of matters as objects, and what a world says of its own.
import { badCall } from './errors.js';
import { CORE, ID, makeHandle } from './handle.js';
import { FRACTURE_NAMES, MATTER, MATTER_COUNTS, MATTER_PATTERN, MATTER_TABLE } from './layout.js';
import { number, object, text, vector, word } from './arguments.js';
import { putFaceRef } from './faces.js';

const TABLE_NAMES = ['matters', 'patterns'];
const MATTER_NAMES = ['name', 'inside', 'density', 'strength', 'hardness', 'fracture'];
const PATTERN_NAMES = ['pattern', 'matter'];
/** A table has no more matters. */
const MOST_MATTERS = 4096;

function list(value, place, what) {
    if (!Array.isArray(value)) throw badCall(place, `${what} must be an array`);
    return value;
}

/** A table as it is given, checked and copied. What its numbers may be is the C API's to say. */
export function readMatters(table, place) {
    const { matters, patterns = [] } = object(table, place, 'matters', TABLE_NAMES);
    return {
        matters: list(matters, place, 'matters.matters').map((one, k) => {
            const what = `matter ${k}`;
            const given = object(one, place, what, MATTER_NAMES);
            const { density = 2400, strength = 3, hardness = 0, fracture = FRACTURE_NAMES[0] } = given;
            const style = FRACTURE_NAMES.indexOf(fracture);
            if (style < 0)
                throw badCall(place, `${what}: fracture must be one of ${FRACTURE_NAMES.join(', ')}`);
            return {
                name: text(given.name, place, `${what}: name`),
                inside: text(given.inside, place, `${what}: inside`),
                density: number(density, place, `${what}: density`),
                strength: number(strength, place, `${what}: strength`),
                hardness: number(hardness, place, `${what}: hardness`),
                style,
            };
        }),
        patterns: list(patterns, place, 'matters.patterns').map((one, k) => {
            const what = `pattern ${k}`;
            const given = object(one, place, what, PATTERN_NAMES);
            return {
                pattern: text(given.pattern, place, `${what}: pattern`),
                matter: word(given.matter, place, `${what}: matter`),
            };
        }),
    };
}

/** Of what readMatters() gave. @returns the address of the struct */
export function putMatters(core, lent, { matters, patterns }) {
    const texts = matters.map(({ name, inside }) => [lent.text(name), lent.text(inside)]);
    const words = patterns.map(({ pattern }) => lent.text(pattern));
    const all = lent.take(matters.length * MATTER.sizeof);
    const each = lent.take(patterns.length * MATTER_PATTERN.sizeof);
    const at = lent.take(MATTER_TABLE.sizeof);
    matters.forEach((one, k) => {
        const start = all + k * MATTER.sizeof;
        core.setU32(start + MATTER.name, texts[k][0]);
        core.setU32(start + MATTER.inside, texts[k][1]);
        for (const name of ['density', 'strength', 'hardness']) core.setF64(start + MATTER[name], one[name]);
        core.setU32(start + MATTER.fracture, one.style);
        core.setU32(start + MATTER.reserved, 0);
    });
    patterns.forEach(({ matter }, k) => {
        const start = each + k * MATTER_PATTERN.sizeof;
        core.setU32(start + MATTER_PATTERN.pattern, words[k]);
        core.setU32(start + MATTER_PATTERN.matter, matter);
        core.setU32(start + MATTER_PATTERN.reserved, 0);
    });
    core.setU32(at + MATTER_TABLE.size, MATTER_TABLE.sizeof);
    core.setU32(at + MATTER_TABLE.reserved, 0);
    core.setU32(at + MATTER_TABLE.matters, all);
    core.setU32(at + MATTER_TABLE.matterCount, matters.length);
    core.setU32(at + MATTER_TABLE.patterns, each);
    core.setU32(at + MATTER_TABLE.patternCount, patterns.length);
    return at;
}

/** What a firma_matters handle shows; releases it. */
export function takeMatters(core, handle) {
    try {
        const at = core.at.matterTable;
        core.run('firma_matters_get_view', handle, at);
        const entries = (name, count, sizeof, get) =>
            Array.from({ length: core.getU32(at + MATTER_TABLE[count]) }, (_, k) =>
                get(core.getU32(at + MATTER_TABLE[name]) + k * sizeof),
            );
        return {
            matters: entries('matters', 'matterCount', MATTER.sizeof, (one) => ({
                name: core.text(core.getU32(one + MATTER.name)),
                inside: core.text(core.getU32(one + MATTER.inside)),
                density: core.getF64(one + MATTER.density),
                strength: core.getF64(one + MATTER.strength),
                hardness: core.getF64(one + MATTER.hardness),
                fracture: FRACTURE_NAMES[core.getU32(one + MATTER.fracture)],
            })),
            patterns: entries('patterns', 'patternCount', MATTER_PATTERN.sizeof, (one) => ({
                pattern: core.text(core.getU32(one + MATTER_PATTERN.pattern)),
                matter: core.getU32(one + MATTER_PATTERN.matter),
            })),
        };
    } finally {
        core.call('firma_matters_release', handle);
    }
}

export const defaultMatters = (core) => takeMatters(core, makeHandle(core, 'firma_matters_default'));

export const mattersOf = (world) => takeMatters(world[CORE], makeHandle(world[CORE], 'firma_world_matters', world[ID]));

export function matterAt(world, point) {
    const core = world[CORE];
    core.setVector(core.at.input, vector(point, 3, 'matterAt', 'point'));
    core.run('firma_world_matter_at', world[ID], core.at.input, core.at.out);
    return core.getU32(core.at.out);
}

export function matterOf(world, ref) {
    const core = world[CORE];
    if (ref === undefined || ref === null) throw badCall('matterOf', 'the face must be one of a hit, or of faces');
    const [face, corner] = putFaceRef(core, ref, 'matterOf');
    const out = core.at.out + 16; // behind the corner
    core.run('firma_world_matter_of', world[ID], face, corner, out);
    return core.getU32(out);
}

export function countMatters(world) {
    const core = world[CORE];
    const at = core.at.matterCounts;
    const each = core.batch();
    core.run('firma_world_count_matters', world[ID], each, MOST_MATTERS, at);
    const count = core.getCount(at + MATTER_COUNTS.matterCount);
    return {
        pieces: core.getCount(at + MATTER_COUNTS.pieces),
        protectedPieces: core.getCount(at + MATTER_COUNTS.protectedPieces),
        ofMatter: Array.from({ length: count }, (_, k) => core.getCount(each + 8 * k)),
        rest: core.getU32(at + MATTER_COUNTS.rest),
    };
}
