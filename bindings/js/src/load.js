// SPDX-License-Identifier: MIT
// Loads the module of worlds.
import { Firma } from './firma.js';
import { kindOf, loadLibrary } from './load_library.js';

const PLACE = 'loadFirma';
const KIND = kindOf("Firma's module", 'firma_carve', PLACE);

export async function loadFirma(source = new URL('./firma.wasm', import.meta.url), options = undefined) {
    return loadLibrary(source, options, PLACE, KIND, Firma);
}
