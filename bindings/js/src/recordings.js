// SPDX-License-Identifier: MIT
// What `import ... from 'firma/recordings'` gives: the module of games with games as one value, recorded and replayed,
// and debris, blasts, parts that break, what a path goes through, convex pieces, supports, casts at bodies, sets of spheres.
import { blastImpulse, blastShare, exposure, pushBlast } from './blasts.js';
import { BodyIndex } from './body_casts.js';
import { blastFelt, breakable, hurt, partPortals, partWorld } from './breakables.js';
import { unpackHandle } from './commands.js';
import { convexPieces, convexPiecesOfChunk } from './convex.js';
import { Debris } from './debris.js';
import { flyScene } from './fly_scene.js';
import { fracture, fracturePattern } from './fracture.js';
import { Games } from './games_library.js';
import { kindOf, loadLibrary } from './load_library.js';
import { pathNextStop } from './part_paths.js';
import { pierce } from './pierce.js';
import { Game, kindOfBytes, Recording } from './recorded_games.js';
import { closestInScene } from './scenes.js';
import { castSet, castSetPair, castSetScene, fitSpheres } from './sphere_sets.js';
import { Supports } from './supports.js';

export { Projectiles } from './projectiles.js';
export * from './common.js';

const PLACE = 'loadRecordings';
const KIND = kindOf("Firma's module of recordings", 'firma_game_begin', PLACE);

class Recordings extends Games {
    #core;

    constructor(core, readers) {
        super(core, readers);
        this.#core = core;
    }

    game(level, rate = 60) {
        return Game.begin(this.#core, level, rate);
    }

    unpackGame(data, name) {
        return new Game(this.#core, unpackHandle(this.#core, 'firma_game_unpack', data, name, 'unpackGame'));
    }

    unpackRecording(data, name) {
        const id = unpackHandle(this.#core, 'firma_recording_unpack', data, name, 'unpackRecording');
        return new Recording(this.#core, id);
    }

    kindOfBytes(data) {
        return kindOfBytes(this.#core, data);
    }

    // ---- casts at bodies, sets of spheres

    bodyIndex(bodies, seconds = 0) {
        return BodyIndex.create(this.#core, bodies, seconds);
    }

    castSet(world, spheres, motion, options) {
        return castSet(this.#core, world, spheres, motion, options);
    }

    castSetScene(scene, spheres, motion, options) {
        return castSetScene(this.#core, scene, spheres, motion, options);
    }

    castSetPair(a, motionA, b, motionB) {
        return castSetPair(this.#core, a, motionA, b, motionB);
    }

    fitSpheres(world, fit) {
        return fitSpheres(this.#core, world, fit);
    }

    closestInScene(scene, point, options) {
        return closestInScene(this.#core, scene, point, options);
    }

    // ---- debris and blasts

    debris() {
        return Debris.create(this.#core);
    }

    fracturePattern(world, matter) {
        return fracturePattern(this.#core, world, matter);
    }

    fracture(world, pattern, options) {
        return fracture(this.#core, world, pattern, options);
    }

    blastShare(blast, distance) {
        return blastShare(this.#core, blast, distance);
    }

    blastImpulse(blast, point, area, seen) {
        return blastImpulse(this.#core, blast, point, area, seen);
    }

    exposure(scene, from, spheres, mask) {
        return exposure(this.#core, scene, from, spheres, mask);
    }

    pushBlast(scene, bodies, blast, options) {
        return pushBlast(this.#core, scene, bodies, blast, options);
    }

    // ---- parts: when they stop, how they break

    pathNextStop(path, seconds) {
        return pathNextStop(this.#core, path, seconds);
    }

    partWorld(parts, part) {
        return partWorld(this.#core, parts, part);
    }

    partPortals(parts, part, world) {
        return partPortals(this.#core, parts, part, world);
    }

    breakable(parts, part) {
        return breakable(this.#core, parts, part);
    }

    hurt(breakable, damage) {
        return hurt(this.#core, breakable, damage);
    }

    blastFelt(parts, part, world, blast, fraction) {
        return blastFelt(this.#core, parts, part, world, blast, fraction);
    }

    // ---- what a path goes through

    flyScene(projectiles, scene, seconds, options) {
        return flyScene(this.#core, projectiles, scene, seconds, options);
    }

    pierce(world, way, options) {
        return pierce(this.#core, world, way, options);
    }

    // ---- convex pieces, what faces hold

    convexPieces(world, options) {
        return convexPieces(this.#core, world, options);
    }

    convexPiecesOfChunk(chunks, chunk, options) {
        return convexPiecesOfChunk(this.#core, chunks, chunk, options);
    }

    findSupports(world, things) {
        return Supports.find(this.#core, world, things);
    }
}

export async function loadRecordings(source = new URL('./firma_recordings.wasm', import.meta.url), options = undefined) {
    return loadLibrary(source, options, PLACE, KIND, Recordings);
}
