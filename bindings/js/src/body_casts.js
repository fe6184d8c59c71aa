// SPDX-License-Identifier: MIT
// Casts at bodies: where these are, kept in an index, and what is met of them.
import { mask, number, object } from './arguments.js';
import { getBodyId, putBodyIdAt } from './bodies.js';
import { CORE, Handle, ID, idOf, makeHandle } from './handle.js';
import { putInput } from './hits.js';
import { BODY_CAST_OPTIONS, BODY_HIT, STATUS_NAMES } from './layout.js';
import { putSet } from './sphere_sets.js';
import { orNull, structTable } from './structs.js';

const { fresh, toFill } = structTable({
    hit: [BODY_HIT],
    options: [BODY_CAST_OPTIONS, 'firma_body_cast_options_defaults'],
});

/** @returns the address of the struct */
function putOptions(core, options, place) {
    const { mask: bits, except, contactOffset } = object(options, place, 'the options', ['mask', 'except', 'contactOffset']);
    const at = fresh(core, 'options');
    if (bits !== undefined) core.setU32(at + BODY_CAST_OPTIONS.mask, mask(bits, place));
    if (except !== undefined && except !== null) putBodyIdAt(core, at + BODY_CAST_OPTIONS.except, except, place);
    if (contactOffset !== undefined) core.setF64(at + BODY_CAST_OPTIONS.contactOffset, number(contactOffset, place, 'contactOffset'));
    return at;
}

function getBodyHit(core, at) {
    const status = STATUS_NAMES[core.getU32(at + BODY_HIT.status)];
    return {
        status,
        hit: status === 'hit' || status === 'touching',
        fraction: core.getF64(at + BODY_HIT.fraction),
        safeFraction: core.getF64(at + BODY_HIT.safeFraction),
        centre: core.getVector(at + BODY_HIT.centre),
        point: core.getVector(at + BODY_HIT.point),
        normal: core.getVector(at + BODY_HIT.normal),
        surfaceVelocity: core.getVector(at + BODY_HIT.surfaceVelocity),
        body: getBodyId(core, at + BODY_HIT.body),
        bodySphere: orNull(core.getU32(at + BODY_HIT.bodySphere)),
        sphere: orNull(core.getU32(at + BODY_HIT.sphere)),
    };
}

export class BodyIndex extends Handle {
    constructor(core, id) {
        super(core, id, 'firma_body_index_release');
    }

    static create(core, bodies, seconds) {
        const id = idOf(bodies, core, 'bodyIndex', 'list of bodies');
        return new BodyIndex(core, makeHandle(core, 'firma_body_index_create', id, number(seconds, 'bodyIndex', 'seconds')));
    }

    cast(input, options) {
        const core = this[CORE];
        const asked = putInput(core, input, 'cast');
        const chosen = putOptions(core, options, 'cast');
        const at = toFill(core, 'hit');
        core.run('firma_body_index_cast', this[ID], asked, chosen, at);
        return getBodyHit(core, at);
    }

    castSet(spheres, motion, options) {
        const core = this[CORE];
        return core.borrow((lent) => {
            const set = putSet(core, lent, spheres, motion, 'castSet');
            const chosen = putOptions(core, options, 'castSet');
            const at = toFill(core, 'hit');
            core.run('firma_body_index_cast_set', this[ID], ...set, chosen, at);
            return getBodyHit(core, at);
        });
    }
}
