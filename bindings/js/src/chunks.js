// SPDX-License-Identifier: MIT
// Loose chunks: what holds pieces, the pieces as bodies and as worlds, and how they become ground again.
import { flag, number, object, text, vector, word, words } from './arguments.js';
import { Cutter, getPose, putPose } from './carving.js';
import { badCall } from './errors.js';
import { CORE, Handle, ID, idOf, makeHandle } from './handle.js';
import { ANCHORS, BOX, CHUNK, MASS, MATTER_VOLUME, REST } from './layout.js';
import { World } from './world.js';
import { putName } from './world_options.js';

export function getMassAt(core, at) {
    const inertia = (at + MASS.inertia) >>> 3;
    return {
        volume: core.getF64(at + MASS.volume),
        mass: core.getF64(at + MASS.mass),
        centre: core.getVector(at + MASS.centre),
        inertia: Array.from(core.f64.subarray(inertia, inertia + 9)),
    };
}

function getVolumes(core, at) {
    return Array.from({ length: core.getU32(at + CHUNK.matterCount) }, (_, k) => {
        const one = core.getU32(at + CHUNK.matters) + k * MATTER_VOLUME.sizeof;
        return {
            matter: core.getU32(one + MATTER_VOLUME.matter),
            volume: core.getF64(one + MATTER_VOLUME.volume),
        };
    });
}

export class Chunks extends Handle {
    constructor(core, id) {
        super(core, id, 'firma_chunks_release');
    }

    list() {
        const core = this[CORE];
        core.run('firma_chunks_get_count', this[ID], core.at.out);
        return Array.from({ length: core.getU32(core.at.out) }, (_, k) => {
            const at = core.at.chunk;
            core.run('firma_chunks_get', this[ID], k, at);
            return {
                origin: core.getVector(at + CHUNK.origin),
                ...getMassAt(core, at + CHUNK.mass),
                faceCount: core.getCount(at + CHUNK.faceCount),
                low: core.getVector(at + CHUNK.low),
                high: core.getVector(at + CHUNK.high),
                matters: getVolumes(core, at),
            };
        });
    }

    world(chunk) {
        const core = this[CORE];
        word(chunk, 'world', 'the chunk');
        return new World(core, makeHandle(core, 'firma_chunks_world', this[ID], chunk));
    }
}

export function getMass(world, density) {
    const core = world[CORE];
    core.run('firma_world_mass', world[ID], number(density, 'mass', 'density'), core.at.mass);
    return getMassAt(core, core.at.mass);
}

export function getPieces(world, density = 2000) {
    const core = world[CORE];
    number(density, 'pieces', 'density');
    return new Chunks(core, makeHandle(core, 'firma_world_pieces', world[ID], density));
}

function putVolumes(core, lent, volumes, place) {
    if (!Array.isArray(volumes)) throw badCall(place, 'volumes must be an array');
    const at = lent.take(volumes.length * BOX.sizeof);
    volumes.forEach((volume, k) => {
        const what = `${place}: volume ${k}`;
        object(volume ?? null, what, 'the volume', ['low', 'high']);
        const low = vector(volume.low, 3, what, 'low');
        const high = vector(volume.high, 3, what, 'high');
        core.setVector(at + k * BOX.sizeof + BOX.low, low);
        core.setVector(at + k * BOX.sizeof + BOX.high, high);
    });
    return at;
}

/** @returns the address of the struct */
export function putAnchors(core, lent, anchors) {
    const place = 'withAnchors';
    const given = object(anchors, place, 'the anchors', ['hanging', 'materials', 'sources', 'volumes']);
    const { hanging = true, materials = [], sources = [], volumes = [] } = given;
    flag(hanging, place, 'hanging');
    if (!Array.isArray(materials)) throw badCall(place, 'materials must be an array');
    for (const name of materials)
        if (typeof name !== 'string') throw badCall(place, 'each of materials must be a string');
    words(sources, undefined, place, 'sources');
    const names = lent.words(materials.map((name) => lent.text(text(name, place, 'a material'))));
    const numbers = lent.words(sources);
    const boxes = putVolumes(core, lent, volumes, place);
    const at = core.at.anchors;
    core.setU32(at + ANCHORS.size, ANCHORS.sizeof);
    core.setU32(at + ANCHORS.noHanging, hanging ? 0 : 1);
    core.setU32(at + ANCHORS.materials, names);
    core.setU32(at + ANCHORS.materialCount, materials.length);
    core.setU32(at + ANCHORS.sources, numbers);
    core.setU32(at + ANCHORS.sourceCount, sources.length);
    core.setU32(at + ANCHORS.volumes, boxes);
    core.setU32(at + ANCHORS.volumeCount, volumes.length);
    return at;
}

export function cutterAtRest(core, world, pose, name) {
    const place = 'cutterAtRest';
    const id = idOf(world, core, place, 'world');
    return core.borrow((lent) => {
        const called = putName(lent, text(name, place, 'name'));
        const at = core.at.rest;
        core.run('firma_cutter_at_rest', id, putPose(core, pose, place), called, core.at.out, at);
        return {
            cutter: new Cutter(core, core.u64[core.at.out >>> 3]),
            pose: getPose(core, at + REST.pose),
            volumeChange: core.getF64(at + REST.volumeChange),
            mended: core.getU32(at + REST.mended),
        };
    });
}
