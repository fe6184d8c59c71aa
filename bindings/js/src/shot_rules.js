// SPDX-License-Identifier: MIT
// Rules of a program's own: what a matter does to a projectile in an impact, asked while they fly.
import { badCall } from './errors.js';
import { getBodyId } from './bodies.js';
import { noFace } from './hits.js';
import { FLY_OPTIONS, SHOT_IMPACT, SHOT_TERMS } from './layout.js';
import { putTerms, TERM_KINDS } from './projectiles.js';
import { getMembers, orNull } from './structs.js';

function getImpact(core, at) {
    const three = (name) => core.getVector(at + SHOT_IMPACT[name]);
    const corner = (at + SHOT_IMPACT.corner) >>> 2;
    return {
        point: three('point'),
        normal: three('normal'),
        velocity: three('velocity'),
        surface: three('surface'),
        mass: core.getF64(at + SHOT_IMPACT.mass),
        projectile: core.getU32(at + SHOT_IMPACT.projectile),
        face: noFace(core.getU32(at + SHOT_IMPACT.face)),
        corner: Array.from(core.i32.subarray(corner, corner + 3)),
        portal: orNull(core.getU32(at + SHOT_IMPACT.portal)),
        body: getBodyId(core, at + SHOT_IMPACT.body),
        material: core.getU32(at + SHOT_IMPACT.material),
        pane: core.getU32(at + SHOT_IMPACT.pane) !== 0,
        part: orNull(core.getU32(at + SHOT_IMPACT.part)),
    };
}

/**
 * Puts the rule, if there is one, into the options at an address.
 * @returns a visitor that asks it: of the struct that bindings/wasm/runtime.cpp shows, an impact, the terms, the matter
 */
export function putRule(core, at, rule, place) {
    if (rule === undefined) return undefined;
    if (typeof rule !== 'function') throw badCall(place, 'the rule must be a function');
    core.setU32(at + FLY_OPTIONS.rule, core.call('firma_wasm_shot_rule'));
    return (shown) => {
        const [impact, terms, matter] = [0, 4, 8].map((offset) => core.getU32(shown + offset));
        const usual = getMembers(core, terms, SHOT_TERMS, TERM_KINDS);
        putTerms(core, terms, rule(getImpact(core, impact), matter, usual), place, 'what the rule gives');
        return 0;
    };
}
