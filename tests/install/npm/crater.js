// SPDX-License-Identifier: MIT
// crater.cpp in JavaScript, for node and browsers: the line that it prints.
import { loadFirma } from 'firma';
import { loadReaders } from 'firma/readers';

export async function crater(level, source, options) {
    const firma = await loadFirma(source, options);
    const world = await firma.worldFromObj(level, { name: 'first.obj' });
    const readers = await loadReaders(firma);
    const again = readers.worldFromObj(level, { name: 'first.obj' });
    if (again.hash() !== world.hash()) throw new Error('the readers make another world');
    const hit = world.cast({ centre: [35, 29, 2], radius: 0.5, path: [0, 0, 10] });
    const { world: after } = world.carve(firma.crater('rocky', 1), { position: hit.point, scale: 1.5 });
    const material = world.facts().materials[hit.material];
    // 17 digits, as C's %.17g.
    return `met ${material} after ${Number(hit.fraction).toPrecision(17)}, hash ${after.hash().toString(16).padStart(16, '0')}`;
}
