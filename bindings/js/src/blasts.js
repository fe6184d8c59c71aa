// SPDX-License-Identifier: MIT
// Blasts: what they give at a distance and behind cover, how they push, and explosions.
import { doubles, longWord, mask, number, object, vector } from './arguments.js';
import { getReport, putCarveOptions, putPose } from './carving.js';
import { bodiesNamed } from './debris_named.js';
import { badCall } from './errors.js';
import { idOf } from './handle.js';
import { BLAST, CARVE_REPORT, EXPLODE_OPTIONS, EXPLOSION, PUSH_OPTIONS, PUSH_REPORT } from './layout.js';
import { putScene } from './scenes.js';
import { putMembers, structTable } from './structs.js';
import { World } from './world.js';

const { fresh, toFill } = structTable({
    blast: [BLAST, 'firma_blast_defaults'],
    explode: [EXPLODE_OPTIONS, 'firma_explode_options_defaults'],
    explosion: [EXPLOSION],
    push: [PUSH_OPTIONS, 'firma_push_options_defaults'],
    pushed: [PUSH_REPORT],
});

const BLAST_KINDS = { at: 'vector', radius: 'number', impulse: 'number' };
const PUSH_KINDS = { mask: 'mask', maxSpeed: 'number' };
const EXPLODE_KINDS = {
    maxBroken: 'word',
    maxPieces: 'word',
    maxSpheres: 'word',
    breakRadius: 'number',
    minVolume: 'number',
};
const EXPLODE_NAMES = [...Object.keys(EXPLODE_KINDS), ...Object.keys(PUSH_KINDS), 'seed', 'carve'];
const COUNTS = ['broken', 'unfit', 'dust', 'reached', 'pushed'];
const HERE = { position: [0, 0, 0] };

/** @returns the address of the struct */
export function putBlast(core, blast, place) {
    if (blast === undefined) throw badCall(place, 'the blast must be an object');
    const given = object(blast, place, 'the blast', Object.keys(BLAST_KINDS));
    const at = fresh(core, 'blast');
    putMembers(core, at, BLAST, BLAST_KINDS, given, place);
    return at;
}

export function blastShare(core, blast, distance) {
    const place = 'blastShare';
    const at = putBlast(core, blast, place);
    core.run('firma_blast_share', at, number(distance, place, 'distance'), core.at.out);
    return core.getF64(core.at.out);
}

export function blastImpulse(core, blast, point, area, seen = 1) {
    const place = 'blastImpulse';
    const at = putBlast(core, blast, place);
    for (const [name, value] of Object.entries({ area, seen })) number(value, place, name);
    core.setVector(core.at.input, vector(point, 3, place, 'point'));
    core.run('firma_blast_impulse', at, core.at.input, area, seen, core.at.input + 24);
    return core.getVector(core.at.input + 24);
}

export function exposure(core, scene, from, spheres, bits = ~0) {
    const place = 'exposure';
    const asked = putScene(core, scene, place);
    doubles(spheres, 4, place, 'the spheres');
    mask(bits, place);
    core.setVector(core.at.input, vector(from, 3, place, 'from'));
    return core.borrow((lent) => {
        const at = lent.doubles(spheres);
        core.run('firma_exposure_scene', asked, core.at.input, at, spheres.length / 4, bits, core.at.out);
        return core.getF64(core.at.out);
    });
}

export function pushBlast(core, scene, bodies, blast, options) {
    const place = 'pushBlast';
    const asked = putScene(core, scene, place);
    const all = idOf(bodies, core, place, 'list of bodies');
    const at = putBlast(core, blast, place);
    const chosen = fresh(core, 'push');
    const given = object(options, place, 'the options', Object.keys(PUSH_KINDS));
    putMembers(core, chosen, PUSH_OPTIONS, PUSH_KINDS, given, place);
    const report = toFill(core, 'pushed');
    core.run('firma_blast_push_scene', asked, all, at, chosen, report);
    return {
        reached: core.getCount(report + PUSH_REPORT.reached),
        pushed: core.getCount(report + PUSH_REPORT.pushed),
    };
}

/** @returns the address of the struct */
function putExplode(core, lent, options, place) {
    const given = object(options, place, 'the options', EXPLODE_NAMES);
    const at = fresh(core, 'explode');
    putMembers(core, at, EXPLODE_OPTIONS, EXPLODE_KINDS, given, place);
    putMembers(core, at + EXPLODE_OPTIONS.push, PUSH_OPTIONS, PUSH_KINDS, given, place);
    if (given.seed !== undefined) core.setU64(at + EXPLODE_OPTIONS.seed, longWord(given.seed, place, 'seed'));
    const carve = { chunks: true, ...object(given.carve, place, 'carve') };
    core.setU32(at + EXPLODE_OPTIONS.carve, putCarveOptions(core, lent, carve, place));
    return at;
}

/** With a crater, or null for none. @param debris  its handle */
export function explode(core, debris, bodies, scene, blast, crater, pose, options) {
    const place = 'explode';
    const all = idOf(bodies, core, place, 'list of bodies');
    const asked = putScene(core, scene, place);
    const cutter = crater === null ? 0n : idOf(crater, core, place, 'cutter');
    const at = putBlast(core, blast, place);
    const where = putPose(core, crater === null ? (pose ?? HERE) : pose, place);
    return core.borrow((lent) => {
        const chosen = putExplode(core, lent, options, place);
        const report = toFill(core, 'explosion');
        core.setU32(report + EXPLOSION.carve + CARVE_REPORT.size, CARVE_REPORT.sizeof);
        core.run('firma_explode_scene', asked, debris, all, at, cutter, where, chosen, core.at.out, report);
        const after = new World(core, core.u64[core.at.out >>> 3]);
        const carve = getReport(core, report + EXPLOSION.carve);
        const counts = COUNTS.map((name) => [name, core.getCount(report + EXPLOSION[name])]);
        const dustMass = core.getF64(report + EXPLOSION.dustMass);
        const [loose, pieces] = ['loose', 'pieces'].map((list) => bodiesNamed(core, debris, list));
        return { world: after, report: { carve, loose, pieces, ...Object.fromEntries(counts), dustMass } };
    });
}
