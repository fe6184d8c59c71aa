// SPDX-License-Identifier: MIT
// Refuses to pack the package without its modules, or with some that are not of the package's version.
import { existsSync, readFileSync } from 'node:fs';
import { loadGames } from '../src/games.js';
import { loadFirma } from '../src/index.js';
import { loadReaders } from '../src/readers.js';
import { loadRecordings } from '../src/recordings.js';

const { version } = JSON.parse(readFileSync(new URL('../package.json', import.meta.url)));

function refuse(reason) {
    console.error(`firma: not packed: ${reason}; tools/build_module.sh makes it`);
    process.exit(1);
}

for (const name of ['firma.wasm', 'firma_games.wasm', 'firma_recordings.wasm', 'firma_readers.wasm'])
    if (!existsSync(new URL(`../src/${name}`, import.meta.url))) refuse(`src/${name} is not there`);
const firma = await loadFirma().catch((error) => refuse(error.message));
if (firma.version !== version) refuse(`src/firma.wasm is of version ${firma.version}, the package of ${version}`);
const games = await loadGames().catch((error) => refuse(error.message));
if (games.version !== version) refuse(`src/firma_games.wasm is of version ${games.version}, the package of ${version}`);
const recordings = await loadRecordings().catch((error) => refuse(error.message));
if (recordings.version !== version)
    refuse(`src/firma_recordings.wasm is of version ${recordings.version}, the package of ${version}`);
const readers = await loadReaders(firma).catch((error) => refuse(error.message));
if (readers.version !== version)
    refuse(`src/firma_readers.wasm is of version ${readers.version}, the package of ${version}`);
