// SPDX-License-Identifier: MIT
// Parts that break: what they bear, broken at once, or carved until they do.
import { flag, longWord, number, object, word, words } from './arguments.js';
import { putBlast } from './blasts.js';
import { BREAKABLE_KINDS, getBreakable } from './breakable.js';
import { putCarveOptions, putPose } from './carving.js';
import { bodiesNamed } from './debris_named.js';
import { badCall } from './errors.js';
import { idOf, makeHandle } from './handle.js';
import { BREAK_OPTIONS, BREAK_REPORT, BREAKABLE, CARVE_STATUS_NAMES, PART_CUT, PART_CUT_OPTIONS } from './layout.js';
import { getMembers, orNone, orNull, putMembers, structTable } from './structs.js';
import { World } from './world.js';

const { fresh, toFill } = structTable({
    breakable: [BREAKABLE],
    cut: [PART_CUT],
    cutOptions: [PART_CUT_OPTIONS, 'firma_part_cut_options_defaults'],
    options: [BREAK_OPTIONS, 'firma_break_options_defaults'],
    report: [BREAK_REPORT],
});

const BREAKABLE_NAMES = ['matter', ...Object.keys(BREAKABLE_KINDS)];
const BREAK_KINDS = {
    maxPieces: 'word',
    maxSpheres: 'word',
    unbroken: 'flag',
    impact: 'vector',
    fraction: 'number',
    seconds: 'number',
    minVolume: 'number',
};
const BREAK_NAMES = [...Object.keys(BREAK_KINDS), 'seed', 'portals'];
const CUT_NAMES = ['breakable', 'holdLargest', 'touch', 'carve', 'pieces'];

/** All its members have to be given. @returns the address of the struct */
function putBreakable(core, breakable, place) {
    if (breakable === undefined) throw badCall(place, 'the breakable must be an object');
    const given = object(breakable, place, 'the breakable', BREAKABLE_NAMES);
    for (const name of BREAKABLE_NAMES)
        if (given[name] === undefined) throw badCall(place, `the breakable has no ${name}`);
    const at = fresh(core, 'breakable');
    core.setU32(at + BREAKABLE.matter, orNone(given.matter, place, 'matter'));
    putMembers(core, at, BREAKABLE, BREAKABLE_KINDS, given, place);
    return at;
}

/** To an address that holds the defaults. */
function putBreakAt(core, lent, at, given, place) {
    putMembers(core, at, BREAK_OPTIONS, BREAK_KINDS, given, place);
    if (given.impact !== undefined) core.setU32(at + BREAK_OPTIONS.hasImpact, 1);
    if (given.seed !== undefined) core.setU64(at + BREAK_OPTIONS.seed, longWord(given.seed, place, 'seed'));
    if (given.portals === undefined) return;
    words(given.portals, undefined, place, 'the portals');
    core.setU32(at + BREAK_OPTIONS.portals, lent.words(given.portals));
    core.setU32(at + BREAK_OPTIONS.portalCount, given.portals.length);
}

function getBroken(core, at) {
    return {
        unfit: core.getCount(at + BREAK_REPORT.unfit),
        dust: core.getCount(at + BREAK_REPORT.dust),
        dustMass: core.getF64(at + BREAK_REPORT.dustMass),
        opened: core.getCount(at + BREAK_REPORT.opened),
    };
}

/** The handle of the parts and the number of one. */
function partOf(core, parts, part, place) {
    return [idOf(parts, core, place, 'list of parts'), word(part, place, 'the part')];
}

export function partWorld(core, parts, part) {
    return new World(core, makeHandle(core, 'firma_parts_world', ...partOf(core, parts, part, 'partWorld')));
}

export function partPortals(core, parts, part, world) {
    const of = partOf(core, parts, part, 'partPortals');
    const level = idOf(world, core, 'partPortals', 'world');
    core.run('firma_parts_portals', ...of, level, 0, 0, core.at.out);
    const count = core.getU32(core.at.out);
    return core.borrow((lent) => {
        const at = lent.take(4 * count);
        core.run('firma_parts_portals', ...of, level, at, count, core.at.out);
        return Array.from(core.u32.subarray(at >>> 2, (at >>> 2) + count));
    });
}

export function breakable(core, parts, part) {
    const of = partOf(core, parts, part, 'breakable');
    const at = toFill(core, 'breakable');
    core.run('firma_parts_breakable', ...of, at);
    return getBreakable(core, at);
}

