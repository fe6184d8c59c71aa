// SPDX-License-Identifier: MIT
// Scenes of bodies as bench_bodies wrote them, so that all contenders get what Firma and Bullet get natively: the same
// levels, the same sets of spheres with the same mass. The others get the level's triangles.
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';

/** The world as it is, its lower corner, and the triangles of its solid. */
function levelOf(world) {
    const { positions, corners } = world.triangles({ solidOnly: true });
    return { world, low: world.facts().low, mesh: { positions: Float64Array.from(positions), corners } };
}

/** @param folder  that bench_bodies wrote */
export function bodyScenes(firma, folder) {
    const scenes = [];
    for (let k = 0; existsSync(join(folder, `${k}.json`)); ++k) {
        const scene = JSON.parse(readFileSync(join(folder, `${k}.json`)));
        scene.level = levelOf(firma.unpackWorld(readFileSync(join(folder, `${k}.firma`))));
        for (const body of scene.bodies) body.spheres = Float64Array.from(body.spheres);
        scenes.push(scene);
    }
    if (scenes.length === 0) throw new Error(`${folder}: no scenes; bench_bodies writes them (bench/node/run.sh)`);
    return scenes;
}
