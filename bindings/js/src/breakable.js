// SPDX-License-Identifier: MIT
// What a part bears, as a level or a call gives it.
import { BREAKABLE } from './layout.js';
import { getMembers, orNull } from './structs.js';

export const BREAKABLE_KINDS = { health: 'number', whole: 'number', maxTaken: 'number', damage: 'number', broken: 'flag' };

export function getBreakable(core, at) {
    return {
        matter: orNull(core.getU32(at + BREAKABLE.matter)),
        ...getMembers(core, at, BREAKABLE, BREAKABLE_KINDS),
    };
}