export function hurt(core, bears, damage) {
    const at = putBreakable(core, bears, 'hurt');
    core.run('firma_breakable_hurt', at, number(damage, 'hurt', 'damage'), core.at.out);
    return { breakable: getBreakable(core, at), breaks: core.getU32(core.at.out) !== 0 };
}

export function blastFelt(core, parts, part, world, blast, fraction = 0) {
    const place = 'blastFelt';
    const of = partOf(core, parts, part, place);
    const level = idOf(world, core, place, 'world');
    number(fraction, place, 'fraction');
    core.run('firma_parts_blast_felt', ...of, level, putBlast(core, blast, place), fraction, core.at.out);
    return core.getF64(core.at.out);
}

/** @param debris  its handle */
export function breakPart(core, debris, bodies, parts, part, world, options) {
    const place = 'breakPart';
    const all = idOf(bodies, core, place, 'list of bodies');
    const of = partOf(core, parts, part, place);
    const level = idOf(world, core, place, 'world');
    const given = object(options, place, 'the options', ['breakable', ...BREAK_NAMES]);
    const bears = given.breakable === undefined ? 0 : putBreakable(core, given.breakable, place);
    return core.borrow((lent) => {
        const chosen = fresh(core, 'options');
        putBreakAt(core, lent, chosen, given, place);
        const report = toFill(core, 'report');
        core.run('firma_parts_break', ...of, level, bears, debris, all, chosen, core.at.out, report);
        return {
            world: new World(core, core.u64[core.at.out >>> 3]),
            breakable: bears === 0 ? null : getBreakable(core, bears),
            report: { ...getBroken(core, report), pieces: bodiesNamed(core, debris, 'pieces') },
        };
    });
}

/** @returns the address of the struct */
function putCut(core, lent, given, place) {
    const at = fresh(core, 'cutOptions');
    core.setU32(at + PART_CUT_OPTIONS.holdLargest, flag(given.holdLargest, place, 'holdLargest'));
    if (given.touch !== undefined) core.setF64(at + PART_CUT_OPTIONS.touch, number(given.touch, place, 'touch'));
    if (given.carve !== undefined)
        core.setU32(at + PART_CUT_OPTIONS.carve, putCarveOptions(core, lent, given.carve, place));
    const pieces = object(given.pieces, place, 'pieces', BREAK_NAMES);
    putBreakAt(core, lent, at + PART_CUT_OPTIONS.pieces, pieces, place);
    return at;
}

/** @param debris  its handle */
export function carvePart(core, debris, bodies, parts, part, world, cutter, pose, options) {
    const place = 'carvePart';
    const all = idOf(bodies, core, place, 'list of bodies');
    const of = partOf(core, parts, part, place);
    const level = idOf(world, core, place, 'world');
    const tool = idOf(cutter, core, place, 'cutter');
    const given = object(options, place, 'the options', CUT_NAMES);
    const bears = given.breakable === undefined ? 0 : putBreakable(core, given.breakable, place);
    const where = putPose(core, pose, place);
    return core.borrow((lent) => {
        const chosen = putCut(core, lent, given, place);
        const report = toFill(core, 'cut');
        core.setU32(report + PART_CUT.rest + BREAK_REPORT.size, BREAK_REPORT.sizeof);
        core.run('firma_parts_carve', ...of, level, bears, tool, where, debris, all, chosen, core.at.out, report);
        const after = new World(core, core.u64[core.at.out >>> 3]);
        const status = CARVE_STATUS_NAMES[core.getU32(report + PART_CUT.status)];
        const reason = status === 'refused' ? core.message() : '';
        const broke = core.getU32(report + PART_CUT.broke) !== 0;
        const told = {
            status,
            reason,
            unfit: core.getCount(report + PART_CUT.unfit),
            volume: core.getF64(report + PART_CUT.volume),
            opened: core.getCount(report + PART_CUT.opened),
            rest: broke ? getBroken(core, report + PART_CUT.rest) : null,
        };
        told.loose = bodiesNamed(core, debris, 'loose');
        if (broke) told.rest.pieces = bodiesNamed(core, debris, 'pieces');
        return { world: after, breakable: bears === 0 ? null : getBreakable(core, bears), report: told };
    });
}
