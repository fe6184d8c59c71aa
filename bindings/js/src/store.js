// SPDX-License-Identifier: MIT
// Histories of worlds, for undo.
import { CORE, Handle, ID, idOf, makeHandle } from './handle.js';
import { STORE_FACTS } from './layout.js';
import { longWord } from './arguments.js';
import { World } from './world.js';

export class Store extends Handle {
    constructor(core, id) {
        super(core, id, 'firma_store_release');
    }

    static open(core, world, maxBytes) {
        const first = idOf(world, core, 'openStore', 'world');
        const most = maxBytes === Infinity ? 2n ** 64n - 1n : longWord(maxBytes, 'openStore', 'maxBytes');
        return new Store(core, makeHandle(core, 'firma_store_open', first, most));
    }

    #world(name, ...args) {
        const core = this[CORE];
        return new World(core, makeHandle(core, name, this[ID], ...args));
    }

    current() {
        return this.#world('firma_store_current');
    }

    publish(before, after) {
        const core = this[CORE];
        const from = idOf(before, core, 'publish', 'world');
        core.run('firma_store_publish', this[ID], from, idOf(after, core, 'publish', 'world'));
    }

    undo() {
        return this.#world('firma_store_undo');
    }

    redo() {
        return this.#world('firma_store_redo');
    }

    at(version) {
        return this.#world('firma_store_at', longWord(version, 'at', 'the version'));
    }

    facts() {
        const core = this[CORE];
        const at = core.at.storeFacts;
        core.run('firma_store_get_facts', this[ID], at);
        const facts = {};
        for (const name of ['oldest', 'current', 'newest', 'versions', 'bytes', 'waiting'])
            facts[name] = core.getCount(at + STORE_FACTS[name]);
        return facts;
    }

    collect() {
        const core = this[CORE];
        core.run('firma_store_collect', this[ID], core.at.out);
        return core.getCount(core.at.out);
    }
}
