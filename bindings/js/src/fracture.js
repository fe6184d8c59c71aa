// SPDX-License-Identifier: MIT
// Solids broken into pieces: patterns of cracks, and pieces of a world's solid.
import { longWord, object, vector, word } from './arguments.js';
import { Chunks } from './chunks.js';
import { badCall } from './errors.js';
import { idOf, makeHandle } from './handle.js';
import { CRACK_STYLE_NAMES, FRACTURE_OPTIONS, FRACTURE_PATTERN } from './layout.js';
import { getMembers, putMembers, structTable } from './structs.js';

const { fresh, toFill } = structTable({
    options: [FRACTURE_OPTIONS],
    pattern: [FRACTURE_PATTERN],
    told: [FRACTURE_PATTERN],
});

const PATTERN_KINDS = { sizeOfPiece: 'vector', growth: 'number', crooked: 'number' };
/** Members that a pattern may do without, null or left out, each with the one that says that it is there. */
const FOUND = { axes: ['quaternion', 'hasAxes'], brickCorner: ['vector', 'hasBrickCorner'] };
const PATTERN_NAMES = ['style', ...Object.keys(PATTERN_KINDS), ...Object.keys(FOUND)];
const OPTION_KINDS = { maxPieces: 'word', material: 'word', impact: 'vector', minVolume: 'number', density: 'number' };
const OPTION_NAMES = [...Object.keys(OPTION_KINDS), 'seed'];
/** Of a body its own density counts. */
export const SHATTER_NAMES = OPTION_NAMES.filter((name) => name !== 'density');

/** @returns the address of the struct */
export function putPattern(core, pattern, place) {
    if (pattern === undefined) throw badCall(place, 'the pattern must be an object');
    const given = object(pattern, place, 'the pattern', PATTERN_NAMES);
    const { style = CRACK_STYLE_NAMES[0] } = given;
    if (!CRACK_STYLE_NAMES.includes(style))
        throw badCall(place, `style must be one of ${CRACK_STYLE_NAMES.join(', ')}`);
    vector(given.sizeOfPiece, 3, place, 'sizeOfPiece');
    const at = fresh(core, 'pattern');
    core.setU32(at + FRACTURE_PATTERN.style, CRACK_STYLE_NAMES.indexOf(style));
    putMembers(core, at, FRACTURE_PATTERN, PATTERN_KINDS, given, place);
    for (const name in FOUND) {
        if (given[name] === undefined || given[name] === null) continue;
        const [kind, has] = FOUND[name];
        putMembers(core, at, FRACTURE_PATTERN, { [name]: kind }, given, place);
        core.setU32(at + FRACTURE_PATTERN[has], 1);
    }
    return at;
}

/** What is given, checked by the caller for its names. @returns the address of the struct */
export function putFracture(core, given, place) {
    const at = fresh(core, 'options');
    putMembers(core, at, FRACTURE_OPTIONS, OPTION_KINDS, given, place);
    if (given.impact !== undefined) core.setU32(at + FRACTURE_OPTIONS.hasImpact, 1);
    if (given.seed !== undefined) core.setU64(at + FRACTURE_OPTIONS.seed, longWord(given.seed, place, 'seed'));
    return at;
}

export function fracturePattern(core, world, matter) {
    const place = 'fracturePattern';
    const id = idOf(world, core, place, 'world');
    const at = toFill(core, 'told');
    core.run('firma_fracture_pattern_of', id, word(matter, place, 'the matter'), at);
    const pattern = {
        style: CRACK_STYLE_NAMES[core.getU32(at + FRACTURE_PATTERN.style)],
        ...getMembers(core, at, FRACTURE_PATTERN, PATTERN_KINDS),
    };
    for (const name in FOUND) {
        const [kind, has] = FOUND[name];
        const there = core.getU32(at + FRACTURE_PATTERN[has]) !== 0;
        pattern[name] = there ? getMembers(core, at, FRACTURE_PATTERN, { [name]: kind })[name] : null;
    }
    return pattern;
}

export function fracture(core, world, pattern, options) {
    const place = 'fracture';
    const id = idOf(world, core, place, 'world');
    const how = putPattern(core, pattern, place);
    const chosen = putFracture(core, object(options, place, 'the options', OPTION_NAMES), place);
    return new Chunks(core, makeHandle(core, 'firma_world_fracture', id, how, chosen));
}
