// SPDX-License-Identifier: MIT
// Projectiles among parts that move meanwhile, and by rules of a program's own.
import { SHOT_EVENT } from './layout.js';
import { flyIn, getEvent } from './projectiles.js';
import { putScene } from './scenes.js';
import { putRule } from './shot_rules.js';
import { orNull } from './structs.js';

/** An event with the part that was met. */
export function getPartEvent(core, at, lengths) {
    return {
        ...getEvent(core, at, lengths),
        part: orNull(core.getU32(at + SHOT_EVENT.part)),
        inPart: core.getVector(at + SHOT_EVENT.inPart),
    };
}

const RULE = { names: ['rule'], put: (core, at, { rule }, place) => putRule(core, at, rule, place) };

export function flyScene(core, projectiles, scene, seconds, options) {
    const place = 'flyScene';
    const where = putScene(core, scene, place);
    return flyIn(core, 'firma_fly_scene', where, projectiles, seconds, options, place, getPartEvent, RULE);
}
