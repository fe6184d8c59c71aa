// SPDX-License-Identifier: MIT
// Loads the module of worlds; that of the readers is loaded when something is read.
import { object } from './arguments.js';
import { moduleOf, startCore } from './compile.js';
import { Firma } from './firma.js';
import { ReadersModule } from './readers_module.js';

const PLACE = 'loadFirma';
const KIND = {
    name: "Firma's module",
    has: 'firma_carve',
    stopped: (why) => `the module stopped (${why}), perhaps out of memory, and cannot be used: load it anew with loadFirma()`,
};

/** Where the readers are unless the caller says: beside a firma.wasm of his, else where the package has them. */
function readersBeside(source) {
    const named = typeof Response === 'function' && source instanceof Response ? source.url : source;
    const parts = /^(|.*[/\\])firma\.wasm([?#].*)?$/.exec(typeof named === 'string' || named instanceof URL ? named : '');
    return parts ? `${parts[1]}firma_readers.wasm${parts[2] ?? ''}` : new URL('./firma_readers.wasm', import.meta.url);
}

export async function loadFirma(source = new URL('./firma.wasm', import.meta.url), options = undefined) {
    const { readers } = object(options, PLACE, 'the options', ['readers']);
    Promise.resolve(readers).catch(() => {}); // one that fails is reported when something is read
    source = await source;
    const core = await startCore(await moduleOf(source, PLACE), PLACE, KIND);
    return new Firma(core, new ReadersModule(readers ?? readersBeside(source)));
}
