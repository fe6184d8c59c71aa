// SPDX-License-Identifier: MIT
// The module that makes levels and worlds of files: fetched and compiled once, the first time it is needed.
import { moduleOf, startCore } from './compile.js';
import { FirmaError } from './errors.js';

/** An instance that a large file has made larger than this is not kept: memory of a module never shrinks. */
const KEPT_BYTES = 64 << 20;

const KIND = {
    name: "Firma's module of readers",
    has: 'firma_world_from_map',
    stopped: (why) => `the module of readers stopped (${why}), perhaps out of memory: loadReaders() starts another`,
};

const usable = (core) => core !== null && !core.stopped;

export class ReadersModule {
    #source;
    #module = null;
    /** The instance in use, of those that were started. */
    #core = null;
    /** All that may hold levels. */
    #started = new Set();

    /** @param source as loadFirma() takes it */
    constructor(source) {
        this.#source = source;
    }

    /** An instance, the one of before where it can still be used. @throws {FirmaError} as loadFirma() */
    async core(place) {
        if (usable(this.#core)) return this.#core;
        const module = await this.#compiled(place);
        if (usable(this.#core)) return this.#core; // of another call that waited too
        const core = await startCore(module, place, KIND);
        if (usable(this.#core)) return this.#core;
        this.#started.add(new WeakRef(core));
        this.#core = core;
        return core;
    }

    /** What a request gives; what it was given may be changed meanwhile. */
    async run(request, core, place) {
        request.keep();
        const readers = await this.core(place);
        try {
            return request.run(readers, core);
        } finally {
            if (this.#core === readers && readers.memory.buffer.byteLength > KEPT_BYTES) this.#core = null;
        }
    }

    /** Levels that are not released yet. */
    liveHandles() {
        let count = 0;
        for (const one of this.#started) {
            const core = one.deref();
            if (usable(core ?? null)) count += core.call('firma_live_handles') >>> 0;
            else this.#started.delete(one);
        }
        return count;
    }

    #compiled(place) {
        this.#module ??= this.#compile(place).catch((error) => {
            this.#module = null; // it may be there the next time
            throw error;
        });
        return this.#module;
    }

    async #compile(place) {
        const source = await this.#source;
        try {
            return await moduleOf(source, place);
        } catch (error) {
            if (!(error instanceof FirmaError) || !(typeof source === 'string' || source instanceof URL)) throw error;
            const where = `the module of readers was looked for at ${source}; loadFirma(source, { readers }) says where else it is`;
            throw new FirmaError(error.code, `${error.message} (${where})`, { cause: error });
        }
    }
}
