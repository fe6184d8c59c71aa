// SPDX-License-Identifier: MIT
// What the module of readers is asked: arguments are checked before anything is loaded.
import { makeHandle } from './handle.js';
import { bytes, number, object, text } from './arguments.js';
import { Cutter } from './carving.js';
import { Level } from './level.js';
import { takeLevelParts } from './level_parts.js';
import { takeMatters } from './matters.js';
import { World } from './world.js';
import { putName, putWorldOptions, readWorldOptions } from './world_options.js';

/** One call: the file that it was given, and what is done with it. */
class Request {
    #file;
    #work;

    /** @param work of (file, readers, core) */
    constructor(file, work) {
        this.#file = file;
        this.#work = work;
    }

    /** Copies the file, which the caller may change before it is read. */
    keep() {
        this.#file = this.#file.slice();
    }

    run(readers, core) {
        return this.#work(this.#file, readers, core);
    }
}

/** Runs work(address, length) on the bytes of a handle, which is released. */
function withBytes(readers, handle, work) {
    try {
        const at = readers.at.out;
        readers.run('firma_bytes_get_view', handle, at, at + 4);
        return work(readers.getU32(at), readers.getU32(at + 4));
    } finally {
        if (!readers.stopped) readers.run('firma_bytes_release', handle);
    }
}

/** A world of the readers becomes one of `core`, the same to the bit, by way of a .firma file's bytes. */
function moveWorld(readers, core, id) {
    let packed;
    try {
        packed = makeHandle(readers, 'firma_world_pack', id, 1);
    } finally {
        if (!readers.stopped) readers.run('firma_world_release', id);
    }
    return withBytes(readers, packed, (from, length) =>
        core.borrow((lent) => {
            const at = lent.bytes(readers.u8.subarray(from, from + length));
            return new World(core, makeHandle(core, 'firma_world_unpack', at, length, 0));
        }),
    );
}

/** A world of a file, by the readers' function for its format. */
function worldOfFile(format, file, options, place) {
    const chosen = readWorldOptions(options, place);
    return new Request(file, (data, readers, core) => {
        const id = readers.borrow((lent) => {
            const at = lent.bytes(data);
            const name = putName(lent, chosen.name);
            return makeHandle(readers, format, at, data.length, name, putWorldOptions(readers, lent, chosen));
        });
        return moveWorld(readers, core, id);
    });
}

/** A level stays with the readers; the worlds made of it do not. */
function levelOfFile(format, file, options, place) {
    const given = object(options, place, 'the options', ['name', 'scale']);
    const scale = given.scale === undefined ? 0 : number(given.scale, place, 'scale');
    const called = text(given.name, place, 'name');
    return new Request(file, (data, readers, core) => {
        const world = (id, chosen) => {
            const options = readWorldOptions(chosen, 'world');
            const made = readers.borrow((lent) =>
                makeHandle(readers, 'firma_world_from_level', id, putWorldOptions(readers, lent, options)),
            );
            return moveWorld(readers, core, made);
        };
        const parts = (id, chosen) => {
            const options = readWorldOptions(chosen, 'parts');
            const made = readers.borrow((lent) =>
                makeHandle(readers, 'firma_parts_from_level', id, putWorldOptions(readers, lent, options)),
            );
            return takeLevelParts(readers, made, (one) => moveWorld(readers, core, one));
        };
        return readers.borrow((lent) => {
            const at = lent.bytes(data);
            const name = putName(lent, called);
            return new Level(readers, makeHandle(readers, format, at, data.length, name, scale), { world, parts });
        });
    });
}

/** A table goes over as an object. */
function mattersOfText(file, name, place) {
    const called = text(name, place, 'name');
    return new Request(file, (data, readers) =>
        readers.borrow((lent) => {
            const at = lent.bytes(data);
            const handle = makeHandle(readers, 'firma_matters_from_text', at, data.length, putName(lent, called));
            return takeMatters(readers, handle);
        }),
    );
}

/** The readers make a mesh of the file, `core` a cutter of the mesh. */
function cutterOfObj(file, name, place) {
    const called = text(name, place, 'name');
    return new Request(file, (data, readers, core) => {
        const count = readers.at.out + 8;
        const mesh = readers.borrow((lent) => {
            const at = lent.bytes(data);
            return makeHandle(readers, 'firma_wasm_mesh_from_obj', at, data.length, putName(lent, called), count);
        });
        const vertices = readers.getU32(count);
        return withBytes(readers, mesh, (from, length) =>
            core.borrow((lent) => {
                const at = lent.bytes(readers.u8.subarray(from, from + length));
                const corners = at + 24 * vertices;
                const triangles = (length - 24 * vertices) / 12;
                const args = [at, vertices, corners, triangles, lent.text(called === '' ? 'obj' : called)];
                return new Cutter(core, makeHandle(core, 'firma_cutter_from_mesh', ...args));
            }),
        );
    });
}

/** For each function that reads, by its name: a request of what it is given. */
export const REQUESTS = {
    worldFromObj(data, options) {
        const place = 'worldFromObj';
        return worldOfFile('firma_world_from_obj', bytes(data, place, 'the file', true), options, place);
    },
    worldFromBsp(data, options) {
        const place = 'worldFromBsp';
        return worldOfFile('firma_world_from_bsp', bytes(data, place, 'the file'), options, place);
    },
    worldFromMap(data, options) {
        const place = 'worldFromMap';
        return worldOfFile('firma_world_from_map', bytes(data, place, 'the file', true), options, place);
    },
    levelFromMap(data, options) {
        const place = 'levelFromMap';
        return levelOfFile('firma_level_from_map', bytes(data, place, 'the file', true), options, place);
    },
    levelFromBsp(data, options) {
        const place = 'levelFromBsp';
        return levelOfFile('firma_level_from_bsp', bytes(data, place, 'the file'), options, place);
    },
    cutterFromObj(data, name) {
        const place = 'cutterFromObj';
        return cutterOfObj(bytes(data, place, 'the file', true), name, place);
    },
    readMatters(data, name) {
        const place = 'readMatters';
        return mattersOfText(bytes(data, place, 'the table', true), name, place);
    },
};
