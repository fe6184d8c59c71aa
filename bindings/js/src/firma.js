// SPDX-License-Identifier: MIT
// The library: makes worlds, cutters, histories.
import { badCall } from './errors.js';
import { idOf, makeHandle } from './handle.js';
import { SHAPE_NAMES } from './layout.js';
import { bytes, doubles, longWord, text, words } from './arguments.js';
import { Cutter, getPose, putPose } from './carving.js';
import { cutterAtRest } from './chunks.js';
import { Command } from './commands.js';
import { EditLog } from './logs.js';
import { defaultMatters } from './matters.js';
import { putMesh, readMesh } from './mesh.js';
import { hullBox, hullFromPoints } from './movers.js';
import { differingRegions } from './patches.js';
import { REQUESTS } from './reading.js';
import { memoryOf, World } from './world.js';
import { Store } from './store.js';
import { putName, putWorldOptions, readWorldOptions } from './world_options.js';

/** For loadReaders(): what a Firma reads with. */
export const READERS = Symbol('readers');

const nameOf = (lent, name, place) => putName(lent, text(name, place, 'name'));

export class Firma {
    #core;
    #readers;

    /** @param readers the ReadersModule */
    constructor(core, readers) {
        this.#core = core;
        this.#readers = readers;
    }

    get version() {
        return this.#core.version();
    }

    liveHandles() {
        return (this.#core.call('firma_live_handles') >>> 0) + this.#readers.liveHandles();
    }

    get [READERS]() {
        return { core: this.#core, module: this.#readers };
    }

    /** Checks at once what was given; reads once there are readers. */
    #read(place, ...args) {
        return this.#readers.run(REQUESTS[place](...args), this.#core, place);
    }

    async worldFromObj(data, options) {
        return this.#read('worldFromObj', data, options);
    }

    async worldFromBsp(data, options) {
        return this.#read('worldFromBsp', data, options);
    }

    async worldFromMap(data, options) {
        return this.#read('worldFromMap', data, options);
    }

    async levelFromMap(data, options) {
        return this.#read('levelFromMap', data, options);
    }

    async levelFromBsp(data, options) {
        return this.#read('levelFromBsp', data, options);
    }

    worldFromMesh(mesh, options) {
        const core = this.#core;
        const place = 'worldFromMesh';
        const read = readMesh(mesh, place);
        const chosen = readWorldOptions(options, place);
        return core.borrow((lent) => {
            const at = putMesh(core, lent, read);
            const name = putName(lent, chosen.name);
            const how = putWorldOptions(core, lent, chosen);
            return new World(core, makeHandle(core, 'firma_world_from_mesh', at, name, how));
        });
    }

    async cutterFromObj(data, name) {
        return this.#read('cutterFromObj', data, name);
    }

    async readMatters(data, name) {
        return this.#read('readMatters', data, name);
    }

    defaultMatters() {
        return defaultMatters(this.#core);
    }

    unpackWorld(data, name) {
        const core = this.#core;
        const place = 'unpackWorld';
        const given = bytes(data, place, 'the file');
        return core.borrow((lent) => {
            const at = lent.bytes(given);
            const called = nameOf(lent, name, place);
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
            const called = nameOf(lent, name, place);
            const [vertices, triangles] = [lent.doubles(positions), lent.words(corners)];
            const args = [vertices, positions.length / 3, triangles, corners.length / 3, called];
            return new Cutter(core, makeHandle(core, 'firma_cutter_from_mesh', ...args));
        });
    }

    hullFromPoints(points) {
        return hullFromPoints(this.#core, points);
    }

    hullBox(half, axes) {
        return hullBox(this.#core, half, axes);
    }

    cutterFromWorld(world, name) {
        const core = this.#core;
        const place = 'cutterFromWorld';
        const solid = idOf(world, core, place, 'world');
        return core.borrow((lent) => {
            const called = nameOf(lent, name, place);
            return new Cutter(core, makeHandle(core, 'firma_cutter_from_world', solid, called));
        });
    }

    cutterAtRest(world, pose, name) {
        return cutterAtRest(this.#core, world, pose, name);
    }

    quantisePose(pose) {
        const core = this.#core;
        const at = putPose(core, pose, 'quantisePose');
        core.run('firma_pose_quantise', at, at);
        return getPose(core, at);
    }

    editCommand(number, cutter, pose, options) {
        return Command.edit(this.#core, number, cutter, pose, options);
    }

    doorCommand(number, portal, open) {
        return Command.door(this.#core, number, portal, open);
    }

    groupCommand(parts) {
        return Command.group(this.#core, parts);
    }

    unpackCommand(data, name) {
        return Command.unpack(this.#core, data, name);
    }

    beginLog(world) {
        return EditLog.begin(this.#core, world);
    }

    unpackLog(data, name) {
        return EditLog.unpack(this.#core, data, name);
    }

    differingRegions(a, b) {
        return differingRegions(this.#core, a, b);
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
