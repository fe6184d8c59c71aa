// SPDX-License-Identifier: MIT
// Refuses to pack the package without its module, or with one that is not of the package's version.
import { existsSync, readFileSync } from 'node:fs';
import { loadFirma } from '../src/index.js';

const module = new URL('../src/firma.wasm', import.meta.url);
const { version } = JSON.parse(readFileSync(new URL('../package.json', import.meta.url)));

function refuse(reason) {
    console.error(`firma: not packed: ${reason}; tools/build_module.sh makes it`);
    process.exit(1);
}

if (!existsSync(module)) refuse('src/firma.wasm is not there');
const firma = await loadFirma(readFileSync(module)).catch((error) => refuse(error.message));
if (firma.version !== version) refuse(`src/firma.wasm is of version ${firma.version}, the package of ${version}`);
