// SPDX-License-Identifier: MIT
// How a world is made: the options of every function that makes one.
import { WORLD_OPTIONS } from './layout.js';
import { flag, number, object, text, word } from './arguments.js';
import { putMatters, readMatters } from './matters.js';

const TREE_NAMES = ['surfaceArea', 'maxDepth', 'facesPerLeaf', 'minNodeVolume'];
const WORLD_OPTION_NAMES = ['name', ...TREE_NAMES, 'contactOffset', 'scale', 'textures', 'matters'];

/** The address of a name, 0 for none. */
export const putName = (lent, name) => (name === '' ? 0 : lent.text(name));

/** Checked: a name, and what is to be set. */
export function readWorldOptions(options, place) {
    const given = object(options, place, 'the options', WORLD_OPTION_NAMES);
    const has = (name) => given[name] !== undefined;
    const set = [];
    if (has('surfaceArea')) set.push(['u32', WORLD_OPTIONS.surfaceArea, flag(given.surfaceArea, place, 'surfaceArea')]);
    if (has('textures')) set.push(['u32', WORLD_OPTIONS.noTextures, 1 - flag(given.textures, place, 'textures')]);
    for (const name of ['maxDepth', 'facesPerLeaf'])
        if (has(name)) set.push(['u32', WORLD_OPTIONS[name], word(given[name], place, name)]);
    for (const name of ['minNodeVolume', 'contactOffset', 'scale'])
        if (has(name)) set.push(['f64', WORLD_OPTIONS[name], number(given[name], place, name)]);
    const matters = has('matters') ? readMatters(given.matters, place) : null;
    return { name: text(given.name, place, 'name'), set, matters };
}

/** What is not given keeps the C API's default. @returns the address of the struct */
export function putWorldOptions(core, lent, { set, matters }) {
    const table = matters ? putMatters(core, lent, matters) : 0;
    const at = core.at.worldOptions;
    core.call('firma_world_options_defaults', at);
    core.setU32(at + WORLD_OPTIONS.matters, table);
    for (const [view, offset, value] of set) core[view][(at + offset) / core[view].BYTES_PER_ELEMENT] = value;
    return at;
}
