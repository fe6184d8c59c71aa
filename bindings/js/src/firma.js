// SPDX-License-Identifier: MIT
// The library: makes worlds, cutters, histories.
import { badCall } from './errors.js';
import { idOf, makeHandle } from './handle.js';
import { MESH, SHAPE_NAMES, WORLD_OPTIONS } from './layout.js';
import { bytes, doubles, flag, flags, longWord, masks, number, object, text, word, words } from './arguments.js';
import { Cutter } from './carving.js';
import { Level } from './level.js';
import { memoryOf, World } from './world.js';
import { Store } from './store.js';

const WORLD_OPTION_NAMES = ['name', 'surfaceArea', 'maxDepth', 'facesPerLeaf', 'minNodeVolume', 'contactOffset', 'scale', 'textures'];
const MESH_NAMES = ['positions', 'corners', 'cornerCounts', 'materials', 'materialNames', 'masks', 'twoSided', 'uvs'];

function nameOf(lent, options, place) {
    const name = text(options.name, place, 'name');
    return name === '' ? 0 : lent.text(name);
}

/** How a world is made; what is not given keeps the C API's default. @returns the address of the struct */
function putWorldOptions(core, options, place) {
    const at = core.at.worldOptions;
    const given = (name) => options[name] !== undefined;
    const set = [];
    if (given('surfaceArea'))
        set.push(['u32', WORLD_OPTIONS.surfaceArea, flag(options.surfaceArea, place, 'surfaceArea')]);
    if (given('textures'))
        set.push(['u32', WORLD_OPTIONS.noTextures, 1 - flag(options.textures, place, 'textures')]);
    for (const name of ['maxDepth', 'facesPerLeaf'])
        if (given(name)) set.push(['u32', WORLD_OPTIONS[name], word(options[name], place, name)]);
    for (const name of ['minNodeVolume', 'contactOffset', 'scale'])
        if (given(name)) set.push(['f64', WORLD_OPTIONS[name], number(options[name], place, name)]);
    core.call('firma_world_options_defaults', at);
    for (const [view, offset, value] of set) core[view][(at + offset) / core[view].BYTES_PER_ELEMENT] = value;
    return at;
}

/** The arrays of a mesh, checked to fit each other. */
function readMesh(mesh, place) {
    if (mesh === undefined) throw badCall(place, 'the mesh must be an object');
    object(mesh, place, 'the mesh', MESH_NAMES);
    const read = {
        positions: doubles(mesh.positions, 3, place, 'positions'),
        corners: words(mesh.corners, undefined, place, 'corners'),
        materialNames: mesh.materialNames === undefined ? [] : mesh.materialNames,
    };
    if (mesh.cornerCounts === undefined) {
        if (read.corners.length % 3 !== 0) throw badCall(place, 'corners of triangles must be a multiple of 3');
        read.faceCount = read.corners.length / 3;
    } else {
        read.cornerCounts = words(mesh.cornerCounts, undefined, place, 'cornerCounts');
        read.faceCount = read.cornerCounts.length;
        let sum = 0;
        for (const count of read.cornerCounts) sum += count;
        if (sum !== read.corners.length)
            throw badCall(place, `cornerCounts sum to ${sum}, corners are ${read.corners.length}`);
    }
    if (!Array.isArray(read.materialNames)) throw badCall(place, 'materialNames must be an array');
    read.materialNames = read.materialNames.map((name, k) => text(name, place, `materialNames[${k}]`));
    if (mesh.materials !== undefined) read.materials = words(mesh.materials, read.faceCount, place, 'materials');
    if (mesh.masks !== undefined) read.masks = masks(mesh.masks, read.faceCount, place, 'masks');
    if (mesh.uvs !== undefined) {
        read.uvs = doubles(mesh.uvs, 2, place, 'uvs');
        if (read.uvs.length !== 2 * read.corners.length)
            throw badCall(place, `uvs must be two for each corner: ${2 * read.corners.length}, not ${read.uvs.length}`);
    }
    if (mesh.twoSided !== undefined) read.twoSided = flags(mesh.twoSided, read.faceCount, place, 'twoSided');
    return read;
}

function putMesh(core, lent, mesh) {
    const names = mesh.materialNames.map((name) => lent.text(name));
    const fields = {
        size: MESH.sizeof,
        materialCount: names.length,
        positions: lent.doubles(mesh.positions),
        vertexCount: mesh.positions.length / 3,
        corners: lent.words(mesh.corners),
        cornerCounts: mesh.cornerCounts ? lent.words(mesh.cornerCounts) : 0,
        faceCount: mesh.faceCount,
        materials: mesh.materials ? lent.words(mesh.materials) : 0,
        materialNames: lent.words(names),
        masks: mesh.masks ? lent.words(mesh.masks) : 0,
        twoSided: mesh.twoSided ? lent.bytes(mesh.twoSided) : 0,
        uvs: mesh.uvs ? lent.doubles(mesh.uvs) : 0,
    };
    for (const name in fields) core.setU32(core.at.mesh + MESH[name], fields[name]);
    return core.at.mesh;
}

export class Firma {
    #core;

    constructor(core) {
        this.#core = core;
    }

    get version() {
        const version = this.#core.call('firma_version');
        return `${version >>> 16}.${(version >>> 8) & 255}.${version & 255}`;
    }

