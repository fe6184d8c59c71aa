// SPDX-License-Identifier: MIT
// Objects that hold a handle of the module. The module knows released handles, so it is asked with them all the same.
import { FirmaError } from './errors.js';

/** The instance of the module that an object belongs to, and its number there. */
export const CORE = Symbol('core');
export const ID = Symbol('id');

/** Releases what was forgotten, some time after nobody can reach it any more. */
const forgotten = new FinalizationRegistry(({ core, release, id }) => {
    try {
        if (!core.stopped) core.call(release, id);
    } catch {
        // A trap: the next call of the program will tell.
    }
});

export class Handle {
    #release;
    #released = false;

    /** @param release the C function that releases it */
    constructor(core, id, release) {
        Object.defineProperty(this, CORE, { value: core });
        Object.defineProperty(this, ID, { value: id });
        this.#release = release;
        forgotten.register(this, { core, release, id }, this);
    }

    get released() {
        return this.#released;
    }

    release() {
        const core = this[CORE];
        if (!core.stopped) core.run(this.#release, this[ID]); // else everything went with the module
        this.#released = true;
        forgotten.unregister(this);
    }
}

/** For `using`: nothing when it was released already. */
if (Symbol.dispose)
    Object.defineProperty(Handle.prototype, Symbol.dispose, {
        value() {
            if (!this.released) this.release();
        },
    });

/** The handle of `object`, to be used with `core`. @throws {FirmaError} BAD_HANDLE */
export function idOf(object, core, place, what) {
    if (!(object instanceof Handle)) throw new FirmaError('BAD_HANDLE', `${place}: not a ${what}`);
    if (object[CORE] !== core) throw new FirmaError('BAD_HANDLE', `${place}: the ${what} is of another module`);
    return object[ID];
}

/** The bytes of a handle of some, copied; releases it. */
export function takeBytes(core, handle) {
    try {
        core.run('firma_bytes_get_view', handle, core.at.out, core.at.out + 4);
        const start = core.getU32(core.at.out);
        return core.u8.slice(start, start + core.getU32(core.at.out + 4));
    } finally {
        core.call('firma_bytes_release', handle);
    }
}

/** Calls a function whose last argument is where it puts a handle; returns that. */
export function makeHandle(core, name, ...args) {
    core.run(name, ...args, core.at.out);
    return core.u64[core.at.out >>> 3];
}
