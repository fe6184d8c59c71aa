// SPDX-License-Identifier: MIT
// Levels of brushes: their entities, and worlds of them.
import { CORE, Handle, ID } from './handle.js';
import { BOX, ENTITY, LEVEL_VIEW, OMISSION } from './layout.js';

export class Level extends Handle {
    #make;

    /** @param make { world, parts }: each makes that of a level's handle and options */
    constructor(core, id, make) {
        super(core, id, 'firma_level_release');
        this.#make = make;
    }

    world(options) {
        return this.#make.world(this[ID], options);
    }

    parts(options) {
        return this.#make.parts(this[ID], options);
    }

    entities() {
        const core = this[CORE];
        const at = this.#view();
        const first = core.getU32(at + LEVEL_VIEW.entities);
        return Array.from({ length: core.getU32(at + LEVEL_VIEW.entityCount) }, (_, k) =>
            getEntity(core, first + k * ENTITY.sizeof),
        );
    }

    notes() {
        const core = this[CORE];
        const at = this.#view();
        return getTexts(core, core.getU32(at + LEVEL_VIEW.notes), core.getU32(at + LEVEL_VIEW.noteCount));
    }

    omissions() {
        const core = this[CORE];
        const at = this.#view();
        const first = core.getU32(at + LEVEL_VIEW.omissions);
        return Array.from({ length: core.getU32(at + LEVEL_VIEW.omissionCount) }, (_, k) => {
            const one = first + k * OMISSION.sizeof;
            return {
                what: core.text(core.getU32(one + OMISSION.what)),
                count: core.getCount(one + OMISSION.count),
                first: core.text(core.getU32(one + OMISSION.first)),
            };
        });
    }

    anchorVolumes() {
        const core = this[CORE];
        const at = this.#view();
        const first = core.getU32(at + LEVEL_VIEW.anchors);
        return Array.from({ length: core.getU32(at + LEVEL_VIEW.anchorCount) }, (_, k) => {
            const one = first + k * BOX.sizeof;
            return { low: core.getVector(one + BOX.low), high: core.getVector(one + BOX.high) };
        });
    }

    get metresPerUnit() {
        return this[CORE].getF64(this.#view() + LEVEL_VIEW.metresAUnit);
    }

    #view() {
        const core = this[CORE];
        core.run('firma_level_get_view', this[ID], core.at.levelView);
        return core.at.levelView;
    }
}

const getTexts = (core, at, count) => Array.from({ length: count }, (_, k) => core.text(core.getU32(at + 4 * k)));

function getEntity(core, at) {
    const count = core.getU32(at + ENTITY.keyCount);
    const names = getTexts(core, core.getU32(at + ENTITY.keys), count);
    const texts = getTexts(core, core.getU32(at + ENTITY.values), count);
    const values = new Map();
    names.forEach((name, k) => {
        if (!values.has(name)) values.set(name, texts[k]);
    });
    return {
        classname: core.text(core.getU32(at + ENTITY.classname)),
        keys: names.map((name, k) => [name, texts[k]]),
        values,
        origin: core.getU32(at + ENTITY.hasOrigin) !== 0 ? core.getVector(at + ENTITY.origin) : null,
        line: core.getU32(at + ENTITY.line),
    };
}
