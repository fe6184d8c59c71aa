// SPDX-License-Identifier: MIT
// Debris: bodies that know their solids. They break, grow old, and become ground.
import { doubles, number, object, word } from './arguments.js';
import { explode } from './blasts.js';
import { putBodyId, putFit } from './bodies.js';
import { breakPart, carvePart } from './breakables.js';
import { Cutter, getPose } from './carving.js';
import { putDebrisRules } from './debris_rules.js';
import { bodiesNamed } from './debris_named.js';
import { putFracture, putPattern, SHATTER_NAMES } from './fracture.js';
import { CORE, Handle, ID, idOf, makeHandle } from './handle.js';
import { DEBRIS_PIECE, DEBRIS_REPORT, DEBRIS_RULES, SHATTER_OPTIONS, SHATTERED } from './layout.js';
import { getMembers, structTable } from './structs.js';
import { World } from './world.js';

const { fresh, toFill } = structTable({
    piece: [DEBRIS_PIECE],
    report: [DEBRIS_REPORT],
    rules: [DEBRIS_RULES, 'firma_debris_rules_defaults'],
    shatter: [SHATTER_OPTIONS],
    shattered: [SHATTERED],
});

const PIECE_KINDS = {
    matter: 'word',
    origin: 'vector',
    age: 'number',
    asleepFor: 'number',
    broken: 'word',
    neverGround: 'flag',
    ofPart: 'flag',
};
const SHATTERED_COUNTS = ['dust', 'cracks', 'refused'];
const SHATTERED_KINDS = { dustMass: 'number', dustMomentum: 'vector', dustAngularMomentum: 'vector' };

const countsAt = (core, at, fields, names) =>
    Object.fromEntries(names.map((name) => [name, core.getCount(at + fields[name])]));

export class Debris extends Handle {
    constructor(core, id) {
        super(core, id, 'firma_debris_release');
    }

    static create(core) {
        return new Debris(core, makeHandle(core, 'firma_debris_create'));
    }

    copy() {
        return new Debris(this[CORE], makeHandle(this[CORE], 'firma_debris_copy', this[ID]));
    }

    hash() {
        const core = this[CORE];
        core.run('firma_debris_hash', this[ID], core.at.out);
        return core.u64[core.at.out >>> 3];
    }

    addChunk(bodies, chunks, chunk, fit) {
        const core = this[CORE];
        const place = 'addChunk';
        const all = idOf(bodies, core, place, 'list of bodies');
        const loose = idOf(chunks, core, place, 'list of chunks');
        word(chunk, place, 'the chunk');
        return makeHandle(core, 'firma_debris_add_chunk', this[ID], all, loose, chunk, putFit(core, fit, place));
    }

    /** The handle of the bodies, and where the module finds a body's name. */
    #of(bodies, id, place) {
        const core = this[CORE];
        return [idOf(bodies, core, place, 'list of bodies'), putBodyId(core, id, place)];
    }

    get(bodies, id) {
        const core = this[CORE];
        const of = this.#of(bodies, id, 'get');
        const at = toFill(core, 'piece');
        core.run('firma_debris_get', this[ID], ...of, at);
        return {
            ...getMembers(core, at, DEBRIS_PIECE, PIECE_KINDS),
            faceCount: core.getCount(at + DEBRIS_PIECE.faceCount),
        };
    }

    world(bodies, id) {
        const core = this[CORE];
        return new World(core, makeHandle(core, 'firma_debris_world', this[ID], ...this.#of(bodies, id, 'world')));
    }

    remove(bodies, id) {
        this[CORE].run('firma_debris_remove', this[ID], ...this.#of(bodies, id, 'remove'));
    }

    shatter(bodies, id, pattern, options) {
        const core = this[CORE];
        const place = 'shatter';
        const given = object(options, place, 'the options', [...SHATTER_NAMES, 'maxSpheres', 'world']);
        const how = putPattern(core, pattern, place);
        const cracks = putFracture(core, given, place);
        const chosen = fresh(core, 'shatter');
        if (given.maxSpheres !== undefined)
            core.setU32(chosen + SHATTER_OPTIONS.maxSpheres, word(given.maxSpheres, place, 'maxSpheres'));
        if (given.world !== undefined)
            core.setU64(chosen + SHATTER_OPTIONS.world, idOf(given.world, core, place, 'world'));
        const report = toFill(core, 'shattered');
        core.run('firma_shatter', this[ID], ...this.#of(bodies, id, place), how, cracks, chosen, report);
        return {
            pieces: bodiesNamed(core, this[ID], 'pieces'),
            ...countsAt(core, report, SHATTERED, SHATTERED_COUNTS),
            ...getMembers(core, report, SHATTERED, SHATTERED_KINDS),
        };
    }

    tend(bodies, world, seconds, rules) {
        const core = this[CORE];
        const place = 'tend';
        const all = idOf(bodies, core, place, 'list of bodies');
        const level = idOf(world, core, place, 'world');
        number(seconds, place, 'seconds');
        return core.borrow((lent) => {
            const chosen = fresh(core, 'rules');
            const { keepClear } = putDebrisRules(core, chosen, rules, place, 'the rules', ['keepClear']);
            if (keepClear !== undefined) {
                doubles(keepClear, 4, place, 'keepClear');
                core.setU32(chosen + DEBRIS_RULES.keepClear, lent.doubles(keepClear));
                core.setU32(chosen + DEBRIS_RULES.keepClearCount, keepClear.length / 4);
            }
            const report = toFill(core, 'report');
            core.run('firma_debris_tend', this[ID], all, level, seconds, chosen, core.at.out, report);
            const after = new World(core, core.u64[core.at.out >>> 3]);
            const counts = countsAt(core, report, DEBRIS_REPORT, ['refused', 'waiting']);
            const removed = bodiesNamed(core, this[ID], 'removed');
            const toGround = bodiesNamed(core, this[ID], 'to_ground');
            return { world: after, report: { removed, toGround, ...counts } };
        });
    }

    fill(index) {
        const core = this[CORE];
        const { out, pose } = core.at;
        core.run('firma_debris_fill', this[ID], word(index, 'fill', 'the index'), out, pose, out + 8);
        return {
            cutter: new Cutter(core, core.u64[out >>> 3]),
            pose: getPose(core, pose),
            material: core.text(core.getU32(out + 8)),
        };
    }

    explode(bodies, scene, blast, crater, pose, options) {
        return explode(this[CORE], this[ID], bodies, scene, blast, crater, pose, options);
    }

    breakPart(bodies, parts, part, world, options) {
        return breakPart(this[CORE], this[ID], bodies, parts, part, world, options);
    }

    carvePart(bodies, parts, part, world, cutter, pose, options) {
        return carvePart(this[CORE], this[ID], bodies, parts, part, world, cutter, pose, options);
    }
}
