// SPDX-License-Identifier: MIT
// The program of README.md in JavaScript: a sphere meets a bridge, and a crater is carved there.
import { readFile } from 'node:fs/promises';
import { loadFirma } from 'firma';

const firma = await loadFirma();
const world = await firma.worldFromObj(await readFile('levels/first.obj'), { name: 'first.obj' });
const hit = world.cast({ centre: [35, 29, 2], radius: 0.5, path: [0, 0, 10] });
const { report } = world.carve(firma.crater('rocky', 1), { position: hit.point, scale: 0.5 });
const material = world.material(hit.material);
console.log(`met ${material} after ${(10 * hit.fraction).toFixed(3)} m, carved ${report.volume.toFixed(3)} m3`);
