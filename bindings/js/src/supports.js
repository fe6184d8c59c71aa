// SPDX-License-Identifier: MIT
// What faces hold, and what an edit took of it.
import { mask, object, vector, word } from './arguments.js';
import { badCall } from './errors.js';
import { CORE, Handle, ID, idOf, makeHandle } from './handle.js';
import { SUPPORT, SUPPORT_CHANGE, SUPPORT_KIND_NAMES, SUPPORT_LOSS_NAMES, SUPPORTED } from './layout.js';
import { getMembers, putMembers, structTable } from './structs.js';

const { toFill } = structTable({ support: [SUPPORT] });

const KINDS = { entity: 'word', reach: 'number' };
const NAMES = [...Object.keys(KINDS), 'kind', 'low', 'high', 'mask'];

function putThing(core, at, thing, place, number) {
    const what = `thing ${number}`;
    if (thing === undefined) throw badCall(place, `${what} must be an object`);
    const given = object(thing, place, what, NAMES);
    const { entity = number, kind = SUPPORT_KIND_NAMES[0] } = given;
    if (!SUPPORT_KIND_NAMES.includes(kind))
        throw badCall(place, `${what}: kind must be one of ${SUPPORT_KIND_NAMES.join(', ')}`);
    core.u8.fill(0, at, at + SUPPORTED.sizeof);
    putMembers(core, at, SUPPORTED, KINDS, { ...given, entity }, `${place}: ${what}`);
    core.setU32(at + SUPPORTED.kind, SUPPORT_KIND_NAMES.indexOf(kind));
    for (const name of ['low', 'high'])
        core.setVector(at + SUPPORTED[name], vector(given[name], 3, `${place}: ${what}`, name));
    if (given.mask !== undefined) core.setU32(at + SUPPORTED.mask, mask(given.mask, `${place}: ${what}`));
}

function getChange(core, at) {
    return {
        thing: core.getU32(at + SUPPORT_CHANGE.thing),
        entity: core.getU32(at + SUPPORT_CHANGE.entity),
        loss: SUPPORT_LOSS_NAMES[core.getU32(at + SUPPORT_CHANGE.loss)],
        buried: core.getU32(at + SUPPORT_CHANGE.buried) !== 0,
        lost: core.getCount(at + SUPPORT_CHANGE.lost),
        before: core.getF64(at + SUPPORT_CHANGE.before),
        after: core.getF64(at + SUPPORT_CHANGE.after),
    };
}

export class Supports extends Handle {
    constructor(core, id) {
        super(core, id, 'firma_supports_release');
    }

    static find(core, world, things) {
        const place = 'findSupports';
        const id = idOf(world, core, place, 'world');
        if (!Array.isArray(things)) throw badCall(place, 'the things must be an array');
        return core.borrow((lent) => {
            const at = lent.take(things.length * SUPPORTED.sizeof);
            things.forEach((thing, k) => putThing(core, at + k * SUPPORTED.sizeof, thing, place, k));
            return new Supports(core, makeHandle(core, 'firma_supports_find', id, at, things.length));
        });
    }

    count() {
        const core = this[CORE];
        core.run('firma_supports_get_count', this[ID], core.at.out);
        return core.getU32(core.at.out);
    }

    get(thing) {
        const core = this[CORE];
        const at = toFill(core, 'support');
        core.run('firma_supports_get', this[ID], word(thing, 'get', 'the thing'), at);
        return {
            ...getMembers(core, at, SUPPORT, { entity: 'word', area: 'number', lowered: 'number' }),
            kind: SUPPORT_KIND_NAMES[core.getU32(at + SUPPORT.kind)],
            faceCount: core.getCount(at + SUPPORT.faceCount),
        };
    }

    faces(thing) {
        const core = this[CORE];
        const count = this.get(thing).faceCount;
        return core.borrow((lent) => {
            const [faces, areas] = [lent.take(4 * count), lent.take(8 * count)];
            core.run('firma_supports_faces', this[ID], thing, faces, areas, count, core.at.out);
            return Array.from({ length: count }, (_, k) => ({
                face: core.getU32(faces + 4 * k),
                area: core.getF64(areas + 8 * k),
            }));
        });
    }

    diff(world, was) {
        const core = this[CORE];
        const now = idOf(world, core, 'diff', 'world');
        const old = was === undefined ? 0n : idOf(was, core, 'diff', 'world');
        const capacity = this.count();
        return core.borrow((lent) => {
            const changes = lent.take(capacity * SUPPORT_CHANGE.sizeof);
            const { out } = core.at;
            core.run('firma_supports_diff', this[ID], old, now, changes, capacity, out + 8, out);
            return {
                changes: Array.from({ length: core.getU32(out + 8) }, (_, k) =>
                    getChange(core, changes + k * SUPPORT_CHANGE.sizeof),
                ),
                after: new Supports(core, core.u64[out >>> 3]),
            };
        });
    }
}
