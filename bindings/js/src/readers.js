// SPDX-License-Identifier: MIT
// What `import ... from 'firma/readers'` gives: files are read at once, as the module of readers is loaded ahead.
import { badCall } from './errors.js';
import { Firma, READERS } from './firma.js';
import { REQUESTS } from './reading.js';

class Readers {
    #core;
    #readers;

    /** @param core of the worlds; @param readers an instance of the module of readers */
    constructor(core, readers) {
        this.#core = core;
        this.#readers = readers;
    }

    get version() {
        return this.#readers.version();
    }

    #read(name, ...args) {
        return REQUESTS[name](...args).run(this.#readers, this.#core);
    }

    worldFromObj(data, options) {
        return this.#read('worldFromObj', data, options);
    }

    worldFromBsp(data, options) {
        return this.#read('worldFromBsp', data, options);
    }

    worldFromMap(data, options) {
        return this.#read('worldFromMap', data, options);
    }

    levelFromMap(data, options) {
        return this.#read('levelFromMap', data, options);
    }

    levelFromBsp(data, options) {
        return this.#read('levelFromBsp', data, options);
    }

    cutterFromObj(data, name) {
        return this.#read('cutterFromObj', data, name);
    }

    readMatters(data, name) {
        return this.#read('readMatters', data, name);
    }
}

export async function loadReaders(firma) {
    const place = 'loadReaders';
    if (!(firma instanceof Firma)) throw badCall(place, 'the argument must be what loadFirma() gave');
    const { core, module } = firma[READERS];
    return new Readers(core, await module.core(place));
}