    liveHandles() {
        return this.#core.call('firma_live_handles') >>> 0;
    }

    /** Of a file's bytes, by the function for its format. */
    #worldFrom(format, data, options, place) {
        const core = this.#core;
        const given = object(options, place, 'the options', WORLD_OPTION_NAMES);
        return core.borrow((lent) => {
            const at = lent.bytes(data);
            const name = nameOf(lent, given, place);
            const chosen = putWorldOptions(core, given, place);
            return new World(core, makeHandle(core, format, at, data.length, name, chosen));
        });
    }

    worldFromObj(data, options) {
        const place = 'worldFromObj';
        return this.#worldFrom('firma_world_from_obj', bytes(data, place, 'the file', true), options, place);
    }

    worldFromBsp(data, options) {
        const place = 'worldFromBsp';
        return this.#worldFrom('firma_world_from_bsp', bytes(data, place, 'the file'), options, place);
    }

    worldFromMap(data, options) {
        const place = 'worldFromMap';
        return this.#worldFrom('firma_world_from_map', bytes(data, place, 'the file', true), options, place);
    }

    /** @param format  the function for the file's format */
    #level(format, data, options, place) {
        const core = this.#core;
        const given = object(options, place, 'the options', ['name', 'scale']);
        const scale = given.scale === undefined ? 0 : number(given.scale, place, 'scale');
        const world = (id, chosen) => {
            const at = putWorldOptions(core, object(chosen, 'world', 'the options', WORLD_OPTION_NAMES), 'world');
            return new World(core, makeHandle(core, 'firma_world_from_level', id, at));
        };
        return core.borrow((lent) => {
            const at = lent.bytes(data);
            const name = nameOf(lent, given, place);
            return new Level(core, makeHandle(core, format, at, data.length, name, scale), world);
        });
    }

    levelFromMap(data, options) {
        return this.#level('firma_level_from_map', bytes(data, 'levelFromMap', 'the file', true), options, 'levelFromMap');
    }

    levelFromBsp(data, options) {
        return this.#level('firma_level_from_bsp', bytes(data, 'levelFromBsp', 'the file'), options, 'levelFromBsp');
    }

    worldFromMesh(mesh, options) {
        const core = this.#core;
        const place = 'worldFromMesh';
        const read = readMesh(mesh, place);
        const given = object(options, place, 'the options', WORLD_OPTION_NAMES);
        return core.borrow((lent) => {
            const at = putMesh(core, lent, read);
            const name = nameOf(lent, given, place);
            const chosen = putWorldOptions(core, given, place);
            return new World(core, makeHandle(core, 'firma_world_from_mesh', at, name, chosen));
        });
    }

    unpackWorld(data, name) {
        const core = this.#core;
        const place = 'unpackWorld';
        const given = bytes(data, place, 'the file');
        return core.borrow((lent) => {
            const at = lent.bytes(given);
            const called = nameOf(lent, { name }, place);
            return new World(core, makeHandle(core, 'firma_world_unpack', at, given.length, called));
        });
    }

    memory(worlds) {
        if (!Array.isArray(worlds)) throw badCall('memory', 'the worlds must be an array');
        return memoryOf(this.#core, worlds);
    }

    crater(shape, seed) {
        const core = this.#core;
        const number = SHAPE_NAMES.indexOf(shape);
        if (number < 0) throw badCall('crater', `the shape must be one of ${SHAPE_NAMES.join(', ')}`);
        return new Cutter(core, makeHandle(core, 'firma_cutter_crater', number, longWord(seed, 'crater', 'the seed')));
    }

    cutterFromMesh(positions, corners, name) {
        const core = this.#core;
        const place = 'cutterFromMesh';
        doubles(positions, 3, place, 'positions');
        words(corners, undefined, place, 'corners');
        if (corners.length % 3 !== 0) throw badCall(place, 'corners of triangles must be a multiple of 3');
        return core.borrow((lent) => {
            const called = nameOf(lent, { name }, place);
            const [vertices, triangles] = [lent.doubles(positions), lent.words(corners)];
            const args = [vertices, positions.length / 3, triangles, corners.length / 3, called];
            return new Cutter(core, makeHandle(core, 'firma_cutter_from_mesh', ...args));
        });
    }

    cutterFromObj(data, name) {
        const core = this.#core;
        const place = 'cutterFromObj';
        const given = bytes(data, place, 'the file', true);
        return core.borrow((lent) => {
            const at = lent.bytes(given);
            const called = nameOf(lent, { name }, place);
            return new Cutter(core, makeHandle(core, 'firma_cutter_from_obj', at, given.length, called));
        });
    }

    cutterFromWorld(world, name) {
        const core = this.#core;
        const place = 'cutterFromWorld';
        const solid = idOf(world, core, place, 'world');
        return core.borrow((lent) => {
            const called = nameOf(lent, { name }, place);
            return new Cutter(core, makeHandle(core, 'firma_cutter_from_world', solid, called));
        });
    }

    randomTurn(seed) {
        const core = this.#core;
        core.call('firma_random_turn', longWord(seed, 'randomTurn', 'the seed'), core.at.out);
        return Array.from(core.f64.subarray(core.at.out >>> 3, (core.at.out >>> 3) + 4));
    }

    openStore(world, maxBytes) {
        return Store.open(this.#core, world, maxBytes);
    }
}
