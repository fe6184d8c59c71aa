// SPDX-License-Identifier: MIT
// Loads a module that has worlds, and knows where its readers are, which are loaded when something is read.
import { object } from './arguments.js';
import { moduleOf, startCore } from './compile.js';
import { ReadersModule } from './readers_module.js';

/** What a module of worlds is for messages. @param name, has, load  of it, of a function of it, of what loads it */
export const kindOf = (name, has, load) => ({
    name,
    has,
    stopped: (why) => `the module stopped (${why}), perhaps out of memory, and cannot be used: load it anew with ${load}()`,
});

/** Where the readers are unless the caller says: beside a module of his, else where the package has them. */
function readersBeside(source) {
    const named = typeof Response === 'function' && source instanceof Response ? source.url : source;
    const parts = /^(|.*[/\\])firma(?:_games|_recordings)?\.wasm([?#].*)?$/.exec(
        typeof named === 'string' || named instanceof URL ? named : '',
    );
    return parts ? `${parts[1]}firma_readers.wasm${parts[2] ?? ''}` : new URL('./firma_readers.wasm', import.meta.url);
}

/** @param source, options as loadFirma() takes them; @param Library is made of a Core and a ReadersModule */
export async function loadLibrary(source, options, place, kind, Library) {
    const { readers } = object(options, place, 'the options', ['readers']);
    Promise.resolve(readers).catch(() => {}); // one that fails is reported when something is read
    source = await source;
    const core = await startCore(await moduleOf(source, place), place, kind);
    return new Library(core, new ReadersModule(readers ?? readersBeside(source)));
}
