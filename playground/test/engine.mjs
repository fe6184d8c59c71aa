// SPDX-License-Identifier: MIT
// The engine for tests in node: the module of recordings and that of the readers.
import { readFileSync } from 'node:fs';
import path from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

export const kRoot = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../..');
const recordings = process.env.FIRMA_JS ?? path.join(kRoot, 'bindings/js/src/recordings.js');
export const { loadRecordings, Projectiles } = await import(pathToFileURL(recordings));
const { loadReaders } = await import(pathToFileURL(path.join(path.dirname(recordings), 'readers.js')));
export const firma = await loadRecordings(process.env.FIRMA_WASM ?? path.join(kRoot, 'build/wasm/bin/firma_recordings.wasm'));
export const readers = await loadReaders(firma);

export const readLevel = (name) => readFileSync(path.join(kRoot, 'levels', name), 'utf8');

/** A level of ours, with what hangs free now held. */
export function makeWorld(name) {
    const read = name.endsWith('.map') ? ofBrushes(name) : { world: readers.worldFromObj(readLevel(name), { name }), volumes: [] };
    const world = read.world.withAnchors({ volumes: read.volumes });
    read.world.release();
    return world;
}

function ofBrushes(name) {
    const level = readers.levelFromMap(readLevel(name), { name });
    const made = { world: level.world(), volumes: level.anchorVolumes() };
    level.release();
    return made;
}
