// SPDX-License-Identifier: MIT
// What differs between worlds, as bytes.
import { bytes, longWord, object, region, text } from './arguments.js';
import { badCall } from './errors.js';
import { CORE, ID, makeHandle, takeBytes } from './handle.js';
import { REGION_HASH } from './layout.js';
import { World } from './world.js';
import { putName } from './world_options.js';

/** As hashRegions() gives them. @returns the address of the structs */
function putHashes(core, lent, hashes, place) {
    if (!Array.isArray(hashes)) throw badCall(place, 'the hashes must be an array, as hashRegions() returns');
    const at = lent.take(hashes.length * REGION_HASH.sizeof);
    hashes.forEach((one, k) => {
        const { region: cube, faces, points } = object(one, place, 'each of the hashes');
        const start = at + k * REGION_HASH.sizeof;
        core.i32.set(region(cube, place), (start + REGION_HASH.region) >>> 2);
        core.setU64(start + REGION_HASH.faces, longWord(faces, place, 'faces'));
        core.setU64(start + REGION_HASH.points, longWord(points, place, 'points'));
    });
    return at;
}

export function differingRegions(core, a, b) {
    const place = 'differingRegions';
    return core.borrow((lent) => {
        const lists = [putHashes(core, lent, a, place), a.length, putHashes(core, lent, b, place), b.length];
        const most = a.length + b.length;
        const at = lent.take(12 * most);
        core.run('firma_differing_regions', ...lists, at, most, core.at.out);
        return Array.from({ length: core.getU32(core.at.out) }, (_, k) => {
            const start = (at >>> 2) + 3 * k;
            return Array.from(core.i32.subarray(start, start + 3));
        });
    });
}

export function listFaces(world, regions) {
    const core = world[CORE];
    const place = 'listFaces';
    if (!Array.isArray(regions)) throw badCall(place, 'the regions must be an array');
    const numbers = regions.flatMap((one) => region(one, place));
    return core.borrow((lent) => {
        const at = lent.words(numbers);
        return takeBytes(core, makeHandle(core, 'firma_world_list_faces', world[ID], at, regions.length));
    });
}

/** Calls a function of a world, bytes and a name that puts a handle. */
function handleOf(world, call, data, name, place) {
    const core = world[CORE];
    const given = bytes(data, place, 'the data');
    return core.borrow((lent) => {
        const at = lent.bytes(given);
        return makeHandle(core, call, world[ID], at, given.length, putName(lent, text(name, place, 'name')));
    });
}

export function makePatch(world, list, name) {
    return takeBytes(world[CORE], handleOf(world, 'firma_world_make_patch', list, name, 'makePatch'));
}

export function applyPatch(world, patch, name) {
    return new World(world[CORE], handleOf(world, 'firma_world_apply_patch', patch, name, 'applyPatch'));
}
