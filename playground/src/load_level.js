// SPDX-License-Identifier: MIT
// The level that the address names, as a world.
import { startOf } from './spawn.js';

/** The levels that come with the page; the first is loaded unless the address names another. */
export const kLevels = ['depot.map', 'first.obj'];

/** The name after ?level=, if it is one of a file beside the page; else throws. */
export function levelName(search) {
    const name = new URLSearchParams(search).get('level') ?? kLevels[0];
    if (!/^[\w][\w .+-]*\.(obj|map|bsp|firma)$/i.test(name)) throw new Error(`${name}: a level is an .obj, .map, .bsp or .firma file beside this page`);
    return name;
}

/** The same, with what hangs free now held, and what reaches into volumes: said once, here, rather than by the first shot. */
function held(world, volumes = []) {
    const made = world.withAnchors({ volumes });
    world.release();
    return made;
}

/** Of a level of brushes. */
function ofBrushes(level) {
    try {
        return { world: held(level.world(), level.anchorVolumes()), start: startOf(level.entities()) };
    } finally {
        level.release();
    }
}

/** The world, and where its author has players start, or null. */
export async function loadLevel(firma, name) {
    const answer = await fetch(new URL(encodeURIComponent(name), document.baseURI));
    if (!answer.ok) throw new Error(`${name}: ${answer.status} ${answer.statusText}`);
    const bytes = new Uint8Array(await answer.arrayBuffer());
    switch (name.toLowerCase().split('.').pop()) {
        case 'map': return ofBrushes(await firma.levelFromMap(bytes, { name }));
        case 'bsp': return ofBrushes(await firma.levelFromBsp(bytes, { name }));
        case 'firma': return { world: firma.unpackWorld(bytes, name), start: null };
        default: return { world: held(await firma.worldFromObj(bytes, { name })), start: null };
    }
}
