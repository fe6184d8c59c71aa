// SPDX-License-Identifier: MIT
// Structs of which a call of games needs one: they lie at fixed places of the module, and begin as by default.
import * as layout from './layout.js';
import { flag, mask, number, vector, word } from './arguments.js';

/** By name: the layout, and the function that sets the defaults; without one all is zero but for the size. */
const STRUCTS = {
    body: [layout.BODY],
    fitOptions: [layout.FIT_OPTIONS],
    flyOptions: [layout.FLY_OPTIONS, 'firma_fly_options_defaults'],
    flyReport: [layout.FLY_REPORT],
    part: [layout.PART, 'firma_part_defaults'],
    partHit: [layout.PART_HIT],
    partNear: [layout.PART_NEAR],
    player: [layout.PLAYER, 'firma_player_defaults'],
    playerMove: [layout.PLAYER_MOVE],
    playerRules: [layout.PLAYER_RULES, 'firma_player_rules_defaults'],
    playerSize: [layout.PLAYER_SIZE, 'firma_player_size_defaults'],
    playerWish: [layout.PLAYER_WISH],
    scene: [layout.SCENE, 'firma_scene_defaults'],
    shotView: [layout.SHOT_VIEW],
    stepOptions: [layout.STEP_OPTIONS, 'firma_step_options_defaults'],
    stepReport: [layout.STEP_REPORT],
};

function place(core, structs) {
    const all = {};
    for (const [name, [{ sizeof, size }, setDefaults]] of Object.entries(structs)) {
        const at = core.take(sizeof);
        core.u8.fill(0, at, at + sizeof);
        if (size !== undefined) core.setU32(at + size, sizeof);
        if (setDefaults !== undefined) core.call(setDefaults, at);
        all[name] = { at, bytes: core.u8.slice(at, at + sizeof) };
    }
    return all;
}

/** Of such structs, which are placed when the first of them is needed: fresh() and toFill(). */
export function structTable(structs) {
    /** Of each instance of the module: by name the address, and the bytes to begin with. */
    const placed = new WeakMap();
    const find = (core, name) => {
        let all = placed.get(core);
        if (all === undefined) placed.set(core, (all = place(core, structs)));
        return all[name];
    };
    return {
        /** The address of a struct that is as by default. */
        fresh: (core, name) => {
            const { at, bytes } = find(core, name);
            core.u8.set(bytes, at);
            return at;
        },
        /** The address of a struct that a call fills; its size is set. */
        toFill: (core, name) => find(core, name).at,
    };
}

export const { fresh, toFill } = structTable(STRUCTS);

/** How a member is checked and put: by its kind. */
const PUT = {
    number: (core, at, value, where, name) => core.setF64(at, number(value, where, name)),
    word: (core, at, value, where, name) => core.setU32(at, word(value, where, name)),
    mask: (core, at, value, where, name) => core.setU32(at, mask(value, where, name)),
    flag: (core, at, value, where, name) => core.setU32(at, flag(value, where, name)),
    vector: (core, at, value, where, name) => core.setVector(at, vector(value, 3, where, name)),
    quaternion: (core, at, value, where, name) => core.setVector(at, vector(value, 4, where, name)),
};

/** Puts the members that are given; what is not stays. @param kinds  of each member, by its name, one of PUT */
export function putMembers(core, at, fields, kinds, given, where) {
    for (const name in kinds)
        if (given[name] !== undefined) PUT[kinds[name]](core, at + fields[name], given[name], where, name);
}

/** What a struct holds, member by member. @param kinds  as of putMembers() */
const GET = {
    number: (core, at) => core.getF64(at),
    word: (core, at) => core.getU32(at),
    mask: (core, at) => core.getU32(at),
    flag: (core, at) => core.getU32(at) !== 0,
    vector: (core, at) => core.getVector(at),
    quaternion: (core, at) => Array.from(core.f64.subarray(at >>> 3, (at >>> 3) + 4)),
};

export function getMembers(core, at, fields, kinds, out = {}) {
    for (const name in kinds) out[name] = GET[kinds[name]](core, at + fields[name]);
    return out;
}

const NONE = 0xffffffff;
/** A number of a part, room or portal; null where there is none. */
export const orNull = (id) => (id === NONE ? null : id);
/** The other way. */
export const orNone = (id, where, what) => (id === null ? NONE : word(id, where, what));
